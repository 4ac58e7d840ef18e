// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every structure on every scene of the catalogue, of triangles (float and double), of implicits,
// and of both: all queries of Exact to the bit, each primitive once, and no leaf passed by that the
// segment meets.
#include "Catalogue.h"
#include "RationalOracle.h"

#include <algorithm>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

std::vector<BuildOptions> structures()
{
  std::vector<BuildOptions> all;
  for (const BuildOptions& options : ownStructures())
  {
    if (options.structure != Structure::BruteForce)
    {
      all.push_back(options);
    }
  }
  for (const Structure structure :
    { Structure::Bvh, Structure::WideBvh, Structure::Octree, Structure::KdTree })
  {
    all.push_back(optionsOf(structure, BvhBuild::LongestAxisMedian));
    all.back().kdBuild = KdBuild::SpatialMedian;
    all.back().leafSize = 1; // as deep as it gets
  }
  for (const Structure structure :
    { Structure::Grid, Structure::Octree, Structure::KdTree, Structure::BspTree })
  {
    all.push_back(optionsOf(structure));
    all.back().mailboxing = true;
  }
  // One cell, and cells along one axis only.
  for (const std::array<int, 3>& resolution : { std::array<int, 3>{ 1, 1, 1 }, { 100, 1, 1 } })
  {
    all.push_back(optionsOf(Structure::Grid));
    all.back().gridResolution = resolution;
  }
  return all;
}

std::vector<ConvexRegion> regionsOf(const Surface& surface)
{
  std::vector<ConvexRegion> regions(1);
  Uniform uniform(11);
  for (int i = 0; i < 40; ++i)
  {
    const auto& ids = surface.hittable();
    const Box box = surface.box(ids[uniform.index(ids.size())]);
    // A corner of a primitive's box is on the border of the first half-space.
    ConvexRegion region;
    for (int h = 0; h < 1 + i % 3; ++h)
    {
      const Vec3 normal = { uniform(-1, 1), i % 4 == 0 ? 0.0 : uniform(-1, 1), uniform(-1, 1) };
      region.push_back({ normal, dot(normal, h == 0 ? box.lower : box.upper) });
    }
    regions.push_back(region);
  }
  return regions;
}

/// A surface, and what brute force says of it.
struct Truth
{
  Truth(const CatalogueScene& scene, Matter matter)
    : name(scene.name + ", matter " + std::to_string(static_cast<int>(matter)))
    , surface(surfaceOf(scene, matter))
    , rays(&scene.rays)
    , answers(*build(this->surface, optionsOf(Structure::BruteForce)), scene.rays, Precision::Exact)
    , regions(regionsOf(*this->surface))
  {
    const auto oracle = build(this->surface, optionsOf(Structure::BruteForce));
    for (const ConvexRegion& region : this->regions)
    {
      this->overlaps.emplace_back();
      oracle->overlap(region, this->overlaps.back());
    }
  }

  std::string name;
  std::shared_ptr<const Surface> surface;
  const Rays* rays;
  Answers answers;
  std::vector<ConvexRegion> regions;
  std::vector<std::vector<PrimitiveId>> overlaps;
};

const std::vector<Truth>& truths()
{
  static const std::vector<CatalogueScene> scenes = catalogue();
  static const std::vector<Truth> all = []
  {
    std::vector<Truth> list;
    for (const CatalogueScene& scene : scenes)
    {
      for (const Matter matter : everyMatter)
      {
        list.emplace_back(scene, matter);
      }
    }
    return list;
  }();
  return all;
}

class Catalogue : public ::testing::TestWithParam<BuildOptions>
{
};

TEST_P(Catalogue, EveryExactAnswerIsThatOfBruteForce)
{
  for (const Truth& truth : truths())
  {
    SCOPED_TRACE(truth.name);
    const auto tree = build(truth.surface, GetParam());
    EXPECT_LE(tree->statistics().depth, 64);
    EXPECT_LT(tree->statistics().memory, std::size_t{ 1 } << 24);
    const Answers got(*tree, *truth.rays, Precision::Exact);
    EXPECT_EQ(got.any, truth.answers.any);
    EXPECT_EQ(got.counts, truth.answers.counts);
    ASSERT_EQ(got.all.offsets, truth.answers.all.offsets);
    for (std::size_t h = 0; h < got.all.hits.size(); ++h)
    {
      ASSERT_TRUE(sameBits(got.all.hits[h], truth.answers.all.hits[h])) << "hit " << h;
    }
    for (std::size_t i = 0; i < got.closest.size(); ++i)
    {
      ASSERT_TRUE(sameBits(got.closest[i], truth.answers.closest[i])) << "ray " << i;
    }
    for (std::size_t r = 0; r < truth.regions.size(); ++r)
    {
      std::vector<PrimitiveId> found;
      tree->overlap(truth.regions[r], found);
      ASSERT_EQ(found, truth.overlaps[r]) << "region " << r;
    }
  }
}

