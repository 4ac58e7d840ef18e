// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Frame_h
#define Lumitree_Radiometry_Frame_h

#include "Accel/Vec3.h"

namespace lumitree
{

/// Three unit vectors at right angles, right-handed.
struct Frame
{
  Vec3 x, y, z;

  [[nodiscard]] Vec3 toWorld(const Vec3& local) const
  {
    return local[0] * this->x + local[1] * this->y + local[2] * this->z;
  }

  [[nodiscard]] Vec3 toLocal(const Vec3& world) const
  {
    return { dot(this->x, world), dot(this->y, world), dot(this->z, world) };
  }

  /// With that unit vector as z. (Duff et al., "Building an orthonormal basis, revisited", JCGT 6,
  /// 2017.)
  static Frame around(const Vec3& z)
  {
    const double sign = std::copysign(1.0, z[2]);
    const double a = -1.0 / (sign + z[2]);
    const double b = z[0] * z[1] * a;
    return { { 1.0 + sign * z[0] * z[0] * a, sign * b, -sign * z[0] },
      { b, sign + z[1] * z[1] * a, -z[1] }, z };
  }
};

} // namespace lumitree

#endif
