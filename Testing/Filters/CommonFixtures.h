// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_CommonFixtures_h
#define Lumitree_Testing_CommonFixtures_h

#include "LumiCache.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <string>
#include <vector>

/// Stands for a filter: takes errors and warnings and remembers them.
class Reporter
{
public:
  Reporter();
  ~Reporter();

  vtkAlgorithm* algorithm() { return this->algorithm_; }

  int errors = 0;
  std::string text; ///< of all errors and warnings

private:
  void remember(vtkObject*, unsigned long event, void* message);
  vtkNew<vtkSphereSource> algorithm_;
};

using Cell = std::vector<vtkIdType>;

/// Polygons over points, given as float or double (`type`: VTK_FLOAT, VTK_DOUBLE).
vtkSmartPointer<vtkPolyData> polygons(
  const std::vector<lumitree::Vec3>& points, const std::vector<Cell>& cells, int type = VTK_DOUBLE);

/// A regular polygon mesh: n × n squares in the plane z = height, unit spacing.
vtkSmartPointer<vtkPolyData> squares(int n, double height = 0.0, int type = VTK_DOUBLE);

/// An image of nx × ny × nz unit voxels.
vtkSmartPointer<vtkImageData> voxels(int nx, int ny, int nz);

/// A ghost array of the cells with these values.
void setGhosts(vtkDataSet* data, const std::vector<int>& values);

/// The cells of all primitives, in their order.
std::vector<std::int64_t> cellsOf(const lumitree::filters::SurfaceInput& input);

/// Twice the area vector of a primitive.
lumitree::Vec3 areaVector(const lumitree::Surface& surface, lumitree::PrimitiveId primitive);

/// The area of all primitives.
double surfaceArea(const lumitree::filters::SurfaceInput& input);

/// Expects that every vertex of every primitive is the point that its leaf says it is, a point of
/// the cell.
void expectMapsBack(const lumitree::filters::SurfaceInput& input);

/// The surface of one rank, which must come without an error.
std::shared_ptr<const lumitree::filters::SurfaceInput> surfaceOf(vtkDataObject* data);

#endif
