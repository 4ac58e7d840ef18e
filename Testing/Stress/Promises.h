// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Stress_Promises_h
#define Lumitree_Testing_Stress_Promises_h

#include "StressCases.h"

#include "Testing/Accel/RationalOracle.h"

#include <string>
#include <vector>

/// What a precision promises, asked of an accelerator and compared with rational numbers.
namespace lumitree::testing
{

/// What rational arithmetic says about a ray.
struct Truth
{
  struct Entry
  {
    PrimitiveId primitive;
    Rational t;
    bool clear; ///< so far from edges, limits and the plane that any arithmetic should find it
  };
  std::vector<Entry> hits; ///< ordered by (t, primitive)
};

[[nodiscard]] std::vector<Truth> truthOf(const StressCase& c);

/// The first promise that is broken, with the ray; empty: all are kept.
[[nodiscard]] std::string brokenPromise(const Accelerator& accelerator, Precision precision,
  const StressCase& c, const std::vector<Truth>& truth);

} // namespace lumitree::testing

#endif
