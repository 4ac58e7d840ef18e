// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Traces a fixed set of rays again and again under other conditions and prints hashes of the
// answers (primitive and the bits of t, u, v of every query of every structure), a line a
// condition:
//   condition fast watertight exact
// With the argument "few" only four of the conditions, for builds that are slow.
// Ends with 1 unless every line shows the hashes of the first. ./lumitree matrix bits compares the
// output of this program as several compilers make it with several flags.
#include "Testing/Accel/InstructionSets.h"

#include "Testing/Accel/ClosedScenes.h"

#include <algorithm>
#include <cfenv>
#include <cinttypes>
#include <cstdio>
#include <exception>
#include <functional>
#include <numeric>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace
{

using namespace lumitree;
using namespace lumitree::testing;

using Hashes = std::array<std::uint64_t, precisionCount>;

/// FNV-1a.
class Hasher
{
public:
  template <class T>
  void add(T value)
  {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes)
    {
      this->value_ = (this->value_ ^ byte) * 0x100000001b3u;
    }
  }
  void add(const Hit& hit)
  {
    this->add(hit.primitive);
    this->add(hit.t);
    this->add(hit.u);
    this->add(hit.v);
  }
  [[nodiscard]] std::uint64_t value() const { return this->value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

struct Scene
{
  std::shared_ptr<const Surface> surface;
  Rays rays;
};

void append(Rays& to, const Rays& from)
{
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    to.add(from.batch()[i]);
  }
}

std::vector<Scene> makeScenes()
{
  std::vector<Scene> scenes;
  for (const bool torus : { false, true })
  {
    for (const Place& place : closedPlaces())
    {
      const ClosedScene closed = closedScene(torus, place, 6);
      Scene scene{ closed.surface, raysAround(*closed.surface, 16, 1) };
      for (const Aim aim : everyAim)
      {
        append(scene.rays, raysFromInside(closed, aim, 8));
        append(scene.rays, raysFromOnePoint(closed, aim, 32, 3));
        append(scene.rays, raysFromAfar(closed, aim, 1e6, 2));
      }
      scenes.push_back(std::move(scene));
    }
  }
  for (const auto& surface :
    { surfaceOf<float>(data::cornellBox(2)), surfaceOf<double>(data::slivers(40, 1e6)),
      surfaceOf<float>(data::terrain(10)), surfaceOf<double>(data::randomCloud(150, 3, 0.5)) })
  {
    scenes.push_back({ surface, raysAround(*surface, 60, 2) });
  }
  return scenes;
}

/// The surface once more, its triangles in another order if wanted; original[i] is what triangle i
/// was.
std::shared_ptr<const Surface> again(
  const Surface& surface, bool permute, std::vector<PrimitiveId>& original)
{
  original.resize(surface.size());
  std::iota(original.begin(), original.end(), PrimitiveId{ 0 });
  Uniform uniform(5);
  for (std::size_t i = original.size(); permute && i > 1; --i)
  {
    std::swap(original[i - 1], original[uniform.index(i)]);
  }
  std::vector<Triangle> triangles;
  for (const PrimitiveId i : original)
  {
    triangles.push_back(surface.triangle(i));
  }
  std::vector<double> xyz;
  for (std::size_t i = 0; i < surface.pointCount(); ++i)
  {
    const Vec3 p = surface.point(i);
    xyz.insert(xyz.end(), p.begin(), p.end());
  }
  PointArray points = surface.scalar() == ArrayView::Scalar::Float
    ? PointArray::from(std::vector<float>(xyz.begin(), xyz.end()))
    : PointArray::from(std::move(xyz));
  return std::make_shared<const Surface>(std::move(points), std::move(triangles));
}

/// How the same rays are asked.
struct Manner
{
  int threads = 1;
  bool shuffled = false;
  std::size_t batch = 0; ///< rays a batch; 0: all at once
  bool permute = false;  ///< the triangles
};

/// One ray's answers, as they came.
struct Answer
{
  Hit closest;
  std::uint8_t any = 0;
  std::uint32_t count = 0;
  std::vector<Hit> all;
  std::vector<Hit> ties;
  std::uint32_t crossings = 0; ///< of Exact
};

std::vector<Hit> listOf(const AllHits& hits, std::size_t ray)
{
  const auto at = [&](std::size_t i)
  { return hits.hits.begin() + static_cast<std::ptrdiff_t>(hits.offsets[i]); };
  return { at(ray), at(ray + 1) };
}

std::vector<Answer> ask(
  const Accelerator& accelerator, const Rays& rays, Precision precision, const Manner& manner)
{
  std::vector<std::size_t> order(rays.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  if (manner.shuffled)
  {
    Uniform uniform(6);
    for (std::size_t i = order.size(); i > 1; --i)
    {
      std::swap(order[i - 1], order[uniform.index(i)]);
    }
  }
  QueryOptions options = with(precision);
  options.threads = manner.threads;
  std::vector<Answer> answers(rays.size());
  const std::size_t step = manner.batch == 0 ? rays.size() : manner.batch;
  for (std::size_t first = 0; first < rays.size(); first += step)
  {
    Rays part;
    for (std::size_t i = first; i < std::min(first + step, rays.size()); ++i)
    {
      part.add(rays.batch()[order[i]]);
    }
    std::vector<Hit> closest(part.size());
    std::vector<std::uint8_t> any(part.size());
    std::vector<std::uint32_t> counts(part.size());
    AllHits all;
    AllHits ties;
    std::vector<std::uint32_t> crossings(part.size());
    accelerator.closest(part.batch(), closest.data(), options);
    accelerator.any(part.batch(), any.data(), options);
    accelerator.count(part.batch(), counts.data(), options);
    accelerator.all(part.batch(), all, options);
    accelerator.ties(part.batch(), ties, options);
    if (precision == Precision::Exact)
    {
      accelerator.crossings(part.batch(), crossings.data(), options);
    }
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      answers[order[first + i]] = { closest[i], any[i], counts[i], listOf(all, i), listOf(ties, i),
        crossings[i] };
    }
  }
  return answers;
}

/// Everything, and what a new order of the triangles must not change: which of several equal hits
/// is the first depends on it, the set of hits does not.
struct Digest
{
  Hashes everything{};
  Hashes sets{};
};

void add(Answer& a, const std::vector<PrimitiveId>& original, Hasher& everything, Hasher& sets)
{
  everything.add(a.closest);
  for (const Hit& hit : a.all)
  {
    everything.add(hit);
  }
  for (const Hit& hit : a.ties)
  {
    everything.add(hit);
  }
  for (std::vector<Hit>* const hits : { &a.all, &a.ties })
  {
    for (Hit& hit : *hits)
    {
      hit.primitive = original[hit.primitive];
    }
    std::sort(hits->begin(), hits->end(),
      [](const Hit& x, const Hit& y) { return x.primitive < y.primitive; });
  }
  sets.add(a.any);
  sets.add(a.count);
  sets.add(a.crossings);
  for (const Hit& hit : a.all)
  {
    sets.add(hit);
  }
  // All ties report the t of the first, and which that is changes with the numbers.
  for (const Hit& hit : a.ties)
  {
    sets.add(hit.primitive);
  }
}

Digest digest(const std::vector<Scene>& scenes, const Manner& manner)
{
  std::array<Hasher, precisionCount> everything;
  std::array<Hasher, precisionCount> sets;
  for (const Scene& scene : scenes)
  {
    std::vector<PrimitiveId> original;
    const auto surface = again(*scene.surface, manner.permute, original);
    for (const BuildOptions& options : ownStructures())
    {
      const auto accelerator = build(surface, options);
      for (int p = 0; p < precisionCount; ++p)
      {
        for (Answer& a : ask(*accelerator, scene.rays, static_cast<Precision>(p), manner))
        {
          add(a, original, everything[p], sets[p]);
        }
      }
    }
  }
  Digest result;
  for (int p = 0; p < precisionCount; ++p)
  {
    everything[p].add(sets[p].value());
    result.everything[p] = everything[p].value();
    result.sets[p] = sets[p].value();
  }
  return result;
}

/// The floating-point state a host may have left, restored at the end.
class Host
{
public:
  Host(int rounding, bool flush)
  {
    std::fegetenv(&this->saved_);
    std::fesetround(rounding);
    if (flush)
    {
#if defined(__SSE__)
      _mm_setcsr(_mm_getcsr() | 0x8040u);
#endif
    }
  }
  ~Host()
  {
    std::fesetenv(&this->saved_);
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

private:
  std::fenv_t saved_;
};

struct Condition
{
  const char* name;
  int rounding = FE_TONEAREST;
  bool flush = false;
  Manner manner;
};

std::vector<Condition> conditions(bool few)
{
  if (few)
  {
    return { { "as it comes", FE_TONEAREST, false, {} },
      { "rounding downward, flushed", FE_DOWNWARD, true, {} },
      { "batches of 7, shuffled, 3 threads", FE_TONEAREST, false, { 3, true, 7, false } },
      { "triangles permuted", FE_TONEAREST, false, { 1, false, 0, true } } };
  }
  return { { "as it comes", FE_TONEAREST, false, {} },
    { "subnormals flushed by the host", FE_TONEAREST, true, {} },
    { "rounding upward", FE_UPWARD, false, {} },
    { "rounding downward, flushed", FE_DOWNWARD, true, {} },
    { "rounding toward zero", FE_TOWARDZERO, false, {} },
    { "2 threads", FE_TONEAREST, false, { 2, false, 0, false } },
    { "all threads, flushed", FE_TONEAREST, true, { 0, false, 0, false } },
    { "rays shuffled", FE_TONEAREST, false, { 1, true, 0, false } },
    { "batches of 1", FE_TONEAREST, false, { 1, false, 1, false } },
    { "batches of 7, shuffled, 3 threads", FE_TONEAREST, false, { 3, true, 7, false } },
    { "triangles permuted", FE_TONEAREST, false, { 1, false, 0, true } } };
}

bool compareAll(bool few)
{
  const std::vector<Scene> scenes = makeScenes();
  bool same = true;
  Digest first;
  bool known = false;
  for (const InstructionSet& set : instructionSets())
  {
    if (!set.lacking().empty())
    {
      std::printf("%s: skipped, %s\n", set.name.c_str(), set.lacking().c_str());
      continue;
    }
    const ForcedInstructionSet forced(set);
    for (const Condition& c : conditions(few))
    {
      Digest found;
      {
        const Host host(c.rounding, c.flush);
        found = digest(scenes, c.manner);
      }
      if (!known)
      {
        first = found;
        known = true;
      }
      // Permuted triangles change which of several equal hits is named.
      const Hashes& shown = c.manner.permute ? found.sets : found.everything;
      const bool agrees =
        c.manner.permute ? found.sets == first.sets : found.everything == first.everything;
      std::printf("%s, %s: %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "%s\n", set.name.c_str(),
        c.name, shown[0], shown[1], shown[2], agrees ? "" : " DIFFERS");
      std::fflush(stdout);
      same = same && agrees;
    }
  }
  return same;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return compareAll(argc > 1 && std::string(argv[1]) == "few") ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "Bits: %s\n", error.what());
    return 2;
  }
}
