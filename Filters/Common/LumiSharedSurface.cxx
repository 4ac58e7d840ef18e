// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSharedSurface.h"

#include "Accel/Save.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace lumitree::filters
{
namespace
{

std::atomic<std::uint64_t> builds{ 0 };

/// When a file was last written; 0 where there is none.
std::int64_t timeOf(const std::string& file)
{
  std::error_code missing;
  const auto time = std::filesystem::last_write_time(file, missing);
  return missing ? 0 : static_cast<std::int64_t>(time.time_since_epoch().count());
}

/// Writes the file that reuse asks for. Never over one that is something else.
void saveWhereAsked(const Accelerator& tree, const TreeReuse& reuse)
{
  if (reuse.file.empty() || !reuse.mayWrite || reuse.fileUse == TreeReuse::File::Load)
  {
    return;
  }
  const bool exists = std::filesystem::exists(reuse.file);
  if (exists && !isSavedStructure(reuse.file))
  {
    throw SaveError("'" + reuse.file + "' is no saved structure: it is not overwritten");
  }
  const bool isThere = &tree == reuse.before.get() && reuse.file == reuse.beforeFile;
  if (!exists || (reuse.fileUse == TreeReuse::File::Save && !isThere))
  {
    saveFile(tree, reuse.file);
  }
}

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
      "more than 2^32 - 2 points, or triangles and bodies, in all datasets together");
  }

  PointArray joinedPoints = join(parts, points);
  std::vector<Triangle> all;
  std::vector<Quadric> quadrics;
  std::vector<Implicit> implicits;
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
    implicits.insert(implicits.end(), own.implicits.begin(), own.implicits.end());
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

  this->input_.surface = std::make_shared<const Surface>(std::move(joinedPoints), std::move(all),
    std::move(quadrics), std::move(implicits), std::move(sources), threads);
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

std::shared_ptr<const Accelerator> SharedSurface::find(
  const BuildOptions& options, const TreeReuse& reuse)
{
  const auto dead = [](const Entry& entry) { return entry.tree.expired(); };
  this->trees_.erase(
    std::remove_if(this->trees_.begin(), this->trees_.end(), dead), this->trees_.end());
  const bool byFile = !reuse.file.empty() && reuse.fileUse == TreeReuse::File::Load;
  for (const Entry& entry : this->trees_)
  {
    std::shared_ptr<const Accelerator> alive = entry.tree.lock();
    if (!alive)
    {
      continue;
    }
    const bool wanted = byFile ? entry.file == reuse.file && entry.fileTime == timeOf(reuse.file)
                               : (entry.asked == options || alive->options() == options) &&
        (reuse.refit || alive->statistics().origin != Origin::Refitted);
    if (wanted)
    {
      return alive;
    }
  }
  return nullptr;
}

std::shared_ptr<const Accelerator> SharedSurface::refitted(
  const BuildOptions& options, JobControl* control, const TreeReuse& reuse) const
{
  const Surface& surface = *this->input_.surface;
  if (!reuse.refit || !reuse.before || !(reuse.beforeAsked == options) ||
    reuse.before->surface().quadricCount() != surface.quadricCount() ||
    reuse.before->surface().triangles() != surface.triangles())
  {
    return nullptr;
  }
  std::shared_ptr<const Accelerator> fitted =
    reuse.before->refit(this->input_.surface, options.threads, control);
  const bool good =
    fitted && fitted->statistics().sahCost <= reuse.refitLimit * fitted->statistics().sahCostBuilt;
  return good ? fitted : nullptr;
}

std::shared_ptr<const Accelerator> SharedSurface::make(
  const BuildOptions& options, JobControl* control, const TreeReuse& reuse)
{
  if (!reuse.file.empty() && reuse.fileUse != TreeReuse::File::Save &&
    (reuse.fileUse == TreeReuse::File::Load || std::filesystem::exists(reuse.file)))
  {
    try
    {
      std::shared_ptr<const Accelerator> loaded =
        loadFile(reuse.file, this->input_.surface, options.threads, control);
      if (reuse.fileUse == TreeReuse::File::Load || options.structure == Structure::Auto ||
        loaded->options() == options)
      {
        return loaded;
      }
    }
    catch (const WrongSurface&)
    {
      if (reuse.fileUse == TreeReuse::File::Load)
      {
        throw;
      }
    }
  }
  if (std::shared_ptr<const Accelerator> fitted = this->refitted(options, control, reuse))
  {
    return fitted;
  }
  std::shared_ptr<const Accelerator> built = build(this->input_.surface, options, control);
  ++builds;
  return built;
}

std::shared_ptr<const Accelerator> SharedSurface::accelerator(
  const BuildOptions& options, JobControl* control, const TreeReuse& reuse)
{
  const auto existing = [&]
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    return this->find(options, reuse);
  };
  std::shared_ptr<const Accelerator> tree = existing();
  if (!tree)
  {
    const std::int64_t time = timeOf(reuse.file);
    const std::shared_ptr<const Accelerator> made = this->make(options, control, reuse);
    const std::lock_guard<std::mutex> lock(this->mutex_);
    tree = this->find(options, reuse);
    if (!tree)
    {
      const bool loaded = made->statistics().origin == Origin::Loaded;
      this->trees_.push_back({ options, made, loaded ? reuse.file : "", loaded ? time : 0 });
      tree = made;
    }
  }
  saveWhereAsked(*tree, reuse);
  return tree;
}

std::uint64_t acceleratorsBuilt()
{
  return builds.load();
}

} // namespace lumitree::filters
