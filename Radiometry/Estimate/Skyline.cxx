// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/Skyline.h"

#include "Radiometry/Constants.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace lumitree
{

namespace
{

/// Numbers of points by their place: meshes whose polygons do not share points are common.
std::vector<std::uint32_t> weld(const Surface& surface)
{
  std::vector<std::uint32_t> order(surface.pointCount());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
    [&](std::uint32_t i, std::uint32_t j) { return surface.point(i) < surface.point(j); });
  std::vector<std::uint32_t> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const bool same = k > 0 && surface.point(order[k]) == surface.point(order[k - 1]);
    number[order[k]] = same ? number[order[k - 1]] : order[k];
  }
  return number;
}

/// Whether two triangles at an edge continue each other in one plane: no eye sees an outline there.
bool flat(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Vec3 one = cross(b - a, c - a);
  const Vec3 two = cross(d - a, b - a);
  const double sizes = length(one) * length(two);
  const Vec3 fold = cross(one, two);
  return dot(one, two) > 0.0 && length(fold) <= 1e-10 * sizes;
}

double tangent(const std::array<double, 2>& slope, double cosine, double sine)
{
  return slope[0] * cosine + slope[1] * sine;
}

} // namespace

Vec3 Skyline::toFrame(const Vec3& p) const
{
  return { dot(this->axes_[0], p), dot(this->axes_[1], p), dot(this->axes_[2], p) };
}

Skyline::Skyline(const Surface& surface, const Vec3& up)
{
  // With up = z the frame is the coordinates' own, without rounding.
  const Vec3 aside = std::fabs(up[2]) > 0.5 ? Vec3{ 1.0, 0.0, 0.0 } : Vec3{ 0.0, 0.0, 1.0 };
  const Vec3 x = aside - dot(aside, up) * up;
  this->axes_[0] = (1.0 / length(x)) * x;
  this->axes_[1] = cross(up, this->axes_[0]);
  this->axes_[2] = up;
  // Bodies have outlines that are no edges.
  if (surface.hittable().size() > 4 * mostEdges || surface.bodyCount() > 0)
  {
    this->edges_.resize(mostEdges + 1);
    return;
  }
  const std::vector<std::uint32_t> number = weld(surface);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite;
  for (const PrimitiveId id : surface.hittable())
  {
    const Triangle& t = surface.triangle(id);
    for (int k = 0; k < 3; ++k)
    {
      const auto ends = std::minmax(number[t[k]], number[t[(k + 1) % 3]]);
      opposite[ends].push_back(number[t[(k + 2) % 3]]);
    }
  }
  for (const auto& [ends, corners] : opposite)
  {
    const Vec3 a = this->toFrame(surface.point(ends.first));
    const Vec3 b = this->toFrame(surface.point(ends.second));
    if (a[0] == b[0] && a[1] == b[1])
    {
      continue; // upright: it has no width
    }
    if (corners.size() == 2 &&
      flat(
        a, b, this->toFrame(surface.point(corners[0])), this->toFrame(surface.point(corners[1]))))
    {
      continue;
    }
    this->edges_.push_back(
      { a, b, std::max(a[2], b[2]), static_cast<std::uint32_t>(this->opposite_.size()),
        static_cast<std::uint32_t>(corners.size()) });
    for (const std::uint32_t corner : corners)
    {
      this->opposite_.push_back(this->toFrame(surface.point(corner)));
    }
  }
  std::stable_sort(this->edges_.begin(), this->edges_.end(),
    [](const Edge& one, const Edge& two) { return one.top > two.top; });
}

void Skyline::addOutline(
  const Vec3& a, const Vec3& b, const Vec3& normal, std::vector<Outline>& outlines)
{
  // normal · x = 0 is the plane through eye and edge.
  const std::array<double, 2> slope = { -normal[0] / normal[2], -normal[1] / normal[2] };
  double from = std::atan2(a[1], a[0]);
  double to = std::atan2(b[1], b[0]);
  if (normal[2] < 0.0)
  {
    std::swap(from, to); // the plan view turns clockwise from a to b
  }
  if (from <= to)
  {
    outlines.push_back({ from, to, slope });
  }
  else
  {
    outlines.push_back({ from, pi, slope });
    outlines.push_back({ -pi, to, slope });
  }
}

bool Skyline::collect(const Vec3& eye, double slack, std::vector<Outline>& outlines) const
{
  outlines.clear();
  for (const Edge& edge : this->edges_)
  {
    if (edge.top <= eye[2] + slack)
    {
      break;
    }
    Vec3 a = edge.a - eye;
    Vec3 b = edge.b - eye;
    const Vec3 normal = cross(a, b);
    const double size = length(normal);
    // Upright planes have no width; neither has an edge that ends in the eye.
    if (std::fabs(normal[2]) <= 1e-14 * size)
    {
      continue;
    }
    bool above = false;
    bool below = false;
    for (std::uint32_t k = 0; k < edge.oppositeCount; ++k)
    {
      const Vec3 c = this->opposite_[edge.firstOpposite + k] - eye;
      const double height = (normal[2] > 0.0 ? 1.0 : -1.0) * dot(normal, c);
      const double rounding = 1e-13 * size * length(c);
      above = above || height > rounding;
      below = below || height < -rounding;
    }
    if (above == below)
    {
      continue; // triangles on both sides, or all seen edge on
    }
    for (int k = 0; k < 2; ++k)
    {
      Vec3& low = k == 0 ? a : b;
      const Vec3& high = k == 0 ? b : a;
      if (low[2] < 0.0)
      {
        const double share = low[2] / (low[2] - high[2]);
        low = (1.0 - share) * low + share * high;
        low[2] = 0.0;
      }
    }
    if (above)
    {
      return false;
    }
    addOutline(a, b, normal, outlines);
  }
  return true;
}

