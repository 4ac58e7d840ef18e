// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Expansion_h
#define Lumitree_Accel_Exact_Expansion_h

#include "Accel/Exact/Terms.h"

namespace lumitree::exact
{

/// A real number as an unevaluated sum of doubles, non-overlapping, of increasing magnitude, without zeros
/// (Shewchuk 1997). Sums, differences and products are exact as long as nothing over- or underflows; who uses them
/// checks the range of the inputs (see Predicates.cxx).
class Expansion
{
public:
  Expansion() = default;
  explicit Expansion(double value);

  /// a - b
  static Expansion difference(double a, double b);

  [[nodiscard]] int sign() const;

  /// Within a few units of the last place.
  [[nodiscard]] double estimate() const;

  /// a / b within a few units of the last place; b is not 0.
  static double quotient(const Expansion& a, const Expansion& b)
  {
    return a.estimate() / b.estimate();
  }

  /// The same number with the largest terms first to hold all the bits they can (Shewchuk's compress), cut to three terms.
  /// The number differs from what is returned by at most error.
  [[nodiscard]] Expansion leading(double& error) const;

  friend Expansion operator+(const Expansion& a, const Expansion& b);
  friend Expansion operator-(const Expansion& a, const Expansion& b);
  friend Expansion operator*(const Expansion& a, const Expansion& b);

private:
  /// Appends value unless it is 0.
  void push(double value)
  {
    if (value != 0.0)
    {
      this->terms_.push(value);
    }
  }

  static Expansion sum(const Expansion& a, const Expansion& b, double signOfB);
  static Expansion scale(const Expansion& a, double factor);

  Terms terms_;
};

} // namespace lumitree::exact

#endif
