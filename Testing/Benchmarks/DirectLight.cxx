// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Error against time of direct light, one thread: what the estimator chooses, and rays alone at
// several tolerances. Scenes: the Cornell box under its light, sixteen houses under a uniform and
// under an overcast sky, and spheres of more and more triangles between a light and the floor.
// Prints tables in Markdown. The reference is our exact one (clipping, skyline); it agrees with
// published values of the same scenes to their 9 digits.
#include "Accel/Accelerator.h"
#include "Data/Scenes.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SkySource.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

namespace
{

using namespace lumitree;

double processorTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Sensors
{
  std::vector<double> positions;
  std::vector<double> normals;

  void add(double x, double y)
  {
    this->positions.insert(this->positions.end(), { x, y, 0.0 });
    this->normals.insert(this->normals.end(), { 0.0, 0.0, 1.0 });
  }
  [[nodiscard]] std::size_t size() const { return this->positions.size() / 3; }
};

struct Scene
{
  std::string name;
  std::shared_ptr<const Accelerator> occluders;
  std::unique_ptr<const Source> light;
  Sensors sensors;
};

void addQuad(std::vector<double>& points, std::vector<Triangle>& triangles, const Vec3& a,
  const Vec3& b, const Vec3& c, const Vec3& d)
{
  const auto first = static_cast<std::uint32_t>(points.size() / 3);
  for (const Vec3& p : { a, b, c, d })
  {
    points.insert(points.end(), p.begin(), p.end());
  }
  triangles.push_back({ first, first + 1, first + 2 });
  triangles.push_back({ first, first + 2, first + 3 });
}

std::shared_ptr<const Surface> surfaceOf(const data::Mesh& mesh, const Vec3& offset, double scale)
{
  std::vector<double> points(mesh.points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = scale * points[i] + offset[i % 3];
  }
  std::vector<Triangle> triangles;
  for (std::size_t c = 0; c + 1 < mesh.offsets.size(); ++c)
  {
    for (auto j = mesh.offsets[c] + 1; j + 1 < mesh.offsets[c + 1]; ++j)
    {
      const auto corner = [&](std::int64_t k)
      { return static_cast<std::uint32_t>(mesh.connectivity[static_cast<std::size_t>(k)]); };
      triangles.push_back({ corner(mesh.offsets[c]), corner(j), corner(j + 1) });
    }
  }
  return std::make_shared<Surface>(PointArray::from(std::move(points)), std::move(triangles));
}

std::unique_ptr<const Source> ceilingLight(double middle, double half, double z)
{
  const double a = middle - half;
  const double b = middle + half;
  return std::make_unique<PolygonSource>(std::vector<EmittingPolygon>{
    { { { a, a, z }, { a, b, z }, { b, b, z }, { b, a, z } }, {}, 10.0, false } });
}

Scene box()
{
  Scene scene;
  scene.name = "Box: area light, two blocks";
  scene.occluders = build(surfaceOf(data::cornellBox(), { 0, 0, 0 }, 1.0));
  scene.light = ceilingLight(0.5, 0.15, 0.995);
  for (int j = 0; j < 50; ++j)
  {
    for (int i = 0; i < 50; ++i)
    {
      scene.sensors.add((i + 0.5) / 50, (j + 0.5) / 50);
    }
  }
  return scene;
}

/// Sixteen houses of 12 by 12 metres, 6 to 30 high, streets of 8, sensors in the streets.
Scene streets(bool overcast)
{
  Scene scene;
  scene.name = overcast ? "Streets: overcast sky" : "Streets: uniform sky";
  std::vector<double> points;
  std::vector<Triangle> triangles;
  addQuad(
    points, triangles, { -200, -200, 0 }, { 200, -200, 0 }, { 200, 200, 0 }, { -200, 200, 0 });
  for (int house = 0; house < 16; ++house)
  {
    const double x = -36.0 + 20.0 * (house % 4);
    const double y = -36.0 + 20.0 * (house / 4);
    const double h = 6.0 + 24.0 * ((house * 7) % 16) / 15.0;
    const Vec3 base[4] = { { x, y, 0 }, { x + 12, y, 0 }, { x + 12, y + 12, 0 }, { x, y + 12, 0 } };
    const Vec3 up = { 0, 0, h };
    for (int i = 0; i < 4; ++i)
    {
      const Vec3& a = base[i];
      const Vec3& b = base[(i + 1) % 4];
      addQuad(points, triangles, a, b, b + up, a + up);
    }
    addQuad(points, triangles, base[0] + up, base[1] + up, base[2] + up, base[3] + up);
  }
  scene.occluders =
    build(std::make_shared<Surface>(PointArray::from(std::move(points)), std::move(triangles)));
  if (overcast)
  {
    scene.light = std::make_unique<OvercastSky>(SkyLevel{ SkyLevel::Kind::ZenithRadiance, 1.0 });
  }
  else
  {
    scene.light = std::make_unique<UniformSky>(1.0);
  }
  for (int j = 0; j < 50; ++j)
  {
    for (int i = 0; i < 50; ++i)
    {
      const double x = -36.0 + 72.0 * (i + 0.5) / 50;
      const double y = -36.0 + 72.0 * (j + 0.5) / 50;
      const auto inside = [](double v) { return std::fmod(v + 36.0, 20.0) < 12.0; };
      if (!inside(x) || !inside(y))
      {
        scene.sensors.add(x, y);
      }
    }
  }
  return scene;
}

/// A ball over the floor, right under the light.
Scene ball(int frequency)
{
  Scene scene;
  scene.name = std::to_string(20 * frequency * frequency) + " triangles";
  scene.occluders = build(surfaceOf(data::sphere(frequency), { 0.5, 0.5, 0.5 }, 0.12));
  scene.light = ceilingLight(0.5, 0.15, 0.995);
  for (int j = 0; j < 24; ++j)
  {
    for (int i = 0; i < 24; ++i)
    {
      scene.sensors.add(0.25 + 0.5 * (i + 0.5) / 24, 0.25 + 0.5 * (j + 0.5) / 24);
    }
  }
  return scene;
}

struct Measured
{
  std::vector<double> values;
  double seconds = 1e300;
  double rays = 0.0; ///< per sensor
};

Measured measure(const Scene& scene, double tolerance, std::uint32_t clipped, bool horizon)
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

void row(const char* what, const Scene& scene, const Measured& m, const std::vector<double>& exact)
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
  for (Scene (*make)() : { box, +[] { return streets(false); }, +[] { return streets(true); } })
  {
    const Scene scene = make();
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
    const Scene scene = ball(frequency);
    const Measured exact = measure(scene, 1e-9, 100000, true);
    row((scene.name + ", chosen").c_str(), scene, measure(scene, 0.01, 192, true), exact.values);
    row((scene.name + ", rays").c_str(), scene, measure(scene, 0.01, 0, true), exact.values);
    row((scene.name + ", cut out").c_str(), scene, exact, exact.values);
  }
  return 0;
}
