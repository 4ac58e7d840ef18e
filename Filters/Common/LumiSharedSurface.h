// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiSharedSurface_h
#define LumiSharedSurface_h

#include "LumiLeafTriangles.h"
#include "LumiSurfaceIndex.h"
#include "LumiSurfaceInput.h"

#include "Accel/Accelerator.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace lumitree::filters
{

/// One leaf's part of a surface.
struct SurfacePart
{
  LeafTriangles triangles;
  SurfaceLeaf leaf; ///< data only where it was gathered
};

/// What the filters of a process share: geometry, and the accelerators over it. It holds no dataset
/// of the pipeline, whose point and cell data may change while the geometry stays.
class SharedSurface : public std::enable_shared_from_this<SharedSurface>
{
public:
  /// Parts of quadrics come after those of triangles. `gathered`: the parts carry their datasets,
  /// whose cells are the triangles. Throws std::invalid_argument when there are too many points or
  /// triangles.
  SharedSurface(std::vector<SurfacePart> parts, bool gathered, int threads = 0);

  /// The surface as a filter sees it; it keeps this object, and so what the cache remembers.
  /// `leaves` are the current datasets, in the order of the parts; none when they were gathered.
  [[nodiscard]] std::shared_ptr<const SurfaceInput> input(
    const std::vector<vtkSmartPointer<vtkDataSet>>& leaves) const;

  /// An accelerator over the surface, the one that exists or a new one. Built without a lock:
  /// progress observers may run other filters meanwhile. Of two built at the same time the first
  /// one stays. Throws BuildStopped.
  [[nodiscard]] std::shared_ptr<const Accelerator> accelerator(
    const BuildOptions& options, JobControl* control = nullptr);

private:
  [[nodiscard]] std::shared_ptr<const Accelerator> find(const BuildOptions& options);

  SurfaceInput input_; ///< what does not change from user to user
  std::unique_ptr<const SurfaceIndex> index_;
  std::mutex mutex_;
  std::vector<std::pair<BuildOptions, std::weak_ptr<const Accelerator>>> trees_;
};

/// How many accelerators were built.
[[nodiscard]] std::uint64_t acceleratorsBuilt();

} // namespace lumitree::filters
#endif
