// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_EmitterIntensity_h
#define Lumitree_Radiometry_EmitterIntensity_h

#include "Accel/Accelerator.h"
#include "Radiometry/Export.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// A surface that shines by Lambert's law, and what is in its way: the far field of a luminaire.
struct Emitter
{
  const Surface* surface = nullptr;       ///< its triangles shine on the side of their winding
  const Accelerator* occluders = nullptr; ///< null: nothing; the surface itself belongs to them
  double radiance = 1.0;                  ///< W/(m² sr) or cd/m²
  bool twoSided = false;
  double metresPerUnit = 1.0;
  std::uint32_t mostClipped = 64; ///< occluders over a triangle that are cut out; more: rays
  Precision precision = Precision::Exact; ///< of rays
  std::uint32_t rays = 64;        ///< from a triangle in one direction, where it is sampled; 2^k
  int threads = 0;
  JobControl* control = nullptr;
};

struct EmitterReport
{
  double flux = 0.0;      ///< π L A of each side that shines, before anything is hidden
  double extent = 0.0;    ///< largest distance across the surface's box, in units
  std::uint64_t rays = 0; ///< 0: every intensity is exact
  bool completed = true;
};

/// Intensity in each direction (any length but 0): I = Σ L A cosθ of the triangles' visible parts.
/// Exact where few triangles are over one (they are cut out of it, in parallel projection), by
/// Owen-scrambled Sobol rays where many are. The numbers do not depend on the number of threads.
/// It is that of the far field: at a distance of five times the extent an inverse-square law is off
/// by about 1 % (a disk at 10 radii: exactly 1 %). Throws std::invalid_argument for directions of
/// no length and numbers out of range.
LUMITREE_RADIOMETRY_EXPORT EmitterReport emitterIntensity(
  const Emitter& emitter, const std::vector<Vec3>& directions, std::vector<double>& intensities);

/// Signed solid angle [sr] of a surface from each position (triples): the sum over its triangles
/// (SolidAngle.h). Outside a closed surface 0, inside ±4π. A position at a vertex counts as in the
/// plane of that vertex's triangles, for which it gets nothing. NaN where a coordinate is not
/// finite. Returns false when stopped.
LUMITREE_RADIOMETRY_EXPORT bool surfaceSolidAngles(const Surface& surface, const double* positions,
  std::size_t count, double* solidAngles, int threads = 0, JobControl* control = nullptr);

} // namespace lumitree

#endif
