// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/LineEstimator.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Estimate/HiddenLine.h"
#include "Radiometry/Integration/GaussLegendre.h"
#include "Radiometry/LineSource.h"
#include "Radiometry/TubeSource.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// Where the line, or the tube's surface, is nearer than this share of the size.
constexpr double touching = 1e-3;

/// Triangles around a tube that are cut out: each costs some hundred lines where its edges are.
constexpr std::size_t mostAroundTube = 24;

constexpr int nodes = 8;

} // namespace

/// The view, and what is in the way.
struct LineEstimator::Cut
{
  const View& view;
  std::vector<std::array<Vec3, 3>> triangles; ///< relative to the eye
  double clearance = 0.0;                     ///< of the light
  HiddenLine hidden;

  /// Adds the light of the seen parts of a line from `begin` along a unit axis: the integral of
  /// density(direction) over its length / distance², weighed as the view asks.
  template <class Density>
  void addLine(const Vec3& begin, const Vec3& axis, double size, const Density& density,
    double share, Amounts& sum)
  {
    const Vec3 toBegin = begin - this->view.eye;
    const auto& parts =
      this->hidden.seen(toBegin, toBegin + size * axis, this->triangles, this->clearance);
    const Vec3 from = begin - this->view.position;
    const double along = dot(from, axis);
    const Vec3 foot = from - along * axis;
    const double height = length(foot);
    if (!(height > 0.0))
    {
      return;
    }
    const Vec3 nearest = (1.0 / height) * foot;
    for (const HiddenLine::Part& part : parts)
    {
      double low = along + size * part.from;
      double high = along + size * part.to;
      if (this->view.sided && !this->aboveHorizon(foot, axis, low, high))
      {
        continue;
      }
      // z = h tanβ: dz / distance² = dβ / h.
      const double first = std::atan2(low, height);
      const double span = std::atan2(height * (high - low), height * height + low * high);
      const auto& rule = GaussLegendre<12>::rule();
      for (int i = 0; i < 12; ++i)
      {
        const double angle = first + 0.5 * span * (1.0 + rule.nodes[i]);
        const Vec3 direction = std::cos(angle) * nearest + std::sin(angle) * axis;
        const double light =
          share * 0.5 * rule.weights[i] * span / height * density(direction, std::cos(angle));
        this->addDirection(direction, light, sum);
      }
    }
  }

  [[nodiscard]] bool aboveHorizon(
    const Vec3& foot, const Vec3& axis, double& low, double& high) const
  {
    const double base = dot(this->view.normal, foot);
    const double slope = dot(this->view.normal, axis);
    const double atLow = base + slope * low;
    const double atHigh = base + slope * high;
    if (atLow <= 0.0 && atHigh <= 0.0)
    {
      return false;
    }
    if (atLow < 0.0 || atHigh < 0.0)
    {
      (atLow < 0.0 ? low : high) = -base / slope;
    }
    return low < high;
  }

  void addDirection(const Vec3& direction, double light, Amounts& sum) const
  {
    if (this->view.sided)
    {
      sum.main += light * std::max(0.0, dot(this->view.normal, direction));
      return;
    }
    sum.main += light;
    sum.vector = sum.vector + light * direction;
    if (this->view.cylindrical)
    {
      const double cosine = dot(this->view.axis, direction);
      sum.cylindrical += light * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / pi;
    }
  }
};

LineEstimator::LineEstimator(const Source& source, const EstimateScene& scene)
  : BoundedEstimator(source, scene)
  , line_(dynamic_cast<const LineSource*>(&source))
  , tube_(dynamic_cast<const TubeSource*>(&source))
{
}

bool LineEstimator::suits(const Source& source)
{
  return dynamic_cast<const LineSource*>(&source) || dynamic_cast<const TubeSource*>(&source);
}

bool LineEstimator::seenOfLine(Cut& cut, Amounts& sum) const
{
  const Vec3 way = this->line_->end() - this->line_->begin();
  const double size = length(way);
  const Vec3 axis = (1.0 / size) * way;
  const Vec3 from = this->line_->begin() - cut.view.position;
  const double height = length(cross(from, axis));
  const double beyond = std::max(0.0, std::fabs(dot(from, axis) + 0.5 * size) - 0.5 * size);
  if (!(height > touching * std::max(touching * size, beyond)))
  {
    return false;
  }
  const bool even = this->line_->distribution() == LineSource::Distribution::Isotropic;
  cut.addLine(
    this->line_->begin(), axis, size,
    [&](const Vec3&, double cosine) { return even ? 1.0 : cosine; },
    this->line_->intensityPerUnit(), sum);
  return true;
}

