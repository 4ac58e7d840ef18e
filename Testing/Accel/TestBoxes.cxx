// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays on, in and beside the planes of boxes, where slab tests fail: on every axis, in both
// directions and at three lengths of the direction. First the slab test alone, then the same boxes
// as surfaces.
#include "Accel/Kernel/RayBox.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();
const double aboveOne = std::nextafter(1.0, 2.0);
const double belowZero = std::nextafter(0.0, -1.0);

/// A box and a ray in a base position.
struct Case
{
  const char* name;
  Vec3 lower;
  Vec3 upper;
  Vec3 origin;
  Vec3 direction;
  double t; ///< at which the ray first meets the box's boundary, at or after 0; infinity: never
  bool met = true;     ///< whether the ray meets the solid box
  bool surface = true; ///< whether the case is also tried on triangles
};

const std::vector<Case>& cases()
{
  const Vec3 zero = { 0, 0, 0 };
  const Vec3 one = { 1, 1, 1 };
  static const std::vector<Case> all = {
    { "on the lower plane", zero, one, { 0, 0.3, -1 }, { 0, 0, 1 }, 1 },
    { "on the lower plane, minus zeros", zero, one, { 0, 0.3, -1 }, { -0.0, -0.0, 1 }, 1 },
    { "on the upper plane", zero, one, { 1, 0.3, -1 }, { 0, 0, 1 }, 1 },
    { "on the upper plane, minus zeros", zero, one, { 1, 0.3, -1 }, { -0.0, -0.0, 1 }, 1 },
    { "on both upper planes", zero, one, { 1, 1, -1 }, { 0, 0, 1 }, 1 },
    { "on a lower and an upper plane", zero, one, { 0, 1, -1 }, { -0.0, 0, 1 }, 1 },
    { "just above the upper plane", zero, one, { aboveOne, 0.3, -1 }, { 0, 0, 1 }, infinity,
      false },
    { "just above, minus zero", zero, one, { aboveOne, 0.3, -1 }, { -0.0, 0, 1 }, infinity, false },
    { "just below the lower plane", zero, one, { belowZero, 0.3, -1 }, { 0, 0, 1 }, infinity,
      false },
    { "just below, minus zero", zero, one, { belowZero, 0.3, -1 }, { -0.0, 0, 1 }, infinity,
      false },
    { "flat box", zero, { 1, 1, 0 }, { 0.5, 0.25, -1 }, { 0, 0, 1 }, 1 },
    { "flat box, oblique", zero, { 1, 1, 0 }, { 0, 0, -1 }, { 0.5, 0.25, 1 }, 1 },
    { "corner of a flat box", zero, { 1, 1, 0 }, { 1, 1, -1 }, { 0, 0, 1 }, 1 },
    { "edge of a flat box", zero, { 1, 1, 0 }, { 1, 0.25, -1 }, { 0, 0, 1 }, 1 },
    { "in a flat box's plane", zero, { 1, 1, 0 }, { -1, 0.25, 0 }, { 1, 0, 0 }, infinity, true },
    { "point", { 0.5, 0.5, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0.5, -1 }, { 0, 0, 1 }, 1, true, false },
    { "point, oblique", { 0.5, 0.25, 0 }, { 0.5, 0.25, 0 }, { 0, 0, -1 }, { 0.5, 0.25, 1 }, 1, true,
      false },
    { "from the far face on", zero, one, { 0.5, 0.25, 1 }, { 0, 0, 1 }, 0 },
    { "from the near face on", zero, one, { 0.5, 0.25, 0 }, { 0, 0, 1 }, 0 },
    { "from within", zero, one, { 0.5, 0.25, 0.5 }, { 0, 0, 1 }, 0.5 },
    { "behind", zero, one, { 0.5, 0.25, 2 }, { 0, 0, 1 }, infinity, false },
    { "through a corner along the diagonal", zero, one, { -1, -1, -1 }, { 1, 1, 1 }, 1 },
    { "along an edge", zero, one, { 1, 1, -1 }, { 0, 0, 1 }, 1 },
    { "a component of 2^-133, a subnormal float", zero, one, { 0, 0.25, -1 }, { 0x1p-133, 0, 1 },
      1 },
    { "a component of 2^-100", zero, one, { 0, 0.25, -1 }, { 0x1p-100, 0, 1 }, 1 },
    { "a component without a finite reciprocal", zero, one, { 0.5, 0.25, -1 }, { 0x1p-1030, 0, 1 },
      1 },
    { "the same on the upper plane, leaning inward", zero, one, { 1, 0.25, -1 },
      { -0x1p-1030, 0, 1 }, 1 },
    { "tiny box", zero, { 0x1p-63, 0x1p-63, 0x1p-63 }, { 0x1p-64, 0x1p-65, -0x1p-63 }, { 0, 0, 1 },
      0x1p-63 },
    { "tiny box, on the upper plane", zero, { 0x1p-63, 0x1p-63, 0x1p-63 },
      { 0x1p-63, 0x1p-65, -0x1p-63 }, { 0, 0, 1 }, 0x1p-63 },
    { "huge box", zero, { 0x1p100, 0x1p100, 0x1p100 }, { 0x1p99, 0x1p98, -0x1p100 }, { 0, 0, 1 },
      0x1p100 },
    { "huge box, on the upper plane", zero, { 0x1p100, 0x1p100, 0x1p100 },
      { 0x1p100, 0x1p98, -0x1p100 }, { 0, 0, 1 }, 0x1p100 },
    { "flat grid's plane, leaving", zero, { 1, 1, 0 }, { 0.5, 0.25, 0 }, { 0, 0, 1 }, 0 },
    { "in the upper face's plane", zero, one, { -1, 0.25, 1 }, { 1, 0, 0 }, 1 },
  };
  return all;
}

