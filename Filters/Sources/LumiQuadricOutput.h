// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiQuadricOutput_h
#define LumiQuadricOutput_h

#include "vtkLumiABI.h"
#include "vtkType.h"

#include "Accel/Quadric.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Quadrics, and the point of an input that each was put at; no points without an input.
struct QuadricSet
{
  std::vector<Quadric> quadrics;
  std::vector<vtkIdType> points;
};

/// Quadrics as pipeline data (LumiQuadrics.h): a vertex cell each, then the polygons that show
/// them. The input's point data goes to each quadric's points.
void makeOutput(
  const QuadricSet& set, vtkDataSet* input, int previewResolution, vtkPolyData* output);

} // namespace lumitree::filters
#endif
