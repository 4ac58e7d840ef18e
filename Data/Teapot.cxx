// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Newell's 32 patches (1975; see Data/README.md). His data is mirror-symmetric, number for number,
// so ten patches are enough: six quarters of surfaces of revolution (mirrored in x and in y), and
// two halves each of the handle and of the spout (mirrored in y).
#include "Data/Teapot.h"

namespace lumitree::data
{
namespace
{

// A row of a quarter patch: (r, 0), (r, -s), (s, -r), (0, -r) at height z.
struct Ring
{
  double r, s, z;
};

struct QuarterPatch
{
  TeapotPart part;
  Ring rings[4];
};

// From the top down, except the bottom, which goes from its centre up.
constexpr QuarterPatch quarters[6] = {
  { TeapotPart::Body,
    { { 1.4, 0.784, 2.4 }, { 1.3375, 0.749, 2.53125 }, { 1.4375, 0.805, 2.53125 },
      { 1.5, 0.84, 2.4 } } },
  { TeapotPart::Body,
    { { 1.5, 0.84, 2.4 }, { 1.75, 0.98, 1.875 }, { 2, 1.12, 1.35 }, { 2, 1.12, 0.9 } } },
  { TeapotPart::Body,
    { { 2, 1.12, 0.9 }, { 2, 1.12, 0.45 }, { 1.5, 0.84, 0.225 }, { 1.5, 0.84, 0.15 } } },
  { TeapotPart::Lid, { { 0, 0, 3.15 }, { 0.8, 0.45, 3.15 }, { 0, 0, 2.85 }, { 0.2, 0.112, 2.7 } } },
  { TeapotPart::Lid,
    { { 0.2, 0.112, 2.7 }, { 0.4, 0.224, 2.55 }, { 1.3, 0.728, 2.55 }, { 1.3, 0.728, 2.4 } } },
  { TeapotPart::Bottom,
    { { 0, 0, 0 }, { 1.425, 0.798, 0 }, { 1.5, 0.84, 0.075 }, { 1.5, 0.84, 0.15 } } },
};

struct HalfPatch
{
  TeapotPart part;
  Point points[16];
};

constexpr HalfPatch halves[4] = {
  { TeapotPart::Handle,
    { { -1.6, 0, 2.025 }, { -1.6, -0.3, 2.025 }, { -1.5, -0.3, 2.25 }, { -1.5, 0, 2.25 },
      { -2.3, 0, 2.025 }, { -2.3, -0.3, 2.025 }, { -2.5, -0.3, 2.25 }, { -2.5, 0, 2.25 },
      { -2.7, 0, 2.025 }, { -2.7, -0.3, 2.025 }, { -3, -0.3, 2.25 }, { -3, 0, 2.25 },
      { -2.7, 0, 1.8 }, { -2.7, -0.3, 1.8 }, { -3, -0.3, 1.8 }, { -3, 0, 1.8 } } },
  { TeapotPart::Handle,
    { { -2.7, 0, 1.8 }, { -2.7, -0.3, 1.8 }, { -3, -0.3, 1.8 }, { -3, 0, 1.8 }, { -2.7, 0, 1.575 },
      { -2.7, -0.3, 1.575 }, { -3, -0.3, 1.35 }, { -3, 0, 1.35 }, { -2.5, 0, 1.125 },
      { -2.5, -0.3, 1.125 }, { -2.65, -0.3, 0.9375 }, { -2.65, 0, 0.9375 }, { -2, 0, 0.9 },
      { -2, -0.3, 0.9 }, { -1.9, -0.3, 0.6 }, { -1.9, 0, 0.6 } } },
  { TeapotPart::Spout,
    { { 1.7, 0, 1.425 }, { 1.7, -0.66, 1.425 }, { 1.7, -0.66, 0.6 }, { 1.7, 0, 0.6 },
      { 2.6, 0, 1.425 }, { 2.6, -0.66, 1.425 }, { 3.1, -0.66, 0.825 }, { 3.1, 0, 0.825 },
      { 2.3, 0, 2.1 }, { 2.3, -0.25, 2.1 }, { 2.4, -0.25, 2.025 }, { 2.4, 0, 2.025 },
      { 2.7, 0, 2.4 }, { 2.7, -0.25, 2.4 }, { 3.3, -0.25, 2.4 }, { 3.3, 0, 2.4 } } },
  { TeapotPart::Spout,
    { { 2.7, 0, 2.4 }, { 2.7, -0.25, 2.4 }, { 3.3, -0.25, 2.4 }, { 3.3, 0, 2.4 }, { 2.8, 0, 2.475 },
      { 2.8, -0.25, 2.475 }, { 3.525, -0.25, 2.49375 }, { 3.525, 0, 2.49375 }, { 2.9, 0, 2.475 },
      { 2.9, -0.15, 2.475 }, { 3.45, -0.15, 2.5125 }, { 3.45, 0, 2.5125 }, { 2.8, 0, 2.4 },
      { 2.8, -0.15, 2.4 }, { 3.2, -0.15, 2.4 }, { 3.2, 0, 2.4 } } },
};

using Patch = std::array<Point, 16>;

Patch mirrored(const Patch& patch, double signX, double signY)
{
  Patch result = patch;
  for (Point& p : result)
  {
    p[0] *= signX;
    p[1] *= signY;
  }
  return result;
}

// The cubic at k/n. The same bits from either end; an end, or four equal points, is itself: that
// is what makes the borders of patches meet exactly.
Point onCubic(const Point& a, const Point& b, const Point& c, const Point& d, int k, int n)
{
  if (k == 0)
  {
    return a;
  }
  if (k == n)
  {
    return d;
  }
  const double l = n - k;
  const double r = k;
  Point p;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const bool same = a[i] == b[i] && b[i] == c[i] && c[i] == d[i];
    p[i] = same ? a[i]
                : ((l * l * l * a[i] + r * r * r * d[i]) +
                    (3 * (l * l * r) * b[i] + 3 * (l * r * r) * c[i])) /
        (double(n) * n * n);
  }
  return p;
}

void addPatch(MeshBuilder& builder, const Patch& patch, int n, double scale, bool flip)
{
  std::vector<std::int64_t> ids;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      Point column[4];
      for (std::size_t row = 0; row < 4; ++row)
      {
        const Point* p = &patch[4 * row];
        column[row] = onCubic(p[0], p[1], p[2], p[3], i, n);
      }
      Point p = onCubic(column[0], column[1], column[2], column[3], j, n);
      for (double& x : p)
      {
        x *= scale;
      }
      ids.push_back(builder.weldPoint(p));
    }
  }
  const std::size_t row = static_cast<std::size_t>(n) + 1;
  for (std::size_t j = 0; j + 1 < row; ++j)
  {
    for (std::size_t i = 0; i + 1 < row; ++i)
    {
      const std::size_t at = j * row + i;
      const std::int64_t a = ids[at], b = ids[at + 1], c = ids[at + row + 1], d = ids[at + row];
      builder.addCollapsed(flip ? std::array{ a, d, c, b } : std::array{ a, b, c, d });
    }
  }
}

}

