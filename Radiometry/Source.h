// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Source_h
#define Lumitree_Radiometry_Source_h

#include "Accel/Box.h"
#include "Accel/Vec3.h"
#include "Radiometry/EmittingPolygon.h"
#include "Radiometry/Export.h"

#include <optional>
#include <vector>

namespace lumitree
{

/// What must be free for a receiver to see a source: the points receiver + t direction with t from
/// 0 to 1, or without end. In units of the coordinates.
struct Sightline
{
  Vec3 direction = { 0.0, 0.0, 1.0 };
  bool endless = false;
};

/// A direction in which a position sees an extended source, drawn from the unit square. The mean
/// over the square of radiance × weight × max(0, cosine of the direction) is the unoccluded
/// irradiance, and that of radiance × weight the scalar irradiance.
struct SourceSample
{
  Sightline sightline; ///< to the point of the source that was drawn
  double radiance =
    0.0; ///< of the source there; of a line, which has none, only the product has a meaning
  double weight = 0.0; ///< sr: 1 / probability density; 0: nothing of the source is seen
};

/// Where a ray meets a source that has radiance.
struct SourceCrossing
{
  double t = 0.0; ///< in units of the ray's direction; infinity: the source is infinitely far
  double radiance = 0.0; ///< > 0
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

  /// The way from a position to the source; to its middle where it is extended.
  [[nodiscard]] virtual Sightline sightline(const Vec3& position) const = 0;

  /// Unoccluded light vector (Gershun 1936): the integral of radiance times direction, pointing to
  /// where the light comes from. Its component along a normal is the irradiance on that side less
  /// that on the other. NaN where it is not defined.
  [[nodiscard]] virtual Vec3 lightVector(const Vec3& position) const = 0;

  /// Whether positions see more than one point or direction of the source. Where they do not, its
  /// sightline alone decides about its visibility.
  [[nodiscard]] virtual bool extended() const { return false; }

  /// Of extended sources: a direction for a point (u, v) of the unit square; the same one, always.
  /// Throws std::logic_error where the source is not extended.
  [[nodiscard]] virtual SourceSample sample(const Vec3& position, double u, double v) const;

  /// What the source consists of, where that is polygons; null otherwise. They live as long as the
  /// source, and what they give adds up.
  [[nodiscard]] virtual const std::vector<EmittingPolygon>* polygons() const { return nullptr; }

  /// A box that holds all of an extended source; nothing where it has no end, or none is known.
  /// What is not in the way to the box does not hide the source.
  [[nodiscard]] virtual std::optional<Box> bounds() const { return std::nullopt; }

  /// Radiance that a position receives from the source out of a direction (any length but 0), as if
  /// nothing, not even the source itself, were in the way; 0 where the source is not in that
  /// direction; nothing where the source has no radiance (it is a point, or a line).
  [[nodiscard]] virtual std::optional<double> radiance(
    const Vec3& position, const Vec3& direction) const;

  /// Appends where the half-line from a position in a direction (any length but 0) meets the
  /// source, as if nothing, not even the source itself, were in the way: the parts of which
  /// radiance() is the sum. Nothing of a source that has no radiance.
  virtual void crossings(
    const Vec3& position, const Vec3& direction, std::vector<SourceCrossing>& to) const;

protected:
  /// radiance() of sources that override crossings().
  [[nodiscard]] double sumOfCrossings(const Vec3& position, const Vec3& direction) const;
};

} // namespace lumitree

#endif
