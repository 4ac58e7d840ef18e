// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_LightSamples_h
#define Lumitree_Radiometry_Estimate_LightSamples_h

#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/SkySource.h"
#include "Radiometry/Source.h"

#include <array>
#include <cstddef>

namespace lumitree
{

/// Directions to some light, many at a time.
class LightSamples
{
public:
  virtual ~LightSamples() = default;

  /// samples[i] for points[i] of the unit square. Weights may be 0.
  virtual void draw(
    const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const = 0;
};

/// As the source draws them.
class WholeSourceSamples : public LightSamples
{
public:
  WholeSourceSamples(const Source& source, const Vec3& eye)
    : source_(source)
    , eye_(eye)
  {
  }

  void draw(
    const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const override;

private:
  const Source& source_;
  const Vec3& eye_;
};

/// Directions above a surface by the cosine with its normal: under an even sky each counts the
/// same. Only for sided views.
class CosineSkySamples : public LightSamples
{
public:
  CosineSkySamples(const SkySource& sky, const Vec3& normal);

  void draw(
    const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const override;

  /// Whether few enough of them go below the horizon.
  [[nodiscard]] static bool suits(const SkySource& sky, const View& view);

private:
  const SkySource& sky_;
  std::array<Vec3, 3> axes_;
};

/// Directions by the radiance of the sky, in steps, times the cosine with the zenith: on nearly
/// level ground each counts nearly the same under any sky. Only for sided views.
class RadianceSkySamples : public LightSamples
{
public:
  explicit RadianceSkySamples(const SkySource& sky);

  void draw(
    const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const override;

  /// Whether the ground is level enough.
  [[nodiscard]] static bool suits(const SkySource& sky, const View& view);

private:
  static constexpr std::size_t rings = 32;
  static constexpr std::size_t sectors = 64;

  /// Where a number in [0, 1) falls among steps that rise from 0 to 1.
  struct Place
  {
    std::size_t step;
    double within; ///< 0 … 1
  };
  static Place place(const double* steps, std::size_t count, double x);

  const SkySource& sky_;
  std::array<Vec3, 3> axes_;
  std::array<double, rings + 1> ringSteps_{};
  std::array<std::array<double, sectors + 1>, rings> sectorSteps_{};
};

} // namespace lumitree

#endif
