// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RaysSort.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lumitree::benchmarks
{
namespace
{

/// The lowest 9 bits, two zeros between any two of them.
std::uint32_t spread(std::uint32_t x)
{
  x = (x | (x << 16)) & 0x030000FFu;
  x = (x | (x << 8)) & 0x0300F00Fu;
  x = (x | (x << 4)) & 0x030C30C3u;
  return (x | (x << 2)) & 0x09249249u;
}

} // namespace

const std::uint32_t* RayOrder::sort(const Rays& rays)
{
  const std::size_t count = rays.size();
  this->keyed_.resize(count);
  this->other_.resize(count);
  this->order_.resize(count);
  std::array<float, 3> lower;
  std::array<float, 3> upper;
  lower.fill(std::numeric_limits<float>::infinity());
  upper.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < 3 * count; i += 3)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      lower[k] = std::min(lower[k], rays.origins[i + k]);
      upper[k] = std::max(upper[k], rays.origins[i + k]);
    }
  }
  std::array<float, 3> scale;
  for (std::size_t k = 0; k < 3; ++k)
  {
    scale[k] = upper[k] > lower[k] ? 511.0f / (upper[k] - lower[k]) : 0.0f;
  }

  constexpr int digits = 3;
  constexpr std::uint32_t digitMask = 1023; // 3 bits of octant and 27 of place
  std::array<std::array<std::uint32_t, digitMask + 1>, digits> firsts{};
  for (std::size_t i = 0; i < count; ++i)
  {
    std::uint32_t key = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const float place = (rays.origins[3 * i + k] - lower[k]) * scale[k];
      key |= spread(static_cast<std::uint32_t>(place)) << k;
      key |= rays.directions[3 * i + k] < 0.0f ? 1u << (27 + k) : 0u;
    }
    this->keyed_[i] = { key, static_cast<std::uint32_t>(i) };
    for (std::size_t d = 0; d < digits; ++d)
    {
      ++firsts[d][(key >> (10 * d)) & digitMask];
    }
  }
  for (std::size_t d = 0; d < digits; ++d)
  {
    std::uint32_t sum = 0;
    for (std::uint32_t& first : firsts[d])
    {
      const std::uint32_t here = first;
      first = sum;
      sum += here;
    }
    for (const Keyed& ray : this->keyed_)
    {
      std::uint32_t& place = firsts[d][(ray.key >> (10 * d)) & digitMask];
      if (d + 1 < digits)
      {
        this->other_[place] = ray;
      }
      else
      {
        this->order_[place] = ray.ray;
      }
      ++place;
    }
    this->keyed_.swap(this->other_);
  }
  return this->order_.data();
}

} // namespace lumitree::benchmarks
