// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays in millions against CGAL's exact kernel (GPL), from inside closed surfaces and from far
// away:
//   GroundTruth [millions of rays [triangles, in multiples of 20 n^2: n [seed [first place, 0 to
//   4]]]]
// Prints a table in Markdown: where Exact differs (whether anything is hit, the primitive, the
// number of hits, all of them in order, t), where Watertight and Fast leak or name another
// primitive, and times. Ends with 1 when a promise is broken.
#include "Accel/Reference/CGAL/CgalReference.h"
#include "Testing/Accel/ClosedScenes.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace
{

using namespace lumitree;
using namespace lumitree::testing;

double seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What is counted of a kind of rays.
struct Tally
{
  std::string name;
  bool fastMayLeak = true;
  bool inside = false;
  std::size_t rays = 0;
  std::size_t hit = 0;        ///< other answer whether anything is hit
  std::size_t primitive = 0;  ///< other primitive
  std::size_t count = 0;      ///< other number of hits
  std::size_t all = 0;        ///< other primitives, or in another order
  std::size_t t = 0;          ///< t further off than promised
  std::size_t structures = 0; ///< another structure gives other bits
  std::size_t asked = 0;      ///< rays asked for ties and for rounded t, a fifth of them
  std::size_t ties = 0;       ///< other ties, or not the double nearest to t
  std::size_t parity = 0;     ///< from inside, and an even number of crossings
  double worstT = 0.0;        ///< relative error of t
  std::size_t undecided = 0;  ///< candidates that went to exact arithmetic
  std::size_t watertightLeaks = 0;
  std::size_t fastLeaks = 0;
  std::size_t fastOthers = 0;
  std::size_t recentredOthers = 0; ///< Fast on floats moved to the origin
  bool recentred = false;
  double exactSeconds = 0.0;
  double truthSeconds = 0.0;

  void add(const Tally& o)
  {
    this->rays += o.rays;
    this->hit += o.hit;
    this->primitive += o.primitive;
    this->count += o.count;
    this->all += o.all;
    this->t += o.t;
    this->structures += o.structures;
    this->asked += o.asked;
    this->ties += o.ties;
    this->parity += o.parity;
    this->worstT = std::max(this->worstT, o.worstT);
    this->undecided += o.undecided;
    this->watertightLeaks += o.watertightLeaks;
    this->fastLeaks += o.fastLeaks;
    this->fastOthers += o.fastOthers;
    this->recentredOthers += o.recentredOthers;
    this->exactSeconds += o.exactSeconds;
    this->truthSeconds += o.truthSeconds;
  }

  [[nodiscard]] std::size_t differences() const
  {
    return this->hit + this->primitive + this->count + this->all + this->t + this->structures +
      this->ties + this->parity;
  }

  [[nodiscard]] bool keepsPromises() const
  {
    return this->differences() == 0 && this->watertightLeaks == 0 &&
      (this->fastMayLeak || this->fastLeaks == 0) &&
      static_cast<double>(this->recentredOthers) <= 1e-5 * static_cast<double>(this->rays);
  }
};

/// A scene under everything that is asked.
struct Subject
{
  ClosedScene scene;
  std::shared_ptr<const Accelerator> truth;
  std::shared_ptr<const Accelerator> wide;
  std::vector<std::shared_ptr<const Accelerator>> others;
  std::shared_ptr<const Accelerator> binary;    ///< one of the others; its boxes are doubles
  std::shared_ptr<const Accelerator> recentred; ///< floats, less the offset
};

Subject subject(bool torus, const Place& place, int detail)
{
  Subject s;
  s.scene = closedScene(torus, place, detail);
  s.truth = build(s.scene.surface, optionsOf(Structure::Cgal));
  for (const BuildOptions& options : ownStructures())
  {
    if (options.structure == Structure::WideBvh && !s.wide)
    {
      s.wide = build(s.scene.surface, options);
    }
    else if (options.structure != Structure::BruteForce)
    {
      s.others.push_back(build(s.scene.surface, options));
      s.binary = options.structure == Structure::Bvh ? s.others.back() : s.binary;
    }
  }
  std::vector<float> points;
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < s.scene.surface->pointCount(); ++i)
  {
    const Vec3 p = s.scene.surface->point(i) - place.offset;
    for (const double x : p)
    {
      points.push_back(static_cast<float>(x));
    }
  }
  for (PrimitiveId i = 0; i < s.scene.surface->size(); ++i)
  {
    triangles.push_back(s.scene.surface->triangle(i));
  }
  s.recentred = build(
    std::make_shared<const Surface>(PointArray::from(std::move(points)), std::move(triangles)),
    optionsOf(Structure::WideBvh));
  return s;
}

