// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_TriangleBlock_h
#define Lumitree_Accel_Kernel_TriangleBlock_h

#include "Accel/LargeMemory.h"
#include "Accel/Surface.h"

#include <vector>

namespace lumitree
{

inline constexpr int blockWidth = 4;

/// Four triangles side by side, coordinates as the surface stores them (T is float or double).
/// Lanes without a triangle repeat the first one and have the id noPrimitive.
template <class T>
struct TriangleBlock
{
  T v[9][blockWidth]; ///< x, y, z of vertex 0, then of vertices 1 and 2
  PrimitiveId id[blockWidth];
  double
    edge; ///< no component of an edge of these triangles is larger, computed as stored - stored

  [[nodiscard]] std::array<Vec3, 3> corners(int lane) const
  {
    return { Vec3{ this->v[0][lane], this->v[1][lane], this->v[2][lane] },
      Vec3{ this->v[3][lane], this->v[4][lane], this->v[5][lane] },
      Vec3{ this->v[6][lane], this->v[7][lane], this->v[8][lane] } };
  }

  /// The vertices' coordinates along an axis.
  [[nodiscard]] std::array<double, 3> along(int axis, int lane) const
  {
    return { this->v[axis][lane], this->v[3 + axis][lane], this->v[6 + axis][lane] };
  }
};

/// The triangles of a structure's leaves, each leaf beginning with a block of its own.
template <class T>
class TriangleBlocks
{
public:
  /// Appends a leaf and returns the index of its first block.
  std::uint32_t append(const Surface& surface, const PrimitiveId* ids, std::size_t count)
  {
    const auto first = static_cast<std::uint32_t>(this->blocks_.size());
    for (std::size_t i = 0; i < count; i += blockWidth)
    {
      this->blocks_.push_back(pack(surface, ids + i, count - i));
    }
    return first;
  }

  /// Makes room for so many blocks in all, to be put.
  void resize(std::size_t blocks) { this->blocks_.resize(blocks); }

  /// Writes a leaf from a block on. From several threads, if leaves do not overlap.
  void put(std::uint32_t first, const Surface& surface, const PrimitiveId* ids, std::size_t count)
  {
    for (std::size_t i = 0; i < count; i += blockWidth)
    {
      this->blocks_[first + i / blockWidth] = pack(surface, ids + i, count - i);
    }
  }

  [[nodiscard]] const TriangleBlock<T>& operator[](std::size_t i) const { return this->blocks_[i]; }

  [[nodiscard]] std::size_t memory() const
  {
    return this->blocks_.capacity() * sizeof(TriangleBlock<T>);
  }

  void reserve(std::size_t blocks) { this->blocks_.reserve(blocks); }

private:
  static TriangleBlock<T> pack(
    const Surface& surface, const PrimitiveId* ids, std::size_t available)
  {
    TriangleBlock<T> block;
    block.edge = 0.0;
    for (std::size_t lane = 0; lane < blockWidth; ++lane)
    {
      const bool used = lane < available;
      const PrimitiveId id = ids[used ? lane : 0];
      const auto vertices = surface.vertices(id);
      block.id[lane] = used ? id : noPrimitive;
      for (int i = 0; i < 3; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          block.v[3 * i + k][lane] = static_cast<T>(vertices[i][k]);
          const double edge = std::fabs(vertices[(i + 1) % 3][k] - vertices[i][k]);
          block.edge = edge > block.edge ? edge : block.edge;
        }
      }
    }
    return block;
  }

  std::vector<TriangleBlock<T>, LargeMemory<TriangleBlock<T>>> blocks_;
};

} // namespace lumitree

#endif
