// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BodyBoxOverlap_h
#define Lumitree_Accel_Structures_BodyBoxOverlap_h

#include "Accel/Surface.h"

namespace lumitree
{

/// False only where the quadric certainly has no point in the closed box, and none within 2^-30 of
/// its terms' magnitudes either: bounds of its forms over the part of the box in the clip box, by
/// their value and gradient in its middle and the signs of the squares. A box that the quadric
/// passes close by may be taken for met.
[[nodiscard]] bool mayMeet(const Quadric& quadric, const Box& box);

/// The same of an implicit, by the function's own bounds, and within 2^-30 of the coordinates. True
/// where it has no bounds and the boxes meet.
[[nodiscard]] bool mayMeet(const Implicit& implicit, const Box& box);

/// The same of whichever the primitive is; it is no triangle.
[[nodiscard]] bool mayMeet(const Surface& surface, PrimitiveId body, const Box& box);

/// False where it certainly has no point at all. Boxes that cannot be decided are halved, a few
/// times.
///@{
[[nodiscard]] bool mayHavePoints(const Quadric& quadric);
[[nodiscard]] bool mayHavePoints(const Implicit& implicit);
///@}

} // namespace lumitree

#endif
