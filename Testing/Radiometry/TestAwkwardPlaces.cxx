// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every kind of source from places where formulas divide by zero: numbers stay between 0 and what
// there is with nothing in the way.
#include "Radiometry/Constants.h"
#include "Radiometry/CosineLobeSource.h"
#include "Radiometry/DirectionalSource.h"
#include "Radiometry/DiskSource.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/IsotropicPointSource.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/LineSource.h"
#include "Radiometry/PhotometricSource.h"
#include "Radiometry/PhotometricWeb.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SphereSource.h"
#include "Radiometry/SpotSource.h"
#include "Radiometry/SunDiskSource.h"
#include "Radiometry/TubeSource.h"
#include "Testing/Accel/TestHelpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace
{

using namespace lumitree;
using lumitree::testing::surfaceOf;

using Triangles = std::vector<std::array<Vec3, 3>>;

/// All kinds, each around that point, of the size of 1.
std::vector<std::pair<std::string, std::unique_ptr<Source>>> sourcesAt(const Vec3& o)
{
  const Vec3 down = { 0, 0, -1 };
  std::vector<std::pair<std::string, std::unique_ptr<Source>>> all;
  all.emplace_back("point", std::make_unique<IsotropicPointSource>(10.0, o));
  all.emplace_back("lobe", std::make_unique<CosineLobeSource>(10.0, 20.0, o, down));
  all.emplace_back("spot", std::make_unique<SpotSource>(10.0, 0.4, 0.6, o, down));
  auto web = std::make_shared<PhotometricWeb>();
  web->verticals = { 0.0, 45.0, 90.0 };
  web->horizontals = { 0.0 };
  web->intensities = { 100.0, 50.0, 0.0 };
  all.emplace_back("web", std::make_unique<PhotometricSource>(web, o, down, Vec3{ 1, 0, 0 }));
  // With a reflex vertex at o.
  const std::vector<Vec3> corners = { o + Vec3{ -1, -1, 0 }, o + Vec3{ -1, 1, 0 },
    o + Vec3{ 0, 1, 0 }, o, o + Vec3{ 1, 0, 0 }, o + Vec3{ 1, -1, 0 } };
  all.emplace_back("polygon",
    std::make_unique<PolygonSource>(std::vector<EmittingPolygon>{ { corners, {}, 10.0, true } }));
  all.emplace_back("sphere", std::make_unique<SphereSource>(10.0, o, 0.5));
  all.emplace_back("disk", std::make_unique<DiskSource>(10.0, o, down, 1.0, true));
  all.emplace_back(
    "tube", std::make_unique<TubeSource>(10.0, o + Vec3{ -1, 0, 0 }, o + Vec3{ 1, 0, 0 }, 0.25));
  all.emplace_back(
    "line", std::make_unique<LineSource>(10.0, o + Vec3{ -1, 0, 0 }, o + Vec3{ 1, 0, 0 }));
  all.emplace_back("even line",
    std::make_unique<LineSource>(
      10.0, o + Vec3{ -1, 0, 0 }, o + Vec3{ 1, 0, 0 }, LineSource::Distribution::Isotropic));
  all.emplace_back("parallel", std::make_unique<DirectionalSource>(10.0, Vec3{ 0.1, 0, -1 }));
  all.emplace_back("sun", std::make_unique<SunDiskSource>(10.0, Vec3{ 0.1, 0, -1 }, 0.01));
  all.emplace_back("uniform", std::make_unique<UniformSky>(10.0));
  all.emplace_back(
    "overcast", std::make_unique<OvercastSky>(SkyLevel{ SkyLevel::Kind::ZenithRadiance, 10.0 }));
  all.emplace_back("clear",
    std::make_unique<GeneralSky>(
      cieSky(12), Vec3{ 0.3, 0, 1 }, SkyLevel{ SkyLevel::Kind::ZenithRadiance, 10.0 }));
  return all;
}

/// A screen beside and below the source, one through it, one that touches it, and a floor.
std::shared_ptr<const Accelerator> screensAround(const Vec3& o)
{
  Triangles all;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    all.push_back({ { o + a, o + b, o + c } });
  };
  add({ 0, -2, -1 }, { 2, -2, -1 }, { 2, 2, -1 });
  add({ 0.5, -1, -0.5 }, { 0.5, 1, -0.5 }, { 0.5, 0, 0.5 });
  add({ -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 });
  add({ -9, -9, -2 }, { 9, -9, -2 }, { 0, 18, -2 });
  return build(surfaceOf<double>(all));
}

