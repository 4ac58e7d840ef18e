// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_ImplicitRoots_h
#define Lumitree_Accel_Kernel_ImplicitRoots_h

#include "Accel/Implicit.h"
#include "Accel/Kernel/Bounded.h"
#include "Accel/Ray.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// Where a ray meets an implicit.
struct ImplicitRoot
{
  double t = 0.0;
  double tLow = 0.0; ///< certain, if there is a root at all
  double tHigh = 0.0;
  std::uint8_t flags = 0; ///< HitFlag: Uncertain, Sampled
  bool passes = true;     ///< the function has different signs before and behind it
};

/// The roots of an implicit along a ray, in the order of t.
///
/// The line is looked at from its point o' = o + t0 d near the middle of the box, computed to twice
/// the precision, as for quadrics; s = t - t0. Bounded functions: an interval of s is left alone
/// when bounds of the function exclude 0, or of its slope do and the ends have certain signs; else
/// it is halved, down to the tolerance (to 4096 times that where even the value in the middle is 0
/// within its rounding) or until mostBounds were asked for. What cannot be decided
/// then is joined with its neighbours, and there is a root in it if the function has different
/// signs on both sides. Bounds are those of the function and of its mean value form, F(middle) +
/// F'(interval) (interval - middle) (Moore, Kearfott and Cloud 2009, ch. 6). Other functions are
/// sampled.
class ImplicitRoots
{
public:
  static constexpr int mostBounds = 1024;

  ImplicitRoots(const Ray& ray, const Implicit& implicit);

  /// All roots, or the first: what is certain, and what is not if that is asked for.
  [[nodiscard]] std::vector<ImplicitRoot> find(bool firstOnly, bool uncertain);

private:
  struct Cluster;

  void isolate(double low, double high);
  void sample(double low, double high);

  [[nodiscard]] Jet boundOver(const Interval& s);
  [[nodiscard]] int signAt(double s);
  [[nodiscard]] double valueAt(double s) const;
  [[nodiscard]] Vec3 pointAt(double s) const;

  /// A simple root between two s, where the function has different signs.
  void refine(Interval s, int signLow);
  void close(Cluster& cluster, int signHigh);
  void add(const Interval& s, bool certain, bool passes);
  [[nodiscard]] bool isBeside(double s) const;
  [[nodiscard]] bool done() const { return this->firstOnly_ && !this->roots_.empty(); }

  const Ray& ray_;
  const Implicit& implicit_;
  double t0_ = 0.0;
  std::array<Bounded, 3> middle_; ///< o'
  double speed_ = 1.0;            ///< |d|
  double tolerance_ = 0.0;        ///< of s
  int bounds_ = 0;
  bool firstOnly_ = false;
  bool uncertain_ = false;
  std::vector<ImplicitRoot> roots_;
};

} // namespace lumitree

#endif
