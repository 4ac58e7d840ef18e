// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeClip_h
#define Lumitree_Accel_Structures_KdTreeClip_h

#include "Accel/Box.h"

namespace lumitree
{

/// A box that holds the part of a triangle inside a closed cell, rounded outward; empty only if
/// there is no such part. Coordinates that no cut changes stay exact, so that what lies on one side
/// of a plane is not taken to reach across it.
[[nodiscard]] Box clippedBounds(const std::array<Vec3, 3>& triangle, const Box& cell);

/// The box common to both; empty if they share no point.
[[nodiscard]] Box commonBox(const Box& a, const Box& b);

} // namespace lumitree

#endif