/// Whether the closed segment meets the closed box, in rational numbers.
bool meets(const Ray& ray, const Box& box)
{
  bool bounded[2] = { !std::isinf(ray.tMin), !std::isinf(ray.tMax) };
  Rational ends[2];
  ends[0] = bounded[0] ? rational(ray.tMin) : Rational(0);
  ends[1] = bounded[1] ? rational(ray.tMax) : Rational(0);
  for (int k = 0; k < 3; ++k)
  {
    if (ray.direction[k] == 0.0)
    {
      if (ray.origin[k] < box.lower[k] || ray.origin[k] > box.upper[k])
      {
        return false;
      }
      continue;
    }
    const bool forward = ray.direction[k] > 0.0;
    for (int end = 0; end < 2; ++end)
    {
      const double plane = (end == 0) == forward ? box.lower[k] : box.upper[k];
      const Rational t = (rational(plane) - rational(ray.origin[k])) / rational(ray.direction[k]);
      if (!bounded[end] || (end == 0 ? t > ends[0] : t < ends[1]))
      {
        ends[end] = t;
        bounded[end] = true;
      }
    }
  }
  return !(bounded[0] && bounded[1]) || ends[0] <= ends[1];
}

/// In doubles: false only where the segment passes the box by more than rounding accounts for.
bool mayMeet(const Ray& ray, const Box& box)
{
  double enter = ray.tMin;
  double leave = ray.tMax;
  for (int k = 0; k < 3; ++k)
  {
    const double margin =
      1e-9 * (std::fabs(box.lower[k]) + std::fabs(box.upper[k]) + std::fabs(ray.origin[k]));
    const double a = box.lower[k] - margin - ray.origin[k];
    const double b = box.upper[k] + margin - ray.origin[k];
    if (std::fabs(ray.direction[k]) < 1e-200)
    {
      if (ray.direction[k] == 0.0 && (a > 0.0 || b < 0.0))
      {
        return false;
      }
      continue;
    }
    const double t[2] = { a / ray.direction[k], b / ray.direction[k] };
    enter = std::max(enter, std::min(t[0], t[1]));
    leave = std::min(leave, std::max(t[0], t[1]));
  }
  return enter <= leave + 1e-9 * (std::fabs(enter) + std::fabs(leave));
}

/// Cells of a grid are shown with the margin of 2^-36 of the grid's size that they hold.
Box withoutMargin(const Box& cell, const Box& grid)
{
  Box box = cell;
  const Vec3 size = grid.size();
  const double margin = 1.01 * 0x1p-36 * size[grid.longestAxis()];
  for (int k = 0; k < 3; ++k)
  {
    box.lower[k] += cell.lower[k] > grid.lower[k] ? margin : 0.0;
    box.upper[k] -= cell.upper[k] < grid.upper[k] ? margin : 0.0;
  }
  return box;
}

/// Whether the segment meets the inside of a polyhedron by more than rounding accounts for.
bool meetsWell(const Ray& ray, const Polyhedron& cell, double margin)
{
  double enter = ray.tMin;
  double leave = ray.tMax;
  for (const auto& face : cell.faces)
  {
    const Vec3& a = cell.points[face[0]];
    Vec3 normal = { 0, 0, 0 };
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      normal = normal + cross(cell.points[face[i - 1]] - a, cell.points[face[i]] - a);
    }
    const double size = length(normal);
    if (!(size > margin * margin))
    {
      return false;
    }
    const double out = dot(normal, ray.origin - a) / size + margin;
    const double slope = dot(normal, ray.direction) / size;
    if (std::fabs(slope) < 1e-12 * length(ray.direction))
    {
      if (out > 0.0)
      {
        return false;
      }
      continue;
    }
    (slope < 0.0 ? enter : leave) =
      slope < 0.0 ? std::max(enter, -out / slope) : std::min(leave, -out / slope);
  }
  return enter < leave;
}