/// A base position carried to another axis, mirrored at the origin, with a longer or shorter
/// direction.
struct Placement
{
  int axis;
  double sign;
  double scale;

  [[nodiscard]] Vec3 operator()(const Vec3& p) const
  {
    Vec3 q;
    for (int k = 0; k < 3; ++k)
    {
      q[(k + this->axis) % 3] = this->sign * p[k];
    }
    return q;
  }

  [[nodiscard]] Ray ray(const Case& c) const
  {
    return { (*this)(c.origin), this->scale * (*this)(c.direction) };
  }
};

std::vector<Placement> placements()
{
  std::vector<Placement> all;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      for (const double scale : { 1.0, 0x1p40, 0x1p-40 })
      {
        all.push_back({ axis, sign, scale });
      }
    }
  }
  return all;
}

/// The twelve triangles of a box, or the two of a flat one.
std::vector<std::array<Vec3, 3>> trianglesOf(const Case& c, const Placement& place)
{
  std::vector<std::array<Vec3, 3>> triangles;
  for (int k = 0; k < 3; ++k)
  {
    for (const bool upper : { false, true })
    {
      if (upper && c.lower[k] == c.upper[k])
      {
        continue;
      }
      std::array<Vec3, 4> corners;
      for (int i = 0; i < 4; ++i)
      {
        Vec3 p = upper ? c.upper : c.lower;
        p[(k + 1) % 3] = (i == 1 || i == 2 ? c.upper : c.lower)[(k + 1) % 3];
        p[(k + 2) % 3] = (i >= 2 ? c.upper : c.lower)[(k + 2) % 3];
        p[k] = (upper ? c.upper : c.lower)[k];
        corners[i] = place(p);
      }
      triangles.push_back({ corners[0], corners[1], corners[2] });
      triangles.push_back({ corners[0], corners[2], corners[3] });
    }
  }
  return triangles;
}

