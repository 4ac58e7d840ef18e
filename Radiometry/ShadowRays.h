// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_ShadowRays_h
#define Lumitree_Radiometry_ShadowRays_h

#include "Accel/Accelerator.h"
#include "Radiometry/Export.h"
#include "Radiometry/Source.h"

namespace lumitree
{

/// Rays from receivers to sources that neither see the surface on which the receiver lies nor the
/// one on which the source lies, and everything else.
///
/// Where a receiver is on a surface, rounding decides on which side of it the receiver is found: of
/// coordinates stored as float, half a unit in the last place each; of the arithmetic of
/// intersections, a share of the size of the scene. Their sum, with some to spare, is the clearance
/// of a position:
///   clearance = 4 u Σ|nₖ pₖ| + a R, R = the largest coordinate difference between the position and
///   the scene's bounds, u = 2⁻²⁴ or 2⁻⁵³ by the type of the stored coordinates, a = 2⁻⁴⁰ (Embree,
///   which works in float: 2⁻¹⁹).
/// At 10⁶ from the origin that is about 0.24 for float coordinates, whose own spacing there is
/// 0.06, and about 10⁻⁹ for double ones. A shadow ray starts by its clearance off the receiver's
/// plane, along the normal, and leaves out as much again at its beginning; at its end it leaves out
/// the clearance of the source, so that a lamp on a ceiling is not hidden by the ceiling. Nothing
/// nearer than that casts a shadow. (As pbrt-v4, section 6.8.6, but with the bound of stored
/// coordinates.)
class LUMITREE_RADIOMETRY_EXPORT ShadowRays
{
public:
  /// stored: the coarser of what receivers and occluders were stored as.
  ShadowRays(const Accelerator& occluders, ArrayView::Scalar stored);

  /// Limits are those of a segment towards the source. tMin > tMax: the source is too near to be
  /// hidden. normal: null where the receiver has none (then it only leaves out the beginning).
  [[nodiscard]] Ray operator()(
    const Source& source, const Vec3& position, const Vec3* normal) const;

  /// Of a position: that along a unit normal, or, without one, along any direction.
  [[nodiscard]] double clearance(const Vec3& position, const Vec3* normal = nullptr) const;

private:
  Box bounds_;
  double coordinateError_; ///< relative
  double arithmeticError_; ///< relative to the extent
};

} // namespace lumitree

#endif