std::vector<Hit> closest(const Accelerator& accelerator, const Rays& rays, Precision precision)
{
  std::vector<Hit> hits(rays.size());
  accelerator.closest(rays.batch(), hits.data(), with(precision));
  return hits;
}

/// What is asked, and of how many rays every other structure is asked, too.
struct Asked
{
  const Accelerator& main;
  std::size_t ofOthers;
};

void compareExact(
  const Subject& s, const Asked& asked, const Rays& rays, const AllHits& truth, Tally& tally)
{
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint32_t> counts(rays.size());
  AllHits all;
  const double start = seconds();
  tally.undecided +=
    asked.main.closest(rays.batch(), hits.data(), with(Precision::Exact)).exactTests;
  tally.exactSeconds += seconds() - start;
  asked.main.count(rays.batch(), counts.data(), with(Precision::Exact));
  asked.main.all(rays.batch(), all, with(Precision::Exact));
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const Hit* const wanted = truth.hits.data() + truth.offsets[i];
    const std::size_t number = truth.offsets[i + 1] - truth.offsets[i];
    tally.hit += (hits[i].primitive != noPrimitive) == (number > 0) ? 0 : 1;
    tally.primitive += hits[i].primitive == (number > 0 ? wanted->primitive : noPrimitive) ? 0 : 1;
    tally.count += counts[i] == number ? 0 : 1;
    const Hit* const found = all.hits.data() + all.offsets[i];
    const bool sameNumber = all.offsets[i + 1] - all.offsets[i] == number;
    const bool same = sameNumber &&
      std::equal(wanted, wanted + number, found,
        [](const Hit& a, const Hit& b) { return a.primitive == b.primitive; });
    tally.all += same ? 0 : 1;
    for (std::size_t h = 0; same && h < number; ++h)
    {
      const double error = std::fabs(found[h].t - wanted[h].t) / std::fabs(wanted[h].t);
      tally.worstT = wanted[h].t != 0.0 ? std::max(tally.worstT, error) : tally.worstT;
      tally.t +=
        std::fabs(found[h].t - wanted[h].t) <= std::fabs(wanted[h].t) * (0x1p-26 + 0x1p-52) ? 0 : 1;
    }
  }
  Rays some;
  for (std::size_t i = 0; i < std::min(rays.size(), asked.ofOthers); ++i)
  {
    some.add(rays.batch()[i]);
  }
  const auto compareStructure = [&](const Accelerator& other)
  {
    const auto found = closest(other, some, Precision::Exact);
    for (std::size_t i = 0; i < some.size(); ++i)
    {
      tally.structures += sameBits(found[i], hits[i]) ? 0 : 1;
    }
  };
  compareStructure(*s.wide);
  for (const auto& other : s.others)
  {
    compareStructure(*other);
  }
}

