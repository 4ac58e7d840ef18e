// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"
#include "Data/Turn.h"

#include <cmath>

namespace lumitree::data
{

Mesh slivers(int count, double aspect)
{
  requireRange("count", count, 3, 1e6);
  requireRange("aspect", aspect, 1, 1e12);
  MeshBuilder builder;
  builder.beginPart("slivers", 0.5);
  for (int i = 0; i < count; ++i)
  {
    const auto [c, s] = cosSinOfTurn(i, count);
    builder.addPoint({ c, s, 0 });
  }
  const auto [c, s] = cosSinOfTurn(1, count);
  const double edge = std::sqrt((c - 1) * (c - 1) + s * s);
  const std::int64_t top = builder.addPoint({ 0, 0, aspect * edge });
  const std::int64_t bottom = builder.addPoint({ 0, 0, -aspect * edge });
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::int64_t next = (i + 1) % count;
    builder.addPolygon({ i, next, top });
    builder.addPolygon({ next, i, bottom });
  }
  return builder.take();
}

}
