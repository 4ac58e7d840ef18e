// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_Amounts_h
#define Lumitree_Radiometry_Estimate_Amounts_h

#include "Accel/Hit.h"
#include "Accel/Vec3.h"

#include <cstddef>
#include <cstdint>

namespace lumitree
{

/// What is asked of a place: irradiance on one side of a surface, or the light in free space.
struct View
{
  Vec3 position = { 0.0, 0.0, 0.0 };
  Vec3 eye = { 0.0, 0.0, 0.0 };    ///< from where things hide: off the surface by its clearance
  Vec3 normal = { 0.0, 0.0, 0.0 }; ///< unit; of sided views
  bool sided = true;
  bool vector = false;      ///< the light vector, too; of views in free space
  bool cylindrical = false; ///< and cylindrical irradiance
  Vec3 axis = { 0.0, 0.0, 1.0 };
  double clearance = 0.0;            ///< what is nearer than that does not hide
  std::uint64_t seed = 0;            ///< of whatever is random
  const PrimitiveId* skip = nullptr; ///< primitives that do not hide, ascending
  std::size_t skipCount = 0;
};

/// Of a sided view: main is the irradiance. Of one in free space: the scalar irradiance; the others
/// where asked for.
struct Amounts
{
  double main = 0.0;
  double cylindrical = 0.0;
  Vec3 vector = { 0.0, 0.0, 0.0 };

  void add(const Amounts& other, double share = 1.0)
  {
    this->main += share * other.main;
    this->cylindrical += share * other.cylindrical;
    this->vector = this->vector + share * other.vector;
  }
};

} // namespace lumitree

#endif
