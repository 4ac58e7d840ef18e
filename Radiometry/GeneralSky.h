// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_GeneralSky_h
#define Lumitree_Radiometry_GeneralSky_h

#include "Radiometry/Integration/HermiteTable.h"
#include "Radiometry/SkyDistribution.h"
#include "Radiometry/SkySource.h"

#include <cstdint>

namespace lumitree
{

/// What a sky is measured by.
struct SkyLevel
{
  enum class Kind
  {
    ZenithRadiance,      ///< W/(m² sr) or cd/m²
    HorizontalIrradiance ///< by the sky alone, without the sun (diffuse horizontal): W/m² or lx
  };
  Kind kind = Kind::ZenithRadiance;
  double value = 0.0; ///< finite, ≥ 0
};

/// The overcast sky of Moon and Spencer (1942): L = Lz (1 + 2 cosZ) / 3; Eh = 7π/9 Lz; on a tilted
/// plane Lz (π (1 + cosβ) / 6 + 4/9 (sinβ + (π − β) cosβ)).
class LUMITREE_RADIOMETRY_EXPORT OvercastSky : public SkySource
{
public:
  /// Throws std::invalid_argument for a level that is negative or not finite, and as SkySource
  /// does.
  explicit OvercastSky(
    const SkyLevel& level, const Vec3& up = { 0.0, 0.0, 1.0 }, double groundRadiance = 0.0);

  [[nodiscard]] double zenithRadiance() const { return this->zenithRadiance_; }

protected:
  [[nodiscard]] double skyRadiance(const Vec3& direction) const override;
  [[nodiscard]] double skyIrradiance(const Vec3& normal) const override;
  [[nodiscard]] double skyScalarIrradiance() const override;
  [[nodiscard]] Vec3 skyVector() const override;

private:
  double zenithRadiance_;
};

/// A sky with a gradation towards the horizon and a corona around the sun: the CIE general skies,
/// and the all-weather sky. Irradiance by quadrature in rings around the sun, to about 1e-11, which
/// takes some milliseconds under a clear sky; the last normals asked for are remembered, as
/// receivers on one face share theirs.
class LUMITREE_RADIOMETRY_EXPORT GeneralSky : public SkySource
{
public:
  /// towardsSun: finite, any length but 0; where the distribution is not round, not below the
  /// horizon. Throws std::invalid_argument otherwise, for a level that is negative or not finite,
  /// for a distribution that is nowhere positive, and as SkySource does.
  GeneralSky(const SkyDistribution& distribution, const Vec3& towardsSun, const SkyLevel& level,
    const Vec3& up = { 0.0, 0.0, 1.0 }, double groundRadiance = 0.0);

  [[nodiscard]] double zenithRadiance() const { return this->skyRadiance(this->up()); }
  [[nodiscard]] double radianceOfSample(const Vec3& direction) const override;

protected:
  [[nodiscard]] double skyRadiance(const Vec3& direction) const override;
  [[nodiscard]] double skyIrradiance(const Vec3& normal) const override;
  [[nodiscard]] double skyScalarIrradiance() const override { return this->scalar_; }
  [[nodiscard]] Vec3 skyVector() const override { return this->vector_; }

private:
  void makeTables();
  [[nodiscard]] double relative(const Vec3& direction) const;
  template <class Kernel>
  [[nodiscard]] double overSky(const Kernel& kernel, const Vec3* normal) const;

  SkyDistribution distribution_;
  Vec3 towardsSun_;
  double scale_ = 1.0;
  double scalar_ = 0.0;
  Vec3 vector_ = { 0.0, 0.0, 0.0 };
  HermiteTable gradation_;  ///< by the sine of the elevation; empty where it is not smooth
  HermiteTable indicatrix_; ///< by √(1 − cosine of the angle to the sun)
  std::uint64_t identity_;  ///< of this sky in what is remembered
};

/// The level's value. Throws std::invalid_argument where it is negative or not finite.
[[nodiscard]] double checkedLevel(const SkyLevel& level);

/// The uniform sky's radiance for a level.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT double uniformRadiance(const SkyLevel& level);

} // namespace lumitree

#endif
