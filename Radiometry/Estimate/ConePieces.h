// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_ConePieces_h
#define Lumitree_Radiometry_Estimate_ConePieces_h

#include "Accel/Vec3.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// A convex polygon as the eye (at the origin) sees it: only the directions of its corners matter.
struct ConePiece
{
  static constexpr int capacity = 16;
  int count = 0;
  Vec3 corners[capacity];
};

/// The directions in which a convex polygon of up to five corners hides what lies behind it: those
/// with planes[k] · x > 0 for every k.
struct OccluderCone
{
  static constexpr int capacity = 5;
  int count = 0;
  Vec3 planes[capacity]; ///< unit normals of the planes through the eye and each edge, inward
  double size = 0.0;     ///< about the solid angle: large ones go first

  /// Of a polygon relative to the eye; false where it is seen from nearer to its plane than the
  /// clearance: it is seen edge on, or it is what the eye lies on.
  bool assign(const Vec3* corners, int cornerCount, double clearance);
};

/// What is left of some directions after what hides is taken away.
struct VisiblePieces
{
  std::vector<ConePiece> visible;
  std::vector<ConePiece> undecided; ///< neither known: the budget of work did not reach them
};

/// Takes the occluders away from the pieces. Exact, but for what the budget leaves undecided.
/// Pieces are halved until few occluders touch each, so that many cost no square of their number.
///
/// Where an edge of an occluder runs through a corner of a piece to within 2^-48 rad (that is,
/// edges that meet), it is taken to run exactly through it.
class ConeSubtraction
{
public:
  /// budget: tests of an occluder against a piece that may be spent.
  void run(const std::vector<ConePiece>& pieces, const std::vector<OccluderCone>& occluders,
    std::size_t budget, VisiblePieces& result);

  /// Tests spent in the last run.
  [[nodiscard]] std::size_t spent() const { return this->spent_; }

private:
  enum class Meeting
  {
    Outside,
    Covers,
    Crosses
  };

  Meeting meets(const OccluderCone& cone, const ConePiece& piece);
  void subtract(const OccluderCone& cone);
  void refine(const ConePiece& piece, std::size_t first, std::size_t last, int depth,
    const std::vector<OccluderCone>& occluders, VisiblePieces& result);

  std::vector<std::uint32_t> stack_; ///< occluders that cross the pieces on the way down
  std::vector<ConePiece> parts_;     ///< of the piece being cut
  std::vector<ConePiece> fragments_; ///< of one part
  std::size_t budget_ = 0;
  std::size_t spent_ = 0;
};

/// Cuts a piece by the plane normal · x = 0. One of the halves may be empty.
void splitPiece(const ConePiece& piece, const Vec3& normal, ConePiece& above, ConePiece& below);

} // namespace lumitree

#endif
