// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_BoundedEstimator_h
#define Lumitree_Radiometry_Estimate_BoundedEstimator_h

#include "Radiometry/Estimate/SourceEstimator.h"
#include "Radiometry/Frame.h"

#include <array>

namespace lumitree
{

/// Many polygons, and whatever else has bounds: closed forms, and rays where something is in the
/// shaft to the box.
class BoundedEstimator : public SourceEstimatorBase
{
public:
  BoundedEstimator(const Source& source, const EstimateScene& scene)
    : SourceEstimatorBase(source, scene)
  {
  }

  [[nodiscard]] Estimate estimate(
    const View& view, double tolerance, EstimateWorkspace& workspace) const override;

protected:
  /// Finds what is in the pyramid from the eye around the source's box; false where there is no
  /// such pyramid, or as find().
  bool shaft(const View& view, std::size_t limit, EstimateWorkspace& workspace) const;

private:
  /// Finds what is in directions z + x low … high, down to that depth along z.
  bool pyramid(const View& view, const Frame& frame, const std::array<double, 2>& low,
    const std::array<double, 2>& high, double deepest, std::size_t limit,
    EstimateWorkspace& workspace) const;
};

} // namespace lumitree

#endif
