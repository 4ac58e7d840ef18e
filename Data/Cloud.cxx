// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"
#include "Data/Random.h"

#include <cmath>

namespace lumitree::data
{
namespace
{

Point scaled(const Point& v, double factor)
{
  return { v[0] * factor, v[1] * factor, v[2] * factor };
}

// By rejection, which needs no trigonometry.
Point randomDirection(Random& random)
{
  for (;;)
  {
    const Point v{ random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1) };
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (square > 0.01 && square < 1)
    {
      return scaled(v, 1 / std::sqrt(square));
    }
  }
}

Point cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

}

Mesh randomCloud(std::int64_t count, std::uint64_t seed, double size, int sizePower)
{
  requireRange("count", static_cast<double>(count), 0, 1e8);
  requireRange("size", size, 1e-300, 1e3);
  requireRange("sizePower", sizePower, 0, 16);
  MeshBuilder builder;
  builder.beginPart("cloud", 0.5);
  Random random(seed);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const Point centre{ random.uniform(), random.uniform(), random.uniform() };
    const double u = 1 - random.uniform();
    double radius = size;
    for (int power = 0; power < sizePower; ++power)
    {
      radius *= u;
    }
    const Point a = randomDirection(random);
    Point b = cross(a, randomDirection(random));
    double square = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    while (square < 0.01)
    {
      b = cross(a, randomDirection(random));
      square = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    }
    b = scaled(b, 1 / std::sqrt(square));

    // An equilateral triangle: corners at 0, 120 and 240 degrees in the plane of a and b.
    constexpr double c[3] = { 1, -0.5, -0.5 };
    constexpr double s[3] = { 0, 0.8660254037844386, -0.8660254037844386 };
    std::int64_t ids[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      Point p;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        p[axis] = centre[axis] + radius * (c[k] * a[axis] + s[k] * b[axis]);
      }
      ids[k] = builder.addPoint(p);
    }
    builder.addPolygon({ ids[0], ids[1], ids[2] });
  }
  return builder.take();
}

}
