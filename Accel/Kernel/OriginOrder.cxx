// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/OriginOrder.h"

#include <array>
#include <cmath>

namespace lumitree
{
namespace
{

/// Structures of 40 MB gained less than sorting costs, one of 66 MB lost a third of its time
/// (Docs/performance.md).
constexpr std::size_t leastMemory = std::size_t{ 48 } << 20;

constexpr int axisBits = 6;
constexpr int keyBits = 3 + 3 * axisBits;

/// Pairs of rays that are looked at before a batch is ordered.
constexpr std::size_t samples = 256;

/// The bits of a number, each followed by two 0.
constexpr std::array<std::uint32_t, 1 << axisBits> makeSpaced()
{
  std::array<std::uint32_t, 1 << axisBits> spaced{};
  for (unsigned i = 0; i < spaced.size(); ++i)
  {
    for (unsigned bit = 0; bit < axisBits; ++bit)
    {
      spaced[i] |= (i >> bit & 1u) << 3 * bit;
    }
  }
  return spaced;
}
constexpr auto spaced = makeSpaced();

/// Cells of the surface's box, of which origins outside take the nearest.
class Cells
{
public:
  explicit Cells(const Box& bounds)
    : lower_(bounds.lower)
  {
    const Vec3 size = bounds.size();
    for (int k = 0; k < 3; ++k)
    {
      this->perUnit_[k] = size[k] > 0.0 ? (1 << axisBits) / size[k] : 0.0;
    }
  }

  /// Octant, then cell. Of a ray that is not valid any.
  [[nodiscard]] std::uint32_t key(const Ray& ray) const
  {
    std::uint32_t key = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double at = (ray.origin[k] - this->lower_[k]) * this->perUnit_[k];
      // False for NaN, too.
      const int cell = at >= 1.0 ? static_cast<int>(std::min(at, last)) : 0;
      key |= spaced[static_cast<std::size_t>(cell)] << k;
      key |= (std::signbit(ray.direction[k]) ? 1u : 0u) << (3 * axisBits + k);
    }
    return key;
  }

private:
  static constexpr double last = (1 << axisBits) - 1;
  Vec3 lower_;
  Vec3 perUnit_{};
};

} // namespace

bool OriginOrder::pays(const RayBatch& rays, const Box& bounds, std::size_t memory)
{
  if (memory < leastMemory || rays.size < leastChunk)
  {
    return false;
  }
  // Cells of an eighth of the box: in them rays in some order stay for long.
  constexpr int coarse = 3 * (axisBits - 3);
  const Cells cells(bounds);
  const std::size_t step = rays.size / samples;
  std::size_t alike = 0;
  for (std::size_t i = 0; i < samples; ++i)
  {
    const std::uint32_t one = cells.key(rays[i * step]);
    const std::uint32_t next = cells.key(rays[i * step + 1]);
    alike += one >> coarse == next >> coarse ? 1 : 0;
  }
  return alike < samples / 2;
}

void OriginOrder::make(const RayBatch& rays, const Box& bounds, std::size_t begin, std::size_t end)
{
  const Cells cells(bounds);
  this->keys_.resize(end - begin);
  for (std::size_t i = begin; i < end; ++i)
  {
    this->keys_[i - begin] = cells.key(rays[i]);
  }
  this->rays_.clear();
  for (const std::uint32_t i : this->order_.sort(this->keys_, keyBits))
  {
    this->rays_.push_back(begin + i);
  }
}

} // namespace lumitree
