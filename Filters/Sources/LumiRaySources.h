// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiRaySources_h
#define LumiRaySources_h

#include "Accel/Vec3.h"

#include "vtkDataObject.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// A point or cell of a surface that sends rays.
struct RaySource
{
  Vec3 position;
  Vec3 normal;         ///< unit
  Vec3 clear;          ///< unit; away from the cell's own plane, on the side of the normal
  double rounding = 0; ///< how far from the plane of a flat cell the position may be
  vtkIdType id = -1;   ///< point or cell id within the leaf dataset
  vtkIdType index = 0; ///< of points the id; of cells their place in the surface, which tells faces
                       ///< of one cell apart
  int compositeIndex = 0; ///< flat index of the leaf
};

struct RaySources
{
  std::vector<RaySource> list;
  std::uint64_t withoutNormal = 0; ///< left out: normal not defined, or a coordinate not finite
  std::uint64_t notDatasets = 0;   ///< leaves of a composite that have no surface: tables, graphs
};

/// Everything of an object that sends rays: all points of its surfaces, or else all cells; leaf by
/// leaf. What a surface, a normal and a ghost are is told by vtkLumiSurfaceRays.
RaySources collectRaySources(vtkDataObject* object, bool points);

}

#endif
