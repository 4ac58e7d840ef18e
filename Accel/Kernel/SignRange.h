// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_SignRange_h
#define Lumitree_Accel_Kernel_SignRange_h

#include "Accel/Kernel/Bounded.h"

namespace lumitree
{

/// The signs (-1, 0, 1) that a number may have, from low to high.
struct SignRange
{
  int low = 0;
  int high = 0;

  static SignRange of(const Bounded& x)
  {
    if (x.isZero())
    {
      return {};
    }
    return x.surelyNegative() ? SignRange{ -1, -1 }
                              : (x.surelyPositive() ? SignRange{ 1, 1 } : SignRange{ -1, 1 });
  }

  [[nodiscard]] bool surelyZero() const { return this->low == 0 && this->high == 0; }
  [[nodiscard]] bool surelyNotZero() const { return this->low > 0 || this->high < 0; }
};

inline SignRange operator-(SignRange a)
{
  return { -a.high, -a.low };
}

inline SignRange minimum(SignRange a, SignRange b)
{
  return { std::min(a.low, b.low), std::min(a.high, b.high) };
}

inline SignRange magnitude(SignRange a)
{
  return { a.surelyNotZero() ? 1 : 0, std::max(-a.low, a.high) };
}

} // namespace lumitree

#endif
