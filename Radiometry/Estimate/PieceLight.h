// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_PieceLight_h
#define Lumitree_Radiometry_Estimate_PieceLight_h

#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/Estimate/ConePieces.h"

namespace lumitree
{

/// Radiance by direction: constant + rising × (up · ω), ω a unit vector. With rising = 0 an area
/// light or the uniform sky, with 2 : 1 the overcast sky of Moon and Spencer.
struct PieceRadiance
{
  double constant = 1.0;
  double rising = 0.0;
  Vec3 up = { 0.0, 0.0, 1.0 };
};

/// Light out of the directions of convex pieces, in closed form: ∫ ω dω is Lambert's sum, ∫ dω the
/// solid angle, and with the divergence theorem on the sphere
///   ∫ (up·ω) ω dω = ⅓ [Ω up + Σ Γ (up·(u + v)) tan(θ/2)]
/// over the edges from u to v (compare J. Arvo, SIGGRAPH 1995, section 4). Cylindrical irradiance
/// is an integral along the edges, by Gauss's rule: 1e-9. winding: 1 where corners a, b, c of the
/// pieces have a · (b × c) > 0, −1 where < 0.
void addPieces(const std::vector<ConePiece>& pieces, double winding, const PieceRadiance& radiance,
  const View& view, Amounts& sum);

} // namespace lumitree

#endif