/// The greater of both at every azimuth.
void Skyline::mergeTwo(const Envelope& one, const Envelope& two, Envelope& result)
{
  result.clear();
  const auto push = [&](double azimuth, const std::array<double, 2>& slope)
  {
    if (result.empty() || result.back().slope != slope)
    {
      result.push_back({ azimuth, slope });
    }
  };
  std::size_t i = 0;
  std::size_t j = 0;
  double from = -pi;
  while (from < pi)
  {
    const double endOne = i + 1 < one.size() ? one[i + 1].azimuth : pi;
    const double endTwo = j + 1 < two.size() ? two[j + 1].azimuth : pi;
    const double to = std::min(endOne, endTwo);
    const std::array<double, 2>& s = one[i].slope;
    const std::array<double, 2>& t = two[j].slope;
    const std::array<double, 2> difference = { s[0] - t[0], s[1] - t[1] };
    if (to > from)
    {
      if (difference[0] == 0.0 && difference[1] == 0.0)
      {
        push(from, s);
      }
      else
      {
        // The difference is 0 at two opposite azimuths; parts may be wider than half a turn.
        const double zero = std::atan2(-difference[0], difference[1]);
        double cut[4] = { from, from, from, to };
        int cuts = 1;
        for (const double crossing : { zero - pi, zero, zero + pi })
        {
          if (crossing > from && crossing < to)
          {
            cut[cuts++] = crossing;
          }
        }
        cut[cuts] = to;
        for (int k = 0; k < cuts; ++k)
        {
          const double middle = 0.5 * (cut[k] + cut[k + 1]);
          push(cut[k], tangent(difference, std::cos(middle), std::sin(middle)) > 0.0 ? s : t);
        }
      }
    }
    from = to;
    i += endOne <= to && i + 1 < one.size() ? 1 : 0;
    j += endTwo <= to && j + 1 < two.size() ? 1 : 0;
  }
}

void Skyline::merge(
  Scratch& scratch, std::size_t first, std::size_t last, Envelope& result, int depth)
{
  if (last - first <= 1)
  {
    // The horizon, and the one outline above it.
    constexpr std::array<double, 2> horizon = { 0.0, 0.0 };
    result.clear();
    if (first == last || scratch.outlines[first].from > -pi)
    {
      result.push_back({ -pi, horizon });
    }
    if (first != last)
    {
      const Outline& outline = scratch.outlines[first];
      result.push_back({ outline.from, outline.slope });
      if (outline.to < pi)
      {
        result.push_back({ outline.to, horizon });
      }
    }
    return;
  }
  const auto level = static_cast<std::size_t>(depth) * 2;
  if (scratch.envelopes.size() < level + 2)
  {
    scratch.envelopes.resize(level + 2);
  }
  const std::size_t middle = first + (last - first) / 2;
  Envelope one = std::move(scratch.envelopes[level]);
  Envelope two = std::move(scratch.envelopes[level + 1]);
  merge(scratch, first, middle, one, depth + 1);
  merge(scratch, middle, last, two, depth + 1);
  mergeTwo(one, two, result);
  scratch.envelopes[level] = std::move(one);
  scratch.envelopes[level + 1] = std::move(two);
}

bool Skyline::visible(
  const Vec3& eye, double slack, Scratch& scratch, std::vector<ConePiece>& pieces) const
{
  pieces.clear();
  if (!this->collect(this->toFrame(eye), slack, scratch.outlines))
  {
    return false;
  }
  // Neighbours first: their envelopes have few steps.
  std::sort(scratch.outlines.begin(), scratch.outlines.end(),
    [](const Outline& one, const Outline& two) { return one.from < two.from; });
  Envelope& envelope = scratch.whole;
  merge(scratch, 0, scratch.outlines.size(), envelope, 0);
  for (std::size_t i = 0; i < envelope.size(); ++i)
  {
    const double from = envelope[i].azimuth;
    const double to = i + 1 < envelope.size() ? envelope[i + 1].azimuth : pi;
    const int parts = 1 + static_cast<int>((to - from) / (0.5 * pi));
    const auto at = [&](int k)
    {
      const double azimuth = from + (to - from) * k / parts;
      const double c = std::cos(azimuth);
      const double s = std::sin(azimuth);
      const double z = std::max(0.0, tangent(envelope[i].slope, c, s));
      return c * this->axes_[0] + s * this->axes_[1] + z * this->axes_[2];
    };
    for (int k = 0; k < parts; ++k)
    {
      ConePiece piece;
      piece.count = 3;
      piece.corners[0] = at(k);
      piece.corners[1] = at(k + 1);
      piece.corners[2] = this->axes_[2];
      pieces.push_back(piece);
    }
  }
  return true;
}

} // namespace lumitree
