// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Stress_StressCases_h
#define Lumitree_Testing_Stress_StressCases_h

#include "Testing/Accel/TestHelpers.h"

#include <string>
#include <vector>

/// Small surfaces and rays at which methods fail, made from a seed.
namespace lumitree::testing
{

struct StressCase
{
  std::string name;
  std::shared_ptr<const Surface> surface;
  Rays rays;
  bool inside = false; ///< the surface is closed, and every ray starts inside
};

/// One case of each kind. Kinds are in the same order, and have the same names, for every seed.
[[nodiscard]] std::vector<StressCase> stressCases(unsigned seed);

} // namespace lumitree::testing

#endif
