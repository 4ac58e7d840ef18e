// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiRandom_h
#define LumiRandom_h

#include "Data/Random.h"

#include <array>
#include <cstdint>

namespace lumitree::filters
{

/// The hash of (seed, i, stream): a ray's numbers depend on its index alone, so that any split into
/// pieces or threads gives the same rays.
inline std::uint64_t hashOf(std::uint64_t seed, std::uint64_t i, std::uint64_t stream)
{
  return data::mixBits(data::mixBits(data::mixBits(seed) ^ i) ^ stream);
}

/// Uniform in [0, 1), a function of (seed, i, stream).
inline double uniformOf(std::uint64_t seed, std::uint64_t i, std::uint64_t stream)
{
  return static_cast<double>(hashOf(seed, i, stream) >> 11) * 0x1p-53;
}

/// Point k of the two-dimensional Sobol sequence with Owen's scrambling, each coordinate in (0, 1).
/// Any 2^m points from a multiple of 2^m on have one point in each of the boxes 2^-a x 2^-b with
/// a + b = m; different scrambles are independent. Source: Burley, "Practical hash-based Owen
/// scrambling", Journal of Computer Graphics Techniques 9(4), 2020, listings 2 and 3.
std::array<double, 2> scrambledSobol(std::uint32_t k, std::uint64_t scramble);

}

#endif
