// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_NearDegenerate_h
#define Lumitree_Testing_Accel_NearDegenerate_h

#include "TestHelpers.h"

namespace lumitree::testing
{

/// A ray and a triangle.
struct Pair
{
  Ray ray;
  std::array<Vec3, 3> triangle;
};

/// Makes pairs that are hard to decide: full mantissas, rays through (or an ulp beside) vertices
/// and edges, slivers, triangles seen edge-on, magnitudes far apart.
class NearDegenerate
{
public:
  static constexpr int kinds = 8;

  explicit NearDegenerate(unsigned seed)
    : uniform_(seed)
  {
  }

  /// A pair of the kind 0 … kinds - 1, coordinates about scale.
  Pair operator()(int kind, double scale)
  {
    Pair p;
    for (Vec3& v : p.triangle)
    {
      v = this->point(scale);
    }
    auto& [a, b, c] = p.triangle;
    p.ray.origin = this->point(scale);
    p.ray.direction = this->point(1.0);
    switch (kind)
    {
      case 0: // anything
        break;
      case 1: // at a vertex
        p.ray.direction = a - p.ray.origin;
        break;
      case 2: // at an edge's midpoint
        p.ray.direction = (a + b) - 2.0 * p.ray.origin;
        break;
      case 3: // beside a vertex by an ulp
        p.ray.direction = a - p.ray.origin;
        this->nudge(p.ray.direction);
        break;
      case 4: // a sliver, at its inside
        c = 0.5 * (a + b);
        this->nudge(c);
        p.ray.direction = 0.25 * (a + b + c + c) - p.ray.origin;
        break;
      case 5: // from a point of the plane, nearly in the plane
        p.ray.origin = a + 0.3 * (b - a);
        p.ray.direction = (c - a) + 0x1p-50 * this->point(scale);
        break;
      case 6: // far away and small
        for (Vec3& v : p.triangle)
        {
          v = 0x1p-30 * v + Vec3{ scale, -scale, scale };
        }
        p.ray.direction = b - p.ray.origin;
        break;
      default: // along an edge
        p.ray.origin = 2.0 * a - b;
        p.ray.direction = b - a;
        break;
    }
    return p;
  }

  Vec3 point(double scale)
  {
    Vec3 p;
    for (double& x : p)
    {
      // 53 random bits: the two draws do not overlap.
      x = scale * (this->uniform_(-1, 1) + 0x1p-32 * this->uniform_(-1, 1));
    }
    return p;
  }

private:
  void nudge(Vec3& p)
  {
    double& x = p[this->uniform_.index(3)];
    x = std::nextafter(x, this->uniform_.index(2) == 0 ? HUGE_VAL : -HUGE_VAL);
  }

  Uniform uniform_;
};

} // namespace lumitree::testing

#endif
