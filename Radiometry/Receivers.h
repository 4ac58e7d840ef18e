// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Receivers_h
#define Lumitree_Radiometry_Receivers_h

#include "Accel/Ray.h"

#include <cstddef>

namespace lumitree
{

/// Places where light is measured, in the caller's memory; nothing is copied.
struct Receivers
{
  std::size_t size = 0;
  ArrayView positions; ///< size triples, in units of the coordinates

  /// size unit vectors: irradiance on their side. Left out: scalar irradiance, from all sides
  /// alike. A normal that is not finite marks a receiver that has no value.
  ArrayView normals;

  /// What the coordinates were stored as before they came here: positions computed in double from
  /// points stored as float are Float.
  ArrayView::Scalar stored = ArrayView::Scalar::Double;

  /// Primitives that do not shadow a receiver: the cells it lies on. One set per receiver, or
  /// setOfRay names the set of each.
  SkipSets skip;
};

} // namespace lumitree

#endif
