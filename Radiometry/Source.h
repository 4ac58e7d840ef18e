// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Source_h
#define Lumitree_Radiometry_Source_h

#include "Accel/Vec3.h"
#include "Radiometry/Export.h"

#include <optional>

namespace lumitree
{

/// What must be free for a receiver to see a source: the points receiver + t direction with t from
/// 0 to 1, or without end. In units of the coordinates.
struct Sightline
{
  Vec3 direction = { 0.0, 0.0, 1.0 };
  bool endless = false;
};

/// A source of light. It answers for itself alone: what is in the way is a separate factor, from
/// Accel. Values are in the units of one LightSystem (W or lm, W/sr or cd, W/m² or lx). Positions
/// are in the units of the coordinates; each source knows how many metres that is.
class LUMITREE_RADIOMETRY_EXPORT Source
{
public:
  Source();
  virtual ~Source();
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  /// Total flux; nothing where it is not finite (parallel light).
  [[nodiscard]] virtual std::optional<double> flux() const = 0;

  /// Intensity in a direction away from the source (any length but 0); nothing where the source has
  /// no intensity (it is infinitely far).
  [[nodiscard]] virtual std::optional<double> intensity(const Vec3& direction) const = 0;

  /// Unoccluded irradiance at a position on the side of the unit normal; 0 where the source is
  /// behind it, NaN where it is not defined (at a point source).
  [[nodiscard]] virtual double irradiance(const Vec3& position, const Vec3& normal) const = 0;

  /// Unoccluded scalar irradiance: from all sides alike, no cosine. NaN where it is not defined.
  [[nodiscard]] virtual double scalarIrradiance(const Vec3& position) const = 0;

  /// The way from a position to the source.
  [[nodiscard]] virtual Sightline sightline(const Vec3& position) const = 0;
};

} // namespace lumitree

#endif
