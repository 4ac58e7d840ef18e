// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Benchmarks/LightScenes.h"

#include "Data/Scenes.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/PolygonSource.h"
#include "Radiometry/SkySource.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lumitree::benchmarks
{

namespace
{

/// Triangles that share no points.
class Mesh
{
public:
  void addTriangle(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    const auto first = static_cast<std::uint32_t>(this->points_.size() / 3);
    for (const Vec3& p : { a, b, c })
    {
      this->points_.insert(this->points_.end(), p.begin(), p.end());
    }
    this->triangles_.push_back({ first, first + 1, first + 2 });
  }

  void addQuad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
  {
    this->addTriangle(a, b, c);
    this->addTriangle(a, c, d);
  }

  /// A box without its bottom, or with it.
  void addBox(const Vec3& low, const Vec3& high, bool bottom)
  {
    const Vec3 base[4] = { low, { high[0], low[1], low[2] }, { high[0], high[1], low[2] },
      { low[0], high[1], low[2] } };
    const Vec3 up = { 0.0, 0.0, high[2] - low[2] };
    for (int i = 0; i < 4; ++i)
    {
      const Vec3& a = base[i];
      const Vec3& b = base[(i + 1) % 4];
      this->addQuad(a, b, b + up, a + up);
    }
    this->addQuad(base[0] + up, base[1] + up, base[2] + up, base[3] + up);
    if (bottom)
    {
      this->addQuad(base[3], base[2], base[1], base[0]);
    }
  }

  void add(const data::Mesh& mesh, const Vec3& offset, double scale, int leaveOutPart = -1)
  {
    const auto point = [&](std::int64_t k)
    {
      const auto i = 3 * static_cast<std::size_t>(mesh.connectivity[static_cast<std::size_t>(k)]);
      return offset + scale * Vec3{ mesh.points[i], mesh.points[i + 1], mesh.points[i + 2] };
    };
    for (std::size_t c = 0; c + 1 < mesh.offsets.size(); ++c)
    {
      for (auto j = mesh.offsets[c] + 1; j + 1 < mesh.offsets[c + 1]; ++j)
      {
        if (mesh.part.empty() || mesh.part[c] != leaveOutPart)
        {
          this->addTriangle(point(mesh.offsets[c]), point(j), point(j + 1));
        }
      }
    }
  }

  [[nodiscard]] std::shared_ptr<const Accelerator> accelerate()
  {
    return build(std::make_shared<Surface>(
      PointArray::from(std::move(this->points_)), std::move(this->triangles_)));
  }

  /// As VTK stores most meshes.
  [[nodiscard]] std::shared_ptr<const Accelerator> accelerateFloats()
  {
    return build(std::make_shared<Surface>(
      PointArray::from(std::vector<float>(this->points_.begin(), this->points_.end())),
      std::move(this->triangles_)));
  }

private:
  std::vector<double> points_;
  std::vector<Triangle> triangles_;
};

void hangLight(LightScene& scene, double middle, double half, double z)
{
  const double a = middle - half;
  const double b = middle + half;
  scene.polygon =
    EmittingPolygon{ { { a, a, z }, { a, b, z }, { b, b, z }, { b, a, z } }, {}, 10.0, false };
  scene.light = std::make_unique<PolygonSource>(std::vector<EmittingPolygon>{ *scene.polygon });
}

void addFloor(Mesh& mesh, double low, double high)
{
  mesh.addQuad({ low, low, 0 }, { high, low, 0 }, { high, high, 0 }, { low, high, 0 });
}

/// Whether a place is inside, or within a millimetre of it.
bool insideConvex(const std::array<std::array<double, 2>, 4>& corners, double x, double y)
{
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const auto& a = corners[i];
    const auto& b = corners[(i + 1) % corners.size()];
    const double left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    if (left < -0.001 * std::hypot(b[0] - a[0], b[1] - a[1]))
    {
      return false;
    }
  }
  return true;
}

} // namespace

