// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/ConvexPolyhedron.h"

#include <algorithm>
#include <map>

namespace lumitree
{
namespace
{

/// Distances to the plane below this share of the largest are no distance.
constexpr double flat = 0x1p-46;

using Point = std::uint32_t;

/// Each point's distance to the plane, and its side: -1, 1, or 0 where it is on it.
void findSides(const Polyhedron& polyhedron, const Vec3& normal, double offset,
  std::vector<double>& distance, std::vector<int>& side)
{
  const std::size_t count = polyhedron.points.size();
  distance.resize(count);
  side.resize(count);
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    distance[i] = dot(normal, polyhedron.points[i]) - offset;
    largest = std::max(largest, std::fabs(distance[i]));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isFlat = std::fabs(distance[i]) <= flat * largest;
    side[i] = isFlat ? 0 : (distance[i] > 0.0 ? 1 : -1);
  }
}

bool isCut(const std::vector<int>& side)
{
  return std::count(side.begin(), side.end(), -1) > 0 &&
    std::count(side.begin(), side.end(), 1) > 0;
}

/// Where an edge crosses the plane; the same from either of its faces, with a before b.
Vec3 crossingOf(const Vec3& a, const Vec3& b, double distanceOfA, double distanceOfB)
{
  const double s = distanceOfA / (distanceOfA - distanceOfB);
  Vec3 x = a + s * (b - a);
  for (int k = 0; k < 3; ++k)
  {
    x[k] = std::clamp(x[k], std::min(a[k], b[k]), std::max(a[k], b[k]));
  }
  return x;
}

/// Cuts one polyhedron. Points are decided once each, and the point on an edge is made once for the
/// two faces that share it, so that the parts are closed.
class Cut
{
public:
  Cut(const Polyhedron& whole, const Vec3& normal, double offset)
    : whole_(whole)
    , points_(whole.points)
  {
    findSides(whole, normal, offset, this->distance_, this->side_);
  }

  [[nodiscard]] bool parts() const { return isCut(this->side_); }

  /// The part at the side -1 or 1; nothing where rounding has left it open.
  std::optional<Polyhedron> part(int kept)
  {
    std::vector<std::vector<Point>> faces;
    std::map<Point, Point> rim; // around the new face, against the other faces
    for (const std::vector<Point>& face : this->whole_.faces)
    {
      std::vector<Point> rest;
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const Point a = face[i];
        const Point b = face[(i + 1) % face.size()];
        if (this->side_[a] != -kept)
        {
          rest.push_back(a);
        }
        if (this->side_[a] * this->side_[b] < 0)
        {
          rest.push_back(this->crossing(a, b));
        }
      }
      const bool reaches = std::any_of(rest.begin(), rest.end(),
        [&](Point p) { return p < this->side_.size() && this->side_[p] == kept; });
      if (!reaches || rest.size() < 3)
      {
        continue;
      }
      for (std::size_t i = 0; i < rest.size(); ++i)
      {
        const Point a = rest[i];
        const Point b = rest[(i + 1) % rest.size()];
        if (this->isOnPlane(a) && this->isOnPlane(b))
        {
          rim[b] = a;
        }
      }
      faces.push_back(std::move(rest));
    }
    std::vector<Point> cap;
    if (!rim.empty())
    {
      Point p = rim.begin()->first;
      while (cap.size() <= rim.size() && (cap.empty() || p != cap.front()))
      {
        cap.push_back(p);
        const auto next = rim.find(p);
        if (next == rim.end())
        {
          return std::nullopt;
        }
        p = next->second;
      }
    }
    if (cap.size() != rim.size() || cap.size() < 3)
    {
      return std::nullopt;
    }
    faces.push_back(std::move(cap));
    return this->compact(std::move(faces));
  }

private:
  [[nodiscard]] bool isOnPlane(Point p) const
  {
    return p >= this->side_.size() || this->side_[p] == 0;
  }

  Point crossing(Point a, Point b)
  {
    if (a > b)
    {
      std::swap(a, b);
    }
    const auto found = this->crossings_.find({ a, b });
    if (found != this->crossings_.end())
    {
      return found->second;
    }
    const Vec3 x =
      crossingOf(this->points_[a], this->points_[b], this->distance_[a], this->distance_[b]);
    const auto made = static_cast<Point>(this->points_.size());
    this->points_.push_back(x);
    this->crossings_[{ a, b }] = made;
    return made;
  }

