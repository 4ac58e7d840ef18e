// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Implicit.h"

namespace lumitree
{

ImplicitFunction::~ImplicitFunction() = default;

Jet ImplicitFunction::bound(const std::array<Jet, 3>&) const
{
  return { Interval::everything(), Interval::everything() };
}

double stepOf(const Implicit& implicit)
{
  return implicit.step > 0.0 ? implicit.step : length(implicit.clip.size()) / 256;
}

double toleranceOf(const Implicit& implicit)
{
  return 0x1p-32 * length(implicit.clip.size());
}

} // namespace lumitree
