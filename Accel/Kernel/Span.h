// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_Span_h
#define Lumitree_Accel_Kernel_Span_h

#include <cstdint>

namespace lumitree
{

/// What a structure's walk hands to its visitor at a leaf.
///
/// The contract of a structure is one function,
///
///     template <class Visitor> void walk(const RayBox&, Visitor&) const;
///
/// which calls visitor.node(i) for each node it enters, visitor.cell() for each grid cell it steps
/// through, and tStop = visitor.leaf(span) for each leaf; visitor.tStop() is the bound before the
/// first leaf. The spans visited are a superset of the leaves that the closed segment meets.
/// Revisits are allowed. A leaf is skipped only when its tEnter > tStop, so no structure ever
/// decides that a hit "belongs" to a cell.
struct Span
{
  std::uint32_t firstBlock = 0; ///< first block of four primitives
  std::uint32_t count = 0;      ///< primitives, from lane 0 of the first block on
  double tEnter = 0.0;          ///< certified lower bound of t inside the leaf
};

} // namespace lumitree

#endif
