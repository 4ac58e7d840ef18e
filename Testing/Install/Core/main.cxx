// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause

// What a program outside does first: one triangle, one ray, one hit at t = 2.

#include "Accel/Accelerator.h"

#include <iostream>
#include <memory>
#include <vector>

int main()
{
  using namespace lumitree;
  const auto points =
    PointArray::from(std::vector<double>{ -1.0, -1.0, 2.0, 1.0, -1.0, 2.0, 0.0, 1.0, 2.0 });
  const auto surface =
    std::make_shared<const Surface>(points, std::vector<Triangle>{ { 0, 1, 2 } });
  const auto accelerator = build(surface);

  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double direction[3] = { 0.0, 0.0, 1.0 };
  RayBatch rays;
  rays.size = 1;
  rays.origins = ArrayView(origin);
  rays.directions = ArrayView(direction);
  Hit hit;
  accelerator->closest(rays, &hit);

  std::cout << "hit primitive " << hit.primitive << " at t = " << hit.t << '\n';
  return hit.primitive == 0 && hit.t == 2.0 ? 0 : 1;
}