void Sensors::add(double x, double y)
{
  this->positions.insert(this->positions.end(), { x, y, 0.0 });
  this->normals.insert(this->normals.end(), { 0.0, 0.0, 1.0 });
}

LightScene box()
{
  LightScene scene;
  scene.key = "box";
  scene.name = "Box: area light, two blocks";
  const data::Mesh room = data::cornellBox();
  const auto light = std::find(room.partNames.begin(), room.partNames.end(), "light");
  Mesh mesh;
  mesh.add(room, { 0, 0, 0 }, 1.0, static_cast<int>(light - room.partNames.begin()));
  scene.occluders = mesh.accelerate();
  hangLight(scene, 0.5, 0.15, 0.995);
  // Where the blocks of the Cornell box stand.
  const std::array<std::array<double, 2>, 4> low = { { { 0.583694072, 0.130988973 },
    { 0.869011027, 0.223694072 }, { 0.776305928, 0.509011027 }, { 0.490988973, 0.416305928 } } };
  const std::array<std::array<double, 2>, 4> high = { { { 0.137743085, 0.560349128 },
    { 0.419650872, 0.457743085 }, { 0.522256915, 0.739650872 }, { 0.240349128, 0.842256915 } } };
  for (int j = 0; j < 50; ++j)
  {
    for (int i = 0; i < 50; ++i)
    {
      const double x = (i + 0.5) / 50;
      const double y = (j + 0.5) / 50;
      if (!insideConvex(low, x, y) && !insideConvex(high, x, y))
      {
        scene.sensors.add(x, y);
      }
    }
  }
  return scene;
}

LightScene streets(bool overcast)
{
  LightScene scene;
  scene.key = overcast ? "overcast" : "city";
  scene.name = overcast ? "Streets: overcast sky" : "Streets: uniform sky";
  constexpr double heights[16] = { 21.0, 27.5, 24.6, 11.4, 13.2, 27.0, 6.1, 25.7, 25.1, 17.2, 13.3,
    12.7, 12.1, 16.7, 18.1, 19.3 };
  Mesh mesh;
  addFloor(mesh, -200.0, 200.0);
  for (int house = 0; house < 16; ++house)
  {
    const double x = -36.0 + 20.0 * (house / 4);
    const double y = -36.0 + 20.0 * (house % 4);
    mesh.addBox({ x, y, 0 }, { x + 12, y + 12, heights[house] }, false);
  }
  scene.occluders = mesh.accelerate();
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
      const double x = -19.6 + 0.8 * i;
      const double y = -19.6 + 0.8 * j;
      const auto inside = [](double v) { return std::fmod(v + 36.0, 20.0) < 12.0; };
      if (!inside(x) || !inside(y))
      {
        scene.sensors.add(x, y);
      }
    }
  }
  return scene;
}

LightScene ball(int frequency)
{
  LightScene scene;
  scene.key = "ball" + std::to_string(frequency);
  scene.name = std::to_string(20 * frequency * frequency) + " triangles";
  Mesh mesh;
  mesh.add(data::sphere(frequency), { 0.5, 0.5, 0.5 }, 0.12);
  scene.occluders = mesh.accelerate();
  hangLight(scene, 0.5, 0.15, 0.995);
  for (int j = 0; j < 24; ++j)
  {
    for (int i = 0; i < 24; ++i)
    {
      scene.sensors.add(0.25 + 0.5 * (i + 0.5) / 24, 0.25 + 0.5 * (j + 0.5) / 24);
    }
  }
  return scene;
}

