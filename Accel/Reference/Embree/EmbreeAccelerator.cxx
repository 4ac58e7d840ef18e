// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Reference/Embree/EmbreeAccelerator.h"

#include "Accel/Kernel/BatchRunner.h"
#include "Accel/Reference/Embree/EmbreeScene.h"

#include <chrono>
#include <string>

namespace lumitree
{
namespace
{

/// What the batch runner takes for a structure: a scene and what is asked of it.
struct Asked
{
  const EmbreeScene& scene;
  void (EmbreeScene::*query)(RayState&) const;
};

template <class Visitor>
void answer(const void* structure, RayState& state, Visitor&)
{
  const auto& asked = *static_cast<const Asked*>(structure);
  (asked.scene.*asked.query)(state);
}

class EmbreeAccelerator final : public Accelerator
{
public:
  EmbreeAccelerator(
    std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
    : Accelerator(std::move(surface), options)
  {
    refuseBodies(this->surface(), "Embree");
    const auto start = std::chrono::steady_clock::now();
    this->scene_ =
      std::make_unique<const EmbreeScene>(this->surface(), options.embreeRobust, control);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    this->statistics_ = describe(this->hierarchy(), this->surface());
    this->statistics_.memory = this->scene_->memory();
    this->statistics_.buildSeconds = elapsed.count();
  }

  [[nodiscard]] bool supports(Precision precision) const override
  {
    return precision == Precision::Fast;
  }

  QueryReport closest(const RayBatch& rays, Hit* hits, const QueryOptions& options) const override
  {
    const Asked asked{ *this->scene_, &EmbreeScene::closest };
    return this->runner(asked, options).closest(rays, hits, options);
  }

  QueryReport any(
    const RayBatch& rays, std::uint8_t* hit, const QueryOptions& options) const override
  {
    const Asked asked{ *this->scene_, &EmbreeScene::any };
    return this->runner(asked, options).any(rays, hit, options);
  }

  QueryReport all(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const override
  {
    const Asked asked{ *this->scene_, &EmbreeScene::all };
    return this->runner(asked, options).all(rays, hits, options);
  }

  QueryReport ties(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const override
  {
    const Asked asked{ *this->scene_, &EmbreeScene::all };
    return this->runner(asked, options).ties(rays, hits, options);
  }

  QueryReport count(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const override
  {
    const Asked asked{ *this->scene_, &EmbreeScene::all };
    return this->runner(asked, options).count(rays, counts, options);
  }

  /// Embree does not show its tree.
  [[nodiscard]] HierarchyView hierarchy() const override
  {
    HierarchyView view;
    view.references = this->surface().hittable();
    HierarchyNode root;
    root.box = this->surface().bounds();
    root.leaf = true;
    root.referenceCount = static_cast<std::uint32_t>(view.references.size());
    view.nodes.push_back(root);
    completeHierarchy(view);
    return view;
  }

private:
  [[nodiscard]] BatchRunner runner(const Asked& asked, const QueryOptions& options) const
  {
    if (!this->supports(options.precision))
    {
      throw UnsupportedQuery("structure '" + std::string(name(Structure::Embree)) +
        "' answers with precision '" + std::string(name(Precision::Fast)) + "' only, not '" +
        std::string(name(options.precision)) + "'");
    }
    StructureWalks walks;
    walks.plain = answer<LeafVisitor>;
    walks.counting = answer<CountingVisitor>;
    return BatchRunner(this->surface(), &asked, walks, nullptr, this->statistics_.nodes, 0);
  }

  std::unique_ptr<const EmbreeScene> scene_;
};

} // namespace

std::shared_ptr<const Accelerator> buildEmbree(
  std::shared_ptr<const Surface> surface, const BuildOptions& options, JobControl* control)
{
  return std::make_shared<EmbreeAccelerator>(std::move(surface), options, control);
}

} // namespace lumitree
