// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Reference values, each computed twice with 30 digits: the closed form, and quadrature.
#include "Radiometry/Constants.h"
#include "Radiometry/LambertPolygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace lumitree;

using Polygon = std::vector<Vec3>;

const Vec3 up = { 0.0, 0.0, 1.0 };

double irradiance(const Polygon& p, const Vec3& normal = up)
{
  return polygonIrradiance(p.data(), p.size(), normal);
}

Polygon rectangle(double x0, double x1, double y0, double y1, double z)
{
  return { { x0, y0, z }, { x1, y0, z }, { x1, y1, z }, { x0, y1, z } };
}

void expectNear(double value, double reference, double tolerance = 1e-12)
{
  EXPECT_NEAR(value, reference, tolerance * std::fabs(reference));
}

TEST(LambertPolygon, Anchors)
{
  expectNear(100.0 * irradiance(rectangle(0, 2, 0, 3, 1.5)), 59.0882481095204); // R1
  // R2: a wall, its foot's end at the side of the receiver.
  expectNear(100.0 * irradiance({ { 1.5, 0, 0 }, { 1.5, 3, 0 }, { 1.5, 3, 2 }, { 1.5, 0, 2 } }),
    29.07569437175872);
  expectNear(100.0 * irradiance(rectangle(-.5, .5, -.5, .5, 1.0)), 75.22746884541075);     // R8
  expectNear(100.0 * irradiance(rectangle(-.5, .5, -.5, .5, 1e-3)), 314.1582370439335);    // R9
  expectNear(100.0 * irradiance(rectangle(-.5, .5, -.5, .5, 1e6)), 9.999999999996667e-11); // R10
  expectNear(100.0 * irradiance({ { 1, .2, 1.5 }, { -.5, 1.2, 2 }, { -.3, -.9, 1 } }),
    54.49364922819212); // G1
  expectNear(
    100.0 * irradiance({ { 2, 0, 1 }, { 2, 2, -1 }, { 2, -1, -.5 } }), 2.917415718833383); // G2
  const Polygon triangle = { { 1, 0, 2 }, { 0, 1, 2 }, { -1, -1, 2 } };
  expectNear(1000.0 / (4.0 * pi) * polygonSolidAngle(triangle.data(), 3), 26.67575458393696); // P5
}

TEST(LambertPolygon, FarAwayItKeepsItsDigits)
{
  // Off the axis, where Lambert's sum cancels: the integral with one term more than the centroid's.
  for (const double d : { 1e2, 1e3, 1e4, 1e6, 1e8 })
  {
    const Vec3 way = { 0.6 * d, 0.0, 0.8 * d };
    const Polygon p = rectangle(way[0] - .5, way[0] + .5, -.5, .5, way[2]);
    const double centroid = 0.8 * 0.8 / (d * d);
    EXPECT_NEAR(irradiance(p) / centroid, 1.0, 1.0 / (d * d) + 1e-14) << d;
    EXPECT_NEAR(polygonSolidAngle(p.data(), 4) / (0.8 / (d * d)), 1.0, 1.0 / (d * d) + 1e-14) << d;
  }
  // Both ways agree where one takes over from the other.
  for (const double h : { 0.6 * 200.0, 0.7 * 200.0, 1.41 * 200.0, 1.42 * 200.0, 1.5 * 200.0 })
  {
    const double exact = irradiance(rectangle(0, 1, 0, 1, h));
    const double a = 1.0 / std::sqrt(1.0 + h * h);
    expectNear(exact, a * std::atan(a), 1e-11);
  }
}

TEST(LambertPolygon, WindingAndShapeDoNotMatter)
{
  const Polygon l = { { 0, 0, 1 }, { 2, 0, 1 }, { 2, 1, 1 }, { 1, 1, 1 }, { 1, 2, 1 },
    { 0, 2, 1 } };
  const Polygon back(l.rbegin(), l.rend());
  const double parts = irradiance(rectangle(0, 2, 0, 1, 1)) + irradiance(rectangle(0, 1, 1, 2, 1));
  expectNear(irradiance(l), parts);
  expectNear(irradiance(back), parts);
  const Vec3 tilted = { 0.6, 0.0, -0.8 }; // the horizon cuts the L
  const double clipped =
    irradiance(rectangle(0, 2, 0, 1, 1), tilted) + irradiance(rectangle(0, 1, 1, 2, 1), tilted);
  expectNear(irradiance(l, tilted), clipped);
  const Vec3 d = polygonLightVector(back.data(), back.size());
  expectNear(d[2], parts);
  EXPECT_GT(d[0], 0.0);
}

TEST(LambertPolygon, NeverNegativeNorNaN)
{
  const std::vector<Polygon> hard = {
    rectangle(-1, 1, -1, 1, 0), // around the receiver
    rectangle(1, 2, -1, 1, 0),  // in its plane
    rectangle(0, 1, 0, 1, 0),   // a corner at the receiver
    rectangle(-1, 1, -1, 1, 1e-300),
    rectangle(-1, 1, -1, 1, 1e-17),
    rectangle(-1, 1, -1, 1, -1),               // below
    { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }, // a point
    { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, // a line
    { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } },
    { { 1, 0, 1 }, { 0, 1, 1 } },
    {},
  };
  for (const Polygon& p : hard)
  {
    for (const Vec3& n : { up, Vec3{ 0, 0, -1 }, Vec3{ 1, 0, 0 }, Vec3{ 0.6, 0.0, 0.8 } })
    {
      const double e = irradiance(p, n);
      EXPECT_GE(e, 0.0);
      EXPECT_LE(e, pi * (1.0 + 1e-12));
    }
    const double omega = polygonSolidAngle(p.data(), p.size());
    EXPECT_GE(omega, 0.0);
    EXPECT_LE(omega, 2.0 * pi);
    EXPECT_TRUE(isFinite(polygonLightVector(p.data(), p.size())));
  }
  EXPECT_EQ(irradiance(rectangle(-1, 1, -1, 1, -1)), 0.0);
  expectNear(irradiance(rectangle(-1, 1, -1, 1, 1e-9)), pi, 1e-8);
}

} // namespace
