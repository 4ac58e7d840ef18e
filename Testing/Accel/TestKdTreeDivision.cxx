// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Building KD-trees without sorting again: what is kept in order must be what sorting would give.
#include "Accel/Structures/KdTreeDivision.h"
#include "TestHelpers.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

using Key = std::tuple<double, std::uint32_t, std::uint32_t>;

/// Events with those of one position and kind in the order of references, which division need not
/// keep.
std::vector<Key> keysOf(const std::vector<KdEvent>& events)
{
  std::vector<Key> keys;
  for (const KdEvent& e : events)
  {
    keys.emplace_back(e.position, e.kind(), e.reference());
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

void expectSorted(const KdPart& part)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<KdEvent>& kept = part.events[static_cast<std::size_t>(axis)];
    std::vector<KdEvent> sorted;
    std::uint32_t index = 0;
    for (const KdReference& r : part.references)
    {
      appendEvents(r.bounds, axis, index++, sorted);
    }
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    EXPECT_EQ(keysOf(kept), keysOf(sorted));
  }
}

KdPart rootOf(const Surface& surface)
{
  KdPart root;
  root.cell = surface.bounds();
  for (const PrimitiveId id : surface.hittable())
  {
    root.references.push_back({ surface.box(id), id });
  }
  root.allowance = 8 * root.references.size();
  BuildProgress progress;
  root.events = sortedEvents(root.references, progress);
  return root;
}

KdOffer bestOf(const KdPart& part)
{
  KdOffer best = kdLeafOffer(part.references.size());
  for (int axis = 0; axis < 3; ++axis)
  {
    best = cheapestAcross(
      axis, part.cell, part.references.size(), part.events[static_cast<std::size_t>(axis)], best);
  }
  return best;
}

/// Divides down to a depth, comparing all the way.
std::size_t compare(const Surface& surface, const KdPart& part, int depth)
{
  expectSorted(part);
  const KdSplit split = bestOf(part).split;
  KdPlaneSearch search;
  const KdSplit again = search.best(part.cell, part.references);
  EXPECT_EQ(split.axis, again.axis);
  EXPECT_EQ(split.position, again.position);
  EXPECT_EQ(split.inPlaneBelow, again.inPlaneBelow);
  KdDivision division;
  KdPart below;
  KdPart above;
  if (depth == 0 || split.axis < 0 || !division.divide(surface, part, split, below, above))
  {
    return 1;
  }
  EXPECT_EQ(below.allowance + above.allowance, part.allowance);
  std::size_t leaves = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    division.takeEvents(part, axis, below, above);
  }
  for (const KdPart* side : { &below, &above })
  {
    EXPECT_GE(side->allowance, side->references.size());
    leaves += side->references.size() < 2 ? 1 : compare(surface, *side, depth - 1);
  }
  return leaves;
}

TEST(KdDivision, KeepsWhatSortingWouldGive)
{
  std::vector<Quadric> balls;
  Uniform uniform(7);
  for (int i = 0; i < 160; ++i)
  {
    balls.push_back(
      Quadric::sphere({ uniform(0, 9), uniform(0, 9), uniform(0, 9) }, uniform(0.1, 2)));
  }
  const auto teapot = surfaceOf<float>(data::teapot(4));
  const Surface mixed(PointArray::from(std::vector<double>{ 0, 0, 0, 9, 1, 0, 2, 8, 9, 3, 3, 3 }),
    { Triangle{ 0, 1, 2 }, Triangle{ 1, 2, 3 }, Triangle{ 0, 2, 3 } }, balls);
  EXPECT_GT(compare(*teapot, rootOf(*teapot), 9), 100u);
  EXPECT_GT(compare(mixed, rootOf(mixed), 9), 4u);
  const auto cloud = surfaceOf<double>(data::randomCloud(300));
  EXPECT_GT(compare(*cloud, rootOf(*cloud), 9), 16u);
  // Boxes: every second triangle lies in a plane across an axis.
  const auto city = surfaceOf<float>(data::city(1));
  EXPECT_GT(compare(*city, rootOf(*city), 9), 50u);
}

TEST(KdDivision, LongListsAreMergedFromRuns)
{
  // More than three runs of 65,536 events, many of them equal.
  Uniform uniform(8);
  std::vector<KdReference> references(110000);
  PrimitiveId id = 0;
  for (KdReference& r : references)
  {
    r.id = id++;
    r.bounds.extend(Vec3{ std::floor(uniform(0, 50)), uniform(0, 1), 0 });
    r.bounds.extend(Vec3{ std::floor(uniform(0, 50)), uniform(0, 1), uniform.index(2) * 1.0 });
  }
  for (const int threads : { 1, 2 })
  {
    BuildProgress progress(nullptr, threads);
    KdPart part;
    part.references = references;
    part.events = sortedEvents(references, progress);
    expectSorted(part);
  }
}

} // namespace
