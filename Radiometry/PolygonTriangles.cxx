// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PolygonTriangles.h"

#include <algorithm>
#include <numeric>

namespace lumitree
{

Vec3 polygonAreaVector(const std::vector<Vec3>& corners)
{
  Vec3 twice = { 0.0, 0.0, 0.0 };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    twice = twice + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return 0.5 * twice;
}

std::vector<std::array<std::size_t, 3>> triangulatePolygon(const std::vector<Vec3>& corners)
{
  const Vec3 normal = polygonAreaVector(corners);
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c)
  { return dot(normal, cross(corners[b] - corners[a], corners[c] - corners[a])); };

  std::vector<std::size_t> left(corners.size());
  std::iota(left.begin(), left.end(), std::size_t{ 0 });
  std::vector<std::array<std::size_t, 3>> triangles;
  while (left.size() > 2)
  {
    const std::size_t size = left.size();
    std::size_t ear = 0;
    for (; ear < size; ++ear)
    {
      const std::size_t a = left[ear];
      const std::size_t b = left[(ear + 1) % size];
      const std::size_t c = left[(ear + 2) % size];
      const bool empty = turn(a, b, c) > 0.0 &&
        std::none_of(left.begin(), left.end(),
          [&](std::size_t p)
          {
            return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
              turn(c, a, p) >= 0.0;
          });
      if (empty)
      {
        break;
      }
    }
    // No ear is left where corners coincide or lie on a line: then any one is cut.
    ear = ear == size ? 0 : ear;
    triangles.push_back({ left[ear], left[(ear + 1) % size], left[(ear + 2) % size] });
    left.erase(left.begin() + static_cast<std::ptrdiff_t>((ear + 1) % size));
  }
  return triangles;
}

} // namespace lumitree
