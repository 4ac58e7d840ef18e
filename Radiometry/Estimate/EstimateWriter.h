// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_EstimateWriter_h
#define Lumitree_Radiometry_Estimate_EstimateWriter_h

#include "Radiometry/Estimate/SourceEstimator.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumitree
{

/// Writes the estimates of the receivers from `begin` on; NaN for those that are not valid.
class EstimateWriter
{
public:
  EstimateWriter(const Receivers& receivers, const EstimateOutputs& outputs, std::size_t begin,
    const std::vector<std::uint8_t>& valid)
    : receivers_(receivers)
    , outputs_(outputs)
    , begin_(begin)
    , valid_(valid)
  {
  }

  /// The main amounts. to: null: nowhere.
  void amounts(double* to, const std::vector<Estimate>& from) const;

  /// All that there is about the main quantity.
  void main(const std::vector<Estimate>& from) const;

  /// Light in free space, but for its main amount.
  void free(const std::vector<Estimate>& from) const;

private:
  const Receivers& receivers_;
  const EstimateOutputs& outputs_;
  std::size_t begin_;
  const std::vector<std::uint8_t>& valid_;
};

} // namespace lumitree

#endif
