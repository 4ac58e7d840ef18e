// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/SeenDisk.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Integration/GaussLegendre.h"
#include "Radiometry/SolidAngle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lumitree
{

namespace
{

constexpr int sides = 8;

/// Counterclockwise from one angle to another, 0 … 2π.
double spanBetween(double from, double to)
{
  double span = std::fmod(to - from, 2.0 * pi);
  return span < 0.0 ? span + 2.0 * pi : span;
}

/// Where the boundary of a piece enters and leaves the circle, in order.
struct Events
{
  struct Event
  {
    double angle;
    bool leaves;
  };
  std::array<Event, 2 * ConePiece::capacity> list;
  int count = 0;

  void add(double angle, bool leaves) { this->list[this->count++] = { angle, leaves }; }

  /// What lies between an event and the next. Together they go around once: where rounding turned
  /// nothing into a whole turn, the widest is nothing.
  [[nodiscard]] std::array<double, 2 * ConePiece::capacity> spans() const
  {
    std::array<double, 2 * ConePiece::capacity> result = {};
    double sum = 0.0;
    for (int i = 0; i < this->count; ++i)
    {
      result[i] =
        spanBetween(this->list[i].angle, this->list[i + 1 == this->count ? 0 : i + 1].angle);
      sum += result[i];
    }
    for (; sum > 3.0 * pi; sum -= 2.0 * pi)
    {
      *std::max_element(result.begin(), result.begin() + this->count) = 0.0;
    }
    return result;
  }
};

} // namespace

SeenDisk::SeenDisk(const Vec3& centre, const Vec3& u, const Vec3& v)
  : centre_(centre)
  , u_(u)
  , v_(v)
  , volume_(dot(cross(u, v), centre))
{
  this->toA_ = (1.0 / this->volume_) * cross(v, centre);
  this->toB_ = (1.0 / this->volume_) * cross(centre, u);
  this->toK_ = (1.0 / this->volume_) * cross(u, v);
  const double distance = length(centre);
  const double radius = length(u);
  this->circular_ = std::hypot(dot(centre, u), dot(centre, v)) <= 0x1p-50 * distance * radius;
  this->small_ = radius < 1e-5 * distance;
}

Vec3 SeenDisk::at(double a, double b) const
{
  return this->centre_ + a * this->u_ + b * this->v_;
}

void SeenDisk::circumscribe(const View& view, std::vector<ConePiece>& pieces) const
{
  const double reach = (1.0 + 0x1p-40) / std::cos(pi / sides);
  ConePiece piece;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * pi * i / sides;
    piece.corners[piece.count++] = this->at(reach * std::cos(angle), reach * std::sin(angle));
  }
  pieces.clear();
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

bool SeenDisk::contains(const Vec3& direction) const
{
  const double k = dot(this->toK_, direction);
  return k > 0.0 && std::hypot(dot(this->toA_, direction), dot(this->toB_, direction)) <= k;
}

void SeenDisk::addLight(const std::vector<ConePiece>& pieces, const View& view, Amounts& sum) const
{
  for (const ConePiece& piece : pieces)
  {
    this->addPiece(piece, view, sum);
  }
}

void SeenDisk::addPiece(const ConePiece& piece, const View& view, Amounts& sum) const
{
  std::array<Point, ConePiece::capacity> corners;
  double turns = 0.0;
  for (int i = 0; i < piece.count; ++i)
  {
    const double k = dot(this->toK_, piece.corners[i]);
    corners[i] = { dot(this->toA_, piece.corners[i]) / k, dot(this->toB_, piece.corners[i]) / k };
  }
  const auto after = [&](int i) { return i + 1 == piece.count ? 0 : i + 1; };
  for (int i = 0; i < piece.count; ++i)
  {
    turns += corners[i].a * corners[after(i)].b - corners[after(i)].a * corners[i].b;
  }
  if (turns < 0.0)
  {
    std::reverse(corners.begin(), corners.begin() + piece.count);
  }
  Events events;
  bool met = false;
  bool around = true; // the middle of the circle is in the piece
  for (int i = 0; i < piece.count; ++i)
  {
    const Point& p = corners[i];
    const Point& q = corners[after(i)];
    const Point way = { q.a - p.a, q.b - p.b };
    around = around && p.a * way.b - p.b * way.a >= 0.0;
    const double squared = way.a * way.a + way.b * way.b;
    const double half = p.a * way.a + p.b * way.b;
    const double outside = p.a * p.a + p.b * p.b - 1.0;
    const double root = half * half - squared * outside;
    if (!(squared > 0.0) || !(root > 0.0))
    {
      continue;
    }
    // Both roots without cancellation.
    const double large = half > 0.0 ? -half - std::sqrt(root) : -half + std::sqrt(root);
    double enters = large / squared;
    double leaves = large != 0.0 ? outside / large : 0.0;
    if (enters > leaves)
    {
      std::swap(enters, leaves);
    }
    const double begin = std::max(0.0, enters);
    const double end = std::min(1.0, leaves);
    if (!(begin < end))
    {
      continue;
    }
    met = true;
    const auto point = [&](double t) { return Point{ p.a + t * way.a, p.b + t * way.b }; };
    const Point first = point(begin);
    const Point last = end == 1.0 ? q : point(end);
    this->addSegment(first, last, view, sum);
    if (enters > 0.0)
    {
      events.add(std::atan2(first.b, first.a), false);
    }
    if (leaves < 1.0)
    {
      events.add(std::atan2(last.b, last.a), true);
    }
  }
  if (!met)
  {
    if (around)
    {
      this->addArc(0.0, 2.0 * pi, view, sum);
    }
    return;
  }
  const auto spans = events.spans();
  for (int i = 0; i < events.count; ++i)
  {
    if (events.list[i].leaves)
    {
      this->addArc(events.list[i].angle, spans[i], view, sum);
    }
  }
}

void SeenDisk::addSegment(const Point& from, const Point& to, const View& view, Amounts& sum) const
{
  if (this->small_)
  {
    const double turn = from.a * to.b - from.b * to.a;
    this->addSmall(
      0.5 * turn, turn * (from.a + to.a) / 6.0, turn * (from.b + to.b) / 6.0, view, sum);
    return;
  }
  const Vec3 p = this->at(from.a, from.b);
  const Vec3 q = this->at(to.a, to.b);
  const Vec3 normal = cross(p, q);
  const double size = length(normal);
  const Vec3 edge =
    size > 0.0 ? (0.5 * std::atan2(size, dot(p, q)) / size) * normal : Vec3{ 0.0, 0.0, 0.0 };
  if (view.sided)
  {
    sum.main += dot(view.normal, edge);
    return;
  }
  sum.main += solidAngle({ 0.0, 0.0, 0.0 }, this->centre_, p, q);
  sum.vector = sum.vector + edge;
}

void SeenDisk::addArc(double from, double span, const View& view, Amounts& sum) const
{
  const double to = from + span;
  if (this->small_)
  {
    this->addSmall(0.5 * span, (std::sin(to) - std::sin(from)) / 3.0,
      (std::cos(from) - std::cos(to)) / 3.0, view, sum);
    return;
  }
  const Vec3 normal = cross(this->u_, this->v_);
  const auto ray = [&](double angle) { return this->at(std::cos(angle), std::sin(angle)); };
  // r × r' = centre × ρ' + u × v, with r = centre + ρ.
  const auto turning = [&](double angle) {
    return cross(this->centre_, std::cos(angle) * this->v_ - std::sin(angle) * this->u_) + normal;
  };
  const double distance = length(this->centre_);
  if (this->circular_)
  {
    const Vec3 rim = ray(from);
    const double squared = dot(rim, rim);
    const Vec3 across =
      (std::cos(to) - std::cos(from)) * this->u_ + (std::sin(to) - std::sin(from)) * this->v_;
    const Vec3 edge = (0.5 / squared) * (cross(this->centre_, across) + span * normal);
    if (view.sided)
    {
      sum.main += dot(view.normal, edge);
      return;
    }
    const double far = std::sqrt(squared);
    sum.main += span * this->volume_ / (far * distance * (far + distance));
    sum.vector = sum.vector + edge;
    return;
  }
  const auto along = [&](const auto& f)
  {
    // The integrand is of the order of 1; where the light is near its plane it has a peak.
    const double middle = 0.5 * (from + to);
    return integrateTo<12>(1e-15, from, middle, f) + integrateTo<12>(1e-15, middle, to, f);
  };
  const auto edge = [&](const Vec3& n)
  {
    return along(
      [&](double angle)
      {
        const Vec3 r = ray(angle);
        return 0.5 * dot(n, turning(angle)) / dot(r, r);
      });
  };
  if (view.sided)
  {
    sum.main += edge(view.normal);
    return;
  }
  sum.main += along(
    [&](double angle)
    {
      const Vec3 r = ray(angle);
      const double far = length(r);
      // ∫ t dt / |centre + t ρ|³ over the radius.
      return this->volume_ / (far * (distance * far + dot(this->centre_, r)));
    });
  if (view.vector)
  {
    sum.vector = sum.vector +
      Vec3{ edge({ 1.0, 0.0, 0.0 }), edge({ 0.0, 1.0, 0.0 }), edge({ 0.0, 0.0, 1.0 }) };
  }
}

void SeenDisk::addSmall(
  double area, double momentA, double momentB, const View& view, Amounts& sum) const
{
  const Vec3& c = this->centre_;
  const double squared = dot(c, c);
  const double density = this->volume_ / (squared * std::sqrt(squared)); // of solid angle
  const double tiltA = dot(c, this->u_) / squared;
  const double tiltB = dot(c, this->v_) / squared;
  const double moments = momentA * tiltA + momentB * tiltB;
  // ∫ ω dω: |volume| r / |r|⁴
  const Vec3 light = (density / std::sqrt(squared)) *
    ((area - 4.0 * moments) * c + momentA * this->u_ + momentB * this->v_);
  if (view.sided)
  {
    sum.main += dot(view.normal, light);
    return;
  }
  sum.main += density * (area - 3.0 * moments);
  sum.vector = sum.vector + light;
}

} // namespace lumitree
