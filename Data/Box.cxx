// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"

namespace lumitree::data
{
namespace
{

// The four sides and the top of a block standing on the floor. The base runs counter-clockwise.
void addBlock(
  MeshBuilder& builder, const std::array<std::array<double, 2>, 4>& base, double top, int divisions)
{
  const auto corner = [&](std::size_t i, double z) { return Point{ base[i][0], base[i][1], z }; };
  builder.addQuadGrid(
    { corner(0, top), corner(1, top), corner(2, top), corner(3, top) }, divisions);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t next = (i + 1) % 4;
    builder.addQuadGrid(
      { corner(i, 0), corner(next, 0), corner(next, top), corner(i, top) }, divisions);
  }
}

}

Mesh cornellBox(int divisions)
{
  requireRange("divisions", divisions, 1, 1000);
  constexpr double reflectance = 0.7;
  const Point p000{ 0, 0, 0 }, p100{ 1, 0, 0 }, p110{ 1, 1, 0 }, p010{ 0, 1, 0 };
  const Point p001{ 0, 0, 1 }, p101{ 1, 0, 1 }, p111{ 1, 1, 1 }, p011{ 0, 1, 1 };

  MeshBuilder builder;
  builder.beginPart("floor", reflectance);
  builder.addQuadGrid({ p000, p100, p110, p010 }, divisions);
  builder.beginPart("ceiling", reflectance);
  builder.addQuadGrid({ p001, p011, p111, p101 }, divisions);
  builder.beginPart("left", reflectance);
  builder.addQuadGrid({ p000, p010, p011, p001 }, divisions);
  builder.beginPart("right", reflectance);
  builder.addQuadGrid({ p100, p101, p111, p110 }, divisions);
  builder.beginPart("front", reflectance);
  builder.addQuadGrid({ p000, p001, p101, p100 }, divisions);
  builder.beginPart("back", reflectance);
  builder.addQuadGrid({ p010, p110, p111, p011 }, divisions);

  builder.beginPart("light", 0);
  constexpr double z = 0.995;
  builder.addQuadGrid({ Point{ 0.35, 0.35, z }, Point{ 0.35, 0.65, z }, Point{ 0.65, 0.65, z },
                        Point{ 0.65, 0.35, z } },
    divisions);

  // Squares of side 0.3 turned by 18 and by -20 degrees about (0.68, 0.32) and (0.33, 0.65),
  // given as numbers because libm's sine is not the same everywhere.
  builder.beginPart("low block", reflectance);
  addBlock(builder,
    { { { 0.583694072, 0.130988973 }, { 0.869011027, 0.223694072 }, { 0.776305928, 0.509011027 },
      { 0.490988973, 0.416305928 } } },
    0.3, divisions);
  builder.beginPart("high block", reflectance);
  addBlock(builder,
    { { { 0.137743085, 0.560349128 }, { 0.419650872, 0.457743085 }, { 0.522256915, 0.739650872 },
      { 0.240349128, 0.842256915 } } },
    0.6, divisions);
  return builder.take();
}

}
