// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_LightSamples_h
#define Lumitree_Radiometry_Estimate_LightSamples_h

#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/SkySource.h"
#include "Radiometry/Source.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

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
  Vec3 eye_;
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

  /// Steps from 0 to 1.
  template <std::size_t count>
  class Steps
  {
  public:
    /// As high as those weights, which are not negative.
    void set(const std::array<double, count>& weights);

    [[nodiscard]] double height(std::size_t step) const
    {
      return this->ends_[step + 1] - this->ends_[step];
    }

    /// The step in which a number in [0, 1) falls; the number becomes how far up it is, 0 … 1.
    std::size_t place(double& x) const
    {
      std::size_t step = this->first_[static_cast<std::size_t>(x * count)];
      while (x >= this->ends_[step + 1])
      {
        ++step;
      }
      x = std::min(1.0, (x - this->ends_[step]) * this->perHeight_[step]);
      return step;
    }

  private:
    std::array<double, count + 1> ends_{};
    std::array<double, count> perHeight_{};
    std::array<std::uint8_t, count> first_{}; ///< where i / count falls
  };

  const SkySource& sky_;
  std::array<Vec3, 3> axes_;
  Steps<rings> ringSteps_;
  std::array<Steps<sectors>, rings> sectorSteps_;
  std::array<std::array<double, sectors>, rings> weights_{}; ///< times the cosine with the zenith
  std::array<std::array<double, 2>, sectors> middles_{};     ///< cosine and sine of the azimuth
};

} // namespace lumitree

#endif
