// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_Estimate_h
#define Lumitree_Radiometry_Estimate_Estimate_h

#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/LightEstimate.h"

#include <algorithm>

namespace lumitree
{

/// Light of one source in one view.
struct Estimate
{
  Amounts value;
  double lower = 0.0; ///< of value.main
  double upper = 0.0;
  double unoccluded = 0.0; ///< main
  EstimateMethod method = EstimateMethod::None;
  std::uint32_t rays = 0;
  bool missed = false; ///< the tolerance

  void add(const Estimate& other)
  {
    this->value.add(other.value);
    this->lower += other.lower;
    this->upper += other.upper;
    this->unoccluded += other.unoccluded;
    this->method = std::max(this->method, other.method);
    this->rays += other.rays;
    this->missed = this->missed || other.missed;
  }
};

} // namespace lumitree

#endif
