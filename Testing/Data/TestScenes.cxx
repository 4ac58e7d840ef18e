// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshChecks.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

using namespace lumitree::data;
using namespace lumitree::data::testing;

TEST(CornellBox, HasItsSeventeenFaces)
{
  const Mesh mesh = cornellBox();
  EXPECT_TRUE(isConsistent(mesh));
  EXPECT_EQ(mesh.numberOfCells(), 17);
  EXPECT_EQ(mesh.numberOfTriangles(), 34);
  EXPECT_EQ(mesh.numberOfPoints(), 8 + 4 + 8 + 8);
}

TEST(CornellBox, SubdividesWithoutSeams)
{
  for (const int n : { 2, 7, 50 })
  {
    const Mesh mesh = cornellBox(n);
    EXPECT_EQ(mesh.numberOfCells(), 17 * n * n);
    const EdgeCounts edges = countEdges(mesh);
    // The light's border and the two blocks' feet.
    EXPECT_EQ(edges.open, 12 * n);
    EXPECT_EQ(edges.wrong, 0);
    // The room is 6, the light 0.09, a block's top 0.09, its sides 4 x 0.3 x height.
    EXPECT_NEAR(area(mesh), 6 + 0.09 + 2 * 0.09 + 1.2 * (0.3 + 0.6), 1e-8);
  }
}

TEST(CornellBox, LightFacesDown)
{
  const Mesh light = partOf(cornellBox(3), "light");
  EXPECT_EQ(light.numberOfCells(), 9);
  // The volume under a face at height z is z/3 of the area it turns upward.
  EXPECT_NEAR(signedVolume(light), -0.995 * 0.09 / 3, 1e-12);
  EXPECT_EQ(light.reflectance.front(), 0);
}

TEST(Teapot, HasNewellsBounds)
{
  const Bounds box = bounds(teapot(64));
  EXPECT_EQ(box.low[0], -3);
  EXPECT_NEAR(box.high[0], 3.434, 1e-3);
  EXPECT_EQ(box.low[1], -2);
  EXPECT_EQ(box.high[1], 2);
  EXPECT_EQ(box.low[2], 0);
  EXPECT_EQ(box.high[2], 3.15);
}

TEST(Teapot, IsWeldedAlongPatchBorders)
{
  for (const int n : { 2, 3, 10, 23 })
  {
    const Mesh mesh = teapot(n);
    EXPECT_TRUE(isConsistent(mesh));
    EXPECT_EQ(mesh.numberOfCells(), 32 * n * n);
    EXPECT_EQ(mesh.numberOfTriangles(), 64 * n * n - 8 * n);
    const EdgeCounts edges = countEdges(mesh);
    // Open are the rim, the lid's edge, and both ends of the handle and of the spout.
    EXPECT_EQ(edges.open, 6 * 4 * n - 8 * n);
    EXPECT_EQ(edges.wrong, 0);
  }
}

TEST(Teapot, FacesOutward)
{
  const Mesh mesh = teapot(20);
  // The bottom runs the same way as the body: no edge is wrong.
  for (const char* part : { "body", "handle", "spout", "lid" })
  {
    EXPECT_GT(signedVolume(partOf(mesh, part)), 0) << part;
  }
}

TEST(City, HasItsBoxes)
{
  const Mesh mesh = city(3, 5);
  EXPECT_TRUE(isConsistent(mesh));
  EXPECT_EQ(mesh.numberOfTriangles(), 9 * 59 * 12 + 2);
  const EdgeCounts edges = countEdges(mesh);
  EXPECT_EQ(edges.open, 4);
  EXPECT_EQ(edges.wrong, 0);
  EXPECT_EQ(city().numberOfTriangles(), 407810);
}

TEST(City, TowersAreFiveToSixtyFiveMetresHigh)
{
  const Mesh mesh = city(10);
  const Mesh towers = partOf(mesh, "tower");
  EXPECT_EQ(towers.numberOfCells(), 600);
  EXPECT_GT(signedVolume(towers), 0);
  const Bounds box = bounds(towers);
  EXPECT_EQ(box.low[2], -1);
  EXPECT_GT(box.high[2], 50);
  EXPECT_LE(box.high[2], 65);
  EXPECT_GT(signedVolume(partOf(mesh, "pole")), 0);
  EXPECT_GT(signedVolume(partOf(mesh, "roof")), 0);
}

TEST(Stadium, IsThreeHundredTeapotsWide)
{
  const Mesh mesh = teapotInStadium();
  EXPECT_TRUE(isConsistent(mesh));
  EXPECT_EQ(mesh.numberOfTriangles(), 102080 + 12);
  const Mesh hall = partOf(mesh, "hall");
  const EdgeCounts edges = countEdges(hall);
  EXPECT_EQ(edges.open + edges.wrong, 0);
  EXPECT_NEAR(signedVolume(hall), -96.0 * 96 * 28.8, 1e-6);
}

TEST(RandomCloud, HasTheSizesAskedFor)
{
  const Mesh equal = randomCloud(1000, 3, 0.1);
  EXPECT_TRUE(isConsistent(equal));
  EXPECT_EQ(equal.numberOfTriangles(), 1000);
  // An equilateral triangle in a circle of radius r has the area 3 sqrt(3) / 4 r^2.
  EXPECT_NEAR(area(equal) / 1000, 1.299038105676658 * 0.01, 1e-12);
  // The mean of u^6 is 1/7.
  EXPECT_NEAR(area(randomCloud(20000, 3, 0.1, 3)) / 20000 / 0.01299, 1.0 / 7, 0.01);
  EXPECT_EQ(randomCloud(0).numberOfCells(), 0);
}

