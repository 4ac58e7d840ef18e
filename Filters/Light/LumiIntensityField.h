// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiIntensityField_h
#define LumiIntensityField_h

#include "vtkLumiABI.h"

#include "Accel/Vec3.h"
#include "Radiometry/PhotometricWeb.h"
#include "Radiometry/Quantities.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkPolyData;
class vtkTable;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Intensity over a sphere of directions, and what the filter gives of it.
struct IntensityField
{
  PhotometricWeb web;           ///< planes 0 … 360 degrees, both ends the same
  std::vector<Vec3> directions; ///< as its intensities
  LightSystem system = LightSystem::Radiometric;
  double emittedFlux = 0.0;
  double farField = 0.0; ///< 0: not known

  /// Planes and steps of gamma around an axis; gamma is 0 along it, and C is 0 at the reference.
  /// Throws std::exception where these are 0 or parallel. No intensities yet.
  void setDirections(const Vec3& axis, const Vec3& reference, int planes, int steps);

  /// Fluxes and the distance of the far field, as field data.
  void addNumbers(vtkDataObject* object) const;

  /// The photometric solid, its farthest point at that distance.
  void fillSolid(const Vec3& centre, double radius, vtkPolyData* solid) const;

  /// A row for each gamma, a column for each plane.
  void fillTable(vtkTable* table) const;

private:
  [[nodiscard]] int planes() const { return static_cast<int>(this->web.horizontals.size()) - 1; }
};

} // namespace lumitree::filters
#endif
