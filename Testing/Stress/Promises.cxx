// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Promises.h"

#include <algorithm>
#include <sstream>

namespace lumitree::testing
{
namespace
{

/// Inside by a thousandth, seen under more than a thousandth of a radian, in proportion.
bool isClear(const Ray& ray, const RationalCrossing& x, const std::array<Vec3, 3>& v)
{
  const Rational sum = x.weights[0] + x.weights[1] + x.weights[2];
  for (const Rational& w : x.weights)
  {
    if (static_cast<double>(Rational(w / sum)) < 1e-3)
    {
      return false;
    }
  }
  const Vec3 a = v[1] - v[0];
  const Vec3 b = v[2] - v[0];
  const double t = static_cast<double>(x.t);
  const double sine =
    std::fabs(dot(ray.direction, cross(a, b))) / (length(ray.direction) * length(a) * length(b));
  const double distance = std::fabs(t) * length(ray.direction);
  const double coordinates = std::max(length(ray.origin), length(v[0]));
  const double size = std::min({ length(a), length(b), length(a - b) });
  return sine > 1e-3 && std::isfinite(t) && size > 1e-6 * std::max(distance, coordinates) &&
    t > ray.tMin + 1e-6 * std::fabs(t) && t < ray.tMax - 1e-6 * std::fabs(t);
}

std::string describe(const std::string& what, const StressCase& c, std::size_t i)
{
  const Ray ray = c.rays.batch()[i];
  std::ostringstream text;
  text << what << ": " << c.name << ", ray " << i << std::hexfloat;
  for (const Vec3& v : { ray.origin, ray.direction })
  {
    text << " (" << v[0] << ", " << v[1] << ", " << v[2] << ")";
  }
  text << " [" << ray.tMin << ", " << ray.tMax << "]";
  return text.str();
}

struct Answers
{
  std::vector<Hit> closest;
  std::vector<std::uint8_t> any;
  std::vector<std::uint32_t> counts;
  AllHits all;
};

std::string brokenByExact(const Hit* hits, std::size_t number, const Truth& truth)
{
  if (number != truth.hits.size())
  {
    return "another number of hits";
  }
  for (std::size_t h = 0; h < number; ++h)
  {
    if (hits[h].primitive != truth.hits[h].primitive)
    {
      return "another primitive, or another order";
    }
    if (abs(rational(hits[h].t) - truth.hits[h].t) >
      abs(truth.hits[h].t) * rational(0x1p-26 + 0x1p-52) + rational(0x1p-1074))
    {
      return "t is further off than promised";
    }
  }
  return {};
}

/// Every hit by the definition is among those reported.
std::string brokenByWatertight(const Hit* hits, std::size_t number, const Truth& truth, bool fast)
{
  for (const Truth::Entry& entry : truth.hits)
  {
    const bool found = std::any_of(
      hits, hits + number, [&](const Hit& hit) { return hit.primitive == entry.primitive; });
    if (!found && (!fast || entry.clear))
    {
      return "a hit is lost";
    }
  }
  return {};
}

/// Every t is on the segment, and none is less than that of the hit before.
std::string brokenSegment(const Hit* hits, std::size_t number, const Ray& ray)
{
  for (std::size_t h = 0; h < number; ++h)
  {
    if (!(ray.tMin <= hits[h].t && hits[h].t <= ray.tMax))
    {
      return "t is not on the segment";
    }
    if (h > 0 && hits[h].t < hits[h - 1].t)
    {
      return "t descends";
    }
  }
  return {};
}

/// From inside a closed surface every ray passes through it an odd number of times, wherever.
std::string brokenParity(const Accelerator& accelerator, const StressCase& c)
{
  std::vector<std::uint32_t> crossings(c.rays.size());
  accelerator.crossings(c.rays.batch(), crossings.data(), with(Precision::Exact));
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (crossings[i] % 2 == 0)
    {
      return describe("an even number of crossings", c, i);
    }
  }
  return {};
}

} // namespace

std::vector<Truth> truthOf(const StressCase& c)
{
  std::vector<Truth> all(c.rays.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Ray ray = c.rays.batch()[i];
    if (!isValid(ray))
    {
      continue;
    }
    for (PrimitiveId p = 0; p < c.surface->size(); ++p)
    {
      const auto v = c.surface->vertices(p);
      bool finite = true;
      for (const Vec3& corner : v)
      {
        for (const double x : corner)
        {
          finite = finite && std::fabs(x) <= coordinateLimit;
        }
      }
      if (!finite)
      {
        continue;
      }
      const RationalCrossing x(ray, v);
      if (rationallyHits(ray, x))
      {
        all[i].hits.push_back({ p, x.t, isClear(ray, x, v) });
      }
    }
    std::sort(all[i].hits.begin(), all[i].hits.end(),
      [](const Truth::Entry& a, const Truth::Entry& b)
      { return a.t < b.t || (a.t == b.t && a.primitive < b.primitive); });
  }
  return all;
}

std::string brokenPromise(const Accelerator& accelerator, Precision precision, const StressCase& c,
  const std::vector<Truth>& truth)
{
  if (c.inside && precision == Precision::Exact)
  {
    const std::string broken = brokenParity(accelerator, c);
    if (!broken.empty())
    {
      return broken;
    }
  }
  const RayBatch batch = c.rays.batch();
  Answers a;
  a.closest.resize(batch.size);
  a.any.resize(batch.size);
  a.counts.resize(batch.size);
  accelerator.closest(batch, a.closest.data(), with(precision));
  accelerator.any(batch, a.any.data(), with(precision));
  accelerator.count(batch, a.counts.data(), with(precision));
  accelerator.all(batch, a.all, with(precision));
  for (std::size_t i = 0; i < batch.size; ++i)
  {
    const Hit* const hits = a.all.hits.data() + a.all.offsets[i];
    const std::size_t number = a.all.offsets[i + 1] - a.all.offsets[i];
    std::string broken = precision == Precision::Exact
      ? brokenByExact(hits, number, truth[i])
      : brokenByWatertight(hits, number, truth[i], precision == Precision::Fast);
    if (broken.empty())
    {
      broken = brokenSegment(hits, number, batch[i]);
    }
    if (broken.empty() && a.counts[i] != number)
    {
      broken = "count and all disagree";
    }
    if (broken.empty() && a.any[i] != (number > 0 ? 1 : 0))
    {
      broken = "any and all disagree";
    }
    if (broken.empty() && !sameBits(a.closest[i], number > 0 ? hits[0] : Hit{}))
    {
      broken = "closest and all disagree";
    }
    if (!broken.empty())
    {
      return describe(broken, c, i);
    }
  }
  return {};
}

} // namespace lumitree::testing
