// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_RaysFixtures_h
#define Lumitree_Testing_RaysFixtures_h

#include "vtkLumiRayAlgorithm.h"

#include "Data/Scenes.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace lumitree::testing
{

using Point = std::array<double, 3>;

struct TestRay
{
  Point origin;
  Point direction;
};

/// The polygons of a generated scene, with points of type VTK_FLOAT or VTK_DOUBLE.
vtkSmartPointer<vtkPolyData> polyData(const data::Mesh& mesh, int pointType = VTK_DOUBLE);

/// Triangles over points given one after the other.
vtkSmartPointer<vtkPolyData> triangles(const std::vector<Point>& corners);

/// Rays from a sphere of that radius about the origin to points within the unit ball: most meet a
/// surface there, some do not.
std::vector<TestRay> raysAtUnitBall(int count, double radius = 3.0, std::uint64_t seed = 1);

/// The three forms.
///@{
vtkSmartPointer<vtkPolyData> pointRays(
  const std::vector<TestRay>& rays, int pointType = VTK_DOUBLE, int directionType = VTK_DOUBLE);
vtkSmartPointer<vtkImageData> imageRays(const std::vector<TestRay>& rays, int width);
vtkSmartPointer<vtkPolyData> lineRays(const std::vector<TestRay>& rays, double length);
///@}

/// Counts the errors and warnings of a filter and of what runs it, and keeps the last text.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* filter);
  ~Messages();
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  int errors = 0;
  int warnings = 0;
  std::string text;

private:
  struct Link;
  std::vector<Link> links_;
};

/// Whether two arrays have the same name, type, shape and bits.
bool sameBits(vtkAbstractArray* a, vtkAbstractArray* b);
/// Whether two sets of arrays have the same arrays in the same order.
bool sameBits(vtkFieldData* a, vtkFieldData* b);

/// "name type components", as the data model lists an array; "" when it is not there.
std::string shape(vtkFieldData* data, const char* name);

double value(vtkFieldData* data, const char* name, vtkIdType tuple, int component = 0);

} // namespace lumitree::testing

#endif
