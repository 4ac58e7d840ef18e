// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LUMITREE_DATA_RANDOM_H
#define LUMITREE_DATA_RANDOM_H

#include <cstdint>

namespace lumitree::data
{

/// The finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014): whole numbers only, hence the same everywhere.
inline std::uint64_t mixBits(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// SplitMix64.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : state_(mixBits(seed))
  {
  }

  /// Uniform in [0, 1).
  double uniform()
  {
    const std::uint64_t bits = mixBits(this->state_);
    this->state_ += 0x9e3779b97f4a7c15ull;
    return static_cast<double>(bits >> 11) * 0x1p-53;
  }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * this->uniform(); }
  /// Uniform in 0 .. count - 1.
  int index(int count) { return static_cast<int>(this->uniform() * count); }

private:
  std::uint64_t state_;
};

}

#endif
