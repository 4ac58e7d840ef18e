// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/PolygonEstimator.h"

#include "Radiometry/Estimate/PieceSamples.h"
#include "Radiometry/Frame.h"
#include "Radiometry/LambertPolygon.h"
#include "Radiometry/PolygonTriangles.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// The hull of points in a plane with that normal, counter-clockwise around it (Andrew 1979).
std::vector<Vec3> convexHull(std::vector<Vec3> points, const Vec3& normal)
{
  const Frame frame = Frame::around(normal);
  const auto turn = [&](const Vec3& a, const Vec3& b, const Vec3& c)
  { return dot(normal, cross(b - a, c - a)); };
  std::sort(points.begin(), points.end(),
    [&](const Vec3& a, const Vec3& b)
    {
      const Vec3 p = frame.toLocal(a);
      const Vec3 q = frame.toLocal(b);
      return p[0] < q[0] || (p[0] == q[0] && p[1] < q[1]);
    });
  std::vector<Vec3> hull;
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::size_t start = hull.size();
    for (const Vec3& p : points)
    {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

bool isConvex(const std::vector<Vec3>& corners, const Vec3& normal)
{
  const std::size_t n = corners.size();
  double turned = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vec3 in = corners[(i + 1) % n] - corners[i];
    const Vec3 out = corners[(i + 2) % n] - corners[(i + 1) % n];
    const double sine = dot(normal, cross(in, out));
    if (sine < 0.0)
    {
      return false;
    }
    turned += std::atan2(sine, dot(in, out));
  }
  return turned < 7.0; // once around, not twice
}

ConePiece seenFrom(const Vec3& eye, const std::vector<Vec3>& corners)
{
  ConePiece piece;
  for (const Vec3& corner : corners)
  {
    piece.corners[piece.count++] = corner - eye;
  }
  return piece;
}

} // namespace

PolygonEstimator::PolygonEstimator(const Source& source, const EstimateScene& scene)
  : SourceEstimatorBase(source, scene)
{
  constexpr std::size_t mostCorners = 8;
  for (const EmittingPolygon& given : *source.polygons())
  {
    if (!(given.radiance > 0.0) || !(length(polygonAreaVector(given.corners)) > 0.0))
    {
      continue;
    }
    Polygon polygon;
    polygon.normal = given.normal;
    polygon.radiance = given.radiance;
    polygon.twoSided = given.twoSided;
    if (isConvex(given.corners, given.normal) && given.corners.size() <= mostCorners)
    {
      polygon.parts.push_back(given.corners);
      polygon.hull = given.corners;
    }
    else
    {
      for (const auto& t : triangulatePolygon(given.corners))
      {
        polygon.parts.push_back({ given.corners[t[0]], given.corners[t[1]], given.corners[t[2]] });
      }
      polygon.hull = convexHull(given.corners, given.normal);
    }
    if (scene.shadowRays)
    {
      for (const Vec3& corner : given.corners)
      {
        polygon.clearance = std::max(polygon.clearance, scene.shadowRays->clearance(corner));
      }
    }
    this->polygons_.push_back(std::move(polygon));
  }
}

Estimate PolygonEstimator::estimate(
  const View& view, double tolerance, EstimateWorkspace& workspace) const
{
  Estimate sum;
  const double share =
    this->polygons_.empty() ? 0.0 : tolerance / static_cast<double>(this->polygons_.size());
  for (const Polygon& polygon : this->polygons_)
  {
    sum.add(this->estimate(polygon, view, share, workspace));
  }
  return sum;
}

bool PolygonEstimator::findCones(const Polygon& polygon, double side, double height,
  std::size_t mostClipped, const View& view, EstimateWorkspace& workspace) const
{
  LightFront front;
  front.hull = polygon.hull.data();
  front.count = polygon.hull.size();
  front.side = -side;
  front.towards = side * polygon.normal;
  front.height = height;
  front.clearance = polygon.clearance;
  front.mostClipped = mostClipped;
  return SourceEstimatorBase::findCones(front, view, workspace);
}

void PolygonEstimator::look(
  const Polygon& polygon, const Vec3& position, const View& view, std::vector<ConePiece>& pieces)
{
  pieces.clear();
  for (const std::vector<Vec3>& part : polygon.parts)
  {
    ConePiece piece = seenFrom(position, part);
    if (view.sided)
    {
      ConePiece in, out;
      splitPiece(piece, view.normal, in, out);
      piece = in;
    }
    if (piece.count >= 3)
    {
      pieces.push_back(piece);
    }
  }
}

Estimate PolygonEstimator::estimate(
  const Polygon& polygon, const View& view, double tolerance, EstimateWorkspace& workspace) const
{
  Estimate result;
  const double above = dot(polygon.normal, view.position - polygon.hull[0]);
  if (!(above > 0.0) && !(polygon.twoSided && above < 0.0))
  {
    return result;
  }
  const double side = above > 0.0 ? 1.0 : -1.0;
  // From the front the corners turn left: seen from the eye, their winding is negative.
  const double winding = -side;
  look(polygon, view.position, view, workspace.pieces);
  const PieceRadiance radiance{ polygon.radiance, 0.0, {} };
  addPieces(workspace.pieces, winding, radiance, view, result.value);
  result.value.main = std::max(0.0, result.value.main);
  result.unoccluded = result.value.main;
  result.lower = result.unoccluded;
  result.upper = result.unoccluded;
  if (!(result.unoccluded > 0.0))
  {
    return result;
  }
  result.method = EstimateMethod::ClosedForm;
  if (!this->scene_.occluders)
  {
    return result;
  }

  // What hides is cut out of the light as the eye sees it; the shares that are left are those of
  // the position.
  look(polygon, view.eye, view, workspace.pieces);
  Amounts certain;
  Amounts open = result.value;
  const std::size_t mostClipped = this->scene_.mostClipped(tolerance, result.unoccluded);
  if (this->findCones(polygon, side, std::fabs(above), mostClipped, view, workspace))
  {
    if (workspace.cones.empty())
    {
      return result;
    }
    Amounts seen;
    addPieces(workspace.pieces, winding, radiance, view, seen);
    const double scale = seen.main > 0.0 ? result.unoccluded / seen.main : 0.0;
    const std::size_t budget = 2000 + 60 * workspace.cones.size();
    workspace.subtraction.run(workspace.pieces, workspace.cones, budget, workspace.cut);
    Amounts visible;
    addPieces(workspace.cut.visible, winding, radiance, view, visible);
    certain.add(visible, scale);
    certain.main = std::clamp(certain.main, 0.0, result.unoccluded);
    Amounts undecided;
    addPieces(workspace.cut.undecided, winding, radiance, view, undecided);
    open = {};
    open.add(undecided, scale);
    open.main = std::clamp(open.main, 0.0, result.unoccluded - certain.main);
    workspace.pieces = workspace.cut.undecided;
    result.value = certain;
    result.lower = certain.main;
    result.upper = certain.main + open.main;
    result.method = EstimateMethod::Clipping;
    const double allowed = std::max(
      tolerance, this->scene_.options.relativeTolerance * (certain.main + 0.5 * open.main));
    if (0.5 * open.main <= allowed)
    {
      if (open.main > 0.0)
      {
        result.value.add(open, 0.5);
        result.method = EstimateMethod::Bounds;
      }
      return result;
    }
  }
  sample(view, certain, open, tolerance,
    std::make_shared<const PieceSamples>(workspace.pieces, polygon.radiance), workspace, result);
  return result;
}

} // namespace lumitree
