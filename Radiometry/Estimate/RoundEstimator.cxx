// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/RoundEstimator.h"

#include "Radiometry/DiskSource.h"
#include "Radiometry/Estimate/PieceSamples.h"
#include "Radiometry/Frame.h"
#include "Radiometry/SphereSource.h"
#include "Radiometry/SunDiskSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace lumitree
{

namespace
{

/// Where the disk's plane, or the sphere's surface, is nearer than this share of the size.
constexpr double touching = 1e-3;

/// Ways to points of a round light within pieces of the plane of its disk.
class RoundSamples : public LightSamples
{
public:
  RoundSamples(PieceSamples pieces, const SeenDisk& seen, bool endless, const SphereSource* sphere,
    const Vec3& eye)
    : pieces_(std::move(pieces))
    , seen_(seen)
    , endless_(endless)
    , sphere_(sphere)
    , eye_(eye)
  {
  }

  void draw(
    const std::array<double, 2>* points, std::size_t count, SourceSample* samples) const override
  {
    this->pieces_.draw(points, count, samples);
    std::vector<SourceCrossing> crossings;
    for (std::size_t i = 0; i < count; ++i)
    {
      Sightline& way = samples[i].sightline;
      way.endless = this->endless_;
      if (!this->seen_.contains(way.direction))
      {
        samples[i].weight = 0.0;
      }
      else if (this->sphere_)
      {
        crossings.clear();
        this->sphere_->crossings(this->eye_, way.direction, crossings);
        way.direction = (crossings.empty() ? 1.0 : crossings[0].t) * way.direction;
      }
    }
  }

private:
  PieceSamples pieces_;
  SeenDisk seen_;
  bool endless_;
  const SphereSource* sphere_; ///< null: the light is in the plane, or endless
  Vec3 eye_;
};

} // namespace

bool RoundEstimator::suits(const Source& source)
{
  return dynamic_cast<const DiskSource*>(&source) || dynamic_cast<const SphereSource*>(&source) ||
    dynamic_cast<const SunDiskSource*>(&source);
}

RoundEstimator::RoundEstimator(const Source& source, const EstimateScene& scene)
  : SourceEstimatorBase(source, scene)
  , disk_(dynamic_cast<const DiskSource*>(&source))
  , sphere_(dynamic_cast<const SphereSource*>(&source))
  , sun_(dynamic_cast<const SunDiskSource*>(&source))
{
}

std::optional<SeenDisk> RoundEstimator::look(const View& view, LightFront& front) const
{
  front.side = 1.0;
  if (this->sun_)
  {
    const double angle = this->sun_->angularRadius();
    if (!(std::cos(angle) > touching))
    {
      return std::nullopt;
    }
    const Frame frame = Frame::around(this->sun_->towards());
    front.endless = true;
    return SeenDisk(frame.z, std::tan(angle) * frame.x, std::tan(angle) * frame.y);
  }
  if (this->disk_)
  {
    const Vec3 way = this->disk_->centre() - view.eye;
    const double radius = this->disk_->radius();
    const double above = -dot(this->disk_->normal(), way);
    front.towards = (above > 0.0 ? 1.0 : -1.0) * this->disk_->normal();
    front.height = std::fabs(above);
    front.clearance = this->scene_.shadowRays->clearance(this->disk_->centre());
    if (!(front.height > touching * radius))
    {
      return std::nullopt;
    }
    // Seen from its side, a frame around the way there turns left.
    const Frame frame = Frame::around(-1.0 * front.towards);
    return SeenDisk(way, radius * frame.x, radius * frame.y);
  }
  const Vec3 way = this->sphere_->centre() - view.eye;
  const double distance = length(way);
  const double radius = this->sphere_->radius();
  if (!(distance > (1.0 + touching) * radius))
  {
    return std::nullopt;
  }
  const double sine = radius / distance;
  const double squared = (1.0 - sine) * (1.0 + sine);
  const Frame frame = Frame::around((1.0 / distance) * way);
  front.towards = -1.0 * frame.z;
  front.height = distance * squared;
  front.clearance = this->scene_.shadowRays->clearance(this->sphere_->centre());
  front.ballCentre = &this->sphere_->centre();
  front.ballRadius = radius;
  const double rim = radius * std::sqrt(squared);
  return SeenDisk(front.height * frame.z, rim * frame.x, rim * frame.y);
}

Estimate RoundEstimator::estimate(
  const View& view, double tolerance, EstimateWorkspace& workspace) const
{
  const Estimate full = this->unoccluded(view, workspace);
  if (!(full.unoccluded > 0.0) || !this->scene_.occluders)
  {
    return full;
  }
  LightFront front;
  const std::optional<SeenDisk> seen = this->look(view, front);
  if (!seen)
  {
    return this->sampleAll(view, full, tolerance, workspace);
  }
  View whole = view;
  whole.sided = false;
  seen->circumscribe(whole, workspace.pieces);
  std::array<Vec3, ConePiece::capacity> hull;
  front.hull = hull.data();
  for (int i = 0; i < workspace.pieces[0].count; ++i)
  {
    hull[front.count++] = view.eye + workspace.pieces[0].corners[i];
  }
  front.mostClipped = this->scene_.mostClipped(tolerance, full.unoccluded);
  if (!this->findCones(front, view, workspace))
  {
    return this->sampleAll(view, full, tolerance, workspace);
  }
  if (workspace.cones.empty())
  {
    return full;
  }
  seen->circumscribe(view, workspace.pieces);
  Amounts all;
  seen->addLight(workspace.pieces, view, all);
  if (view.cylindrical || !(all.main > 0.0))
  {
    return this->sampleAll(view, full, tolerance, workspace);
  }
  // What hides is cut out of the light as the eye sees it; the shares that are left are those of
  // the position.
  const double scale = full.unoccluded / all.main;
  workspace.subtraction.run(
    workspace.pieces, workspace.cones, 2000 + 60 * workspace.cones.size(), workspace.cut);
  Amounts visible;
  seen->addLight(workspace.cut.visible, view, visible);
  Amounts certain;
  certain.add(visible, scale);
  certain.main = std::clamp(certain.main, 0.0, full.unoccluded);
  Amounts undecided;
  seen->addLight(workspace.cut.undecided, view, undecided);
  Amounts open;
  open.add(undecided, scale);
  open.main = std::clamp(open.main, 0.0, full.unoccluded - certain.main);
  Estimate result = full;
  result.value = certain;
  result.lower = certain.main;
  result.upper = certain.main + open.main;
  result.method = EstimateMethod::Clipping;
  const double allowed =
    std::max(tolerance, this->scene_.options.relativeTolerance * (certain.main + 0.5 * open.main));
  if (0.5 * open.main <= allowed)
  {
    if (open.main > 0.0)
    {
      result.value.add(open, 0.5);
      result.method = EstimateMethod::Bounds;
    }
    return result;
  }
  sample(view, certain, open, tolerance,
    std::make_shared<const RoundSamples>(
      PieceSamples(workspace.cut.undecided, 1.0), *seen, front.endless, this->sphere_, view.eye),
    workspace, result);
  return result;
}

} // namespace lumitree
