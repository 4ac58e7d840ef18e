// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/RadixOrder.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lumitree
{
namespace
{

/// Fewer keys are sorted by comparing: a radix sort would look at its buckets for longer.
constexpr std::size_t leastRadix = 512;

} // namespace

const std::vector<std::uint32_t>& RadixOrder::sort(const std::vector<std::uint32_t>& keys, int bits)
{
  this->order_.resize(keys.size());
  if (keys.size() < leastRadix)
  {
    std::iota(this->order_.begin(), this->order_.end(), 0u);
    std::sort(this->order_.begin(), this->order_.end(),
      [&](std::uint32_t a, std::uint32_t b)
      { return std::tie(keys[a], a) < std::tie(keys[b], b); });
  }
  else
  {
    this->sortByRadix(keys, bits);
  }
  return this->order_;
}

void RadixOrder::sortByRadix(const std::vector<std::uint32_t>& keys, int bits)
{
  const int lowBits = (bits + 1) / 2;
  const std::uint32_t mask = (1u << lowBits) - 1;
  this->lowStarts_.assign((std::size_t{ 1 } << lowBits) + 1, 0);
  this->highStarts_.assign((std::size_t{ 1 } << (bits - lowBits)) + 1, 0);
  for (const std::uint32_t key : keys)
  {
    ++this->lowStarts_[(key & mask) + 1];
    ++this->highStarts_[(key >> lowBits) + 1];
  }
  std::partial_sum(this->lowStarts_.begin(), this->lowStarts_.end(), this->lowStarts_.begin());
  std::partial_sum(this->highStarts_.begin(), this->highStarts_.end(), this->highStarts_.begin());
  this->byLowBits_.resize(keys.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i)
  {
    this->byLowBits_[this->lowStarts_[keys[i] & mask]++] = i;
  }
  for (const std::uint32_t i : this->byLowBits_)
  {
    this->order_[this->highStarts_[keys[i] >> lowBits]++] = i;
  }
}

} // namespace lumitree
