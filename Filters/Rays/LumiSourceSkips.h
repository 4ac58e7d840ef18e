// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiSourceSkips_h
#define Lumitree_Filters_Rays_LumiSourceSkips_h

#include "LumiRayInput.h"
#include "LumiSurfaceInput.h"

#include "vtkDataSet.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// What rays that leave a surface must not hit: the cell they start in, the cells around the point
/// they start at.
struct SourceSkips
{
  std::vector<std::uint64_t> offsets; ///< rays + 1
  std::vector<PrimitiveId> primitives;

  [[nodiscard]] SkipSets sets() const
  {
    return { nullptr, this->offsets.data(), this->primitives.data() };
  }
};

/// Reads SourceCellId, SourcePointId and SourceCompositeIndex (Docs/data-model.md, Rays) of each
/// ray; ids are those of this rank's pieces. Ids of no cell or point skip nothing. False after one
/// vtkErrorMacro of the reporter: the rays have neither id, or one with several components.
[[nodiscard]] bool readSourceSkips(vtkDataSet* dataset, const RayInput& rays,
  const SurfaceInput& surface, int process, int threads, SourceSkips& skips,
  vtkAlgorithm* reporter);

} // namespace lumitree::filters

#endif
