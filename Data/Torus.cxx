// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"
#include "Data/Turn.h"

namespace lumitree::data
{

Mesh torus(int around, int across, double bump)
{
  requireRange("around", around, 3, 10000);
  requireRange("across", across, 3, 10000);
  requireRange("bump", bump, 0, 0.9);
  MeshBuilder builder;
  builder.beginPart("torus", 0.5);
  for (int i = 0; i < around; ++i)
  {
    const auto [cosU, sinU] = cosSinOfTurn(i, around);
    for (int j = 0; j < across; ++j)
    {
      const auto [cosV, sinV] = cosSinOfTurn(j, across);
      const double wave = cosSinOfTurn(7 * i, around).first * cosSinOfTurn(3 * j, across).first;
      const double tube = 0.4 * (1 + bump * wave);
      const double radius = 1 + tube * cosV;
      builder.addPoint({ radius * cosU, radius * sinU, tube * sinV });
    }
  }
  const auto id = [&](int i, int j)
  { return static_cast<std::int64_t>(i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      builder.addPolygon({ id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return builder.take();
}

}
