// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_Sobol_h
#define Lumitree_Radiometry_Estimate_Sobol_h

#include <array>
#include <cstdint>

namespace lumitree
{

/// The first two dimensions of the Sobol sequence in random order, Owen-scrambled by hashing
/// (B. Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020). Each seed is another
/// randomisation: unbiased, and any first 2^k points of it are a (0, k, 2)-net.
class Sobol
{
public:
  explicit Sobol(std::uint64_t seed)
    : order_(static_cast<std::uint32_t>(mix(seed)))
    , x_(static_cast<std::uint32_t>(mix(seed + 1)))
    , y_(static_cast<std::uint32_t>(mix(seed + 2)))
  {
  }

  /// Point i of the unit square, each coordinate in (0, 1).
  [[nodiscard]] std::array<double, 2> operator()(std::uint32_t i) const
  {
    const std::uint32_t index = scramble(i, this->order_);
    // Reversed bits of the first dimension are the index itself.
    const std::uint32_t x = reverse(hash(index, this->x_));
    const std::uint32_t y = reverse(hash(reversedSecond(index), this->y_));
    return { (x + 0.5) * 0x1p-32, (y + 0.5) * 0x1p-32 };
  }

  /// A number from which others with no visible relation come for each stream (SplitMix64).
  [[nodiscard]] static std::uint64_t mix(std::uint64_t x)
  {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

private:
  static std::uint32_t reverse(std::uint32_t x)
  {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    x = (x >> 8 & 0x00ff00ffu) | (x & 0x00ff00ffu) << 8;
    return x >> 16 | x << 16;
  }

  /// Each bit is flipped by a hash of those below it (Burley, section 4; constants of N. Vegdahl).
  static std::uint32_t hash(std::uint32_t x, std::uint32_t seed)
  {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
  }

  static std::uint32_t scramble(std::uint32_t x, std::uint32_t seed)
  {
    return reverse(hash(reverse(x), seed));
  }

  /// The second dimension, its bits reversed: a product with Pascal's triangle modulo 2, whose
  /// powers of two are shifts (A. G. M. Ahmed, An Implementation Algorithm of 2D Sobol Sequence,
  /// Fast, Elegant, and Compact, EGSR 2024).
  static std::uint32_t reversedSecond(std::uint32_t x)
  {
    x ^= x >> 16;
    x ^= (x & 0xff00ff00u) >> 8;
    x ^= (x & 0xf0f0f0f0u) >> 4;
    x ^= (x & 0xccccccccu) >> 2;
    return x ^ (x & 0xaaaaaaaau) >> 1;
  }

  std::uint32_t order_;
  std::uint32_t x_;
  std::uint32_t y_;
};

} // namespace lumitree

#endif
