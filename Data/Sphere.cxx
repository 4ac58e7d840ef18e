// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"

#include <cmath>

namespace lumitree::data
{

Mesh sphere(int frequency)
{
  requireRange("frequency", frequency, 1, 1000);
  const int n = frequency;
  const double g = 0.5 * (1 + std::sqrt(5.0));
  const Point corners[12] = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g },
    { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 },
    { -g, 0, 1 } };
  constexpr int faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 },
    { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 },
    { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 },
    { 8, 6, 7 }, { 9, 8, 1 } };

  MeshBuilder builder;
  builder.beginPart("sphere", 0.5);
  for (const auto& face : faces)
  {
    // Row j holds n - j + 1 points.
    std::vector<std::int64_t> ids;
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i + j <= n; ++i)
      {
        Point p;
        for (std::size_t k = 0; k < 3; ++k)
        {
          // Two terms along an edge: the same bits from both faces.
          p[k] = double(n - i - j) * corners[face[0]][k] + double(i) * corners[face[1]][k] +
            double(j) * corners[face[2]][k];
        }
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        ids.push_back(builder.weldPoint({ p[0] / length, p[1] / length, p[2] / length }));
      }
    }
    std::size_t row = 0;
    for (int j = 0; j < n; ++j)
    {
      const std::size_t above = row + static_cast<std::size_t>(n - j + 1);
      for (std::size_t i = 0; i < static_cast<std::size_t>(n - j); ++i)
      {
        builder.addPolygon({ ids[row + i], ids[row + i + 1], ids[above + i] });
        if (i + 1 < static_cast<std::size_t>(n - j))
        {
          builder.addPolygon({ ids[row + i + 1], ids[above + i + 1], ids[above + i] });
        }
      }
      row = above;
    }
  }
  return builder.take();
}

}