TEST_P(Catalogue, NoLeafIsPassedByThatTheSegmentMeets)
{
  std::size_t met = 0;
  for (const Truth& truth : truths())
  {
    SCOPED_TRACE(truth.name);
    const auto tree = build(truth.surface, GetParam());
    const HierarchyView view = tree->hierarchy();
    std::vector<std::uint64_t> visits(view.nodes.size());
    const Vec3 size = view.nodes[0].box.size();
    const double margin =
      1e-9 * (length(view.nodes[0].box.lower) + std::max({ size[0], size[1], size[2] }));
    QueryOptions options = with(Precision::Exact);
    options.perNode = visits.data();
    for (std::size_t i = 0; i < truth.rays->size(); i += 16)
    {
      RayBatch one = truth.rays->batch();
      const Ray ray = one[i];
      if (!isValid(ray))
      {
        continue;
      }
      one.size = 1;
      one.origins = ArrayView(truth.rays->origins.data() + 3 * i);
      one.directions = ArrayView(truth.rays->directions.data() + 3 * i);
      one.tMins = ArrayView(truth.rays->tMins.data() + i);
      one.tMaxs = ArrayView(truth.rays->tMaxs.data() + i);
      std::fill(visits.begin(), visits.end(), std::uint64_t{ 0 });
      AllHits all;
      tree->all(one, all, options);
      for (std::size_t n = 0; n < view.nodes.size(); ++n)
      {
        HierarchyNode node = view.nodes[n];
        if (GetParam().structure == Structure::Grid)
        {
          node.box = withoutMargin(node.box, view.nodes[0].box);
        }
        if (!node.leaf || node.referenceCount == 0 || visits[n] > 0 || !mayMeet(ray, node.box))
        {
          met += node.leaf && visits[n] > 0 ? 1 : 0;
          continue;
        }
        ASSERT_FALSE(
          view.polyhedra.empty() ? meets(ray, node.box) : meetsWell(ray, view.polyhedra[n], margin))
          << "leaf " << n << ", ray " << i;
      }
    }
  }
  EXPECT_GT(met, 400u);
}

TEST(Catalogue, ListsEachTriangleOnceAndEachQuadricTwiceAtMost)
{
  for (const Truth& truth : truths())
  {
    SCOPED_TRACE(truth.name);
    const Surface& surface = *truth.surface;
    std::size_t hitRays = 0;
    for (std::size_t i = 0; i < truth.rays->size(); ++i)
    {
      std::vector<PrimitiveId> ids;
      const auto& all = truth.answers.all;
      for (auto h = all.offsets[i]; h < all.offsets[i + 1]; ++h)
      {
        ids.push_back(all.hits[h].primitive);
      }
      hitRays += ids.empty() ? 0 : 1;
      std::sort(ids.begin(), ids.end());
      for (std::size_t k = 0; k < ids.size(); ++k)
      {
        const auto times = std::count(ids.begin(), ids.end(), ids[k]);
        ASSERT_LE(times, surface.isTriangle(ids[k]) ? 1 : (surface.isQuadric(ids[k]) ? 2 : 8));
      }
      ASSERT_EQ(truth.answers.counts[i], ids.size());
      ASSERT_EQ(truth.answers.any[i], ids.empty() ? 0 : 1);
      ASSERT_EQ(truth.answers.closest[i].primitive,
        ids.empty() ? noPrimitive : all.hits[all.offsets[i]].primitive);
    }
    EXPECT_GT(hitRays, truth.rays->size() / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Structures, Catalogue, ::testing::ValuesIn(structures()),
  [](const auto& options)
  {
    std::string text = label(options.param) + "Leaf" + std::to_string(options.param.leafSize);
    text += options.param.mailboxing ? "Mailboxing" : "";
    for (const int cells : options.param.gridResolution)
    {
      text += cells > 0 ? "x" + std::to_string(cells) : "";
    }
    text.erase(std::remove_if(text.begin(), text.end(),
                 [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }),
      text.end());
    return text;
  });

} // namespace
