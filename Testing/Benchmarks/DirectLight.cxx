// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Error against time of direct light, one thread: what the estimator chooses, and rays alone at
// several tolerances. Scenes: the Cornell box under its light, sixteen houses under a uniform and
// under an overcast sky, and spheres of more and more triangles between a light and the floor.
// Prints tables in Markdown. The reference is our exact one (clipping, skyline); it agrees with
// published values of the same scenes to their 9 digits.
#include "Radiometry/LightEstimate.h"
#include "Testing/Benchmarks/LightScenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

namespace
{

using namespace lumitree;
using namespace lumitree::benchmarks;

double processorTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Measured
{
  std::vector<double> values;
  double seconds = 1e300;
  double rays = 0.0; ///< per sensor
};

Measured measure(const LightScene& scene, double tolerance, std::uint32_t clipped, bool horizon)
{
  Receivers receivers;
  receivers.size = scene.sensors.size();
  receivers.positions = scene.sensors.positions.data();
  receivers.normals = scene.sensors.normals.data();
  EstimateOptions options;
  options.occluders = scene.occluders.get();
  options.threads = 1;
  options.relativeTolerance = tolerance;
  options.mostClipped = clipped;
  options.horizon = horizon;
  Measured result;
  result.values.resize(receivers.size);
  EstimateOutputs out;
  out.irradiance = result.values.data();
  for (int repeat = 0; repeat < 3; ++repeat)
  {
    const double start = processorTime();
    const EstimateReport report = estimateLight(receivers, { scene.light.get() }, out, options);
    result.seconds = std::min(result.seconds, processorTime() - start);
    result.rays = static_cast<double>(report.rays) / static_cast<double>(receivers.size);
  }
  return result;
}

double relativeError(const std::vector<double>& values, const std::vector<double>& exact)
{
  double squares = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    squares += (values[i] - exact[i]) * (values[i] - exact[i]);
    mean += exact[i];
  }
  const auto n = static_cast<double>(exact.size());
  return mean > 0.0 ? std::sqrt(squares / n) / (mean / n) : 0.0;
}

void row(
  const char* what, const LightScene& scene, const Measured& m, const std::vector<double>& exact)
{
  std::printf("| %s | %.1f | %.2f | %.0f | %.3f |\n", what, 1e3 * m.seconds,
    1e6 * m.seconds / static_cast<double>(scene.sensors.size()), m.rays,
    100.0 * relativeError(m.values, exact));
  std::fflush(stdout);
}

constexpr const char* head = "| time [ms] | [us per sensor] | rays per sensor | nRMSE [%] |\n"
                             "| --- | --- | --- | --- | --- |\n";

} // namespace

int main()
{
  for (LightScene (*make)() :
    { box, +[] { return streets(false); }, +[] { return streets(true); } })
  {
    const LightScene scene = make();
    std::printf(
      "\n### %s, %zu sensors\n\n| method %s", scene.name.c_str(), scene.sensors.size(), head);
    const Measured chosen = measure(scene, 0.01, 192, true);
    row("chosen", scene, chosen, chosen.values);
    row("cut out, no skyline", scene, measure(scene, 0.01, 100000, false), chosen.values);
    for (const double tolerance : { 0.1, 0.05, 0.02, 0.01 })
    {
      char name[32];
      std::snprintf(name, sizeof name, "rays, tolerance %g", tolerance);
      row(name, scene, measure(scene, tolerance, 0, false), chosen.values);
    }
  }
  std::printf(
    "\n### A ball between a light and the floor, tolerance 1 %%\n\n| ball, method %s", head);
  for (const int frequency : { 1, 2, 3, 4, 8, 16 })
  {
    const LightScene scene = ball(frequency);
    const Measured exact = measure(scene, 1e-9, 100000, true);
    row((scene.name + ", chosen").c_str(), scene, measure(scene, 0.01, 192, true), exact.values);
    row((scene.name + ", rays").c_str(), scene, measure(scene, 0.01, 0, true), exact.values);
    row((scene.name + ", cut out").c_str(), scene, exact, exact.values);
  }
  return 0;
}