TEST(Boxes, SlabTestMeetsWhatTheRayMeetsAndNothingElse)
{
  ASSERT_GE(cases().size(), 33u);
  for (const Case& c : cases())
  {
    for (const Placement& place : placements())
    {
      SCOPED_TRACE(std::string(c.name) + ", axis " + std::to_string(place.axis) + ", sign " +
        std::to_string(place.sign) + ", scale " + std::to_string(place.scale));
      Box box;
      box.extend(place(c.lower));
      box.extend(place(c.upper));
      const Ray ray = place.ray(c);
      double tEnter = -1.0;
      EXPECT_EQ(RayBox(ray).meets(box, infinity, tEnter), c.met);
      if (c.met && c.t < infinity)
      {
        EXPECT_LE(tEnter, c.t / place.scale);
        double ignored = 0.0;
        EXPECT_TRUE(RayBox(ray).meets(box, c.t / place.scale, ignored)) << "cut at t";
      }
    }
  }
}

TEST(Boxes, SlabTestEndsWhereTheSegmentEnds)
{
  Box box;
  box.extend(Vec3{ 0, 0, 0 });
  box.extend(Vec3{ 1, 1, 1 });
  double tEnter = 0.0;
  const auto meets = [&](double tMin, double tMax)
  {
    const Ray ray = { { 0.5, 0.5, -1 }, { 0, 0, 1 }, tMin, tMax };
    return RayBox(ray).meets(box, tMax, tEnter);
  };
  EXPECT_TRUE(meets(0, 1));
  EXPECT_FALSE(meets(0, 0.999));
  EXPECT_TRUE(meets(2, 3));
  EXPECT_FALSE(meets(2.001, 3));
  EXPECT_TRUE(meets(-infinity, infinity));
  EXPECT_TRUE(meets(1.5, 1.5));
  EXPECT_FALSE(meets(-5, -1));
}

TEST(Boxes, SubnormalDirectionsStillPassBesideSlabs)
{
  Box box;
  box.extend(Vec3{ 0, 0, 0 });
  box.extend(Vec3{ 1, 1, 1 });
  double tEnter = 0.0;
  for (const double beside : { -1.0, 2.0, belowZero, aboveOne })
  {
    for (const double tMin : { 0.0, -infinity })
    {
      for (const double zero : { 0.0, -0.0 })
      {
        const Ray ray = { { 0.5, beside, 0.5 }, { 0x1p-1030, zero, zero }, tMin };
        EXPECT_FALSE(RayBox(ray).meets(box, infinity, tEnter)) << beside;
      }
    }
  }
  EXPECT_TRUE(RayBox(Ray{ { -1, 0.5, 1 }, { 0x1p-1030, 0, 0 } }).meets(box, infinity, tEnter));
  // Where t overflows, the box is still there.
  Box far;
  far.extend(Vec3{ 0, 0, 0x1p100 });
  far.extend(Vec3{ 1, 1, 0x1p101 });
  EXPECT_TRUE(RayBox(Ray{ { 0.5, 0.5, 0 }, { 0, 0, 0x1p-1000 } }).meets(far, infinity, tEnter));
  EXPECT_FALSE(RayBox(Ray{ { 0.5, 0.5, 0 }, { 0, 0, -0x1p-1000 } }).meets(far, infinity, tEnter));
  EXPECT_TRUE(
    RayBox(Ray{ { 0.5, 0.5, 0 }, { 0, 0, -0x1p-1000 }, -infinity }).meets(far, infinity, tEnter));
}

