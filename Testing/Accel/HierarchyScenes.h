// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_HierarchyScenes_h
#define Lumitree_Testing_Accel_HierarchyScenes_h

#include "TestHelpers.h"

#include <gtest/gtest.h>

/// What the tests of nodes, cells and counters are made with.
namespace lumitree::testing
{

inline const std::vector<std::shared_ptr<const Surface>>& surfaces()
{
  static const std::vector<std::shared_ptr<const Surface>> all = {
    surfaceOf<float>(data::teapot(5)),
    surfaceOf<double>(data::teapotInStadium(3), { 5e5, 4.6e6, 100 }),
    surfaceOf<float>(data::randomCloud(1000, 2, 0.3)),
    surfaceOf<float>(data::terrain(8, 1, 0.0)),
    surfaceOf<float>(std::vector<std::array<Vec3, 3>>{}),
  };
  return all;
}

template <class Check>
void forEverything(const Check& check)
{
  for (std::size_t i = 0; i < surfaces().size(); ++i)
  {
    for (const auto& accelerator : accelerators(surfaces()[i]))
    {
      SCOPED_TRACE("surface " + std::to_string(i) + ", " + label(accelerator->options()));
      check(*accelerator);
    }
  }
}

} // namespace lumitree::testing

#endif
