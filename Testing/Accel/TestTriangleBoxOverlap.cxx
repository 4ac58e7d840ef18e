// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangle against box: never a box lost that the triangle touches (integers decide exactly), none
// kept that is clearly missed; touching in a point, slivers, far away, scales from subnormal to
// huge.
#include "Accel/Structures/TriangleBoxOverlap.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Corners = std::array<Vec3, 3>;
using Whole = std::array<std::int64_t, 3>;

/// The same question in whole numbers, where nothing rounds: the corners are doubled, so that the
/// box has a centre.
bool meets(const std::array<Whole, 3>& triangle, const Whole& lower, const Whole& upper)
{
  std::array<Whole, 3> v;
  Whole half;
  for (int k = 0; k < 3; ++k)
  {
    half[k] = upper[k] - lower[k];
    for (int i = 0; i < 3; ++i)
    {
      v[i][k] = 2 * triangle[i][k] - (lower[k] + upper[k]);
    }
  }
  const auto separates = [&](const Whole& axis)
  {
    std::int64_t radius = 0;
    std::array<std::int64_t, 3> p = { 0, 0, 0 };
    for (int k = 0; k < 3; ++k)
    {
      radius += std::abs(axis[k]) * half[k];
      for (int i = 0; i < 3; ++i)
      {
        p[i] += axis[k] * v[i][k];
      }
    }
    return std::min({ p[0], p[1], p[2] }) > radius || std::max({ p[0], p[1], p[2] }) < -radius;
  };
  const auto crossed = [](const Whole& a, const Whole& b)
  {
    return Whole{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  const auto edge = [&](int i)
  {
    const Whole& a = v[i];
    const Whole& b = v[(i + 1) % 3];
    return Whole{ b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  };
  const std::array<Whole, 3> units = { Whole{ 1, 0, 0 }, Whole{ 0, 1, 0 }, Whole{ 0, 0, 1 } };
  bool apart = separates(crossed(edge(0), edge(1)));
  for (int i = 0; i < 3; ++i)
  {
    apart = apart || separates(units[i]);
    for (int k = 0; k < 3; ++k)
    {
      apart = apart || separates(crossed(units[k], edge(i)));
    }
  }
  return !apart;
}

Vec3 placed(const Whole& p, double scale, const Vec3& offset)
{
  return { scale * static_cast<double>(p[0]) + offset[0],
    scale * static_cast<double>(p[1]) + offset[1], scale * static_cast<double>(p[2]) + offset[2] };
}

/// Random whole triangles and boxes, placed so that the doubles are exact; wrong answers of both
/// kinds.
void compare(int extent, double scale, const Vec3& offset, std::size_t& lost, std::size_t& kept)
{
  Uniform uniform(17);
  const auto whole = [&]
  {
    Whole p;
    for (std::int64_t& x : p)
    {
      x =
        static_cast<std::int64_t>(uniform.index(static_cast<std::size_t>(2 * extent + 1))) - extent;
    }
    return p;
  };
  for (int trial = 0; trial < 200000; ++trial)
  {
    const std::array<Whole, 3> t = { whole(), whole(), whole() };
    Whole lower = whole();
    Whole upper = whole();
    for (int k = 0; k < 3; ++k)
    {
      const std::int64_t size = std::abs(upper[k] - lower[k]) / 3;
      upper[k] = lower[k] + size;
    }
    const Box box = { placed(lower, scale, offset), placed(upper, scale, offset) };
    const TriangleBoxOverlap overlap(Corners{
      placed(t[0], scale, offset), placed(t[1], scale, offset), placed(t[2], scale, offset) });
    const bool truth = meets(t, lower, upper);
    const bool answer = overlap.mayMeet(box);
    lost += truth && !answer ? 1 : 0;
    kept += !truth && answer ? 1 : 0;
  }
}

TEST(TriangleBoxOverlap, WholeNumbersDecideAlike)
{
  for (const int extent : { 2, 5, 20, 300 })
  {
    std::size_t lost = 0;
    std::size_t kept = 0;
    compare(extent, 1.0, { 0, 0, 0 }, lost, kept);
    compare(extent, 0x1p-20, { 524288, -4194304, 131072 }, lost, kept);
    EXPECT_EQ(lost, 0u) << extent;
    EXPECT_EQ(kept, 0u) << extent;
  }
}

TEST(TriangleBoxOverlap, EveryScale)
{
  for (const double scale : { 0x1p-1070, 0x1p-1000, 0x1p-500, 0x1p-120, 0x1p120, 0x1p500, 0x1p980 })
  {
    std::size_t lost = 0;
    std::size_t kept = 0;
    compare(20, scale, { 0, 0, 0 }, lost, kept);
    EXPECT_EQ(lost, 0u) << scale;
    // Among the last subnormal numbers the bound is as large as the scene.
    EXPECT_LE(kept, scale < 0x1p-1060 ? 200000u : 0u) << scale;
  }
}

TEST(TriangleBoxOverlap, NeighboursOnEachSideOfATouch)
{
  const Corners triangle = { Vec3{ 0, 0, 0 }, Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 } };
  const TriangleBoxOverlap overlap(triangle);
  EXPECT_TRUE(overlap.mayMeet({ { 1, 0, 0 }, { 2, 1, 1 } }));     // in a vertex
  EXPECT_TRUE(overlap.mayMeet({ { 0, -1, -1 }, { 1, 0, 0 } }));   // along an edge
  EXPECT_TRUE(overlap.mayMeet({ { 0.5, 0.5, 0 }, { 2, 2, 0 } })); // a flat box, at the long edge
  EXPECT_TRUE(overlap.mayMeet({ { 0.25, 0.25, 0 }, { 0.25, 0.25, 0 } })); // a point box
  EXPECT_FALSE(overlap.mayMeet(
    { { 0.6, 0.6, -1 }, { 2, 2, 1 } })); // bounds overlap, the triangle is elsewhere
  EXPECT_FALSE(overlap.mayMeet({ { std::nextafter(1.0, 2.0), 0, 0 }, { 2, 1, 1 } }));
  EXPECT_FALSE(overlap.mayMeet({ { 0, 0, 0x1p-1074 }, { 1, 1, 1 } }));
}

TEST(TriangleBoxOverlap, PointsOfRandomTrianglesStayInTheirBoxes)
{
  // A point of the triangle, rounded to the nearest double and a box of a few ulp around it: always
  // met.
  Uniform uniform(23);
  for (int trial = 0; trial < 200000; ++trial)
  {
    Corners t;
    const double thin = trial % 2 == 0 ? 1.0 : 1e-9;
    const double offset = trial % 3 == 0 ? 1e6 : 0.0;
    for (Vec3& corner : t)
    {
      corner = { offset + uniform(-1, 1), uniform(-1, 1), offset + thin * uniform(-1, 1) };
    }
    const double u = uniform(0, 1);
    const double v = uniform(0, 1 - u);
    const Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    Box box;
    for (int k = 0; k < 3; ++k)
    {
      const double margin =
        8e-16 * std::max({ std::fabs(t[0][k]), std::fabs(t[1][k]), std::fabs(t[2][k]) });
      box.lower[k] = p[k] - margin;
      box.upper[k] = p[k] + margin;
    }
    ASSERT_TRUE(TriangleBoxOverlap(t).mayMeet(box)) << trial;
  }
}

} // namespace
