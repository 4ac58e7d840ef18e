// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/PieceLight.h"

#include "Radiometry/Constants.h"
#include "Radiometry/LambertPolygon.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

Vec3 unit(const Vec3& a)
{
  const double size = length(a);
  return size > 0.0 ? (1.0 / size) * a : Vec3{ 0.0, 0.0, 0.0 };
}

/// ∫ (up·ω) ω dω.
Vec3 risingVector(const ConePiece& piece, double winding, const Vec3& up)
{
  Vec3 sum =
    (winding * polygonSolidAngle(piece.corners, static_cast<std::size_t>(piece.count))) * up;
  Vec3 u = unit(piece.corners[piece.count - 1]);
  for (int i = 0; i < piece.count; ++i)
  {
    const Vec3 v = unit(piece.corners[i]);
    const double whole = 1.0 + dot(u, v);
    if (whole > 0.0)
    {
      sum = sum + (dot(up, u + v) / whole) * cross(u, v);
    }
    u = v;
  }
  return (winding / 3.0) * sum;
}

/// ∫ sinθ dω (power 0) or ∫ cosθ sinθ dω (power 1) over the half of a piece above (sign 1) or below
/// (−1) the equator, θ from the axis: along each edge, ∮ F(θ) dφ with F = ∫ sin²θ (cosθ) dθ from
/// the near pole.
double sineIntegral(
  const std::vector<Vec3>& corners, double winding, const Vec3& axis, double sign, int power)
{
  constexpr double nodes[4] = { 0.18343464249564980494, 0.52553240991632898582,
    0.79666647741362673959, 0.96028985649753623168 };
  constexpr double weights[4] = { 0.36268378337836198297, 0.31370664587788728734,
    0.22238103445337447054, 0.10122853629037625915 };
  const auto density = [&](const Vec3& direction)
  {
    const double cosine = std::clamp(sign * dot(axis, direction), -1.0, 1.0);
    const double squared = std::max(0.0, 1.0 - cosine * cosine);
    const double sine = std::sqrt(squared);
    if (power == 1)
    {
      return sine / 3.0; // sin³θ / 3 over sin²θ
    }
    const double angle = std::atan2(sine, cosine);
    // (θ − sinθ cosθ) / (2 sin²θ), which cancels at the pole.
    return sine < 1e-3 ? angle / 3.0 : 0.5 * (angle - sine * cosine) / squared;
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vec3 u = unit(corners[i]);
    const Vec3 v = unit(corners[i + 1 == corners.size() ? 0 : i + 1]);
    const Vec3 normal = cross(u, v);
    const double sine = length(normal);
    if (!(sine > 0.0))
    {
      continue;
    }
    const double angle = std::atan2(sine, dot(u, v));
    const Vec3 gamma = (1.0 / sine) * normal;
    const Vec3 w = cross(gamma, u);
    const double turning = sign * dot(axis, gamma);
    const int steps = 1 + static_cast<int>(angle / 0.15);
    const double half = 0.5 * angle / steps;
    for (int step = 0; step < steps; ++step)
    {
      const double middle = (2 * step + 1) * half;
      for (int k = 0; k < 4; ++k)
      {
        for (const double s : { middle - half * nodes[k], middle + half * nodes[k] })
        {
          sum += half * weights[k] * turning * density(std::cos(s) * u + std::sin(s) * w);
        }
      }
    }
  }
  // Below the equator the axis is turned round, and with it the sense of φ: dφ' = −dφ; the boundary
  // is walked in the same sense, so that the sign comes out of `turning` alone.
  return winding * sum;
}

double cylindrical(
  const ConePiece& piece, double winding, const PieceRadiance& radiance, const Vec3& axis)
{
  double sum = 0.0;
  std::vector<Vec3> half;
  for (const double sign : { 1.0, -1.0 })
  {
    clipPolygon(piece.corners, static_cast<std::size_t>(piece.count), sign * axis, half);
    if (half.size() < 3)
    {
      continue;
    }
    sum += radiance.constant * sineIntegral(half, winding, axis, sign, 0);
    if (radiance.rising != 0.0)
    {
      sum += radiance.rising * dot(radiance.up, axis) * sign *
        sineIntegral(half, winding, axis, sign, 1);
    }
  }
  return sum / pi;
}

void addPiece(const ConePiece& piece, double winding, const PieceRadiance& radiance,
  const View& view, Amounts& sum)
{
  const auto count = static_cast<std::size_t>(piece.count);
  Vec3 vector = { 0.0, 0.0, 0.0 };
  if (radiance.constant != 0.0)
  {
    vector = (winding * radiance.constant) * windingLightVector(piece.corners, count);
  }
  if (radiance.rising != 0.0)
  {
    vector = vector + radiance.rising * risingVector(piece, winding, radiance.up);
  }
  if (view.sided)
  {
    sum.main += dot(view.normal, vector);
    return;
  }
  if (view.vector)
  {
    sum.vector = sum.vector + vector;
  }
  sum.main += radiance.constant * polygonSolidAngle(piece.corners, count);
  if (radiance.rising != 0.0)
  {
    sum.main +=
      radiance.rising * winding * dot(radiance.up, windingLightVector(piece.corners, count));
  }
  if (view.cylindrical)
  {
    sum.cylindrical += cylindrical(piece, winding, radiance, view.axis);
  }
}

} // namespace

void addPieces(const std::vector<ConePiece>& pieces, double winding, const PieceRadiance& radiance,
  const View& view, Amounts& sum)
{
  for (const ConePiece& piece : pieces)
  {
    if (!view.sided)
    {
      addPiece(piece, winding, radiance, view, sum);
      continue;
    }
    bool above = false;
    bool below = false;
    for (int i = 0; i < piece.count; ++i)
    {
      const double height = dot(view.normal, piece.corners[i]);
      above = above || height > 0.0;
      below = below || height < 0.0;
    }
    if (above && !below)
    {
      addPiece(piece, winding, radiance, view, sum);
    }
    else if (above && piece.count < ConePiece::capacity)
    {
      ConePiece in, out;
      splitPiece(piece, view.normal, in, out);
      addPiece(in, winding, radiance, view, sum);
    }
  }
}

} // namespace lumitree
