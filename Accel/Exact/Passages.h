// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Passages_h
#define Lumitree_Accel_Exact_Passages_h

#include "Accel/Quadric.h"
#include "Accel/Ray.h"

#include <array>

namespace lumitree::exact
{

/// Whether the ray, moved by next to nothing (Moved.h), passes through the quadric at the lower (0)
/// and the upper root (1) of its form along the line: where the root is simple, its point in the
/// quadric and t between the limits. Where the quadric has a tree, the tree's sign must change
/// there; of forms that are 0 along with its own, only the first is taken to pass. All of it
/// decided on the stored numbers, taken as reals: some ten microseconds.
[[nodiscard]] std::array<bool, 2> movedPassages(const Ray& ray, const Quadric& quadric);

} // namespace lumitree::exact

#endif