  /// Only the points that faces use.
  Polyhedron compact(std::vector<std::vector<Point>> faces) const
  {
    constexpr Point none = ~Point{ 0 };
    std::vector<Point> place(this->points_.size(), none);
    Polyhedron part;
    for (std::vector<Point>& face : faces)
    {
      for (Point& p : face)
      {
        if (place[p] == none)
        {
          place[p] = static_cast<Point>(part.points.size());
          part.points.push_back(this->points_[p]);
        }
        p = place[p];
      }
    }
    part.faces = std::move(faces);
    return part;
  }

  const Polyhedron& whole_;
  std::vector<Vec3> points_;
  std::vector<int> side_; ///< of the whole's points
  std::vector<double> distance_;
  std::map<std::pair<Point, Point>, Point> crossings_;
};

} // namespace

Polyhedron polyhedronOf(const Box& box)
{
  Polyhedron polyhedron;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = (corner >> k & 1) ? box.upper[k] : box.lower[k];
    }
    polyhedron.points.push_back(p);
  }
  polyhedron.faces = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  return polyhedron;
}

std::optional<std::pair<Polyhedron, Polyhedron>> cutPolyhedron(
  const Polyhedron& polyhedron, const Vec3& normal, double offset)
{
  Cut cut(polyhedron, normal, offset);
  if (!cut.parts())
  {
    return std::nullopt;
  }
  std::optional<Polyhedron> below = cut.part(-1);
  std::optional<Polyhedron> above = cut.part(1);
  if (!below || !above)
  {
    return std::nullopt;
  }
  return std::make_pair(std::move(*below), std::move(*above));
}

std::optional<std::pair<double, double>> CutAreas::operator()(
  const Polyhedron& polyhedron, const Vec3& normal, double offset)
{
  findSides(polyhedron, normal, offset, this->distance_, this->side_);
  if (!isCut(this->side_))
  {
    return std::nullopt;
  }
  return std::make_pair(this->areaOfPart(polyhedron, -1), this->areaOfPart(polyhedron, 1));
}

double CutAreas::areaOfPart(const Polyhedron& polyhedron, int kept) const
{
  double area = 0.0;
  Vec3 open = { 0.0, 0.0, 0.0 }; // the new face closes the part: all faces' vectors add up to 0
  for (const std::vector<Point>& face : polyhedron.faces)
  {
    Vec3 first;
    Vec3 last;
    Vec3 sum = { 0.0, 0.0, 0.0 };
    int count = 0;
    bool reaches = false;
    const auto add = [&](const Vec3& p)
    {
      if (count == 0)
      {
        first = p;
      }
      else
      {
        sum = sum + cross(last - first, p - first);
      }
      last = p;
      ++count;
    };
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const Point a = face[i];
      const Point b = face[i + 1 < face.size() ? i + 1 : 0];
      reaches = reaches || this->side_[a] == kept;
      if (this->side_[a] != -kept)
      {
        add(polyhedron.points[a]);
      }
      if (this->side_[a] * this->side_[b] < 0)
      {
        const auto [low, high] = std::minmax(a, b);
        add(crossingOf(polyhedron.points[low], polyhedron.points[high], this->distance_[low],
          this->distance_[high]));
      }
    }
    if (reaches)
    {
      area += 0.5 * length(sum);
      open = open + 0.5 * sum;
    }
  }
  return area + length(open);
}

double areaOf(const Polyhedron& polyhedron)
{
  double area = 0.0;
  for (const std::vector<Point>& face : polyhedron.faces)
  {
    const Vec3& a = polyhedron.points[face[0]];
    Vec3 sum = { 0.0, 0.0, 0.0 };
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
    {
      sum = sum + cross(polyhedron.points[face[i]] - a, polyhedron.points[face[i + 1]] - a);
    }
    area += 0.5 * length(sum);
  }
  return area;
}

Box boundsOf(const Polyhedron& polyhedron)
{
  Box box;
  for (const Vec3& p : polyhedron.points)
  {
    box.extend(p);
  }
  return box;
}

} // namespace lumitree
