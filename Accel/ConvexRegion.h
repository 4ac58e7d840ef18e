// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_ConvexRegion_h
#define Lumitree_Accel_ConvexRegion_h

#include "Accel/Vec3.h"

#include <vector>

namespace lumitree
{

/// The points x with normal · x <= offset. The normal is of any length: 0 makes it all of space
/// (offset >= 0) or nothing. The offset may be infinite.
struct HalfSpace
{
  Vec3 normal = { 0.0, 0.0, 0.0 };
  double offset = 0.0;
};

/// The points that lie in every half-space; without any, all of space. It may be unbounded, and
/// empty.
using ConvexRegion = std::vector<HalfSpace>;

} // namespace lumitree

#endif