LightScene scan()
{
  LightScene scene;
  scene.key = "scan";
  scene.name = "Scan of 69,620 triangles: area light";
  data::Mesh lump = data::sphere(59);
  for (std::size_t i = 0; i < lump.points.size(); i += 3)
  {
    const double x = lump.points[i];
    const double y = lump.points[i + 1];
    const double z = lump.points[i + 2];
    const double swell = 1.0 + 0.25 * std::sin(4 * x + 1) * std::sin(5 * y + 2) * std::sin(3 * z) +
      0.04 * std::sin(19 * x) * std::sin(17 * y) * std::sin(23 * z);
    for (std::size_t k = 0; k < 3; ++k)
    {
      lump.points[i + k] *= swell;
    }
  }
  Mesh mesh;
  addFloor(mesh, 0.0, 1.0);
  mesh.add(lump, { 0.5, 0.5, 0.3 }, 0.2);
  scene.occluders = mesh.accelerateFloats();
  hangLight(scene, 0.5, 0.15, 0.995);
  for (int j = 0; j < 40; ++j)
  {
    for (int i = 0; i < 40; ++i)
    {
      scene.sensors.add((i + 0.5) / 40, (j + 0.5) / 40);
    }
  }
  return scene;
}

LightScene yard()
{
  LightScene scene;
  scene.key = "yard";
  scene.name = "Yard: balconies, bridge, trees; CIE clear sky";
  Mesh mesh;
  addFloor(mesh, -100.0, 100.0);
  for (int side = 0; side < 4; ++side)
  {
    // A house along each side, on columns, with balconies towards the yard.
    const auto place = [&](double along, double out, double z) -> Vec3
    {
      switch (side)
      {
        case 0:
          return { along, out, z };
        case 1:
          return { -along, -out, z };
        case 2:
          return { out, -along, z };
        default:
          return { -out, along, z };
      }
    };
    const auto addBlock =
      [&](double from, double to, double near, double far, double low, double high)
    {
      const Vec3 a = place(from, near, low);
      const Vec3 b = place(to, far, high);
      mesh.addBox({ std::min(a[0], b[0]), std::min(a[1], b[1]), low },
        { std::max(a[0], b[0]), std::max(a[1], b[1]), high }, true);
    };
    addBlock(-16, 16, 14, 24, 3.5, 9.0 + 3.0 * side);
    for (int column = 0; column < 9; ++column)
    {
      addBlock(-16 + 3.95 * column, -15.6 + 3.95 * column, 14, 14.4, 0, 3.5);
    }
    for (int floor = 0; floor < 2 + side; ++floor)
    {
      for (int balcony = 0; balcony < 5; ++balcony)
      {
        const double at = -14 + 6 * balcony;
        const double z = 4 + 2.8 * floor;
        addBlock(at, at + 3, 12.4, 14, z, z + 0.2);
        addBlock(at, at + 3, 12.4, 12.45, z + 0.2, z + 1.1);
      }
    }
  }
  mesh.addBox({ -2, -14, 6 }, { 0, 14, 7 }, true); // a bridge across
  for (const auto& tree : { std::array<double, 2>{ 6, 5 }, { 7, -6 }, { -8, 4.2 }, { -6.3, -8 } })
  {
    mesh.addBox({ tree[0] - 0.2, tree[1] - 0.2, 0 }, { tree[0] + 0.2, tree[1] + 0.2, 3.5 }, false);
    mesh.add(data::sphere(8), { tree[0], tree[1], 5.2 }, 2.2);
  }
  scene.occluders = mesh.accelerateFloats();
  scene.sky = cieSky(12);
  scene.towardsSun = { 0.5, 0.5, std::sqrt(0.5) };
  scene.light = std::make_unique<GeneralSky>(
    scene.sky, scene.towardsSun, SkyLevel{ SkyLevel::Kind::ZenithRadiance, 1.0 });
  for (int j = 0; j < 40; ++j)
  {
    for (int i = 0; i < 40; ++i)
    {
      scene.sensors.add(-13.65 + 0.7 * i, -13.65 + 0.7 * j);
    }
  }
  return scene;
}

} // namespace lumitree::benchmarks
