// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/HiddenLine.h"

#include <algorithm>

namespace lumitree
{

namespace
{

/// A point of the plane of eye and segment: begin × a + end × b.
struct Place
{
  double a, b;
};

/// The part of p … q where the values, linear between the two, are not negative; false: none.
bool clip(Place& p, Place& q, double atP, double atQ)
{
  if (atP < 0.0 && atQ < 0.0)
  {
    return false;
  }
  const auto between = [&]
  {
    const double share = atP / (atP - atQ);
    return Place{ (1.0 - share) * p.a + share * q.a, (1.0 - share) * p.b + share * q.b };
  };
  if (atP < 0.0)
  {
    p = between();
  }
  else if (atQ < 0.0)
  {
    q = between();
  }
  return true;
}

} // namespace

const std::vector<HiddenLine::Part>& HiddenLine::seen(const Vec3& toBegin, const Vec3& toEnd,
  const std::vector<std::array<Vec3, 3>>& triangles, double clearance)
{
  this->hidden_.clear();
  this->seen_.clear();
  const Vec3 normal = cross(toBegin, toEnd);
  const double squared = dot(normal, normal);
  const double size = length(toEnd - toBegin);
  if (squared > 0.0 && size > 0.0)
  {
    const Vec3 dualBegin = (1.0 / squared) * cross(toEnd, normal);
    const Vec3 dualEnd = (1.0 / squared) * cross(normal, toBegin);
    const double height = std::sqrt(squared) / size; // of the eye over the segment's line
    const double front = 1.0 - clearance / height;
    for (const std::array<Vec3, 3>& triangle : triangles)
    {
      const double h[3] = { dot(normal, triangle[0]), dot(normal, triangle[1]),
        dot(normal, triangle[2]) };
      Place ends[3];
      int count = 0;
      for (int i = 0; i < 3; ++i)
      {
        const int j = (i + 1) % 3;
        // A corner on the plane belongs to the upper side.
        if ((h[i] >= 0.0) != (h[j] >= 0.0))
        {
          const double share = h[i] / (h[i] - h[j]);
          const Vec3 point = (1.0 - share) * triangle[i] + share * triangle[j];
          ends[count++] = { dot(dualBegin, point), dot(dualEnd, point) };
        }
      }
      if (count < 2)
      {
        continue;
      }
      Place& p = ends[0];
      Place& q = ends[1];
      if (!clip(p, q, p.a, q.a) || !clip(p, q, p.b, q.b) ||
        !clip(p, q, front - p.a - p.b, front - q.a - q.b))
      {
        continue;
      }
      const auto project = [](const Place& x)
      { return x.a + x.b > 0.0 ? std::clamp(x.b / (x.a + x.b), 0.0, 1.0) : 0.0; };
      const double s = project(p);
      const double t = project(q);
      this->hidden_.push_back({ std::min(s, t), std::max(s, t) });
    }
  }
  std::sort(this->hidden_.begin(), this->hidden_.end(),
    [](const Part& x, const Part& y) { return x.from < y.from; });
  double reached = 0.0;
  for (const Part& part : this->hidden_)
  {
    if (part.from > reached)
    {
      this->seen_.push_back({ reached, part.from });
    }
    reached = std::max(reached, part.to);
  }
  if (reached < 1.0)
  {
    this->seen_.push_back({ reached, 1.0 });
  }
  return this->seen_;
}

} // namespace lumitree
