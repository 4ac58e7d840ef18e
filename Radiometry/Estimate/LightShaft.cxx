// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/SourceEstimator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lumitree
{

namespace
{

/// A triangle, or what is left of it on this side of a light's plane.
struct CutTriangle
{
  int count = 0;
  Vec3 corners[4];
};

/// The square of the distance of the origin from a triangle (Ericson, Real-Time Collision
/// Detection, section 5.1.5).
double distanceSquared(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const auto toSegment = [](const Vec3& p, const Vec3& q)
  {
    const Vec3 way = q - p;
    const double squared = dot(way, way);
    const double t = squared > 0.0 ? std::clamp(-dot(p, way) / squared, 0.0, 1.0) : 0.0;
    const Vec3 nearest = p + t * way;
    return dot(nearest, nearest);
  };
  double least = std::min({ toSegment(a, b), toSegment(b, c), toSegment(c, a) });
  const Vec3 area = cross(b - a, c - a);
  const double squared = dot(area, area);
  if (squared > 0.0)
  {
    const Vec3 foot = (dot(area, a) / squared) * area;
    const bool inside = dot(area, cross(b - a, foot - a)) >= 0.0 &&
      dot(area, cross(c - b, foot - b)) >= 0.0 && dot(area, cross(a - c, foot - c)) >= 0.0;
    least = inside ? std::min(least, dot(foot, foot)) : least;
  }
  return least;
}

enum class AtBall
{
  Apart,
  Within,
  Reaches ///< from within to without
};

AtBall atBall(const std::array<Vec3, 3>& vertices, const LightFront& front)
{
  const Vec3 a = vertices[0] - *front.ballCentre;
  const Vec3 b = vertices[1] - *front.ballCentre;
  const Vec3 c = vertices[2] - *front.ballCentre;
  const double outer = front.ballRadius + front.clearance;
  if (std::max({ length(a), length(b), length(c) }) <= outer)
  {
    return AtBall::Within;
  }
  const double inner = std::max(0.0, front.ballRadius - front.clearance);
  return distanceSquared(a, b, c) >= inner * inner ? AtBall::Apart : AtBall::Reaches;
}

} // namespace

bool SourceEstimatorBase::findCones(
  const LightFront& front, const View& view, EstimateWorkspace& workspace) const
{
  ConvexRegion& region = workspace.region;
  region.clear();
  Vec3 previous = front.hull[front.count - 1] - view.eye;
  for (std::size_t i = 0; i < front.count; ++i)
  {
    const Vec3 next = front.hull[i] - view.eye;
    const Vec3 outward = -front.side * cross(previous, next);
    region.push_back({ outward, dot(outward, view.eye) });
    previous = next;
  }
  if (!front.endless)
  {
    const double plane = dot(front.towards, front.hull[0]);
    region.push_back({ -1.0 * front.towards, -plane - front.clearance });
    region.push_back({ front.towards, plane + front.height });
  }
  if (view.sided)
  {
    region.push_back({ -1.0 * view.normal, -dot(view.normal, view.eye) });
  }
  if (!this->find(view, front.mostClipped, workspace))
  {
    return false;
  }

  workspace.cones.clear();
  const Surface& surface = this->scene_.occluders->surface();
  for (const PrimitiveId id : workspace.found)
  {
    const std::array<Vec3, 3> vertices = surface.vertices(id);
    if (front.ballCentre)
    {
      const AtBall where = atBall(vertices, front);
      if (where == AtBall::Reaches)
      {
        return false;
      }
      if (where == AtBall::Within)
      {
        continue;
      }
    }
    CutTriangle cut;
    double heights[3] = { 1.0, 1.0, 1.0 };
    for (int k = 0; k < 3 && !front.endless; ++k)
    {
      heights[k] = dot(front.towards, vertices[k] - front.hull[0]) - front.clearance;
    }
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const double a = heights[k];
      const double b = heights[next];
      if (a >= 0.0)
      {
        cut.corners[cut.count++] = vertices[k] - view.eye;
      }
      if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0))
      {
        const double share = a / (a - b);
        cut.corners[cut.count++] =
          (1.0 - share) * (vertices[k] - view.eye) + share * (vertices[next] - view.eye);
      }
    }
    OccluderCone cone;
    if (cut.count >= 3 && cone.assign(cut.corners, cut.count, view.clearance))
    {
      workspace.cones.push_back(cone);
    }
  }
  return true;
}

} // namespace lumitree
