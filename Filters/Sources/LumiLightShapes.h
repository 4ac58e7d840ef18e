// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiLightShapes_h
#define LumiLightShapes_h

#include "vtkLumiABI.h"

#include "Accel/Vec3.h"
#include "Radiometry/Source.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/// What lights look like: geometry for an empty output, in double.
namespace lumitree::filters
{

/// A line of that length that ends at a point, in a direction of unit length.
void drawRay(vtkPolyData* output, const Vec3& end, const Vec3& direction, double length);

/// A vertex at the position, which is point 0, and around it the solid of intensities: in each
/// direction as far as the intensity there, the largest at that size; with the point array
/// `Intensity` in the light's unit. Nothing but the vertex where size is 0.
void drawIntensities(vtkPolyData* output, const Source& source, const Vec3& position,
  const Vec3& axis, double size, const char* arrayName);

void drawPoint(vtkPolyData* output, const Vec3& position);
void drawSphere(vtkPolyData* output, const Vec3& centre, double radius);
void drawDisk(vtkPolyData* output, const Vec3& centre, const Vec3& normal, double radius);
void drawTube(vtkPolyData* output, const Vec3& begin, const Vec3& end, double radius);
void drawLine(vtkPolyData* output, const Vec3& begin, const Vec3& end);
void drawQuad(vtkPolyData* output, const Vec3& origin, const Vec3& point1, const Vec3& point2);

/// A hemisphere around a place, with the radiance of a sky as a point array.
void drawSky(vtkPolyData* output, const Source& sky, const Vec3& up, const Vec3& anchor,
  double radius, const char* arrayName);

/// Whether all three are finite.
[[nodiscard]] bool isFinite3(const double* values);

} // namespace lumitree::filters
#endif