void compareOthers(
  const Subject& s, const Asked& asked, const Rays& rays, const AllHits& truth, Tally& tally)
{
  const auto first = [&](std::size_t i)
  {
    return truth.offsets[i + 1] > truth.offsets[i] ? truth.hits[truth.offsets[i]].primitive
                                                   : noPrimitive;
  };
  const auto watertight = closest(asked.main, rays, Precision::Watertight);
  const auto fast = closest(asked.main, rays, Precision::Fast);
  std::vector<Hit> recentred;
  if (tally.recentred)
  {
    Rays moved;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const Ray ray = rays.batch()[i];
      moved.add(ray.origin - s.scene.offset, ray.direction);
    }
    recentred = closest(*s.recentred, moved, Precision::Fast);
  }
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const bool hits = first(i) != noPrimitive;
    tally.watertightLeaks += hits && watertight[i].primitive == noPrimitive ? 1 : 0;
    tally.fastLeaks += hits && fast[i].primitive == noPrimitive ? 1 : 0;
    tally.fastOthers += fast[i].primitive != noPrimitive && fast[i].primitive != first(i) ? 1 : 0;
    tally.recentredOthers += tally.recentred && recentred[i].primitive != first(i) ? 1 : 0;
  }
}

void compareTies(const Subject& s, const Asked& asked, const Rays& rays, Tally& tally)
{
  QueryOptions options = with(Precision::Exact);
  options.roundedT = true;
  AllHits truth;
  AllHits found;
  s.truth->ties(rays.batch(), truth, with(Precision::Exact));
  asked.main.ties(rays.batch(), found, options);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const auto first = [i](const AllHits& hits)
    { return hits.hits.begin() + static_cast<std::ptrdiff_t>(hits.offsets[i]); };
    const auto last = [i](const AllHits& hits)
    { return hits.hits.begin() + static_cast<std::ptrdiff_t>(hits.offsets[i + 1]); };
    const bool same = std::equal(first(truth), last(truth), first(found), last(found),
      [](const Hit& a, const Hit& b) { return a.primitive == b.primitive && a.t == b.t; });
    tally.ties += same ? 0 : 1;
  }
  tally.asked += rays.size();
}

void countEven(const Asked& asked, const Rays& rays, Tally& tally)
{
  std::vector<std::uint32_t> crossings(rays.size());
  asked.main.crossings(rays.batch(), crossings.data(), with(Precision::Exact));
  for (const std::uint32_t n : crossings)
  {
    tally.parity += n % 2 == 1 ? 0 : 1;
  }
}

/// Adds a kind of rays, chunk by chunk.
template <class Make>
void compare(const Subject& s, const Asked& asked, std::size_t count, unsigned seed,
  const Make& make, Tally& tally)
{
  constexpr std::size_t chunk = 2000;
  for (std::size_t done = 0; done < count; done += chunk)
  {
    const Rays rays = make(std::min(chunk, count - done), seed++);
    AllHits truth;
    const double start = seconds();
    s.truth->all(rays.batch(), truth, with(Precision::Exact));
    tally.truthSeconds += seconds() - start;
    compareExact(s, asked, rays, truth, tally);
    compareOthers(s, asked, rays, truth, tally);
    if (done % (5 * chunk) == 0)
    {
      compareTies(s, asked, rays, tally);
    }
    if (tally.inside)
    {
      countEven(asked, rays, tally);
    }
    tally.rays += rays.size();
  }
}

void print(const Tally& t)
{
  const double n = static_cast<double>(t.rays);
  std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %zu of %zu | %s | %.1e | %.2g | "
              "%zu | %zu | %zu | %s | "
              "%.0f | %.1f |\n",
    t.name.c_str(), t.rays, t.hit, t.primitive, t.count, t.all, t.t, t.structures, t.ties, t.asked,
    t.inside ? std::to_string(t.parity).c_str() : "", t.worstT,
    static_cast<double>(t.undecided) / n, t.watertightLeaks, t.fastLeaks, t.fastOthers,
    t.recentred ? std::to_string(t.recentredOthers).c_str() : "", 1e9 * t.exactSeconds / n,
    1e6 * t.truthSeconds / n);
  std::fflush(stdout);
}

/// The Tally of a row, one for both shapes.
Tally& row(std::vector<Tally>& rows, const std::string& name)
{
  for (Tally& t : rows)
  {
    if (t.name == name)
    {
      return t;
    }
  }
  rows.emplace_back();
  rows.back().name = name;
  return rows.back();
}

