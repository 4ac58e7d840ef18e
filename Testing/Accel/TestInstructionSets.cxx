// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// The same rays give the same bits with every instruction set: all structures, precisions, queries.
#include "InstructionSets.h"

#include "Answers.h"

#include <map>
#include <set>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

struct Scene
{
  std::string name;
  std::shared_ptr<const Surface> surface;
  Rays rays;
};

/// Vertices, edges, random directions; along axes in the planes of boxes; from far away; with
/// limits.
Rays hardRays(const Surface& surface, std::size_t count)
{
  Rays rays = raysAround(surface, count, 31);
  Uniform uniform(32);
  const Vec3 size = surface.bounds().size();
  for (std::size_t i = 0; i < count / 4; ++i)
  {
    const auto c = surface.vertices(static_cast<PrimitiveId>(uniform.index(surface.size())));
    Vec3 axis = { 0, 0, 0 };
    axis[i % 3] = i % 2 == 0 ? 1 : -1;
    rays.add(c[0] - length(size) * axis, axis);
    const Vec3 far = { uniform(-1e6, 1e6), uniform(-1e6, 1e6), uniform(-1e6, 1e6) };
    rays.add(length(size) * far, c[1] - length(size) * far);
    const Vec3 o = rays.batch()[i].origin;
    rays.add(Ray{ o, c[2] - o, -0.5, 1 });
    rays.add(Ray{ o, 0x1p-40 * (c[2] - o), 0x1p40, 0x1p41 });
  }
  return rays;
}

const std::vector<Scene>& scenes()
{
  static const std::vector<Scene> all = []
  {
    std::vector<Scene> made = {
      { "teapot of floats", surfaceOf<float>(data::teapot(3)), {} },
      { "torus of doubles", surfaceOf<double>(data::torus(32, 16, 0.3), { 5e5, 4649776, 100 }),
        {} },
      { "room", surfaceOf<float>(data::cornellBox(3)), {} },
    };
    for (Scene& scene : made)
    {
      scene.rays = hardRays(*scene.surface, 600);
    }
    made.push_back({ "teapot seen from one point", made.front().surface, {} });
    Uniform uniform(33);
    for (int i = 0; i < 1200; ++i)
    {
      made.back().rays.add(
        { 0.3, -2, 0.5 }, { uniform(-0.2, 0.1), 1, i % 8 == 0 ? 0 : uniform(-0.3, 0.1) });
    }
    return made;
  }();
  return all;
}

/// The answers that the instruction set at hand gives, once for all tests.
const Answers& usual(std::size_t scene, const BuildOptions& options, Precision precision)
{
  static std::map<std::string, Answers> known;
  const std::string key = std::to_string(scene) + label(options) + std::string(name(precision));
  const auto found = known.find(key);
  if (found != known.end())
  {
    return found->second;
  }
  const Scene& s = scenes()[scene];
  return known[key] = ask(*build(s.surface, options), s.rays.batch(), with(precision));
}

class InstructionSets : public ::testing::TestWithParam<InstructionSet>
{
};

TEST_P(InstructionSets, GiveTheSameBits)
{
  const std::string lacking = GetParam().lacking();
  if (!lacking.empty())
  {
    GTEST_SKIP() << lacking;
  }
  for (std::size_t scene = 0; scene < scenes().size(); ++scene)
  {
    for (const BuildOptions& options : ownStructures())
    {
      for (const Precision precision : everyPrecision)
      {
        SCOPED_TRACE(
          scenes()[scene].name + ", " + label(options) + ", " + std::string(name(precision)));
        const Answers& wanted = usual(scene, options, precision);
        const ForcedInstructionSet forced(GetParam());
        const auto accelerator = build(scenes()[scene].surface, options);
        expectSame(wanted, ask(*accelerator, scenes()[scene].rays.batch(), with(precision)));
        if (::testing::Test::HasFailure())
        {
          return;
        }
      }
    }
  }
}

TEST_P(InstructionSets, AreForced)
{
  const std::string lacking = GetParam().lacking();
  if (!lacking.empty())
  {
    GTEST_SKIP() << lacking;
  }
  std::set<std::size_t> chosen;
  for (const InstructionSet& other : instructionSets())
  {
    if (other.target != GetParam().target && other.lacking().empty())
    {
      const ForcedInstructionSet forced(other);
      chosen.insert(hwy::GetChosenTarget().GetIndex());
    }
  }
  const ForcedInstructionSet forced(GetParam());
  EXPECT_EQ(chosen.count(hwy::GetChosenTarget().GetIndex()), 0u);
}

INSTANTIATE_TEST_SUITE_P(Each, InstructionSets, ::testing::ValuesIn(instructionSets()),
  [](const auto& set) { return set.param.name; });

} // namespace
