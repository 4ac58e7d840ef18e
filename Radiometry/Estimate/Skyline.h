// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_Skyline_h
#define Lumitree_Radiometry_Estimate_Skyline_h

#include "Accel/Surface.h"
#include "Radiometry/Estimate/ConePieces.h"

#include <array>
#include <vector>

namespace lumitree
{

/// The visible part of the sky above scenes of 2.5 dimensions (buildings on a ground, terrain): the
/// upper envelope, by azimuth, of the edges that can be an outline against the sky.
///
/// Seen from an eye, an edge is an upper outline where all of its triangles lie below it, a lower
/// one where they lie above. Without lower outlines above the horizon, whatever is hidden is hidden
/// down to the horizon: the lowest point of a stretch of hidden elevations can only be the horizon
/// or a point of a lower outline. So the envelope of the upper outlines is all that matters, and it
/// is decided for each eye, whatever the scene is elsewhere. Balconies, bridges and tree crowns
/// have lower outlines: such an eye is refused, even where something behind hides the gap.
class Skyline
{
public:
  /// up: unit vector. Edges between triangles that are coplanar to 1e-10 are never an outline.
  Skyline(const Surface& surface, const Vec3& up);

  /// Whether the surface has so few edges that looking at all of them for each eye pays.
  [[nodiscard]] bool pays() const { return this->edges_.size() <= mostEdges; }

private:
  static constexpr std::size_t mostEdges = 1500;

  /// From that azimuth on, to the next, the tangent of the elevation is slope · (cosφ, sinφ).
  struct Step
  {
    double azimuth;
    std::array<double, 2> slope;
  };
  using Envelope = std::vector<Step>;

  struct Outline
  {
    double from;
    double to;
    std::array<double, 2> slope;
  };

public:
  /// Memory that calls on one thread use again.
  class Scratch
  {
    friend class Skyline;
    std::vector<Outline> outlines;
    std::vector<Envelope> envelopes;
    Envelope whole;
  };

  /// The visible sky above an eye, as triangles with the zenith (winding 1). False where the eye is
  /// refused. What is less than slack above the eye is taken to be on its horizon.
  bool visible(
    const Vec3& eye, double slack, Scratch& scratch, std::vector<ConePiece>& pieces) const;

private:
  /// An edge and the third corners of its triangles, in the frame where up is z.
  struct Edge
  {
    Vec3 a;
    Vec3 b;
    double top;
    std::uint32_t firstOpposite;
    std::uint32_t oppositeCount;
  };

  [[nodiscard]] Vec3 toFrame(const Vec3& p) const;
  bool collect(const Vec3& eye, double slack, std::vector<Outline>& outlines) const;
  static void addOutline(
    const Vec3& a, const Vec3& b, const Vec3& normal, std::vector<Outline>& outlines);
  static void merge(
    Scratch& scratch, std::size_t first, std::size_t last, Envelope& result, int depth);
  static void mergeTwo(const Envelope& one, const Envelope& two, Envelope& result);

  std::array<Vec3, 3> axes_;
  std::vector<Edge> edges_; ///< highest first
  std::vector<Vec3> opposite_;
};

} // namespace lumitree

#endif
