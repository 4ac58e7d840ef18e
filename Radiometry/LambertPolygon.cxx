// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/LambertPolygon.h"

#include "Radiometry/Constants.h"

#include <algorithm>

namespace lumitree
{

namespace
{

/// Twice the area times the normal by winding, from the first corner.
Vec3 doubleArea(const Vec3* corners, std::size_t count)
{
  Vec3 area = { 0.0, 0.0, 0.0 };
  Vec3 previous = corners[1] - corners[0];
  for (std::size_t i = 2; i < count; ++i)
  {
    const Vec3 next = corners[i] - corners[0];
    area = area + cross(previous, next);
    previous = next;
  }
  return area;
}

/// Whether the polygon is so small or far that Lambert's sum would cancel.
bool looksSmall(const Vec3* corners, std::size_t count)
{
  constexpr double limit = 1.0 / 200.0;
  double size = 0.0;
  double distance = dot(corners[0], corners[0]);
  for (std::size_t i = 1; i < count; ++i)
  {
    const Vec3 way = corners[i] - corners[0];
    size = std::max(size, dot(way, way));
    distance = std::min(distance, dot(corners[i], corners[i]));
  }
  return size < limit * limit * distance;
}

/// Sums f(x, weight) over the polygon, weight the share of twice its area vector: Radon's rule of
/// seven points, degree five, on each triangle of a fan.
template <class F>
void integrate(const Vec3* corners, std::size_t count, F&& f)
{
  constexpr double near1 = 0.47014206410511508977;
  constexpr double far1 = 0.10128650732345633880;
  constexpr double centreWeight = 0.225;
  constexpr double nearWeight = 0.13239415278850618074;
  constexpr double farWeight = 0.12593918054482715260;
  const Vec3& a = corners[0];
  for (std::size_t i = 2; i < count; ++i)
  {
    const Vec3& b = corners[i - 1];
    const Vec3& c = corners[i];
    const Vec3 area = cross(b - a, c - a);
    const auto at = [&](double u, double v, double w, double weight)
    { f(u * a + v * b + w * c, weight * area); };
    at(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, centreWeight);
    at(near1, near1, 1.0 - 2.0 * near1, nearWeight);
    at(near1, 1.0 - 2.0 * near1, near1, nearWeight);
    at(1.0 - 2.0 * near1, near1, near1, nearWeight);
    at(far1, far1, 1.0 - 2.0 * far1, farWeight);
    at(far1, 1.0 - 2.0 * far1, far1, farWeight);
    at(1.0 - 2.0 * far1, far1, far1, farWeight);
  }
}

/// On which side of the polygon's plane the receiver is: 1 where the normal by winding points away
/// from it, 0 within rounding of the plane.
int side(const Vec3* corners, std::size_t count)
{
  const Vec3 area = doubleArea(corners, count);
  double height = 0.0;
  double reach = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    height = std::max(height, std::fabs(dot(area, corners[i])));
    reach = std::max(reach, length(corners[i]));
  }
  if (!(height > 0x1p-50 * length(area) * reach))
  {
    return 0;
  }
  return dot(area, corners[0] + corners[1] + corners[2]) > 0.0 ? 1 : -1;
}

} // namespace

Vec3 windingLightVector(const Vec3* corners, std::size_t count)
{
  Vec3 sum = { 0.0, 0.0, 0.0 };
  if (count < 3)
  {
    return sum;
  }
  if (looksSmall(corners, count))
  {
    integrate(corners, count,
      [&](const Vec3& x, const Vec3& area)
      {
        const double squared = dot(x, x);
        sum = sum + (0.5 * dot(area, x) / squared / squared) * x;
      });
    return sum;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3& a = corners[i];
    const Vec3& b = corners[i + 1 == count ? 0 : i + 1];
    const Vec3 normal = cross(a, b);
    const double sine = length(normal);
    if (sine > 0.0)
    {
      sum = sum + (0.5 * std::atan2(sine, dot(a, b)) / sine) * normal;
    }
  }
  return sum;
}

Vec3 polygonLightVector(const Vec3* corners, std::size_t count)
{
  if (count < 3)
  {
    return { 0.0, 0.0, 0.0 };
  }
  return static_cast<double>(side(corners, count)) * windingLightVector(corners, count);
}

void clipPolygon(
  const Vec3* corners, std::size_t count, const Vec3& normal, std::vector<Vec3>& result)
{
  result.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3& a = corners[i];
    const Vec3& b = corners[i + 1 == count ? 0 : i + 1];
    const double heightA = dot(normal, a);
    const double heightB = dot(normal, b);
    if (heightA >= 0.0)
    {
      result.push_back(a);
    }
    if ((heightA > 0.0 && heightB < 0.0) || (heightA < 0.0 && heightB > 0.0))
    {
      const double share = heightA / (heightA - heightB);
      result.push_back((1.0 - share) * a + share * b);
    }
  }
}

double polygonIrradiance(const Vec3* corners, std::size_t count, const Vec3& normal)
{
  bool above = false;
  bool below = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double height = dot(normal, corners[i]);
    above = above || height > 0.0;
    below = below || height < 0.0;
  }
  if (!above || count < 3)
  {
    return 0.0;
  }
  if (!below)
  {
    return std::max(0.0, dot(normal, polygonLightVector(corners, count)));
  }
  std::vector<Vec3> clipped;
  clipPolygon(corners, count, normal, clipped);
  if (clipped.size() < 3)
  {
    return 0.0;
  }
  // The side of the whole polygon's plane: that of a sliver left above the horizon would be lost.
  return std::max(
    0.0, side(corners, count) * dot(normal, windingLightVector(clipped.data(), clipped.size())));
}

double polygonSolidAngle(const Vec3* corners, std::size_t count)
{
  if (count < 3 || side(corners, count) == 0)
  {
    return 0.0;
  }
  double sum = 0.0;
  if (looksSmall(corners, count))
  {
    integrate(corners, count,
      [&](const Vec3& x, const Vec3& area)
      {
        const double squared = dot(x, x);
        sum += 0.5 * dot(area, x) / squared / std::sqrt(squared);
      });
    return std::fabs(sum);
  }
  // Van Oosterom & Strackee (1983), eq. 8, on a fan.
  const auto unit = [&](const Vec3& p)
  {
    const double size = length(p);
    return size > 0.0 ? (1.0 / size) * p : Vec3{ 0.0, 0.0, 0.0 };
  };
  const Vec3 first = unit(corners[0]);
  Vec3 previous = unit(corners[1]);
  for (std::size_t i = 2; i < count; ++i)
  {
    const Vec3 next = unit(corners[i]);
    const double determinant = dot(first, cross(previous, next));
    if (determinant != 0.0)
    {
      sum += 2.0 *
        std::atan2(
          determinant, 1.0 + dot(first, previous) + dot(previous, next) + dot(next, first));
    }
    previous = next;
  }
  return std::min(std::fabs(sum), 2.0 * pi);
}

} // namespace lumitree
