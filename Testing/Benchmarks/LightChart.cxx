// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Error against time of direct light, one thread, by tolerance: what the estimator chooses, and
// rays alone; the tolerance relative to each sensor's value, or to the mean. Prints a table in
// Markdown. With the name of a directory as argument it also leaves there what other programs need
// to do the same (Docs/make_light_chart.py): for each scene its triangles (9 doubles each), its
// sensors and their reference values, as doubles, and its light in scenes.json; and the table as
// ours.csv.
//
// The reference is exact where the estimator has an exact method (box, city); else it is of 2^15
// rays per sensor, other ones than those measured.
#include "Radiometry/LightEstimate.h"
#include "Testing/Benchmarks/LightScenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
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

enum class Method
{
  Chosen,
  ChosenOfTheMean, ///< the tolerance is absolute, that share of the mean of all sensors
  Rays
};

const char* name(Method method)
{
  switch (method)
  {
    case Method::Chosen:
      return "chosen";
    case Method::ChosenOfTheMean:
      return "chosen, of the mean";
    default:
      return "rays, of the mean";
  }
}

struct Run
{
  Method method;
  double tolerance;
  std::vector<double> seconds;
  double error = 0.0; ///< nRMSE
  double rays = 0.0;  ///< per sensor
};

Receivers receiversOf(const LightScene& scene)
{
  Receivers receivers;
  receivers.size = scene.sensors.size();
  receivers.positions = scene.sensors.positions.data();
  receivers.normals = scene.sensors.normals.data();
  return receivers;
}

std::vector<double> reference(const LightScene& scene)
{
  EstimateOptions options;
  options.occluders = scene.occluders.get();
  options.threads = 1;
  options.relativeTolerance = 1e-9;
  options.maximumRays = 1u << 15;
  options.seed = std::uint64_t{ 1 } << 40;
  std::vector<double> values(scene.sensors.size());
  EstimateOutputs out;
  out.irradiance = values.data();
  estimateLight(receiversOf(scene), { scene.light.get() }, out, options);
  return values;
}

double meanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

void measure(const LightScene& scene, const std::vector<double>& exact, Run& run)
{
  const double mean = meanOf(exact);
  EstimateOptions options;
  options.occluders = scene.occluders.get();
  options.threads = 1;
  options.relativeTolerance = run.method == Method::Chosen ? run.tolerance : 0.0;
  options.absoluteTolerance = run.method == Method::Chosen ? 0.0 : run.tolerance * mean;
  if (run.method == Method::Rays)
  {
    options.mostClipped = 0;
    options.horizon = false;
  }
  std::vector<double> values(exact.size());
  EstimateOutputs out;
  out.irradiance = values.data();
  const double start = processorTime();
  const EstimateReport report =
    estimateLight(receiversOf(scene), { scene.light.get() }, out, options);
  run.seconds.push_back(processorTime() - start);
  const auto n = static_cast<double>(exact.size());
  run.rays = static_cast<double>(report.rays) / n;
  double squares = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    squares += (values[i] - exact[i]) * (values[i] - exact[i]);
  }
  run.error = std::sqrt(squares / n) / mean;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <class T>
void save(const std::string& path, const std::vector<T>& values)
{
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()),
    static_cast<std::streamsize>(values.size() * sizeof(T)));
  if (!file)
  {
    std::fprintf(stderr, "cannot write %s\n", path.c_str());
    std::exit(1);
  }
}

void saveScene(const std::string& directory, const LightScene& scene,
  const std::vector<double>& exact, std::ofstream& json)
{
  const std::string base = directory + "/" + scene.key;
  const Surface& surface = scene.occluders->surface();
  std::vector<double> corners;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t)
  {
    for (const Vec3& p : surface.vertices(static_cast<PrimitiveId>(t)))
    {
      corners.insert(corners.end(), p.begin(), p.end());
    }
  }
  save(base + ".triangles", corners);
  save(base + ".sensors", scene.sensors.positions);
  save(base + ".exact", exact);
  json << "  { \"key\": \"" << scene.key << "\", \"name\": \"" << scene.name << "\", ";
  if (scene.polygon)
  {
    json << "\"radiance\": " << scene.polygon->radiance << ", \"polygon\": [";
    const char* comma = "";
    for (const Vec3& p : scene.polygon->corners)
    {
      json << comma << "[" << p[0] << ", " << p[1] << ", " << p[2] << "]";
      comma = ", ";
    }
    json << "] }";
    return;
  }
  const SkyDistribution& sky = scene.sky;
  const Vec3& sun = scene.towardsSun;
  json << "\"sky\": [" << sky.a << ", " << sky.b << ", " << sky.c << ", " << sky.d << ", " << sky.e
       << ", " << sky.base << "], \"sun\": [" << sun[0] << ", " << sun[1] << ", " << sun[2]
       << "] }";
}

} // namespace

int main(int argc, char** argv)
{
  const std::string directory = argc > 1 ? argv[1] : "";
  std::ofstream json;
  std::ofstream csv;
  if (!directory.empty())
  {
    json.open(directory + "/scenes.json");
    json.precision(17);
    json << "[\n";
    csv.open(directory + "/ours.csv");
    csv << "Scene,Method,Tolerance,Seconds,Error,Rays\n";
  }
  const char* comma = "";
  for (LightScene (*make)() : { box, +[] { return streets(false); }, scan, yard })
  {
    const LightScene scene = make();
    const std::vector<double> exact = reference(scene);
    std::vector<Run> runs;
    for (const double tolerance : { 0.3, 0.1, 0.05, 0.03, 0.02 })
    {
      for (const Method method : { Method::Chosen, Method::ChosenOfTheMean, Method::Rays })
      {
        if (method != Method::Rays || tolerance == 0.1 || tolerance == 0.03)
        {
          runs.push_back({ method, tolerance, {} });
        }
      }
    }
    constexpr int rounds = 3;
    constexpr double longEnough = 0.5; // [s]: once does
    for (int round = 0; round < rounds; ++round)
    {
      for (Run& run : runs)
      {
        if (run.seconds.empty() || run.seconds.front() < longEnough)
        {
          measure(scene, exact, run);
        }
      }
    }
    std::printf("\n### %s; %zu triangles, %zu sensors\n\n"
                "| method | tolerance | time [ms] | rays per sensor | nRMSE [%%] |\n"
                "| --- | --- | --- | --- | --- |\n",
      scene.name.c_str(), scene.occluders->surface().triangleCount(), scene.sensors.size());
    for (const Run& run : runs)
    {
      const double seconds = median(run.seconds);
      std::printf("| %s | %g | %.2f | %.0f | %.4f |\n", name(run.method), run.tolerance,
        1e3 * seconds, run.rays, 100.0 * run.error);
      if (csv.is_open())
      {
        csv << scene.key << ',' << '"' << name(run.method) << "\"," << run.tolerance << ','
            << seconds << ',' << run.error << ',' << run.rays << '\n';
      }
    }
    std::fflush(stdout);
    if (json.is_open())
    {
      json << comma;
      saveScene(directory, scene, exact, json);
      comma = ",\n";
    }
  }
  if (json.is_open())
  {
    json << "\n]\n";
  }
  return 0;
}
