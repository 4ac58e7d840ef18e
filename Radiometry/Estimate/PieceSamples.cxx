// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/PieceSamples.h"

#include "Radiometry/Constants.h"
#include "Radiometry/LambertPolygon.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

Vec3 unit(const Vec3& v)
{
  const double size = length(v);
  return size > 0.0 ? (1.0 / size) * v : v;
}

/// Angle between the planes of two great circles with those normals.
double angleBetween(const Vec3& a, const Vec3& b)
{
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// Whether 1 / r² varies by less than three over the corners and what is between them.
bool isFar(const ConePiece& piece)
{
  constexpr double nearest = 4.0; // distances to the middle over the radius
  Vec3 middle = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < piece.count; ++i)
  {
    middle = middle + (1.0 / piece.count) * piece.corners[i];
  }
  double radius = 0.0;
  for (int i = 0; i < piece.count; ++i)
  {
    const Vec3 off = piece.corners[i] - middle;
    radius = std::max(radius, dot(off, off));
  }
  return nearest * nearest * radius < dot(middle, middle);
}

bool isParallelogram(const ConePiece& piece)
{
  if (piece.count != 4)
  {
    return false;
  }
  const Vec3* const c = piece.corners;
  const Vec3 off = (c[0] - c[1]) + (c[2] - c[3]);
  const Vec3 diagonal = c[2] - c[0];
  return dot(off, off) <= 1e-24 * dot(diagonal, diagonal);
}

} // namespace

PieceSamples::PieceSamples(const std::vector<ConePiece>& pieces, double radiance)
  : radiance_(radiance)
{
  for (const ConePiece& piece : pieces)
  {
    const bool far = isFar(piece);
    if (far && isParallelogram(piece))
    {
      this->add(Shape::Parallelogram, piece.corners[0], piece.corners[1], piece.corners[3],
        polygonSolidAngle(piece.corners, 4));
      continue;
    }
    for (int i = 2; i < piece.count; ++i)
    {
      const Vec3 corners[3] = { piece.corners[0], piece.corners[i - 1], piece.corners[i] };
      this->add(far ? Shape::Far : Shape::Near, corners[0], corners[1], corners[2],
        polygonSolidAngle(corners, 3));
    }
  }
  double from = 0.0;
  for (Part& part : this->parts_)
  {
    const double share = part.perShare / this->solidAngle_; // it holds the solid angle until here
    part.from = from;
    part.perShare = 1.0 / share;
    // By area the density over the solid angle is r³ / (area · way), and a share of that.
    part.weight =
      (part.shape == Shape::Parallelogram ? 1.0 : 0.5) * std::fabs(part.height) * part.perShare;
    from += share;
  }
}

void PieceSamples::add(Shape shape, const Vec3& a, const Vec3& b, const Vec3& c, double solidAngle)
{
  if (!(solidAngle > 0.0))
  {
    return;
  }
  // Outside of these the sphere's triangle has no digits left.
  constexpr double smallest = 3e-4;
  constexpr double largest = 6.22;
  Part part{};
  part.shape = shape;
  if (shape == Shape::Near && !(solidAngle > smallest && solidAngle < largest))
  {
    part.shape = Shape::Far;
  }
  part.corners = { a, b, c };
  part.area = cross(b - a, c - a);
  part.height = dot(part.area, a);
  part.perShare = solidAngle;
  if (part.shape == Shape::Near)
  {
    part.a = unit(a);
    part.b = unit(b);
    const Vec3 third = unit(c);
    const Vec3 ab = unit(cross(part.a, part.b));
    const Vec3 bc = unit(cross(part.b, third));
    const Vec3 ca = unit(cross(third, part.a));
    part.alpha = angleBetween(ab, -1.0 * ca);
    part.cosineAlpha = std::cos(part.alpha);
    part.sineAlpha = std::sin(part.alpha);
    part.excess = part.alpha + angleBetween(bc, -1.0 * ab) + angleBetween(ca, -1.0 * bc) - pi;
    part.cosineAB = dot(part.a, part.b);
    part.acrossA = unit(third - dot(third, part.a) * part.a);
  }
  this->solidAngle_ += solidAngle;
  this->parts_.push_back(part);
}

void PieceSamples::draw(
  const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    SourceSample& sample = samples[i];
    sample = {};
    std::size_t k = 0;
    while (k + 1 < this->parts_.size() && points[i][0] >= this->parts_[k + 1].from)
    {
      ++k;
    }
    if (k == this->parts_.size())
    {
      continue; // no pieces
    }
    const Part& part = this->parts_[k];
    const double u = std::min(1.0, (points[i][0] - part.from) * part.perShare);
    if (part.shape == Shape::Near)
    {
      sample.weight = this->solidAngle_;
      drawNear(part, u, points[i][1], sample);
    }
    else
    {
      drawFar(part, u, points[i][1], sample);
    }
    sample.radiance = this->radiance_;
  }
}

void PieceSamples::drawNear(const Part& part, double u, double v, SourceSample& sample)
{
  // The sub-triangle (a, b, c') of the area u × whole; then a point between b and c'.
  const double angle = u * part.excess - part.alpha;
  const double s = std::sin(angle);
  const double t = std::cos(angle);
  const double p = t - part.cosineAlpha;
  const double q = s + part.sineAlpha * part.cosineAB;
  const double above = (q * t - p * s) * part.cosineAlpha - q;
  const double below = (q * s + p * t) * part.sineAlpha;
  const double x = below == 0.0 ? 1.0 : std::clamp(above / below, -1.0, 1.0);
  const Vec3 edge = x * part.a + std::sqrt((1.0 - x) * (1.0 + x)) * part.acrossA;
  const double along = dot(edge, part.b);
  const double z = 1.0 - v * (1.0 - along);
  const Vec3 direction =
    z * part.b + std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z))) * unit(edge - along * part.b);
  const double distance = part.height / dot(part.area, direction);
  if (distance > 0.0 && std::isfinite(distance))
  {
    sample.sightline.direction = distance * direction;
  }
  else
  {
    drawFar(part, u, v, sample);
  }
}

void PieceSamples::drawFar(const Part& part, double u, double v, SourceSample& sample)
{
  const auto& [a, b, c] = part.corners;
  Vec3 way;
  if (part.shape == Shape::Parallelogram)
  {
    way = a + u * (b - a) + v * (c - a);
  }
  else
  {
    const double root = std::sqrt(u);
    way = (1.0 - root) * a + (root * (1.0 - v)) * b + (root * v) * c;
  }
  const double squared = dot(way, way);
  sample.sightline.direction = way;
  sample.weight = squared > 0.0 ? part.weight / (squared * std::sqrt(squared)) : 0.0;
}

} // namespace lumitree
