// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Moved_h
#define Lumitree_Accel_Exact_Moved_h

#include "Accel/Exact/Dyadic.h"
#include "Accel/Ray.h"

#include <array>
#include <vector>

namespace lumitree::exact
{

/// A polynomial in e, which is above 0 and below every other positive number: its sign is that of
/// the lowest power whose coefficient is not 0. Sums, differences and products of such numbers are
/// exact, so what holds for them holds for every small enough e.
///
/// Origins are moved by (e, e^5, e^25). Between them no two different products of up to four of
/// these are equal, so a polynomial of degree 4 in the move is 0 only if it is 0 everywhere. The
/// first component that is not 0 decides about all that is linear in the move, as it does for (e,
/// e^2, e^3): for triangles the two say the same.
class Moved
{
public:
  Moved() = default;
  explicit Moved(double value)
    : Moved(Dyadic(value), 0)
  {
  }

  /// The moved origin of a ray less a point.
  static std::array<Moved, 3> fromOrigin(const Ray& ray, const Vec3& point)
  {
    constexpr int powers[3] = { 1, 5, 25 };
    std::array<Moved, 3> y;
    for (std::size_t k = 0; k < 3; ++k)
    {
      y[k] = Moved(Dyadic::difference(ray.origin[k], point[k]), 0) + Moved(Dyadic(1.0), powers[k]);
    }
    return y;
  }

  [[nodiscard]] int sign() const
  {
    return this->terms_.empty() ? 0 : this->terms_[0].factor.sign();
  }

  friend Moved operator+(const Moved& a, const Moved& b) { return join(a, b, false); }
  friend Moved operator-(const Moved& a, const Moved& b) { return join(a, b, true); }
  friend Moved operator*(const Moved& a, const Moved& b)
  {
    Moved sum;
    for (const Term& term : a.terms_)
    {
      Moved part;
      for (const Term& other : b.terms_)
      {
        part.terms_.push_back({ term.power + other.power, term.factor * other.factor });
      }
      sum = sum + part;
    }
    return sum;
  }

private:
  struct Term
  {
    int power;
    Dyadic factor; ///< not 0
  };

  Moved(const Dyadic& factor, int power)
  {
    if (factor.sign() != 0)
    {
      this->terms_.push_back({ power, factor });
    }
  }

  static Moved join(const Moved& a, const Moved& b, bool less)
  {
    Moved sum;
    auto i = a.terms_.begin();
    auto j = b.terms_.begin();
    while (i != a.terms_.end() || j != b.terms_.end())
    {
      const bool first = j == b.terms_.end() || (i != a.terms_.end() && i->power <= j->power);
      const bool second = i == a.terms_.end() || (j != b.terms_.end() && j->power <= i->power);
      const int power = first ? i->power : j->power;
      Dyadic factor = first ? (i++)->factor : Dyadic();
      if (second)
      {
        factor = less ? factor - j->factor : factor + j->factor;
        ++j;
      }
      if (factor.sign() != 0)
      {
        sum.terms_.push_back({ power, factor });
      }
    }
    return sum;
  }

  std::vector<Term> terms_; ///< ascending by power
};

} // namespace lumitree::exact

#endif
