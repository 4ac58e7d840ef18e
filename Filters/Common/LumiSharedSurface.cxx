// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSharedSurface.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>

namespace lumitree::filters
{
namespace
{

std::atomic<std::uint64_t> builds{ 0 };

template <class T>
PointArray joined(const std::vector<SurfacePart>& parts, std::size_t count)
{
  std::vector<T> xyz;
  xyz.reserve(3 * count);
  for (const SurfacePart& part : parts)
  {
    const PointArray& points = part.triangles.points;
    for (std::size_t i = 0; i < 3 * points.count; ++i)
    {
      xyz.push_back(static_cast<T>(points.values.scalar(i)));
    }
  }
  return PointArray::from(std::move(xyz));
}

/// All points in one array. Those of a single leaf stay where they are; of several they are floats
/// if all are, for a float widened is exact and a double narrowed is not.
PointArray join(const std::vector<SurfacePart>& parts, std::size_t count)
{
  bool allFloat = true;
  for (const SurfacePart& part : parts)
  {
    const PointArray& points = part.triangles.points;
    if (points.count == count)
    {
      return points;
    }
    allFloat = allFloat && (points.count == 0 || points.values.type == ArrayView::Scalar::Float);
  }
  return allFloat ? joined<float>(parts, count) : joined<double>(parts, count);
}

/// Primitive i is cell i of the only dataset: no list is needed.
bool isIdentity(const std::vector<std::int64_t>& cells)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (cells[i] != static_cast<std::int64_t>(i))
    {
      return false;
    }
  }
  return true;
}

} // namespace

SharedSurface::SharedSurface(std::vector<SurfacePart> parts, bool gathered, int threads)
{
  auto index = std::make_unique<SurfaceIndex>(parts.size());
  index->gathered = gathered;
  std::size_t points = 0;
  std::size_t triangles = 0;
  std::size_t primitives = 0;
  for (const SurfacePart& part : parts)
  {
    points += part.triangles.points.count;
    triangles += part.triangles.triangles.size();
    primitives += part.triangles.cells.size();
  }
  if (std::max(points, primitives) >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument(
      "more than 2^32 - 2 points, or triangles and quadrics, in all datasets together");
  }

  PointArray joinedPoints = join(parts, points);
  std::vector<Triangle> all;
  std::vector<Quadric> quadrics;
  SourceMap sources;
  if (parts.size() != 1)
  {
    all.reserve(triangles);
    sources.cells.reserve(primitives);
  }
  std::size_t firstPoint = 0;
  PrimitiveId firstPrimitive = 0;
  for (SurfacePart& part : parts)
  {
    LeafTriangles& own = part.triangles;
    this->input_.hiddenCells += own.hiddenCells;
    this->input_.duplicateCells += own.duplicateCells;
    this->input_.passedOver += own.passedOver;
    this->input_.firstPrimitive.push_back(firstPrimitive);
    this->input_.leaves.push_back(part.leaf);
    index->firstPrimitive.push_back(firstPrimitive);
    index->firstPoint.push_back(firstPoint);
    index->pointIds.push_back(own.pointIds);
    if (!own.cells.empty())
    {
      sources.blocks.push_back({ firstPrimitive, part.leaf.compositeIndex });
    }

    firstPrimitive += static_cast<PrimitiveId>(own.cells.size());
    quadrics.insert(quadrics.end(), own.quadrics.begin(), own.quadrics.end());
    if (parts.size() == 1)
    {
      all = std::move(own.triangles);
      sources.cells = std::move(own.cells);
    }
    else
    {
      const auto offset = static_cast<std::uint32_t>(firstPoint);
      for (const Triangle& triangle : own.triangles)
      {
        all.push_back({ triangle[0] + offset, triangle[1] + offset, triangle[2] + offset });
      }
      sources.cells.insert(sources.cells.end(), own.cells.begin(), own.cells.end());
    }
    firstPoint += own.points.count;
    own = {}; // no second copy of everything
  }
  index->firstPrimitive.push_back(firstPrimitive);
  index->firstPoint.push_back(firstPoint);
  if (parts.size() == 1 && isIdentity(sources.cells))
  {
    sources.cells = {};
  }

  this->input_.surface = std::make_shared<const Surface>(
    std::move(joinedPoints), std::move(all), std::move(quadrics), std::move(sources), threads);
  index->surface = this->input_.surface;
  this->index_ = std::move(index);
}

std::shared_ptr<const SurfaceInput> SharedSurface::input(
  const std::vector<vtkSmartPointer<vtkDataSet>>& leaves) const
{
  auto result = std::make_shared<SurfaceInput>(this->input_);
  result->index = { this->shared_from_this(), this->index_.get() };
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    result->leaves[i].data = leaves[i];
  }
  return result;
}

std::shared_ptr<const Accelerator> SharedSurface::find(const BuildOptions& options)
{
  const auto dead = [](const auto& tree) { return tree.second.expired(); };
  this->trees_.erase(
    std::remove_if(this->trees_.begin(), this->trees_.end(), dead), this->trees_.end());
  for (const auto& [asked, tree] : this->trees_)
  {
    std::shared_ptr<const Accelerator> alive = tree.lock();
    if (alive && (asked == options || alive->options() == options))
    {
      return alive;
    }
  }
  return nullptr;
}

std::shared_ptr<const Accelerator> SharedSurface::accelerator(
  const BuildOptions& options, JobControl* control)
{
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    if (std::shared_ptr<const Accelerator> existing = this->find(options))
    {
      return existing;
    }
  }
  std::shared_ptr<const Accelerator> built = build(this->input_.surface, options, control);
  ++builds;
  const std::lock_guard<std::mutex> lock(this->mutex_);
  if (std::shared_ptr<const Accelerator> earlier = this->find(options))
  {
    return earlier;
  }
  this->trees_.emplace_back(options, built);
  return built;
}

std::uint64_t acceleratorsBuilt()
{
  return builds.load();
}

} // namespace lumitree::filters
