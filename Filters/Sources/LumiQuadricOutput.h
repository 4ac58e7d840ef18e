// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiQuadricOutput_h
#define LumiQuadricOutput_h

#include "vtkLumiABI.h"
#include "vtkType.h"

#include "LumiImplicitData.h"

#include "Accel/Quadric.h"

#include <memory>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkImplicitFunction;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Quadrics, and the point of an input that each was put at; no points without an input.
struct QuadricSet
{
  std::vector<Quadric> quadrics;
  std::vector<vtkIdType> points;
  /// Or an implicit, of a tree or of a function that is sampled.
  std::optional<Implicit> implicit;
  std::shared_ptr<const ImplicitTree> tree;
  vtkImplicitFunction* function = nullptr;
  bool isFunction = false;                ///< the shape is Function
  Guarantee guarantee = Guarantee::Exact; ///< what is promised of a function
};

/// Quadrics as pipeline data (LumiQuadrics.h): a vertex cell each, then the polygons that show
/// them. The input's point data goes to each quadric's points.
void makeOutput(
  const QuadricSet& set, vtkDataSet* input, int previewResolution, vtkPolyData* output);

} // namespace lumitree::filters
#endif
