// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Integration/Outline.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Integration/GaussLegendre.h"

#include <algorithm>
#include <array>

namespace lumitree
{

namespace
{

/// ∫ (A + B cosφ + C sinφ) / (p + q cosφ + s sinφ) dφ over an arc.
double integrateArc(
  const Vec3& centre, const Vec3& u, const Vec3& v, const Vec3& normal, double from, double to)
{
  const double squared = dot(u, u);
  const double a = dot(normal, cross(u, v));
  const double b = dot(normal, cross(centre, v));
  const double c = -dot(normal, cross(centre, u));
  const double p = dot(centre, centre) + squared;
  const double q = 2.0 * dot(centre, u);
  const double s = 2.0 * dot(centre, v);
  const double m = std::hypot(q, s);
  if (m < 0.5 * p)
  {
    // Far from the circle, or near its axis: smooth, and the closed form would cancel.
    const int parts = 1 + static_cast<int>(std::fabs(to - from) / (0.5 * pi));
    const double step = (to - from) / parts;
    double sum = 0.0;
    for (int i = 0; i < parts; ++i)
    {
      sum += integrate<16>(from + i * step, from + (i + 1) * step,
        [&](double phi)
        {
          const double x = std::cos(phi);
          const double y = std::sin(phi);
          return (a + b * x + c * y) / (p + q * x + s * y);
        });
    }
    return sum;
  }
  // ψ = φ − φ₀ − π: the denominator is p − m cosψ. p² − m² is the product of the squares of the
  // smallest and the largest distance from the circle.
  const double phase = std::atan2(s, q);
  const double turned = -(b * std::cos(phase) + c * std::sin(phase));
  const double across = b * std::sin(phase) - c * std::cos(phase);
  const Vec3 axis = (1.0 / squared) * cross(u, v);
  const double height = dot(axis, centre);
  const double radius = std::sqrt(squared);
  const double foot = m / (2.0 * radius);
  const double nearest = height * height + (foot - radius) * (foot - radius);
  const double farthest = height * height + (foot + radius) * (foot + radius);
  const auto halfAngles = [&](double psi)
  {
    const double turns = std::floor((psi + pi) / (2.0 * pi));
    const double half = 0.5 * (psi - 2.0 * pi * turns);
    return std::atan2(std::sqrt(farthest) * std::sin(half), std::sqrt(nearest) * std::cos(half)) +
      turns * pi;
  };
  const auto denominator = [&](double psi)
  {
    const double half = std::sin(0.5 * psi);
    return nearest + 2.0 * m * half * half;
  };
  const double begin = from - phase - pi;
  const double end = to - phase - pi;
  const double root = std::sqrt(nearest * farthest);
  if (!(root > 0.0))
  {
    return 0.0; // on the circle itself
  }
  const double plain = 2.0 / root * (halfAngles(end) - halfAngles(begin));
  return a * plain + turned / m * (p * plain - (end - begin)) +
    across / m * std::log(denominator(end) / denominator(begin));
}

} // namespace

void Outline::enter(const Vec3& point, bool onHorizon)
{
  if (!this->begun_)
  {
    this->begun_ = true;
    this->cameFromHorizon_ = onHorizon;
    this->firstEntry_ = point;
  }
  else if (this->isBelow_)
  {
    this->sum_ += this->alongHorizon(this->lastExit_, point);
  }
  this->isBelow_ = false;
}

void Outline::leave(const Vec3& point, bool onHorizon)
{
  this->isBelow_ = onHorizon;
  this->lastExit_ = point;
}

double Outline::alongHorizon(const Vec3& from, const Vec3& to) const
{
  return std::atan2(dot(this->normal_, cross(from, to)), dot(from, to));
}

void Outline::segment(const Vec3& from, const Vec3& to)
{
  const double a = dot(this->normal_, from);
  const double b = dot(this->normal_, to);
  if (this->cuts_ && a < 0.0 && b < 0.0)
  {
    return;
  }
  const Vec3 way = to - from;
  const bool cutFrom = this->cuts_ && a < 0.0;
  const bool cutTo = this->cuts_ && b < 0.0;
  const Vec3 crossing = cutFrom || cutTo ? from + (a / (a - b)) * way : from;
  const Vec3 begin = cutFrom ? crossing : from;
  const Vec3 end = cutTo ? crossing : to;
  this->enter(begin, cutFrom);
  const Vec3 product = cross(begin, way);
  const double size = length(product);
  if (size > 0.0)
  {
    const double angle = std::atan2(length(cross(begin, end)), dot(begin, end));
    this->sum_ += angle * dot(this->normal_, product) / size;
  }
  this->leave(end, cutTo);
}

void Outline::arc(const Vec3& centre, const Vec3& u, const Vec3& v, double from, double to)
{
  const auto at = [&](double phi) { return centre + std::cos(phi) * u + std::sin(phi) * v; };
  std::array<double, 18> marks = { from, to }; // 6 at most; smaller ones confuse gcc 12
  std::size_t count = 2;
  if (this->cuts_)
  {
    const double x = dot(this->normal_, u);
    const double y = dot(this->normal_, v);
    const double size = std::hypot(x, y);
    const double sought = -dot(this->normal_, centre);
    if (std::fabs(sought) < size)
    {
      const double middle = std::atan2(y, x);
      const double half = std::acos(sought / size);
      for (const double root : { middle - half, middle + half })
      {
        const double low = std::min(from, to);
        const double high = std::max(from, to);
        double phi = root + 2.0 * pi * std::ceil((low - root) / (2.0 * pi));
        for (; phi < high && count < marks.size(); phi += 2.0 * pi)
        {
          if (phi > low)
          {
            marks[count++] = phi;
          }
        }
      }
    }
  }
  std::sort(marks.begin(), marks.begin() + static_cast<std::ptrdiff_t>(count));
  if (from > to)
  {
    std::reverse(marks.begin(), marks.begin() + static_cast<std::ptrdiff_t>(count));
  }
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    const double middle = 0.5 * (marks[i] + marks[i + 1]);
    if (this->cuts_ && dot(this->normal_, at(middle)) < 0.0)
    {
      continue;
    }
    this->enter(at(marks[i]), this->cuts_ && (i > 0 || dot(this->normal_, at(from)) < 0.0));
    this->sum_ += integrateArc(centre, u, v, this->normal_, marks[i], marks[i + 1]);
    this->leave(at(marks[i + 1]), i + 2 < count);
  }
}

double Outline::integral() const
{
  const double closing = this->isBelow_ || (this->begun_ && this->cameFromHorizon_)
    ? this->alongHorizon(this->lastExit_, this->firstEntry_)
    : 0.0;
  return 0.5 * (this->sum_ + closing);
}

} // namespace lumitree
