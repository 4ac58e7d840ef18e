// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeDivide_h
#define Lumitree_Accel_Structures_KdTreeDivide_h

#include "Accel/Structures/KdTreeSplitters.h"
#include "Accel/Surface.h"

namespace lumitree
{

/// Where a reference goes when its cell is divided.
enum class KdSide : std::uint32_t
{
  Below = 0,
  Above = 1,
  Both = 2 ///< in parts, of which one may be empty
};
[[nodiscard]] KdSide sideOf(const KdReference& reference, const KdSplit& split);

/// What a reference has inside a part of its cell, rounded outward; empty where that is nothing.
[[nodiscard]] Box partOf(const Surface& surface, const KdReference& reference, const Box& cell);

/// What reaches into the two parts of a cell.
struct KdSides
{
  std::vector<KdReference> below;
  std::vector<KdReference> above;
};

/// Divides the references of a cell by a plane. Order is kept, so references that ascend by id do
/// so on both sides.
[[nodiscard]] KdSides divideReferences(const Surface& surface, const Box& cell,
  const std::vector<KdReference>& references, const KdSplit& split);

} // namespace lumitree

#endif