bool LineEstimator::seenOfTube(Cut& cut, double whole, Amounts& sum) const
{
  const Vec3& axis = this->tube_->axis();
  const double radius = this->tube_->radius();
  const Vec3 from = cut.view.position - this->tube_->begin();
  const Vec3 off = from - dot(from, axis) * axis;
  const double offset = length(off);
  if (!(offset > (1.0 + touching) * radius))
  {
    return false;
  }
  const Vec3 x = (1.0 / offset) * off;
  const Vec3 y = cross(axis, x);
  const auto part = [&](double a, double b)
  {
    Amounts result;
    const auto& rule = GaussLegendre<nodes>::rule();
    for (int i = 0; i < nodes; ++i)
    {
      const double phi = 0.5 * (a + b) + 0.5 * (b - a) * rule.nodes[i];
      const Vec3 outward = std::cos(phi) * x + std::sin(phi) * y;
      cut.addLine(
        this->tube_->begin() + radius * outward, axis, this->tube_->length(),
        [&](const Vec3& direction, double)
        { return this->tube_->tubeRadiance() * std::max(0.0, -dot(outward, direction)); },
        0.5 * (b - a) * rule.weights[i] * radius, result);
    }
    return result;
  };
  // Where an edge of what hides begins or ends the integrand has a kink, or a step: halved until
  // it does not matter, or the work would be more than that of rays.
  constexpr int deepest = 40;
  int budget = 2500;
  const double tolerance = 1e-11 * whole; // of each piece; there are tens of them
  const auto refine = [&](const auto& self, double a, double b, const Amounts& once,
                        int depth) -> void
  {
    const double middle = 0.5 * (a + b);
    const Amounts left = part(a, middle);
    const Amounts right = part(middle, b);
    budget -= 2;
    if (depth == 0 || budget < 0 || std::fabs(left.main + right.main - once.main) <= tolerance)
    {
      sum.add(left);
      sum.add(right);
      return;
    }
    self(self, a, middle, left, depth - 1);
    self(self, middle, b, right, depth - 1);
  };
  const double reach = std::acos(radius / offset);
  refine(refine, -reach, reach, part(-reach, reach), deepest);
  return budget >= 0;
}

Estimate LineEstimator::estimate(
  const View& view, double tolerance, EstimateWorkspace& workspace) const
{
  const Estimate full = this->unoccluded(view, workspace);
  if (!(full.unoccluded > 0.0) || !this->scene_.occluders)
  {
    return full;
  }
  const std::size_t most = this->scene_.mostClipped(tolerance, full.unoccluded);
  if (!this->shaft(view, this->tube_ ? std::min(most, mostAroundTube) : most, workspace))
  {
    return this->sampleAll(view, full, tolerance, workspace);
  }
  Cut cut{ view, {}, 0.0, {} };
  for (const PrimitiveId id : workspace.found)
  {
    std::array<Vec3, 3> triangle = this->scene_.occluders->surface().vertices(id);
    for (Vec3& corner : triangle)
    {
      corner = corner - view.eye;
    }
    const Vec3 area = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    if (std::fabs(dot(area, triangle[0])) > view.clearance * length(area))
    {
      cut.triangles.push_back(triangle);
    }
  }
  if (cut.triangles.empty())
  {
    return full;
  }
  cut.clearance =
    this->scene_.shadowRays->clearance(view.eye + this->source_.sightline(view.eye).direction);
  Amounts seen;
  if (!(this->line_ ? this->seenOfLine(cut, seen) : this->seenOfTube(cut, full.unoccluded, seen)))
  {
    return this->sampleAll(view, full, tolerance, workspace);
  }
  Estimate result = full;
  result.value = seen;
  result.value.main = std::clamp(seen.main, 0.0, full.unoccluded);
  result.lower = result.value.main;
  result.upper = result.value.main;
  result.method = EstimateMethod::Clipping;
  return result;
}

} // namespace lumitree
