// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiPoints_h
#define LumiPoints_h

#include "vtkDataArray.h"

#include "Accel/Surface.h"

#include <memory>

namespace lumitree::filters
{

/// A view of an array that is tightly packed floats or doubles; empty for any other.
[[nodiscard]] ArrayView viewOf(vtkDataArray* array);

/// The values of an array, and what keeps them alive.
struct Values
{
  ArrayView view;
  std::shared_ptr<const void> owner;
};

/// The values of an array where they are if they can be viewed, else a copy: of floats for a float
/// array, of doubles for any other.
[[nodiscard]] Values valuesOf(vtkDataArray* array);

/// An array of three components as points, its memory shared where that can be. Null gives no
/// points.
[[nodiscard]] PointArray pointsOf(vtkDataArray* array);

} // namespace lumitree::filters
#endif
