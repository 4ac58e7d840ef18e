// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiRandom.h"

namespace
{

std::uint32_t reverseBits(std::uint32_t x)
{
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

std::uint32_t sobolSecond(std::uint32_t k)
{
  std::uint32_t result = 0;
  for (std::uint32_t v = 0x80000000u; k != 0; k >>= 1, v ^= v >> 1)
  {
    result ^= (k & 1u) != 0 ? v : 0u;
  }
  return result;
}

/// Laine and Karras: a bit is flipped depending on the bits below it, which is Owen's scrambling of
/// the reversed number.
std::uint32_t owenScramble(std::uint32_t x, std::uint32_t seed)
{
  x = reverseBits(x) + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reverseBits(x);
}

/// The middle of the 2^-32 wide cell, so that neither 0 nor 1 occurs.
double toUnit(std::uint32_t x)
{
  return (static_cast<double>(x) + 0.5) * 0x1p-32;
}

}

namespace lumitree::filters
{

std::array<double, 2> scrambledSobol(std::uint32_t k, std::uint64_t scramble)
{
  return { toUnit(owenScramble(reverseBits(k), static_cast<std::uint32_t>(scramble))),
    toUnit(owenScramble(sobolSecond(k), static_cast<std::uint32_t>(scramble >> 32))) };
}

}
