// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiAccuracyRays_h
#define LumiAccuracyRays_h

#include "Accel/Surface.h"

#include <string>
#include <vector>

namespace lumitree::filters
{

/// Rays of one kind, in memory of their own.
struct RaySet
{
  std::string kind;
  std::vector<double> origins;
  std::vector<double> directions;

  [[nodiscard]] std::size_t size() const { return this->origins.size() / 3; }
  [[nodiscard]] RayBatch batch() const;
};

/// Random: from the middle of the bounds, any direction. Camera: a pinhole outside, row by row.
/// ThroughVertex and ThroughEdge: from the middle, exactly through a vertex or an edge's middle as
/// far as doubles can. TowardVertex: a direction to a vertex that was normalised and rounded to
/// float. Origins are floats, less the Camera's.
[[nodiscard]] std::vector<RaySet> accuracyRays(
  const Surface& surface, std::size_t count, unsigned int seed);

/// The triangles that can be hit, without the quadrics.
[[nodiscard]] std::vector<PrimitiveId> hittableTriangles(const Surface& surface);

} // namespace lumitree::filters

#endif
