// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_LeafBlocks_h
#define Lumitree_Accel_Kernel_LeafBlocks_h

#include "Accel/Kernel/TriangleBlock.h"

#include <variant>

namespace lumitree
{

/// Blocks of the surface's own scalar type.
using LeafBlocks = std::variant<TriangleBlocks<float>, TriangleBlocks<double>>;

[[nodiscard]] inline LeafBlocks makeLeafBlocks(const Surface& surface)
{
  if (surface.scalar() == ArrayView::Scalar::Float)
  {
    return TriangleBlocks<float>{};
  }
  return TriangleBlocks<double>{};
}

/// Primitive i of the leaf that begins with that block.
[[nodiscard]] inline PrimitiveId primitiveAt(
  const LeafBlocks& blocks, std::uint32_t firstBlock, std::uint32_t i)
{
  return std::visit([&](const auto& store)
    { return store[firstBlock + i / blockWidth].id[i % blockWidth]; },
    blocks);
}

} // namespace lumitree

#endif