void addTeapot(MeshBuilder& builder, int divisions, double scale)
{
  constexpr double reflectance = 0.7;
  const int first = builder.beginPart("body", reflectance);
  for (const char* name : { "handle", "spout", "lid", "bottom" })
  {
    builder.beginPart(name, reflectance);
  }

  for (const QuarterPatch& quarter : quarters)
  {
    builder.usePart(first + static_cast<int>(quarter.part), reflectance);
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row)
    {
      const Ring& ring = quarter.rings[row];
      patch[4 * row] = { ring.r, 0, ring.z };
      patch[4 * row + 1] = { ring.r, -ring.s, ring.z };
      patch[4 * row + 2] = { ring.s, -ring.r, ring.z };
      patch[4 * row + 3] = { 0, -ring.r, ring.z };
    }
    const bool upward = quarter.part == TeapotPart::Bottom;
    for (const double signX : { 1.0, -1.0 })
    {
      for (const double signY : { 1.0, -1.0 })
      {
        addPatch(
          builder, mirrored(patch, signX, signY), divisions, scale, (signX * signY < 0) != upward);
      }
    }
  }
  for (const HalfPatch& half : halves)
  {
    builder.usePart(first + static_cast<int>(half.part), reflectance);
    Patch patch;
    for (std::size_t i = 0; i < 16; ++i)
    {
      patch[i] = half.points[i];
    }
    for (const double signY : { 1.0, -1.0 })
    {
      addPatch(builder, mirrored(patch, 1, signY), divisions, scale, signY < 0);
    }
  }
}

Mesh teapot(int divisions)
{
  requireRange("divisions", divisions, 2, 1000);
  MeshBuilder builder;
  addTeapot(builder, divisions, 1);
  return builder.take();
}

}