/// Few numbers, so that rays run in planes, beside boxes and through their corners all the time.
TEST(Boxes, TwoAtOnceAreMetAsEachAlone)
{
  const double numbers[] = { 0.0, -0.0, 1.0, -1.0, 0.5, 3.0, 0x1p-1030, -0x1p-1030, 0x1p-1000,
    0x1p100, -0x1p100 };
  const double limits[] = { -infinity, 0.0, 0.5, 2.0, infinity };
  Uniform uniform(12);
  const auto any = [&] { return numbers[uniform.index(std::size(numbers))]; };
  const auto point = [&] { return Vec3{ any(), any(), any() }; };
  std::size_t met[4] = {};
  for (int i = 0; i < 200000; ++i)
  {
    const RayBox ray(Ray{ point(), point(), limits[uniform.index(3)] });
    const double tStop = limits[1 + uniform.index(4)];
    Box boxes[2];
    for (Box& box : boxes)
    {
      box.extend(point());
      box.extend(point());
    }
    double entered[2] = {};
    double alone[2] = {};
    const unsigned both = ray.meetPair(boxes[0], boxes[1], tStop, entered);
    for (unsigned b : { 0u, 1u })
    {
      ASSERT_EQ(ray.meets(boxes[b], tStop, alone[b]), (both >> b & 1u) != 0) << i;
      ASSERT_TRUE((both >> b & 1u) == 0 || alone[b] == entered[b]) << i;
    }
    ++met[both];
  }
  EXPECT_GT(*std::min_element(met, met + 4), 1000u);
}

TEST(Boxes, EmptyBoxIsNeverMet)
{
  double tEnter = 0.0;
  EXPECT_FALSE(RayBox(Ray{ { 0, 0, 0 }, { 0, 0, 1 } }).meets(Box{}, infinity, tEnter));
  EXPECT_FALSE(RayBox(Ray{ { 0, 0, 0 }, { 1, -1, 1 } }).meets(Box{}, infinity, tEnter));
}

template <class T>
void everyStructureFindsTheBoundary()
{
  for (const Case& c : cases())
  {
    if (!c.surface)
    {
      continue;
    }
    for (const Placement& place : placements())
    {
      const auto surface = surfaceOf<T>(trianglesOf(c, place));
      const Ray ray = place.ray(c);
      for (const auto& accelerator : accelerators(surface))
      {
        for (const Precision precision : everyPrecision)
        {
          if (precision == Precision::Watertight && c.t == infinity)
          {
            continue; // what it cannot tell from a hit, such as a parallel ray, it counts
          }
          SCOPED_TRACE(std::string(c.name) + ", axis " + std::to_string(place.axis) + ", sign " +
            std::to_string(place.sign) + ", scale " + std::to_string(place.scale) + ", " +
            label(accelerator->options()) + ", " + std::string(name(precision)));
          const Hit hit = closestOf(*accelerator, ray, precision);
          ASSERT_EQ(hit.t, c.t / place.scale);
          ASSERT_EQ(hit.primitive != noPrimitive, c.t < infinity);
        }
      }
    }
  }
}

TEST(Boxes, EveryStructureFindsTheBoundaryOfDoubles)
{
  everyStructureFindsTheBoundary<double>();
}

TEST(Boxes, EveryStructureFindsTheBoundaryOfFloats)
{
  everyStructureFindsTheBoundary<float>();
}

TEST(Boxes, FlatGridIsHitAtVerticesCornersAndBoundary)
{
  const auto grid = surfaceOf<float>(data::terrain(16, 1, 0.0));
  for (const auto& accelerator : accelerators(grid))
  {
    for (const Precision precision : everyPrecision)
    {
      SCOPED_TRACE(label(accelerator->options()) + ", " + std::string(name(precision)));
      for (int i = 0; i <= 16; ++i)
      {
        for (int j = 0; j <= 16; ++j)
        {
          const Vec3 target = { i / 16.0, j / 16.0, 0.0 };
          const Ray straight = { { target[0], target[1], -1 }, { 0, 0, 1 } };
          ASSERT_EQ(closestOf(*accelerator, straight, precision).t, 1.0) << i << " " << j;
          const Ray oblique = { { 0.5, 0.25, 2 }, target - Vec3{ 0.5, 0.25, 2 } };
          ASSERT_EQ(closestOf(*accelerator, oblique, precision).t, 1.0) << i << " " << j;
        }
      }
    }
  }
}

