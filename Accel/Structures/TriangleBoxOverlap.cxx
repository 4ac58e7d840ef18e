// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/TriangleBoxOverlap.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{
namespace
{

/// Edges, offsets and products each carry at most two roundings of 2^-53, sums of three products
/// three more: errors stay below ten of them, relative to the magnitudes added up.
constexpr double relativeError = 0x1p-49;
/// What underflow can take from a scaled edge or a normal, with much to spare; the error of a
/// product with a coordinate then is relativeError * tiny * coordinate. So large that this is no
/// subnormal number, which processors are slow to calculate: edges along an axis have components
/// of 0.
constexpr double tiny = 0x1p-900;
/// What underflow can take from the last products, and more; no subnormal number either.
constexpr double smallest = 0x1p-1020;

} // namespace

TriangleBoxOverlap::TriangleBoxOverlap(const std::array<Vec3, 3>& corners)
  : corners_(corners)
{
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    this->bounds_.extend(corners[i]);
    this->edges_[i] = corners[(i + 1) % 3] - corners[i];
    for (const double component : this->edges_[i])
    {
      largest = std::max(largest, std::fabs(component));
    }
  }
  if (largest > 0.0)
  {
    const int exponent = -std::ilogb(largest);
    for (Vec3& edge : this->edges_)
    {
      for (double& component : edge)
      {
        component = std::scalbn(component, exponent);
      }
    }
  }
  const Vec3& a = this->edges_[0];
  const Vec3& b = this->edges_[1];
  for (int k = 0; k < 3; ++k)
  {
    const int y = (k + 1) % 3;
    const int z = (k + 2) % 3;
    this->normal_[k] = a[y] * b[z] - a[z] * b[y];
    this->normalReach_[k] = std::fabs(a[y] * b[z]) + std::fabs(a[z] * b[y]) + tiny;
  }
}

bool TriangleBoxOverlap::mayMeet(const Box& box) const
{
  for (int k = 0; k < 3; ++k)
  {
    if (this->bounds_.upper[k] < box.lower[k] || this->bounds_.lower[k] > box.upper[k])
    {
      return false;
    }
  }
  // Seen from any point near the centre, as long as half reaches both sides.
  const Vec3 centre = box.centre();
  Vec3 half;
  Vec3 reach;
  std::array<Vec3, 3> seen;
  for (int k = 0; k < 3; ++k)
  {
    half[k] = std::max(box.upper[k] - centre[k], centre[k] - box.lower[k]);
    reach[k] = half[k];
    for (int i = 0; i < 3; ++i)
    {
      seen[i][k] = this->corners_[i][k] - centre[k];
      reach[k] = std::max(reach[k], std::fabs(seen[i][k]));
    }
    reach[k] += half[k];
  }

  // Every comparison is false with NaN (from overflow), which keeps the box.
  double distance = 0.0;
  double radius = smallest;
  for (int k = 0; k < 3; ++k)
  {
    distance += this->normal_[k] * seen[0][k];
    radius +=
      std::fabs(this->normal_[k]) * half[k] + relativeError * this->normalReach_[k] * reach[k];
  }
  if (std::fabs(distance) > radius)
  {
    return false;
  }

  for (const Vec3& edge : this->edges_)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int y = (k + 1) % 3;
      const int z = (k + 2) % 3;
      const double ey = std::fabs(edge[y]);
      const double ez = std::fabs(edge[z]);
      const double spread = ey * half[z] + ez * half[y] +
        relativeError * ((ey + tiny) * reach[z] + (ez + tiny) * reach[y]) + smallest;
      double low = edge[y] * seen[0][z] - edge[z] * seen[0][y];
      double high = low;
      for (int i = 1; i < 3; ++i)
      {
        const double p = edge[y] * seen[i][z] - edge[z] * seen[i][y];
        low = p < low ? p : low;
        high = p > high ? p : high;
      }
      if (low > spread || high < -spread)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace lumitree
