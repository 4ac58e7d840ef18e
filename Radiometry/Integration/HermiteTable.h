// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Integration_HermiteTable_h
#define Lumitree_Radiometry_Integration_HermiteTable_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lumitree
{

/// A smooth function on [0, end] by cubics between equal steps that have its values and slopes at
/// their ends: off by step⁴ / 384 times the fourth derivative at most.
class HermiteTable
{
public:
  HermiteTable() = default;

  /// function(x) gives value and slope, as a pair.
  template <class Function>
  HermiteTable(double end, std::size_t steps, const Function& function)
    : perStep_(static_cast<double>(steps) / end)
  {
    for (std::size_t i = 0; i <= steps; ++i)
    {
      const auto [value, slope] = function(static_cast<double>(i) / this->perStep_);
      this->nodes_.push_back({ value, slope / this->perStep_ });
    }
  }

  [[nodiscard]] bool empty() const { return this->nodes_.empty(); }

  [[nodiscard]] double operator()(double x) const
  {
    const double at = x * this->perStep_;
    const std::size_t i = std::min(static_cast<std::size_t>(at), this->nodes_.size() - 2);
    const double t = at - static_cast<double>(i);
    const Node& a = this->nodes_[i];
    const Node& b = this->nodes_[i + 1];
    const double rise = b.value - a.value;
    return a.value +
      t *
      (a.slope +
        t * ((3.0 * rise - 2.0 * a.slope - b.slope) + t * (a.slope + b.slope - 2.0 * rise)));
  }

private:
  struct Node
  {
    double value;
    double slope; ///< per step
  };

  std::vector<Node> nodes_;
  double perStep_ = 1.0;
};

} // namespace lumitree

#endif