TEST(Boxes, TinyAndHugeBoxesAreExact)
{
  for (const double size : { 0x1p-1000, 0x1p-500, 0x1p-300, 0x1p300, 0x1p900 })
  {
    Case c = cases().front();
    c.upper = { size, size, size };
    c.origin = { size, 0.25 * size, -size };
    for (const Placement& place : placements())
    {
      const auto surface = surfaceOf<double>(trianglesOf(c, place));
      ASSERT_EQ(surface->hittable().size(), 12u) << size;
      for (const auto& accelerator : accelerators(surface))
      {
        const Hit hit = closestOf(*accelerator, place.ray(c), Precision::Exact);
        ASSERT_EQ(hit.t, size / place.scale) << size << " " << label(accelerator->options());
      }
    }
  }
}

TEST(Boxes, OriginsBeyondTheRangeOfFloatsAreFollowed)
{
  // A scene of size 2^-100, so that in its own units the origin is 2^140 away, before and behind.
  const double size = 0x1p-100;
  Case c = cases().front();
  c.upper = { size, size, size };
  for (const Placement& place : placements())
  {
    for (const auto& accelerator : accelerators(surfaceOf<double>(trianglesOf(c, place))))
    {
      for (const double distance : { 0x1p-40, 0x1p0, 0x1p40 })
      {
        c.origin = { 0.5 * size, 0.25 * size, -distance };
        Ray ray = place.ray(c);
        const Hit ahead = closestOf(*accelerator, ray, Precision::Exact);
        ASSERT_EQ(ahead.t, distance / place.scale) << label(accelerator->options());
        ray.direction = -1.0 * ray.direction;
        ray.tMin = -HUGE_VAL;
        ray.tMax = 0.0;
        const Hit behind = closestOf(*accelerator, ray, Precision::Exact);
        ASSERT_EQ(behind.t, -distance / place.scale) << label(accelerator->options());
      }
    }
  }
}

/// Triangles far smaller than a float's last place, one a leaf, seen from where the origin has no
/// room for error: all that a box may still be met by is what the slab test allows for rounding.
/// Coordinates just above powers of two round worst.
TEST(Boxes, PointsAreMetFromTheMiddleOfTheScene)
{
  constexpr std::size_t count = 20000;
  Uniform uniform(71);
  // The first two make the middle of the scene the origin.
  std::vector<std::array<Vec3, 3>> triangles = { { Vec3{ -1, -1, -1 }, Vec3{ -0.9, -1, -1 },
                                                   Vec3{ -1, -0.9, -1 } },
    { Vec3{ 1, 1, 1 }, Vec3{ 0.9, 1, 1 }, Vec3{ 1, 0.9, 1 } } };
  while (triangles.size() < count)
  {
    Vec3 p;
    for (double& x : p)
    {
      x = (uniform.index(2) == 0 ? -1 : 1) * uniform(0.5, 0.53);
    }
    constexpr double size = 1e-12;
    triangles.push_back({ p, p + Vec3{ size, -size, 0 }, p + Vec3{ 0, size, size } });
  }
  const auto surface = surfaceOf<double>(triangles);
  BuildOptions options = optionsOf(Structure::WideBvh);
  options.leafSize = 1;
  const auto wide = build(surface, options);
  const auto binary = build(surface, optionsOf(Structure::Bvh));
  for (const double tMin : { 0.0, -1.0 })
  {
    Rays rays;
    for (std::size_t i = 0; i < 10 * count; ++i)
    {
      const auto& t = triangles[i % count];
      rays.add(Ray{ { 0, 0, 0 }, uniform(0.95, 1) / 3 * (t[0] + t[1] + t[2]), tMin, HUGE_VAL });
    }
    std::vector<Hit> wanted(rays.size());
    std::vector<Hit> found(rays.size());
    binary->closest(rays.batch(), wanted.data(), with(Precision::Exact));
    wide->closest(rays.batch(), found.data(), with(Precision::Exact));
    std::size_t lost = 0;
    std::size_t met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      lost += sameBits(found[i], wanted[i]) ? 0 : 1;
      met += wanted[i].primitive == noPrimitive ? 0 : 1;
    }
    EXPECT_GT(met, rays.size() / 2);
    EXPECT_EQ(lost, 0u) << "tMin " << tMin;
  }
}

} // namespace
