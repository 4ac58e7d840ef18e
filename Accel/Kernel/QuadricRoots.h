// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_QuadricRoots_h
#define Lumitree_Accel_Kernel_QuadricRoots_h

#include "Accel/Kernel/SignRange.h"
#include "Accel/Quadric.h"
#include "Accel/Ray.h"

namespace lumitree
{

/// Where the line of a ray meets a quadric, as far as double arithmetic knows: a pure function of
/// the two.
///
/// The line is looked at from its point near the middle of the quadric's box, o' = o + t0 d,
/// computed to twice the precision, so that a distant origin costs no digits (Haines, Günther and
/// Akenine-Möller 2019, "Precision improvements for ray/sphere intersection", Ray Tracing Gems,
/// ch. 7). With A s² + B s + C the form along the line from there, the roots are q / A and C / q,
/// q = -(B + sign(B) sqrt(B² - 4 A C)) / 2: nothing cancels. Every number carries a bound of its
/// error (Bounded.h). Derivation: Docs/exactness.md.
class QuadricRoots
{
public:
  enum class Known
  {
    Nothing,      ///< out of range, or the degree along the line is not certain
    Roots,        ///< exactly count roots, each in its interval
    TwoOneOrNone, ///< nearly tangent: any roots are in the interval of the first, the only one
                  ///< given
  };

  struct Root
  {
    Bounded s; ///< t - t0
    double t = 0.0;
    double tLow = 0.0;
    double tHigh = 0.0;
  };

  QuadricRoots(const Ray& ray, const Quadric& quadric);

  [[nodiscard]] Known known() const { return this->known_; }
  /// The form along the line has neither a square nor a slope.
  [[nodiscard]] bool isConstant() const { return this->constant_; }
  /// Nearly tangent, and plain floating point says that it misses.
  [[nodiscard]] bool apparentlyNone() const { return this->apparentlyNone_; }
  /// In the order of t. What plain floating point says where nothing is known.
  ///@{
  [[nodiscard]] int count() const { return this->count_; }
  [[nodiscard]] const Root& operator[](int i) const { return this->roots_[i]; }
  ///@}

  /// Where the point at a root lies: 1 certainly in the quadric's box, cuts and bound, where its
  /// tree is certainly 0; -1 certainly not; 0 not known.
  [[nodiscard]] int inside(int root) const;

  /// The same of a ray that is moved by next to nothing, which must pass there from one sign of the
  /// tree to the other: nothing is certain on a limit.
  [[nodiscard]] int movedInside(int root) const;

  /// What plain floating point says about that.
  [[nodiscard]] bool apparentlyInside(int root) const;

private:
  using Point = std::array<Bounded, 3>;

  void solve(const Bounded& a, const Bounded& b, const Bounded& c);
  void add(const Bounded& s);
  /// How far inside, one number per constraint: f(distance) for each that is not trivial.
  template <class F>
  void eachConstraint(int root, F f) const;
  /// The sign of the tree, if its own form is in the range given. certain: whether no other form is
  /// or may be 0.
  [[nodiscard]] SignRange treeSign(int root, SignRange own, bool& certain) const;

  const Ray& ray_;
  const Quadric& quadric_;
  double t0_ = 0.0;
  Point middle_; ///< o' less the form's centre
  Known known_ = Known::Nothing;
  bool apparentlyNone_ = false;
  bool constant_ = false;
  int count_ = 0;
  std::array<Root, 2> roots_;
};

} // namespace lumitree

#endif
