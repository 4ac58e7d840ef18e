// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// A convex body lit from within shadows nothing of itself, wherever it is and whether or not its
// triangles share points. No receiver is told here which triangles it lies on.
#include "Accel/Registry.h"
#include "Radiometry/DirectIrradiance.h"
#include "Radiometry/IsotropicPointSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace
{

using namespace lumitree;

constexpr double radius = 100.0;
constexpr double pi = 3.14159265358979323846;

/// A sphere of rings and segments around (offset, offset, offset), its points stored as T, every
/// triangle with points of its own.
template <class T>
struct Body
{
  std::vector<T> points; // nine numbers a triangle
  double offset;

  Body(double where, int rings, int segments)
    : offset(where)
  {
    const auto corner = [&](int ring, int segment)
    {
      const double theta = pi * ring / rings;
      const double phi = 2.0 * pi * (segment % segments) / segments;
      const double s = ring == 0 || ring == rings ? 0.0 : std::sin(theta);
      return std::array<T, 3>{ static_cast<T>(where + radius * s * std::cos(phi)),
        static_cast<T>(where + radius * s * std::sin(phi)),
        static_cast<T>(where + radius * std::cos(theta)) };
    };
    const auto add =
      [&](const std::array<T, 3>& a, const std::array<T, 3>& b, const std::array<T, 3>& c)
    {
      if (a != b && b != c && c != a)
      {
        for (const auto& p : { a, b, c })
        {
          points.insert(points.end(), p.begin(), p.end());
        }
      }
    };
    for (int r = 0; r < rings; ++r)
    {
      for (int s = 0; s < segments; ++s)
      {
        add(corner(r, s), corner(r + 1, s), corner(r + 1, s + 1));
        add(corner(r, s), corner(r + 1, s + 1), corner(r, s + 1));
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return this->points.size() / 9; }

  [[nodiscard]] Vec3 vertex(std::size_t triangle, int k) const
  {
    const T* p = this->points.data() + 9 * triangle + 3 * k;
    return { p[0], p[1], p[2] };
  }

  [[nodiscard]] std::shared_ptr<const Accelerator> accelerate(Structure structure) const
  {
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < this->size(); ++i)
    {
      triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    }
    BuildOptions options;
    options.structure = structure;
    return build(std::make_shared<Surface>(PointArray::from(this->points), triangles), options);
  }

  /// The inner normal of a triangle; nothing for one that rounding has flattened.
  [[nodiscard]] bool innerNormal(std::size_t i, Vec3& normal) const
  {
    const Vec3 a = this->vertex(i, 0);
    normal = cross(this->vertex(i, 2) - a, this->vertex(i, 1) - a);
    const double size = length(normal);
    if (size == 0.0)
    {
      return false;
    }
    const Vec3 inward = Vec3{ this->offset, this->offset, this->offset } - a;
    normal = (dot(normal, inward) > 0.0 ? 1.0 / size : -1.0 / size) * normal;
    return true;
  }
};

enum class Where
{
  Vertices,
  Centres,
  Anywhere // on a triangle, rounded to what the points are stored as
};

template <class T>
void expectNoShadow(
  double offset, Where where, std::size_t count, Structure structure = Structure::Auto)
{
  const Body<T> body(offset, 100, 200);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<T> positions;
  std::vector<double> normals;
  for (std::size_t i = 0; normals.size() < 3 * count; ++i)
  {
    const std::size_t triangle = i % body.size();
    Vec3 normal;
    if (!body.innerNormal(triangle, normal))
    {
      continue;
    }
    Vec3 p = body.vertex(triangle, static_cast<int>(i / body.size() % 3));
    if (where != Where::Vertices)
    {
      double u = where == Where::Centres ? 1.0 / 3.0 : uniform(random);
      double v = where == Where::Centres ? 1.0 / 3.0 : uniform(random);
      if (u + v > 1.0)
      {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      const Vec3 a = body.vertex(triangle, 0);
      p = a + u * (body.vertex(triangle, 1) - a) + v * (body.vertex(triangle, 2) - a);
    }
    for (int k = 0; k < 3; ++k)
    {
      positions.push_back(static_cast<T>(p[k]));
      normals.push_back(normal[k]);
    }
  }

  const auto occluders = body.accelerate(structure);
  const IsotropicPointSource source(1000.0, { offset + 30.0, offset - 20.0, offset + 40.0 });
  Receivers receivers;
  receivers.size = count;
  receivers.positions = positions.data();
  receivers.normals = normals.data();
  receivers.stored = receivers.positions.type;
  DirectOptions options;
  options.occluders = occluders.get();
  for (const Precision precision : { Precision::Fast, Precision::Watertight, Precision::Exact })
  {
    if (!occluders->supports(precision))
    {
      continue;
    }
    options.precision = precision;
    std::vector<double> e(count);
    const DirectReport report = directIrradiance(receivers, { &source }, e.data(), {}, options);
    std::size_t shadowed = 0;
    for (const double value : e)
    {
      shadowed += value > 0.0 ? 0 : 1;
    }
    EXPECT_EQ(shadowed, 0u) << "offset " << offset << ", precision " << name(precision) << ", rays "
                            << report.shadowRays;
  }
}

class SelfShadow : public testing::TestWithParam<double>
{
};

TEST_P(SelfShadow, FloatVertices)
{
  expectNoShadow<float>(GetParam(), Where::Vertices, 200000);
}

TEST_P(SelfShadow, FloatCentres)
{
  expectNoShadow<float>(GetParam(), Where::Centres, 200000);
}

TEST_P(SelfShadow, FloatAnywhere)
{
  expectNoShadow<float>(GetParam(), Where::Anywhere, 200000);
}

TEST_P(SelfShadow, DoubleVertices)
{
  expectNoShadow<double>(GetParam(), Where::Vertices, 200000);
}

TEST_P(SelfShadow, DoubleAnywhere)
{
  expectNoShadow<double>(GetParam(), Where::Anywhere, 200000);
}

TEST_P(SelfShadow, EveryStructure)
{
  for (const Structure structure : Registry::instance().structures())
  {
    if (structure != Structure::BruteForce) // it would take minutes
    {
      expectNoShadow<float>(GetParam(), Where::Anywhere, 4000, structure);
      expectNoShadow<double>(GetParam(), Where::Anywhere, 4000, structure);
    }
  }
}

TEST_P(SelfShadow, CornersOfATurnedRoom)
{
  // In a corner three planes meet: leaving one of them, a ray may run along the others.
  const double offset = GetParam();
  const std::array<Vec3, 3> axes = { { { 2.0 / 3, 2.0 / 3, 1.0 / 3 },
    { -2.0 / 3, 1.0 / 3, 2.0 / 3 }, { 1.0 / 3, -2.0 / 3, 2.0 / 3 } } };
  const auto place = [&](double x, double y, double z) {
    return Vec3{ offset, offset, offset } + (x * axes[0] + (y * axes[1] + z * axes[2]));
  };
  std::vector<float> points;
  std::vector<Triangle> triangles;
  std::vector<double> normals;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const double side = face % 2 == 0 ? 5.0 : -5.0;
    const auto first = static_cast<std::uint32_t>(points.size() / 3);
    for (const auto& [a, b] : { std::pair(-5.0, -5.0), { 5.0, -5.0 }, { 5.0, 5.0 }, { -5.0, 5.0 } })
    {
      Vec3 corner;
      corner[axis] = side;
      corner[(axis + 1) % 3] = a;
      corner[(axis + 2) % 3] = b;
      const Vec3 p = place(corner[0], corner[1], corner[2]);
      const Vec3 inward = (side > 0.0 ? -1.0 : 1.0) * axes[axis];
      for (int k = 0; k < 3; ++k)
      {
        points.push_back(static_cast<float>(p[k]));
        normals.push_back(inward[k]);
      }
    }
    triangles.push_back({ first, first + 1, first + 2 });
    triangles.push_back({ first, first + 2, first + 3 });
  }
  const auto room = build(std::make_shared<Surface>(PointArray::from(points), triangles));
  Receivers receivers;
  receivers.size = normals.size() / 3;
  receivers.positions = points.data();
  receivers.normals = normals.data();
  receivers.stored = ArrayView::Scalar::Float;
  DirectOptions options;
  options.occluders = room.get();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> within(-4.0, 4.0);
  int shadowed = 0;
  for (int i = 0; i < 500; ++i)
  {
    const IsotropicPointSource source(1.0, place(within(random), within(random), within(random)));
    std::vector<double> e(receivers.size);
    directIrradiance(receivers, { &source }, e.data(), {}, options);
    shadowed += static_cast<int>(std::count(e.begin(), e.end(), 0.0));
  }
  EXPECT_EQ(shadowed, 0);
}

INSTANTIATE_TEST_SUITE_P(Offsets, SelfShadow, testing::Values(0.0, 1e4, 1e6));

} // namespace
