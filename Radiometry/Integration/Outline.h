// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Integration_Outline_h
#define Lumitree_Radiometry_Integration_Outline_h

#include "Accel/Vec3.h"

namespace lumitree
{

/// The outline of something of radiance 1 as a receiver in the origin sees it, made of straight
/// segments and arcs of circles, one after the other, and closed. Its boundary integral
/// ½ ∮ n·(r × dr) / |r|² is the irradiance on the side of the normal (Lambert's formula for any
/// curve), negative where the outline turns right as seen by the receiver.
class Outline
{
public:
  enum class Horizon
  {
    Cuts, ///< what is below the plane with that normal does not count
    Ignored
  };

  Outline(const Vec3& normal, Horizon horizon)
    : normal_(normal)
    , cuts_(horizon == Horizon::Cuts)
  {
  }

  void segment(const Vec3& from, const Vec3& to);

  /// centre + cosφ u + sinφ v with φ from one angle to another, either way; u and v are of the same
  /// length and at right angles.
  void arc(const Vec3& centre, const Vec3& u, const Vec3& v, double from, double to);

  /// The integral over the outline, closed along the horizon where it was cut.
  [[nodiscard]] double integral() const;

private:
  void enter(const Vec3& point, bool onHorizon);
  void leave(const Vec3& point, bool onHorizon);
  [[nodiscard]] double alongHorizon(const Vec3& from, const Vec3& to) const;

  Vec3 normal_;
  bool cuts_;
  bool begun_ = false;
  bool cameFromHorizon_ = false; ///< the outline begins below
  bool isBelow_ = false;
  Vec3 firstEntry_ = { 0.0, 0.0, 0.0 };
  Vec3 lastExit_ = { 0.0, 0.0, 0.0 };
  double sum_ = 0.0;
};

} // namespace lumitree

#endif
