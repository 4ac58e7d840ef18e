// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_PieceSamples_h
#define Lumitree_Radiometry_Estimate_PieceSamples_h

#include "Radiometry/Estimate/ConePieces.h"
#include "Radiometry/Estimate/LightSamples.h"

#include <vector>

namespace lumitree
{

/// Ways from the eye to points of flat pieces of even radiance: by area where a piece is far off,
/// which costs less, by solid angle where it is near (J. Arvo, Stratified Sampling of Spherical
/// Triangles, SIGGRAPH 1995).
class PieceSamples : public LightSamples
{
public:
  PieceSamples(const std::vector<ConePiece>& pieces, double radiance);

  /// Weights are 0 where there is no piece.
  void draw(
    const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const override;

private:
  enum class Shape
  {
    Near,         ///< a triangle by solid angle
    Far,          ///< a triangle by area
    Parallelogram ///< by area
  };

  /// Of a flat piece, relative to the eye.
  struct Part
  {
    Shape shape;
    double from;                 ///< of the unit interval, the share of the solid angle
    double perShare;             ///< 1 / share
    std::array<Vec3, 3> corners; ///< of a parallelogram the middle one is the first
    Vec3 area;                   ///< twice the triangle's area vector
    double height;               ///< area · a corner
    double weight;               ///< of samples by area: times 1 / r³
    // Of a near triangle (a, b, c) on the unit sphere:
    Vec3 b;
    Vec3 a;
    Vec3 acrossA; ///< the part of c at right angles to a, of unit length
    double cosineAB;
    double alpha;
    double cosineAlpha;
    double sineAlpha;
    double excess; ///< its area
  };

  void add(Shape shape, const Vec3& a, const Vec3& b, const Vec3& c, double solidAngle);
  static void drawNear(const Part& part, double u, double v, SourceSample& sample);
  static void drawFar(const Part& part, double u, double v, SourceSample& sample);

  std::vector<Part> parts_;
  double radiance_;
  double solidAngle_ = 0.0;
};

} // namespace lumitree

#endif
