// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhBuilder_h
#define Lumitree_Accel_Structures_BvhBuilder_h

#include "Accel/BuildOptions.h"
#include "Accel/BuildProgress.h"
#include "Accel/Structures/BvhNodes.h"
#include "Accel/Surface.h"

#include <functional>

namespace lumitree
{

/// A primitive while a hierarchy is built.
struct BuildReference
{
  Box box;
  Vec3 centre;
  PrimitiveId id;
};

/// How a node's references were divided: [begin, middle) and [middle, end).
struct BvhSplit
{
  BuildReference* middle = nullptr; ///< null: do not divide
  int axis = -1;
};

/// Divides the references of a node by reordering them; both sides hold at least one.
using BvhSplitter =
  std::function<BvhSplit(const Box& bounds, BuildReference* begin, BuildReference* end)>;

/// The textbook's split: along the longest axis of the node's box, at the object in the middle.
/// Leaves hold up to leafSize.
[[nodiscard]] BvhSplitter medianSplitter(int leafSize);

/// The surface-area heuristic over 16 bins of the centres on each axis (Wald 2007). Where no plane
/// parts the centres, the object in the middle does.
[[nodiscard]] BvhSplitter binnedSahSplitter(int leafSize);

/// Divides from the root on until the splitter stops or maxDepth is reached. Deterministic.
[[nodiscard]] BvhNodes buildBvhNodes(
  const Surface& surface, const BvhSplitter& split, int maxDepth, BuildProgress& progress);

} // namespace lumitree

#endif
