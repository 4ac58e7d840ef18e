// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhLeaves.h"

#include "Accel/Structures/BvhParts.h"

#include <numeric>

namespace lumitree
{
namespace
{

constexpr std::size_t chunk = 1024;
/// No builder splits primitives into more references than this many each.
constexpr std::size_t mostParts = 2;

/// Of each primitive whether it can be hit.
std::vector<bool> hittableOf(const Surface& surface)
{
  std::vector<bool> hittable(surface.size(), false);
  for (const PrimitiveId id : surface.hittable())
  {
    hittable[id] = true;
  }
  return hittable;
}

/// Where each leaf begins.
std::vector<std::size_t> firstsOf(const std::vector<std::uint32_t>& sizes)
{
  std::vector<std::size_t> firsts(sizes.size() + 1, 0);
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    firsts[i + 1] = firsts[i] + sizes[i];
  }
  return firsts;
}

} // namespace

bool holdAll(const Surface& surface, const std::vector<PrimitiveId>& references)
{
  std::vector<bool> missing = hittableOf(surface);
  std::size_t found = 0;
  for (const PrimitiveId id : references)
  {
    found += missing[id] ? 1 : 0;
    missing[id] = false;
  }
  return found == surface.hittable().size();
}

void keepHittable(const Surface& surface, BvhLeaves& leaves)
{
  if (surface.hittable().size() == surface.size())
  {
    return;
  }
  const std::vector<bool> hittable = hittableOf(surface);
  std::size_t from = 0;
  std::size_t kept = 0;
  for (std::uint32_t& size : leaves.sizes)
  {
    const std::size_t first = kept;
    for (const std::size_t end = from + size; from < end; ++from)
    {
      const PrimitiveId id = leaves.references[from];
      if (hittable[id])
      {
        leaves.references[kept++] = id;
      }
    }
    size = static_cast<std::uint32_t>(kept - first);
  }
  leaves.references.resize(kept);
}

void fitBoxes(const Surface& surface, BvhLeaves& leaves, BuildProgress& progress)
{
  const std::vector<std::size_t> firsts = firstsOf(leaves.sizes);
  progress.stage(0.5, surface.size());
  const std::vector<Box> parts =
    leaves.boxes.empty() ? std::vector<Box>{} : boxesOfParts(surface, leaves, firsts, progress);
  leaves.boxes.assign(leaves.sizes.size(), Box{});
  progress.stage(0.8, leaves.sizes.size());
  progress.forEach(leaves.sizes.size(), chunk,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t leaf = begin; leaf < end; ++leaf)
      {
        Box box;
        for (std::size_t i = firsts[leaf]; i < firsts[leaf + 1]; ++i)
        {
          box.extend(parts.empty() ? surface.box(leaves.references[i]) : parts[i]);
        }
        leaves.boxes[leaf] = box;
      }
    });
}

void saveLeaves(const BvhLeaves& leaves, SaveWriter& writer)
{
  writer.putAll(leaves.sizes);
  writer.put(std::uint64_t{ leaves.references.size() });
  writer.putAll(leaves.references);
  for (const Box& box : leaves.boxes)
  {
    for (int k = 0; k < 3; ++k)
    {
      writer.put(box.lower[k]);
      writer.put(box.upper[k]);
    }
  }
}

BvhLeaves loadLeaves(const Surface& surface, std::size_t count, bool parts, SaveReader& reader)
{
  BvhLeaves leaves;
  leaves.sizes = reader.getAll<std::uint32_t>(count);
  leaves.references = reader.getAll<PrimitiveId>(reader.get<std::uint64_t>());
  std::uint64_t held = 0;
  for (const std::uint32_t size : leaves.sizes)
  {
    held += size;
  }
  require(held == leaves.references.size(), "its leaves do not hold all its references");
  for (const PrimitiveId id : leaves.references)
  {
    require(id < surface.size(), "it names a primitive that there is not");
  }
  const std::size_t hittable = surface.hittable().size();
  require(parts ? held <= mostParts * hittable : held == hittable,
    "it has another number of references than its surface needs");
  require(holdAll(surface, leaves.references), "it does not hold every primitive");
  if (parts)
  {
    const std::vector<double> planes = reader.getAll<double>(6 * std::uint64_t{ count });
    leaves.boxes.resize(count);
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      Box& box = leaves.boxes[i / 6];
      (i % 2 == 0 ? box.lower : box.upper)[i % 6 / 2] = planes[i];
    }
  }
  return leaves;
}

} // namespace lumitree
