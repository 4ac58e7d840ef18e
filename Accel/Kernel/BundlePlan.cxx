// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Kernel/BundlePlan.h"

#include "Accel/Kernel/RayBundle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lumitree
{
namespace
{

/// Fewer rays of one sector go alone: what they share would not pay for itself.
constexpr std::uint32_t leastBundle = 16;

/// A tile of directions wider than this is not tried: it sees too much of any surface.
constexpr float widestSpread = 0.25f;

/// Sums of a direction's components that floats hold with all their digits. Others go alone.
///@{
constexpr double smallestSize = 0x1p-100;
constexpr double largestSize = 0x1p100;
///@}

constexpr int cellBits = 7; ///< per direction of a face
constexpr int sectorBits = 5;

/// The bits of a number, each followed by a 0.
constexpr std::array<std::uint16_t, 1 << cellBits> makeSpaced()
{
  std::array<std::uint16_t, 1 << cellBits> spaced{};
  for (unsigned i = 0; i < spaced.size(); ++i)
  {
    for (unsigned bit = 0; bit < cellBits; ++bit)
    {
      spaced[i] = static_cast<std::uint16_t>(spaced[i] | ((i >> bit & 1u) << 2 * bit));
    }
  }
  return spaced;
}
constexpr auto spaced = makeSpaced();

template <class T>
std::size_t endOfRun(const void* data, std::size_t first, std::size_t end)
{
  const T* const points = static_cast<const T*>(data);
  const T* const p = points + 3 * first;
  std::size_t i = first + 1;
  while (i < end && std::equal(p, p + 3, points + 3 * i))
  {
    ++i;
  }
  return i;
}

/// The end of the rays from first on that start where it does.
std::size_t endOfRun(const ArrayView& origins, std::size_t first, std::size_t end)
{
  return origins.type == ArrayView::Scalar::Float ? endOfRun<float>(origins.data, first, end)
                                                  : endOfRun<double>(origins.data, first, end);
}

} // namespace

bool BundlePlan::mayPay(const RayBatch& rays)
{
  const std::size_t asked = leastBundle;
  return rays.size >= asked && endOfRun(rays.origins, 0, asked) == asked;
}

void BundlePlan::make(const RayBatch& rays, std::size_t begin, std::size_t end)
{
  this->begin_ = begin;
  this->order_.clear();
  this->bundles_.clear();
  this->alone_.clear();
  for (std::size_t first = begin; first < end;)
  {
    const std::size_t last = endOfRun(rays.origins, first, end);
    this->addRun(rays, first, last);
    first = last;
  }
}

void BundlePlan::addRun(const RayBatch& rays, std::size_t first, std::size_t last)
{
  if (last - first < leastBundle || !isValid(Ray{ rays.origins.triple(first) }))
  {
    for (std::size_t i = first; i < last; ++i)
    {
      this->alone_.push_back(i);
    }
    return;
  }
  if (rays.directions.type == ArrayView::Scalar::Float)
  {
    this->place(static_cast<const float*>(rays.directions.data), rays, first, last);
  }
  else
  {
    this->place(static_cast<const double*>(rays.directions.data), rays, first, last);
  }
  this->sort();
  this->cut();
}

template <class T>
void BundlePlan::place(
  const T* directions, const RayBatch& rays, std::size_t first, std::size_t last)
{
  const bool ownLimits = rays.tMins || rays.tMaxs;
  const bool limits = rays.tMin <= rays.tMax;
  this->places_.resize(last - first);
  std::size_t count = 0;
  this->low_ = 1.0f;
  this->high_ = -1.0f;
  for (std::size_t i = first; i < last; ++i)
  {
    const T* const d = directions + 3 * i;
    const double x = std::fabs(static_cast<double>(d[0]));
    const double y = std::fabs(static_cast<double>(d[1]));
    const double z = std::fabs(static_cast<double>(d[2]));
    const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    const double size = std::max(x, std::max(y, z));
    // Also false where a component is not a number.
    const bool valid = x + y + z >= smallestSize && x + y + z <= largestSize &&
      (ownLimits ? isValid(rays[i]) : limits);
    if (!valid)
    {
      this->alone_.push_back(i);
      continue;
    }
    const auto scale = static_cast<float>(1.0 / size);
    Place& p = this->places_[count++];
    p.u = static_cast<float>(d[axis == 0 ? 1 : 0]) * scale;
    p.v = static_cast<float>(d[axis == 2 ? 1 : 2]) * scale;
    p.ray = static_cast<std::uint32_t>(i - this->begin_);
    p.sector = static_cast<std::uint32_t>((std::signbit(d[0]) ? 1 : 0) |
      (std::signbit(d[1]) ? 2 : 0) | (std::signbit(d[2]) ? 4 : 0) | (axis << 3));
    this->low_ = std::min(this->low_, std::min(p.u, p.v));
    this->high_ = std::max(this->high_, std::max(p.u, p.v));
  }
  this->places_.resize(count);
}

void BundlePlan::sort()
{
  const float cells =
    static_cast<float>((1 << cellBits) - 1) / std::max(this->high_ - this->low_, 1e-6f);
  this->keys_.clear();
  for (const Place& p : this->places_)
  {
    const auto cell = [&](float at) { return static_cast<unsigned>((at - this->low_) * cells); };
    this->keys_.push_back(p.sector << 2 * cellBits |
      static_cast<std::uint32_t>(spaced[cell(p.u)] | spaced[cell(p.v)] << 1));
  }
  this->sorted_.clear();
  for (const std::uint32_t i : this->byKey_.sort(this->keys_, 2 * cellBits + sectorBits))
  {
    this->sorted_.push_back(this->places_[i]);
  }
  this->places_.swap(this->sorted_);
}

void BundlePlan::cut()
{
  const auto count = static_cast<std::uint32_t>(this->places_.size());
  const auto before = static_cast<std::uint32_t>(this->order_.size());
  for (const Place& p : this->places_)
  {
    this->order_.push_back(this->begin_ + p.ray);
  }
  for (std::uint32_t first = 0; first < count;)
  {
    const Place& start = this->places_[first];
    float low[2] = { start.u, start.v };
    float high[2] = { start.u, start.v };
    std::uint32_t last = first;
    for (; last < count && last - first < RayBundle::capacity &&
         this->places_[last].sector == start.sector;
         ++last)
    {
      const Place& p = this->places_[last];
      low[0] = std::min(low[0], p.u);
      low[1] = std::min(low[1], p.v);
      high[0] = std::max(high[0], p.u);
      high[1] = std::max(high[1], p.v);
    }
    const Bundle bundle{ before + first, last - first, static_cast<int>(start.sector >> 3),
      std::max(high[0] - low[0], high[1] - low[1]) };
    if (bundle.count >= leastBundle && bundle.spread <= widestSpread)
    {
      this->bundles_.push_back(bundle);
    }
    else
    {
      this->separate(bundle);
    }
    first = last;
  }
}

void BundlePlan::separate(const Bundle& bundle)
{
  for (std::uint32_t i = 0; i < bundle.count; ++i)
  {
    this->alone_.push_back(this->order_[bundle.first + i]);
  }
}

} // namespace lumitree
