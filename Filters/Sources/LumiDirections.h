// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiDirections_h
#define LumiDirections_h

#include "Accel/Vec3.h"

#include <array>
#include <cstdint>

namespace lumitree::filters
{

/// (cos, sin) of 2 pi turns, within a few ulp. Own polynomials, because the mathematics library
/// chooses its code by the processor and would give other bits on another machine.
std::array<double, 2> unitCircle(double turns);

/// Maps the unit square to the sphere, uniform to uniform (Archimedes).
Vec3 sphereDirection(double u, double v);

/// Direction i of count, evenly spread over the sphere: a spiral whose turns keep to the golden
/// ratio. Source: Keinert et al., "Spherical Fibonacci mapping", ACM TOG 34(6), 2015, equation 2.
Vec3 spiralDirection(std::uint64_t i, std::uint64_t count);

/// Two unit vectors that make a right-handed orthonormal basis with the unit vector n.
/// Source: Duff et al., "Building an orthonormal basis, revisited", JCGT 6(1), 2017, listing 3.
std::array<Vec3, 2> tangents(const Vec3& n);

/// Maps (0, 1) x (0, 1) to the directions above the plane with unit normal n; strictly above.
///@{
Vec3 cosineDirection(const Vec3& n, double u, double v);  ///< density cos / pi
Vec3 uniformDirection(const Vec3& n, double u, double v); ///< density 1 / (2 pi)
///@}

/// v / |v|, or zero when that is not defined: zero, too small, or not finite.
Vec3 unit(const Vec3& v);

inline bool isZero(const Vec3& v)
{
  return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
}

}

#endif