void printHeader()
{
  std::printf(
    "| rays | number | hit | primitive | count | all | t | structures | ties | parity | worst t | "
    "undecided per ray | leaks of watertight | leaks of fast | other primitives of fast | "
    "of fast, recentred floats | exact [ns] | EPECK [us] |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | "
    "--- | --- | --- |\n");
}

/// The rays of one place: rows for each aim, from inside and from afar.
std::vector<Tally> compareAt(const Place& place, int detail, std::size_t fromInside,
  std::size_t fromOnePoint, std::size_t fromAfar, unsigned& seed)
{
  std::vector<Tally> rows;
  rows.reserve(3 * everyAim.size());
  for (const bool torus : { false, true })
  {
    const Subject s = subject(torus, place, detail);
    for (const Aim aim : everyAim)
    {
      const std::string kind = std::string(place.name) + ", " + name(aim);
      Tally& near = row(rows, kind);
      near.inside = true;
      near.recentred = place.offset[0] == 500000 && aim == Aim::Random;
      near.fastMayLeak = aim != Aim::Random || place.offset[0] > 1e4;
      compare(
        s, { *s.wide, fromInside }, fromInside, seed,
        [&](std::size_t n, unsigned from) { return raysFromInside(s.scene, aim, n, from); }, near);
      seed += 100000;
      Tally& together = row(rows, kind + ", from one point");
      together.inside = true;
      together.fastMayLeak = near.fastMayLeak;
      compare(
        s, { *s.wide, fromOnePoint }, fromOnePoint, seed,
        [&](std::size_t n, unsigned from) { return raysFromOnePoint(s.scene, aim, n, from); },
        together);
      seed += 100000;
      for (const double distance : { 1e4, 1e6, 1e8 })
      {
        Tally& far = row(rows, kind + ", from afar");
        // From so far away floats cannot tell boxes apart, and the eight-wide tree tests them all.
        const Asked asked = { *s.binary, distance > 1e4 ? 20 : fromAfar };
        compare(
          s, asked, fromAfar, seed,
          [&](std::size_t n, unsigned from)
          { return raysFromAfar(s.scene, aim, distance, n, from); },
          far);
        seed += 100000;
      }
      std::fprintf(stderr, "%s, %s: done\n", s.scene.name.c_str(), name(aim));
    }
  }
  return rows;
}

bool run(double millions, int detail, unsigned seed, std::size_t firstPlace)
{
  // Two thirds from inside, a quarter of these from a point that many share, and one third from
  // afar, over shapes, places and aims.
  const double cells = 2.0 * static_cast<double>(closedPlaces().size() * everyAim.size());
  const auto fromInside = static_cast<std::size_t>(millions * 1e6 / 2 / cells);
  const auto fromOnePoint = static_cast<std::size_t>(millions * 1e6 / 6 / cells);
  const auto fromAfar = static_cast<std::size_t>(millions * 1e6 / 3 / cells / 3);
  printHeader();
  Tally sum;
  sum.name = "all";
  bool kept = true;
  for (std::size_t place = firstPlace; place < closedPlaces().size(); ++place)
  {
    for (const Tally& t :
      compareAt(closedPlaces()[place], detail, fromInside, fromOnePoint, fromAfar, seed))
    {
      print(t);
      sum.add(t);
      kept = kept && t.keepsPromises();
    }
  }
  print(sum);
  std::printf("\n%d triangles a surface, %s\n", 20 * detail * detail,
    kept ? "every promise kept" : "A PROMISE IS BROKEN");
  return kept;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    registerCgal();
    const double millions = argc > 1 ? std::atof(argv[1]) : 6.0;
    const int detail = argc > 2 ? std::atoi(argv[2]) : 64;
    const auto seed = static_cast<unsigned>(argc > 3 ? std::atoi(argv[3]) : 1);
    const auto place = static_cast<std::size_t>(argc > 4 ? std::atoi(argv[4]) : 0);
    return run(millions, detail, seed, place) ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "GroundTruth: %s\n", error.what());
    return 2;
  }
}
