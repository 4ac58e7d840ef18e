// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/NetGrid.h"

namespace lumitree
{

void NetGrid::reset(int bits)
{
  if (bits < 0)
  {
    *this = {};
    return;
  }
  this->columnBits_ = (bits + 1) / 2;
  this->rowBits_ = bits / 2;
  this->columns_ = static_cast<double>(1u << this->columnBits_);
  this->rows_ = static_cast<double>(1u << this->rowBits_);
  this->stride_ = (std::size_t{ 1 } << this->rowBits_) + 2;
  this->lights_.assign(std::size_t{ 1 } << bits, 0.0f);
  this->states_.assign(this->stride_ * ((std::size_t{ 1 } << this->columnBits_) + 2), Nothing);
}

void NetGrid::compareNeighbours()
{
  // States are bits: what neighbours found is their union. The border adds none, and a cell where
  // nothing comes from neither.
  const std::size_t size = this->states_.size();
  const std::size_t stride = this->stride_;
  this->threes_.assign(size, 0);
  this->around_.assign(size, 0);
  const std::uint8_t* const states = this->states_.data();
  std::uint8_t* const threes = this->threes_.data();
  for (std::size_t i = 1; i + 1 < size; ++i)
  {
    threes[i] = static_cast<std::uint8_t>(states[i - 1] | states[i] | states[i + 1]);
  }
  std::uint8_t* const around = this->around_.data();
  for (std::size_t i = stride; i + stride < size; ++i)
  {
    around[i] = static_cast<std::uint8_t>(
      threes[i - stride] | threes[i + stride] | states[i - 1] | states[i + 1]);
  }
}

} // namespace lumitree
