// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"
#include "Data/Random.h"

namespace lumitree::data
{
namespace
{

double latticeValue(std::uint64_t seed, int octave, int i, int j)
{
  const std::uint64_t cell = (static_cast<std::uint64_t>(octave) << 40) |
    (static_cast<std::uint64_t>(j) << 20) | static_cast<std::uint64_t>(i);
  return static_cast<double>(mixBits(mixBits(seed) ^ cell) >> 11) * 0x1p-53;
}

double smooth(double t)
{
  return t * t * (3 - 2 * t);
}

// Values on a lattice of 2^(octave + 2) cells a side, blended smoothly. x and y in [0, 1].
double noise(std::uint64_t seed, int octave, double x, double y)
{
  const int cells = 4 << octave;
  const int i = static_cast<int>(x * cells);
  const int j = static_cast<int>(y * cells);
  const double u = smooth(x * cells - i);
  const double v = smooth(y * cells - j);
  const double low =
    latticeValue(seed, octave, i, j) * (1 - u) + latticeValue(seed, octave, i + 1, j) * u;
  const double high =
    latticeValue(seed, octave, i, j + 1) * (1 - u) + latticeValue(seed, octave, i + 1, j + 1) * u;
  return low * (1 - v) + high * v;
}

}

Mesh terrain(int divisions, std::uint64_t seed, double height)
{
  requireRange("divisions", divisions, 1, 5000);
  requireRange("height", height, 0, 10);
  MeshBuilder builder;
  builder.beginPart("terrain", 0.2);
  for (int j = 0; j <= divisions; ++j)
  {
    for (int i = 0; i <= divisions; ++i)
    {
      const double x = static_cast<double>(i) / divisions;
      const double y = static_cast<double>(j) / divisions;
      double sum = 0;
      double weight = 1;
      double total = 0;
      for (int octave = 0; octave < 6; ++octave)
      {
        sum += weight * noise(seed, octave, x, y);
        total += weight;
        weight *= 0.5;
      }
      builder.addPoint({ x, y, height * (sum / total) });
    }
  }
  const std::int64_t row = divisions + 1;
  for (std::int64_t j = 0; j < divisions; ++j)
  {
    for (std::int64_t i = 0; i < divisions; ++i)
    {
      const std::int64_t at = j * row + i;
      builder.addPolygon({ at, at + 1, at + row + 1, at + row });
    }
  }
  return builder.take();
}

}
