// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Implicit_h
#define Lumitree_Accel_Implicit_h

#include "Accel/Box.h"
#include "Accel/Export.h"
#include "Accel/Interval.h"

#include <memory>
#include <vector>

namespace lumitree
{

/// A continuous function of space, known by its values, and by bounds of them if it can tell.
/// Immutable: any number of threads may ask; who has only one at a time to offer keeps a lock.
class LUMITREE_ACCEL_EXPORT ImplicitFunction
{
public:
  ImplicitFunction() = default;
  virtual ~ImplicitFunction();
  ImplicitFunction(const ImplicitFunction&) = delete;
  ImplicitFunction& operator=(const ImplicitFunction&) = delete;

  /// In double arithmetic; NaN where there is none.
  [[nodiscard]] virtual double value(const Vec3& x) const = 0;

  /// Of any length; 0 where there is none.
  [[nodiscard]] virtual Vec3 gradient(const Vec3& x) const = 0;

  /// All that defines it, as numbers: two functions of the same type with the same numbers are the
  /// same. Empty where only the object itself knows; structures over it are then not saved.
  [[nodiscard]] virtual std::vector<double> numbers() const { return {}; }

  /// Whether bound says anything.
  [[nodiscard]] virtual bool isBounded() const { return false; }

  /// Bounds of the function, and of its derivative by t, given those of the coordinates.
  [[nodiscard]] virtual Jet bound(const std::array<Jet, 3>& x) const;
};

/// A primitive: where a function is 0 in a closed box. What rays hit of it:
///
/// - Of a function that is bounded: every sign change, once. Intervals isolate it; that it is
/// there,
///   and between which t, is then certain. Where nothing can be proven down to the tolerance (a
///   tangent, a crease, a function that is 0 throughout) there is one hit, marked
///   HitFlag::Uncertain. Sign changes less than the tolerance apart may be told as one.
/// - Of any other: sign changes between samples along the ray, `step` apart, from where it enters
///   the box; all are marked HitFlag::Sampled. What lies between two samples is not seen, nor is a
///   zero without a change of sign.
///
/// The box is taken as far as double arithmetic knows.
struct Implicit
{
  std::shared_ptr<const ImplicitFunction> function; ///< never null
  Box clip;
  /// Length between samples; 0: 1/256 of the box's diagonal. At least 1e-6 of the diagonal.
  double step = 0.0;
};

/// The step as it is used, and the distance within which isolation gives up: 2^-32 of the box's
/// diagonal.
///@{
[[nodiscard]] LUMITREE_ACCEL_EXPORT double stepOf(const Implicit& implicit);
[[nodiscard]] LUMITREE_ACCEL_EXPORT double toleranceOf(const Implicit& implicit);
///@}

} // namespace lumitree

#endif
