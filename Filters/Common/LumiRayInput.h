// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiRayInput_h
#define LumiRayInput_h

#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include "vtkDataSet.h"

#include "Accel/Ray.h"

#include <array>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// The rays of a dataset, ready for a query. The batch looks into the dataset's arrays where they
/// are tightly packed floats or doubles; else into memory that is kept here. Valid as long as this
/// object.
struct RayInput
{
  RayBatch batch;
  vtkIdType size = 0;
  /// False: ray i is point i. True: ray i is segment i of the lines, in the cells' order.
  bool perCell = false;
  bool doublePoints = false; ///< whether origins are doubles (see Precision of points)

  std::vector<std::array<vtkIdType, 2>>
    segmentPoints;                     ///< perCell: first and second point of a segment
  std::vector<vtkIdType> segmentCells; ///< perCell: the line cell it is part of

  std::vector<std::shared_ptr<const void>> owners; ///< keep the batch's memory alive
};

/// Reads the rays in the three forms of the data model (Docs/data-model.md, Rays). tMin and tMax
/// hold where the dataset has no RayTMin or RayTMax; a segment's limits are the common part of
/// [tMin, tMax] and [0, 1]. Pass null or "" as direction array for the default, RayDirection;
/// another name must be there. On bad input: one vtkErrorMacro of the reporter, and false. An empty
/// dataset is no error.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT bool readRays(vtkDataSet* rays,
  const char* directionArray, double tMin, double tMax, RayInput& result, vtkAlgorithm* reporter);

} // namespace lumitree::filters
#endif
