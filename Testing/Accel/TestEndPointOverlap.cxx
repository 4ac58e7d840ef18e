// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// End-point overlap of hierarchies of boxes.
#include "Accel/EndPointOverlap.h"
#include "HierarchyScenes.h"

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

TEST(EndPointOverlap, OfTwoBoxesIsWhatLiesInBoth)
{
  // Two unit squares in z = 0 that share a quarter, as two leaves under a root of their own.
  const auto square = [](double x, double y)
  {
    const Vec3 a{ x, y, 0 };
    const Vec3 b{ x + 1, y, 0 };
    const Vec3 c{ x + 1, y + 1, 0 };
    const Vec3 d{ x, y + 1, 0 };
    return std::vector<std::array<Vec3, 3>>{ { a, b, c }, { a, c, d } };
  };
  std::vector<std::array<Vec3, 3>> triangles = square(0, 0);
  for (const auto& triangle : square(0.5, 0.5))
  {
    triangles.push_back(triangle);
  }
  const auto surface = surfaceOf<double>(triangles);
  HierarchyView view;
  view.references = { 0, 1, 2, 3 };
  view.nodes.resize(3);
  view.nodes[0].box = surface->bounds();
  for (std::uint32_t leaf : { 1u, 2u })
  {
    HierarchyNode& node = view.nodes[leaf];
    node.box = surface->box(2 * leaf - 2);
    node.parent = 0;
    node.depth = 1;
    node.leaf = true;
    node.firstReference = 2 * leaf - 2;
    node.referenceCount = 2;
  }
  completeHierarchy(view);
  // A quarter of each square lies in the other's leaf, which costs a block; the squares have
  // area 2.
  EXPECT_NEAR(endPointOverlap(view, *surface), (2 * 0.25) / 2.0, 1e-15);
  EXPECT_EQ(endPointOverlap({}, *surface), 0.0);
}

TEST(EndPointOverlap, IsLessWithTheHeuristicThanWithTheMedian)
{
  const auto surface = surfaceOf<float>(data::teapot(8));
  BuildOptions options;
  options.structure = Structure::Bvh;
  const double heuristic = endPointOverlap(build(surface, options)->hierarchy(), *surface);
  options.bvhBuild = BvhBuild::LongestAxisMedian;
  const double median = endPointOverlap(build(surface, options)->hierarchy(), *surface);
  EXPECT_GT(heuristic, 0.0);
  EXPECT_LT(heuristic, median);
  options.structure = Structure::BruteForce;
  EXPECT_EQ(endPointOverlap(build(surface, options)->hierarchy(), *surface), 0.0);
}

} // namespace