class AwkwardPlaces : public ::testing::TestWithParam<double>
{
};

TEST_P(AwkwardPlaces, NumbersStayWithinWhatThereIs)
{
  const double offset = GetParam();
  const Vec3 o = { offset, -offset, 0.5 * offset };
  const auto occluders = screensAround(o);
  std::vector<double> positions;
  std::vector<double> normals;
  // On it, at the reflex vertex, in its plane, at its rim, on its surface and next to that, behind
  // it, on the screens and their edges, and far off.
  for (const Vec3& way :
    { Vec3{ 0, 0, 0 }, Vec3{ 1e-12, 0, -1e-12 }, Vec3{ 0, 0, -1e-9 }, Vec3{ 0.5, 0.5, 0 },
      Vec3{ 3, 3, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 1.5, 0, 0 }, Vec3{ 0, 0, -0.5 },
      Vec3{ 0, 0, -0.5000001 }, Vec3{ 0, 0, -0.25 }, Vec3{ 0, 0.25, 1e-14 }, Vec3{ 0.3, 0.1, 1 },
      Vec3{ 0.5, 0, 0 }, Vec3{ 1, -1, -1 }, Vec3{ 0, -2, -1 }, Vec3{ 0, 0, -2 },
      Vec3{ 1e-3, 0, -1e-3 }, Vec3{ 1e6, 0, 0 }, Vec3{ 0, 1, -1e6 }, Vec3{ 3e5, -1e6, 2e5 } })
  {
    for (const Vec3& n :
      { Vec3{ 0, 0, 1 }, Vec3{ 0, 0, -1 }, Vec3{ 1, 0, 0 }, Vec3{ 0.6, 0, 0.8 } })
    {
      const Vec3 p = o + way;
      positions.insert(positions.end(), p.begin(), p.end());
      normals.insert(normals.end(), n.begin(), n.end());
    }
  }
  Receivers receivers;
  receivers.size = positions.size() / 3;
  receivers.positions = positions.data();
  receivers.normals = normals.data();
  for (const auto& [kind, source] : sourcesAt(o))
  {
    for (const std::uint32_t clipped : { 512u, 0u })
    {
      const std::size_t size = receivers.size;
      std::vector<double> e(size), back(size), scalar(size), cylinder(size), hemisphere(size),
        lower(size), upper(size), open(size), vector(3 * size);
      EstimateOutputs out;
      out.irradiance = e.data();
      out.back = back.data();
      out.scalar = scalar.data();
      out.vector = vector.data();
      out.cylindrical = cylinder.data();
      out.hemispherical = hemisphere.data();
      out.lower = lower.data();
      out.upper = upper.data();
      out.unoccluded = open.data();
      EstimateOptions options;
      options.occluders = occluders.get();
      options.mostClipped = clipped;
      options.maximumRays = 256;
      estimateLight(receivers, { source.get() }, out, options);
      for (std::size_t i = 0; i < size; ++i)
      {
        const Vec3 p = receivers.positions.triple(i);
        if (std::isnan(source->scalarIrradiance(p)))
        {
          // At a point, or on a line: nothing is defined, and nothing is made up.
          EXPECT_TRUE(std::isnan(e[i]) || e[i] == 0.0) << kind << " " << i;
          continue;
        }
        const double most = open[i] * (1.0 + 1e-12);
        EXPECT_GE(e[i], 0.0) << kind << " " << i;
        EXPECT_LE(e[i], most) << kind << " " << i;
        EXPECT_GE(lower[i], 0.0) << kind << " " << i;
        EXPECT_LE(lower[i], e[i]) << kind << " " << i;
        EXPECT_GE(upper[i], e[i]) << kind << " " << i;
        EXPECT_LE(upper[i], most) << kind << " " << i;
        const double whole = source->scalarIrradiance(p) * (1.0 + 1e-9) + 1e-300;
        for (const double x : { back[i], scalar[i], cylinder[i], hemisphere[i] })
        {
          EXPECT_GE(x, 0.0) << kind << " " << i;
          EXPECT_LE(x, whole) << kind << " " << i;
        }
        EXPECT_LE(length({ vector[3 * i], vector[3 * i + 1], vector[3 * i + 2] }), whole)
          << kind << " " << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Offsets, AwkwardPlaces, ::testing::Values(0.0, 5e6));

} // namespace
