// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Teapot.h"

namespace lumitree::data
{

Mesh teapotInStadium(int divisions, double ratio)
{
  requireRange("divisions", divisions, 2, 1000);
  requireRange("ratio", ratio, 4, 1e6);
  MeshBuilder builder;
  addTeapot(builder, divisions, 0.05);

  constexpr double teapotLength = 0.32;
  const double half = 0.5 * ratio * teapotLength;
  const double top = 0.3 * ratio * teapotLength;
  builder.beginPart("hall", 0.5);
  std::int64_t corner[8];
  for (int i = 0; i < 8; ++i)
  {
    corner[i] = builder.addPoint({ i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? top : 0.0 });
  }
  constexpr int inward[6][4] = { { 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 4, 5, 1 }, { 2, 3, 7, 6 },
    { 0, 2, 6, 4 }, { 1, 5, 7, 3 } };
  for (const auto& face : inward)
  {
    builder.addPolygon({ corner[face[0]], corner[face[1]], corner[face[2]], corner[face[3]] });
  }
  return builder.take();
}

}
