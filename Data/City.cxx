// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"
#include "Data/Random.h"

namespace lumitree::data
{
namespace
{

constexpr double pitch = 30;

struct Parts
{
  int tower, roof, pole;
};

// A box on a square base of the given half width.
void addPillar(
  MeshBuilder& builder, double x, double y, double halfX, double halfY, double bottom, double top)
{
  builder.addBox({ x - halfX, y - halfY, bottom }, { x + halfX, y + halfY, top });
}

void addPlot(MeshBuilder& builder, const Parts& parts, double x, double y, Random& random)
{
  constexpr double reflectance = 0.3;
  const double halfX = random.uniform(5, 9);
  const double halfY = random.uniform(5, 9);
  const double u = random.uniform();
  const double roof = 5 + 60 * (u * u * u);
  builder.usePart(parts.tower, reflectance);
  addPillar(builder, x, y, halfX, halfY, -1, roof);

  builder.usePart(parts.roof, reflectance);
  for (int i = 0; i < 18; ++i)
  {
    const double boxX = random.uniform(0.25, 1.25);
    const double boxY = random.uniform(0.25, 1.25);
    const double atX = x + random.uniform(-1, 1) * (halfX - boxX);
    const double atY = y + random.uniform(-1, 1) * (halfY - boxY);
    addPillar(builder, atX, atY, boxX, boxY, roof - 0.1, roof + random.uniform(0.3, 2));
  }

  builder.usePart(parts.pole, reflectance);
  for (int i = 0; i < 40; ++i)
  {
    // In the band from 10 to 14 m off the plot's axes, clear of every tower.
    const int side = random.index(4);
    const double along = random.uniform(-14, 14);
    const double off = (side & 1 ? 1 : -1) * random.uniform(10, 14);
    const double half = random.uniform(0.02, 0.06);
    const double atX = x + (side & 2 ? along : off);
    const double atY = y + (side & 2 ? off : along);
    addPillar(builder, atX, atY, half, half, -0.5, random.uniform(3, 9));
  }
}

}

Mesh city(int plots, std::uint64_t seed)
{
  requireRange("plots", plots, 1, 200);
  MeshBuilder builder;
  builder.beginPart("ground", 0.2);
  const double edge = 0.5 * pitch * plots + 60;
  builder.addQuadGrid({ Point{ -edge, -edge, 0 }, Point{ edge, -edge, 0 }, Point{ edge, edge, 0 },
                        Point{ -edge, edge, 0 } },
    1);
  Parts parts;
  parts.tower = builder.beginPart("tower", 0);
  parts.roof = builder.beginPart("roof", 0);
  parts.pole = builder.beginPart("pole", 0);
  for (int j = 0; j < plots; ++j)
  {
    for (int i = 0; i < plots; ++i)
    {
      // A stream of its own for each plot: its look depends on its number only.
      Random random(mixBits(seed) + static_cast<std::uint64_t>(j * plots + i));
      const double x = pitch * (i - 0.5 * (plots - 1));
      const double y = pitch * (j - 0.5 * (plots - 1));
      addPlot(builder, parts, x, y, random);
    }
  }
  return builder.take();
}

}
