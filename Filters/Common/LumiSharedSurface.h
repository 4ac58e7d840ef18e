// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiSharedSurface_h
#define LumiSharedSurface_h

#include "LumiLeafTriangles.h"
#include "LumiSurfaceIndex.h"
#include "LumiSurfaceInput.h"

#include "Accel/Accelerator.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace lumitree::filters
{

/// One leaf's part of a surface.
struct SurfacePart
{
  LeafTriangles triangles;
  SurfaceLeaf leaf; ///< data only where it was gathered
};

/// Which structures may be used in place of one built from nothing.
struct TreeReuse
{
  enum class File
  {
    LoadOrBuild = 0, ///< loaded where the file is of this surface; saved where there is no file
    Load = 1,        ///< whatever options were asked for; an error where it cannot be loaded
    Save = 2         ///< what was built is saved, over a structure saved before
  };

  /// Refit `before` where it was asked for with the same options, its surface has the same
  /// triangles and as many quadrics, and its cost does not exceed `refitLimit` times that when its
  /// nodes were built. Else, and of others, refitted accelerators are passed by.
  ///@{
  bool refit = false;
  std::shared_ptr<const Accelerator> before;
  BuildOptions beforeAsked;
  std::string beforeFile;
  double refitLimit = 2.0;
  ///@}

  std::string file; ///< empty: none
  File fileUse = File::LoadOrBuild;
  bool mayWrite = true; ///< of several ranks one writes
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

  /// An accelerator over the surface: the one that exists, one loaded or refitted, or a new one.
  /// Throws SaveError where a file is to be loaded or written and cannot be, and is no saved
  /// structure. Built without a lock:
  /// progress observers may run other filters meanwhile. Of two built at the same time the first
  /// one stays. Throws BuildStopped.
  [[nodiscard]] std::shared_ptr<const Accelerator> accelerator(
    const BuildOptions& options, JobControl* control = nullptr, const TreeReuse& reuse = {});

private:
  /// An accelerator, what was asked for, and where it was loaded from.
  struct Entry
  {
    BuildOptions asked;
    std::weak_ptr<const Accelerator> tree;
    std::string file;
    std::int64_t fileTime = 0;
  };

  [[nodiscard]] std::shared_ptr<const Accelerator> find(
    const BuildOptions& options, const TreeReuse& reuse);
  [[nodiscard]] std::shared_ptr<const Accelerator> make(
    const BuildOptions& options, JobControl* control, const TreeReuse& reuse);
  [[nodiscard]] std::shared_ptr<const Accelerator> refitted(
    const BuildOptions& options, JobControl* control, const TreeReuse& reuse) const;

  SurfaceInput input_; ///< what does not change from user to user
  std::unique_ptr<const SurfaceIndex> index_;
  std::mutex mutex_;
  std::vector<Entry> trees_;
};

/// How many accelerators were built, neither refitted nor loaded.
[[nodiscard]] std::uint64_t acceleratorsBuilt();

} // namespace lumitree::filters
#endif
