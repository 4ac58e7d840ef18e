// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/SkyEstimator.h"

#include "Radiometry/Constants.h"
#include "Radiometry/Frame.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// The form constant + rising × sine of the elevation, where a sky has it: two directions give the
/// numbers, and a spiral of others must agree with them to the last digits.
std::optional<PieceRadiance> linearRadiance(const SkySource& sky)
{
  const Frame frame = Frame::around(sky.up());
  const auto at = [&](double sine, double azimuth)
  {
    const double cosine = std::sqrt(1.0 - sine * sine);
    return sky.radianceFrom(
      frame.toWorld({ cosine * std::cos(azimuth), cosine * std::sin(azimuth), sine }));
  };
  PieceRadiance result;
  result.up = sky.up();
  const double zenith = at(1.0, 0.0);
  const double half = at(0.5, 0.0);
  result.rising = 2.0 * (zenith - half);
  result.constant = zenith - result.rising;
  constexpr int probes = 64;
  for (int i = 0; i < probes; ++i)
  {
    const double sine = (i + 0.5) / probes;
    const double expected = result.constant + result.rising * sine;
    if (!(std::fabs(at(sine, 2.39996 * i) - expected) <= 1e-13 * std::fabs(zenith)))
    {
      return std::nullopt;
    }
  }
  if (std::fabs(result.rising) <= 1e-14 * std::fabs(zenith))
  {
    result = { zenith, 0.0, sky.up() };
  }
  return result;
}

/// Quarters of the hemisphere around an axis (winding 1), cut by the horizon of a sided view.
void addHemisphere(const Vec3& axis, const View& view, std::vector<ConePiece>& pieces)
{
  const Frame frame = Frame::around(axis);
  const Vec3 corners[4] = { frame.x, frame.y, -1.0 * frame.x, -1.0 * frame.y };
  for (int k = 0; k < 4; ++k)
  {
    ConePiece piece;
    piece.count = 3;
    piece.corners[0] = corners[k];
    piece.corners[1] = corners[(k + 1) % 4];
    piece.corners[2] = axis;
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

} // namespace

SkyEstimator::SkyEstimator(const SkySource& sky, const EstimateScene& scene)
  : SourceEstimatorBase(sky, scene)
  , sky_(sky)
  , samples_(std::make_shared<const RadianceSkySamples>(sky))
  , radiance_(linearRadiance(sky))
{
  if (scene.occluders && scene.options.horizon && this->radiance_ && sky.groundRadiance() == 0.0 &&
    scene.occluders->surface().bodyCount() == 0)
  {
    this->skyline_.emplace(scene.occluders->surface(), sky.up());
    if (!this->skyline_->pays())
    {
      this->skyline_.reset();
    }
  }
}

bool SkyEstimator::cut(
  const View& view, double tolerance, EstimateWorkspace& workspace, Estimate& result) const
{
  // A sum of elevations and directions: cylinders along another axis have no such form.
  const bool oblique = view.cylindrical && this->radiance_ && this->radiance_->rising != 0.0 &&
    !(std::fabs(dot(view.axis, this->sky_.up())) > 1.0 - 1e-14);
  if (this->skyline_ && !oblique && (view.sided || view.skipCount == 0) &&
    this->skyline_->visible(view.eye, 2.0 * view.clearance, workspace.skyline, workspace.pieces))
  {
    result.value = {};
    addPieces(workspace.pieces, 1.0, *this->radiance_, view, result.value);
    result.method = EstimateMethod::Horizon;
    return true;
  }

  ConvexRegion& region = workspace.region;
  region.clear();
  if (this->sky_.groundRadiance() == 0.0)
  {
    region.push_back({ -1.0 * this->sky_.up(), -dot(this->sky_.up(), view.eye) });
  }
  if (view.sided)
  {
    region.push_back({ -1.0 * view.normal, -dot(view.normal, view.eye) });
  }
  const std::size_t limit = this->radiance_ && !oblique
    ? this->scene_.mostClipped(tolerance, result.unoccluded)
    : std::size_t{ 0 };
  if (!this->find(view, limit, workspace))
  {
    return false;
  }
  workspace.cones.clear();
  for (const PrimitiveId id : workspace.found)
  {
    std::array<Vec3, 3> corners = this->scene_.occluders->surface().vertices(id);
    for (Vec3& corner : corners)
    {
      corner = corner - view.eye;
    }
    OccluderCone cone;
    if (cone.assign(corners.data(), 3, view.clearance))
    {
      workspace.cones.push_back(cone);
    }
  }
  if (workspace.cones.empty())
  {
    return true;
  }
  Amounts sum;
  for (const double half : { 1.0, -1.0 })
  {
    PieceRadiance radiance = *this->radiance_;
    if (half < 0.0)
    {
      radiance = { this->sky_.groundRadiance(), 0.0, this->sky_.up() };
    }
    if (radiance.constant == 0.0 && radiance.rising == 0.0)
    {
      continue;
    }
    workspace.pieces.clear();
    addHemisphere(half * this->sky_.up(), view, workspace.pieces);
    const std::size_t budget = 2000 + 60 * workspace.cones.size();
    workspace.subtraction.run(workspace.pieces, workspace.cones, budget, workspace.cut);
    if (!workspace.cut.undecided.empty())
    {
      return false;
    }
    addPieces(workspace.cut.visible, 1.0, radiance, view, sum);
  }
  result.value = sum;
  result.method = EstimateMethod::Clipping;
  return true;
}

Estimate SkyEstimator::estimate(
  const View& view, double tolerance, EstimateWorkspace& workspace) const
{
  Estimate result = this->unoccluded(view, workspace);
  if (!(result.unoccluded > 0.0) || !this->scene_.occluders)
  {
    return result;
  }
  if (!this->cut(view, tolerance, workspace, result))
  {
    if (RadianceSkySamples::suits(this->sky_, view))
    {
      return this->sampleAll(view, result, tolerance, this->samples_, workspace);
    }
    if (CosineSkySamples::suits(this->sky_, view))
    {
      return this->sampleAll(view, result, tolerance,
        std::make_shared<const CosineSkySamples>(this->sky_, view.normal), workspace);
    }
    return this->sampleAll(view, result, tolerance, workspace);
  }
  result.value.main = std::clamp(result.value.main, 0.0, result.unoccluded);
  result.lower = result.value.main;
  result.upper = result.value.main;
  return result;
}

} // namespace lumitree
