// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_SeenDisk_h
#define Lumitree_Radiometry_Estimate_SeenDisk_h

#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/Estimate/ConePieces.h"

#include <vector>

namespace lumitree
{

/// A round light of radiance 1 as the eye (at the origin) sees it: the directions of
/// centre + a u + b v with a² + b² <= 1. A disk; of a sphere, the disk within the circle along
/// which it is touched by lines of sight; of the sun, any section of its cone.
///
/// In the plane of (a, b) edges of occluders are straight and the light is the unit circle: what is
/// left of it after exact cutting is pieces of convex polygons within the circle, bounded by
/// segments and arcs. Its light is the integral along these, ½ ∮ r × dr / |r|² (Lambert's sum for
/// any curve; of arcs in closed form where the cone is circular, else by Gauss's rule to 1e-14).
class SeenDisk
{
public:
  /// u, v: at right angles and of the same length, with (u × v) · centre > 0.
  SeenDisk(const Vec3& centre, const Vec3& u, const Vec3& v);

  /// An octagon around it in its own plane, cut by the horizon of a sided view.
  void circumscribe(const View& view, std::vector<ConePiece>& pieces) const;

  /// Whether it is seen in that direction (any length but 0).
  [[nodiscard]] bool contains(const Vec3& direction) const;

  /// Adds the light of the parts of pieces, which lie in the octagon, that are within the disk. Of
  /// views in free space without cylindrical irradiance.
  void addLight(const std::vector<ConePiece>& pieces, const View& view, Amounts& sum) const;

private:
  struct Point
  {
    double a, b;
  };

  [[nodiscard]] Vec3 at(double a, double b) const;
  void addPiece(const ConePiece& piece, const View& view, Amounts& sum) const;
  void addSegment(const Point& from, const Point& to, const View& view, Amounts& sum) const;
  void addArc(double from, double span, const View& view, Amounts& sum) const;

  /// Of what looks small: to first order around the centre, from its area and first moments.
  void addSmall(double area, double momentA, double momentB, const View& view, Amounts& sum) const;

  Vec3 centre_;
  Vec3 u_;
  Vec3 v_;
  Vec3 toA_; ///< dual vectors: the coordinates of a direction
  Vec3 toB_;
  Vec3 toK_;
  double volume_; ///< (u × v) · centre
  bool circular_; ///< seen from its axis
  bool small_;    ///< Lambert's sum would lose its digits
};

} // namespace lumitree

#endif
