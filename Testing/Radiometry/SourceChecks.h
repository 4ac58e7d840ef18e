// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Radiometry_SourceChecks_h
#define Testing_Radiometry_SourceChecks_h

#include "Radiometry/Source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// What holds for every source of light.
namespace sourcechecks
{

inline void expectRelative(double value, double reference, double tolerance = 1e-10)
{
  EXPECT_NEAR(value, reference, tolerance * std::fabs(reference));
}

/// The mean of samples is the closed form. Points of the square: a lattice (Korobov), even enough
/// for a tolerance far below that of random points.
inline void expectSamplesMeanIrradiance(const lumitree::Source& source,
  const lumitree::Vec3& position, const lumitree::Vec3& normal, double tolerance)
{
  constexpr int count = 65521;
  double sum = 0.0;
  double scalar = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double u = (i + 0.5) / count;
    const double v = std::fmod(i * 17364.0 / count, 1.0);
    const lumitree::SourceSample s = source.sample(position, u, v);
    EXPECT_GE(s.weight, 0.0);
    const double cosine =
      lumitree::dot(normal, s.sightline.direction) / lumitree::length(s.sightline.direction);
    sum += s.radiance * s.weight * std::max(0.0, cosine);
    scalar += s.radiance * s.weight;
  }
  expectRelative(sum / count, source.irradiance(position, normal), tolerance);
  expectRelative(scalar / count, source.scalarIrradiance(position), tolerance);
}

/// What a sphere around the source catches is its flux: irradiances at spiral points.
inline void expectFluxThroughSphere(
  const lumitree::Source& source, const lumitree::Vec3& middle, double radius, double tolerance)
{
  using namespace lumitree;
  constexpr int count = 20000;
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    const double phi = 2.399963229728653 * i;
    const Vec3 outward = { r * std::cos(phi), r * std::sin(phi), z };
    sum += source.irradiance(middle + radius * outward, -1.0 * outward);
  }
  expectRelative(
    sum / count * 4.0 * 3.141592653589793 * radius * radius, source.flux().value(), tolerance);
}

/// Around a source of that size: finite, not negative, and the light vector is what the irradiances
/// on two sides say.
inline void expectSane(const lumitree::Source& source, const lumitree::Vec3& middle, double size)
{
  using namespace lumitree;
  const Vec3 normals[] = { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 }, { 0.6, -0.8, 0.0 },
    { 0.48, 0.64, 0.6 }, { -2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0 } };
  const Vec3 ways[] = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 },
    { 0.5, 0.5, 0.0 }, { 0.6, -0.7, 0.2 }, { -0.3, 0.1, 1e-9 }, { 0.3, 0.3, -0.9 } };
  for (const Vec3& way : ways)
  {
    for (const double distance : { 1e-9, 1e-3, 0.5, 1.0, 30.0, 1e3, 1e6, 1e12 })
    {
      const Vec3 position = middle + (distance * size) * way;
      const Vec3 vector = source.lightVector(position);
      const double scalar = source.scalarIrradiance(position);
      EXPECT_GE(scalar, 0.0);
      EXPECT_TRUE(std::isfinite(scalar));
      for (const Vec3& normal : normals)
      {
        const double front = source.irradiance(position, normal);
        const double back = source.irradiance(position, -1.0 * normal);
        EXPECT_GE(front, 0.0) << distance;
        EXPECT_TRUE(std::isfinite(front)) << distance;
        EXPECT_LE(front, scalar * (1.0 + 1e-6) + 1e-300) << distance;
        // Far away, and at a corner, edges of the horizon have fewer digits than the whole.
        EXPECT_NEAR(
          front - back, dot(normal, vector), 1e-12 * scalar * (1e3 + distance + 1e-3 / distance))
          << distance << " " << way[0] << " " << way[1] << " " << way[2];
      }
      const SourceSample sample = source.sample(position, 0.3, 0.7);
      EXPECT_TRUE(std::isfinite(sample.radiance * sample.weight));
      EXPECT_GE(sample.weight, 0.0);
    }
  }
}

} // namespace sourcechecks

#endif
