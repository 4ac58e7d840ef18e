// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Registry.h"

#if defined(LUMITREE_EMBREE_MAJOR)
#include "Accel/Reference/Embree/EmbreeAccelerator.h"
#endif
#include "Accel/Structures/BruteForce.h"
#include "Accel/Structures/BspTree.h"
#include "Accel/Structures/Bvh.h"
#include "Accel/Structures/Grid.h"
#include "Accel/Structures/KdTree.h"
#include "Accel/Structures/Octree.h"
#include "Accel/Structures/WideBvh.h"

#include <map>
#include <mutex>

namespace lumitree
{

struct Registry::Internals
{
  mutable std::mutex mutex;
  std::map<Structure, Backend> backends;
};

Registry::Registry()
  : internals_(std::make_unique<Internals>())
{
  this->add({ Structure::BruteForce, "every primitive, every ray", buildBruteForce, loadBruteForce });
  this->add({ Structure::Bvh, "binary bounding volume hierarchy", buildBvh, loadBvh });
  this->add({ Structure::WideBvh, "eight-wide bounding volume hierarchy", buildWideBvh, loadWideBvh });
  this->add({ Structure::Grid, "uniform grid", buildGrid, loadGrid });
  this->add({ Structure::Octree, "octree", buildOctree, loadOctree });
  this->add({ Structure::KdTree, "KD-tree", buildKdTree, loadKdTree });
  this->add({ Structure::BspTree, "BSP-tree", buildBspTree, loadBspTree });
#if defined(LUMITREE_EMBREE_MAJOR)
  this->add({ Structure::Embree, "Intel Embree, in float; shown as one node", buildEmbree });
#endif
}

Registry::~Registry() = default;

Registry& Registry::instance()
{
  static Registry registry;
  return registry;
}

void Registry::add(Backend backend)
{
  const std::lock_guard<std::mutex> lock(this->internals_->mutex);
  const Structure structure = backend.structure;
  this->internals_->backends[structure] = std::move(backend);
}

bool Registry::has(Structure structure) const
{
  const std::lock_guard<std::mutex> lock(this->internals_->mutex);
  return this->internals_->backends.count(structure) > 0;
}

std::vector<Structure> Registry::structures() const
{
  const std::lock_guard<std::mutex> lock(this->internals_->mutex);
  std::vector<Structure> found;
  for (const auto& entry : this->internals_->backends)
  {
    found.push_back(entry.first);
  }
  return found;
}

Backend Registry::find(Structure structure) const
{
  const std::lock_guard<std::mutex> lock(this->internals_->mutex);
  const auto entry = this->internals_->backends.find(structure);
  if (entry == this->internals_->backends.end())
  {
    std::string message = "structure '" + std::string(name(structure)) + "' is not available here;";
    for (const auto& other : this->internals_->backends)
    {
      message += " " + std::string(name(other.first));
    }
    throw UnknownStructure(message + " can be had");
  }
  return entry->second;
}

} // namespace lumitree
