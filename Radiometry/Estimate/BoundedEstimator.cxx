// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/BoundedEstimator.h"

#include <algorithm>
#include <optional>

namespace lumitree
{

Estimate BoundedEstimator::estimate(
  const View& view, double tolerance, EstimateWorkspace& workspace) const
{
  const Estimate full = this->unoccluded(view, workspace);
  if (!(full.unoccluded > 0.0) || !this->scene_.occluders ||
    (this->shaft(view, 0, workspace) && workspace.found.empty()))
  {
    return full;
  }
  return this->sampleAll(view, full, tolerance, workspace);
}

bool BoundedEstimator::shaft(
  const View& view, std::size_t limit, EstimateWorkspace& workspace) const
{
  const std::optional<Box> box = this->source_.bounds();
  if (!box || box->empty())
  {
    return false;
  }
  const Vec3 way = box->centre() - view.eye;
  const double distance = length(way);
  if (!(distance > 0.0))
  {
    return false;
  }
  const Frame frame = Frame::around((1.0 / distance) * way);
  std::array<double, 2> low = { 0.0, 0.0 };
  std::array<double, 2> high = { 0.0, 0.0 };
  double deepest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 p = { (corner & 1) != 0 ? box->upper[0] : box->lower[0],
      (corner & 2) != 0 ? box->upper[1] : box->lower[1],
      (corner & 4) != 0 ? box->upper[2] : box->lower[2] };
    const Vec3 local = frame.toLocal(p - view.eye);
    if (!(local[2] > 1e-3 * distance))
    {
      return false; // within the box, or nearly
    }
    deepest = std::max(deepest, local[2]);
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], local[k] / local[2]);
      high[k] = std::max(high[k], local[k] / local[2]);
    }
  }
  return this->pyramid(view, frame, low, high, deepest, limit, workspace);
}

bool BoundedEstimator::pyramid(const View& view, const Frame& frame,
  const std::array<double, 2>& low, const std::array<double, 2>& high, double deepest,
  std::size_t limit, EstimateWorkspace& workspace) const
{
  ConvexRegion& region = workspace.region;
  region.clear();
  const auto add = [&](const Vec3& outward, double beyond) {
    region.push_back({ outward, dot(outward, view.eye) + beyond });
  };
  const double slack = 1.0 + 0x1p-40;
  add(frame.x - (slack * high[0]) * frame.z, 0.0);
  add((slack * low[0]) * frame.z - frame.x, 0.0);
  add(frame.y - (slack * high[1]) * frame.z, 0.0);
  add((slack * low[1]) * frame.z - frame.y, 0.0);
  add(frame.z, deepest);
  if (view.sided)
  {
    add(-1.0 * view.normal, 0.0);
  }
  return this->find(view, limit, workspace);
}

} // namespace lumitree
