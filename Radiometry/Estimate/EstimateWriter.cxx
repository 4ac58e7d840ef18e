// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/EstimateWriter.h"

#include <algorithm>
#include <limits>

namespace lumitree
{

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ShadowState shadowOf(const Estimate& estimate)
{
  constexpr double whole = 1.0 - 1e-9; // the sum over what is left of a light that is cut
  if (!(estimate.unoccluded > 0.0))
  {
    return ShadowState::Averted;
  }
  if (!(estimate.value.main > 0.0))
  {
    return ShadowState::Umbra;
  }
  return estimate.value.main >= whole * estimate.unoccluded ? ShadowState::Lit
                                                            : ShadowState::Penumbra;
}

} // namespace

void EstimateWriter::amounts(double* to, const std::vector<Estimate>& from) const
{
  for (std::size_t k = 0; k < from.size() && to; ++k)
  {
    to[this->begin_ + k] = this->valid_[k] ? from[k].value.main : nan;
  }
}

void EstimateWriter::main(const std::vector<Estimate>& from) const
{
  const EstimateOutputs& out = this->outputs_;
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    const std::size_t i = this->begin_ + k;
    const bool valid = this->valid_[k] != 0;
    if (out.lower)
    {
      out.lower[i] = valid ? from[k].lower : nan;
    }
    if (out.upper)
    {
      out.upper[i] = valid ? from[k].upper : nan;
    }
    if (out.unoccluded)
    {
      out.unoccluded[i] = valid ? from[k].unoccluded : nan;
    }
    if (out.method)
    {
      out.method[i] = valid ? from[k].method : EstimateMethod::None;
    }
    if (out.shadow)
    {
      out.shadow[i] = valid ? shadowOf(from[k]) : ShadowState::Averted;
    }
  }
}

void EstimateWriter::free(const std::vector<Estimate>& from) const
{
  const EstimateOutputs& out = this->outputs_;
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    const std::size_t i = this->begin_ + k;
    const bool valid = this->valid_[k] != 0;
    const Amounts& value = from[k].value;
    for (int c = 0; c < 3 && out.vector; ++c)
    {
      out.vector[3 * i + c] = valid ? value.vector[c] : nan;
    }
    if (out.cylindrical)
    {
      out.cylindrical[i] = valid ? value.cylindrical : nan;
    }
    if (out.hemispherical)
    {
      const bool sided = static_cast<bool>(this->receivers_.normals);
      const Vec3 normal = sided ? this->receivers_.normals.triple(i) : Vec3{};
      out.hemispherical[i] =
        valid && sided ? std::max(0.0, 0.25 * (value.main + dot(normal, value.vector))) : nan;
    }
  }
}

} // namespace lumitree
