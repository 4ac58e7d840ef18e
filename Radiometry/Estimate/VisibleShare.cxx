// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/VisibleShare.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lumitree
{

namespace
{

/// Half the interval over the standard deviation of pairs, which is mostly more than the error:
/// Docs/radiometry.md says how often intervals cover the truth with it.
constexpr double width = 1.65;

/// Cells of the first grid, of the largest with which to begin, and of the largest: longer
/// sequences cast all rays.
///@{
constexpr int leastBits = 6;
constexpr int mostFirstBits = 15;
constexpr int mostBits = 17;
///@}

/// Parts of half the interval sought that the gaps, and the light of what is found alone, may be
/// for rays to be left out.
///@{
constexpr double mostGap = 0.5;
constexpr double mostAlone = 0.1;
///@}

} // namespace

void VisibleShare::startWith(double share, std::uint32_t most)
{
  int bits = leastBits;
  while (
    share * this->end_ < width && std::uint64_t{ this->end_ } * 2 <= most && bits < mostFirstBits)
  {
    this->end_ *= 2;
    ++bits;
  }
  this->full_ = this->end_;
  this->now_.reset(bits);
}

bool VisibleShare::takeOver(const std::array<double, 2>& point, std::uint32_t& slot)
{
  slot = this->now_.empty() ? 0 : this->now_.cell(point);
  if (this->begin_ > 0 && !this->now_.empty())
  {
    const std::uint32_t cell = this->now_.parent(slot);
    const NetGrid::State state = this->before_.state(cell);
    const float light = this->before_.light(cell);
    this->now_.set(this->now_.twin(slot), state, light);
    if (this->sparing_ && state != NetGrid::Nothing)
    {
      const NetGrid::State agreed = this->before_.agreed(cell);
      if (agreed != NetGrid::Nothing)
      {
        this->addLight(slot, light);
        if (state == NetGrid::Hidden)
        {
          this->hide(slot, light);
        }
        if (state != agreed)
        {
          this->takenAlone_ += 4.0 * light * light;
        }
        return true;
      }
    }
  }
  ++this->cast_;
  return false;
}

void VisibleShare::addLight(std::uint32_t slot, double light)
{
  this->all_ += light;
  if (!this->now_.empty())
  {
    this->now_.set(slot, NetGrid::Lit, static_cast<float>(light));
  }
}

void VisibleShare::hide(std::uint32_t slot, double light)
{
  this->hidden_ += light;
  if (!this->now_.empty())
  {
    this->now_.set(slot, NetGrid::Hidden, static_cast<float>(light));
  }
}

void VisibleShare::judge()
{
  if (this->now_.empty())
  {
    return;
  }
  const double share = this->hiddenShare();
  const auto off = [&](std::uint32_t cell)
  {
    const double hidden = this->now_.state(cell) == NetGrid::Hidden ? 1.0 : 0.0;
    return this->now_.light(cell) * (hidden - share);
  };
  this->now_.compareNeighbours();
  double pairs = 0.0;
  double squares = 0.0;
  this->alone_ = 0.0;
  for (std::uint32_t cell = 0; cell < this->now_.size(); ++cell)
  {
    const std::uint32_t twin = this->now_.twin(cell);
    if (cell < twin)
    {
      const double difference = off(cell) - off(twin);
      pairs += difference * difference;
    }
    const NetGrid::State state = this->now_.state(cell);
    const NetGrid::State agreed = this->now_.agreed(cell);
    if (state != agreed && state != NetGrid::Nothing && agreed != NetGrid::Nothing)
    {
      const double light = this->now_.light(cell);
      squares += light * light;
      this->alone_ += light;
    }
  }
  this->perPoint_ = (pairs + squares + this->takenAlone_) / this->end_;
}

double VisibleShare::halfWidth()
{
  this->judge();
  // Points that agree say nothing about what is smaller than the gaps between all rays: one more
  // that differs.
  const double gap = 1.0 / this->full_;
  const double deviation =
    this->all_ > 0.0 ? std::sqrt(this->perPoint_ * this->end_) / this->all_ : 0.0;
  return width * std::hypot(deviation, gap);
}

bool VisibleShare::canSpare(double sought) const
{
  return !this->now_.empty() && !this->before_.empty() && 1.0 / this->full_ <= mostGap * sought &&
    this->alone_ <= mostAlone * sought * this->all_;
}

void VisibleShare::goOn(double sought)
{
  this->begin_ = this->end_;
  this->end_ *= 2;
  std::swap(this->before_, this->now_);
  const int bits = this->before_.bits() + 1;
  this->now_.reset(this->before_.empty() || bits > mostBits ? -1 : bits);
  this->sparing_ = this->canSpare(sought);
  if (!this->sparing_)
  {
    this->full_ = this->cast_ == this->begin_ ? this->end_ : this->begin_;
  }
}

} // namespace lumitree