TEST(Sphere, IsClosedAndRound)
{
  for (const int n : { 1, 2, 5, 16 })
  {
    const Mesh mesh = sphere(n);
    EXPECT_EQ(mesh.numberOfTriangles(), 20 * n * n);
    EXPECT_EQ(mesh.numberOfPoints(), 10 * n * n + 2);
    const EdgeCounts edges = countEdges(mesh);
    EXPECT_EQ(edges.open + edges.wrong, 0);
    EXPECT_GT(signedVolume(mesh), 0);
  }
  EXPECT_NEAR(signedVolume(sphere(64)), 4.18879, 4e-3);
}

TEST(Torus, IsClosedAndOutward)
{
  for (const double bump : { 0.0, 0.5, 0.9 })
  {
    const Mesh mesh = torus(60, 31, bump);
    const EdgeCounts edges = countEdges(mesh);
    EXPECT_EQ(edges.open + edges.wrong, 0);
    EXPECT_GT(signedVolume(mesh), 0);
  }
  // 2 pi^2 R r^2.
  EXPECT_NEAR(signedVolume(torus(400, 400)), 3.158273408348595, 1e-3);
}

TEST(Terrain, IsAGridFacingUp)
{
  const Mesh mesh = terrain(20, 9, 0.3);
  EXPECT_TRUE(isConsistent(mesh));
  EXPECT_EQ(mesh.numberOfCells(), 400);
  EXPECT_EQ(countEdges(mesh).open, 80);
  const Bounds box = bounds(mesh);
  EXPECT_GE(box.low[2], 0);
  EXPECT_LE(box.high[2], 0.3);
  EXPECT_GT(box.high[2] - box.low[2], 0.05);
  EXPECT_GT(signedVolume(mesh), 0);
  EXPECT_NEAR(area(terrain(10, 1, 0)), 1, 1e-12);
}

TEST(Slivers, AreClosedAndThin)
{
  const Mesh mesh = slivers(50, 1e6);
  const EdgeCounts edges = countEdges(mesh);
  EXPECT_EQ(edges.open + edges.wrong, 0);
  EXPECT_GT(signedVolume(mesh), 0);
  EXPECT_EQ(mesh.numberOfTriangles(), 100);
}

// These numbers must not change with compiler, options or processor.
TEST(Determinism, FingerprintsAreTheSameEverywhere)
{
  EXPECT_EQ(fingerprint(cornellBox(5)), 0xf96776be149e8ceau);
  EXPECT_EQ(fingerprint(teapot(10)), 0x98cb077f8698217cu);
  EXPECT_EQ(fingerprint(city(4, 1)), 0x1498ac22acf772c9u);
  EXPECT_EQ(fingerprint(teapotInStadium(6)), 0x82dd4a09db3a652bu);
  EXPECT_EQ(fingerprint(randomCloud(1000, 1, 0.02, 3)), 0x39e0ea192d91a323u);
  EXPECT_EQ(fingerprint(sphere(9)), 0x0df77d30a863ef01u);
  EXPECT_EQ(fingerprint(torus(40, 30, 0.5)), 0x34a8dd78916af22au);
  EXPECT_EQ(fingerprint(terrain(40)), 0x254083dc1ab2eb47u);
  EXPECT_EQ(fingerprint(slivers(77)), 0x4e19fe4aba8b6b6bu);
}

TEST(Determinism, SeedsMatter)
{
  EXPECT_NE(fingerprint(city(2, 1)), fingerprint(city(2, 2)));
  EXPECT_NE(fingerprint(randomCloud(10, 1)), fingerprint(randomCloud(10, 2)));
  EXPECT_NE(fingerprint(terrain(4, 1)), fingerprint(terrain(4, 2)));
}

TEST(Arguments, OutOfRangeThrow)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)cornellBox(0), std::invalid_argument);
  EXPECT_THROW((void)teapot(1), std::invalid_argument);
  EXPECT_THROW((void)teapot(1001), std::invalid_argument);
  EXPECT_THROW((void)city(0), std::invalid_argument);
  EXPECT_THROW((void)city(201), std::invalid_argument);
  EXPECT_THROW((void)teapotInStadium(0), std::invalid_argument);
  EXPECT_THROW((void)teapotInStadium(4, 1), std::invalid_argument);
  EXPECT_THROW((void)teapotInStadium(4, nan), std::invalid_argument);
  EXPECT_THROW((void)randomCloud(-1), std::invalid_argument);
  EXPECT_THROW((void)randomCloud(1, 1, 0), std::invalid_argument);
  EXPECT_THROW((void)randomCloud(1, 1, 0.1, 17), std::invalid_argument);
  EXPECT_THROW((void)sphere(0), std::invalid_argument);
  EXPECT_THROW((void)torus(2, 3), std::invalid_argument);
  EXPECT_THROW((void)torus(3, 3, 1), std::invalid_argument);
  EXPECT_THROW((void)terrain(0), std::invalid_argument);
  EXPECT_THROW((void)terrain(4, 1, -1), std::invalid_argument);
  EXPECT_THROW((void)slivers(2), std::invalid_argument);
  EXPECT_THROW((void)slivers(3, 0), std::invalid_argument);
  try
  {
    (void)city(0);
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(), "plots must lie in [1, 200], got 0");
  }
}
