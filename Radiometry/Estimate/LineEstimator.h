// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_LineEstimator_h
#define Lumitree_Radiometry_Estimate_LineEstimator_h

#include "Radiometry/Estimate/BoundedEstimator.h"

namespace lumitree
{

class LineSource;
class TubeSource;

/// Light of a line: what hides it is cut out of it exactly, and the rest integrated by angle to
/// rounding. Light of a tube: an integral over such lines around it, to 1e-9 of what it would be
/// with nothing in the way. Rays remain where too much is in the shaft, where quadrics hide, and
/// from places that all but touch the light.
class LineEstimator : public BoundedEstimator
{
public:
  LineEstimator(const Source& source, const EstimateScene& scene);

  /// Whether the source is one of these.
  [[nodiscard]] static bool suits(const Source& source);

  [[nodiscard]] Estimate estimate(
    const View& view, double tolerance, EstimateWorkspace& workspace) const override;

private:
  struct Cut;

  /// What is seen of the source; false where it is not known to that accuracy.
  bool seenOfLine(Cut& cut, Amounts& sum) const;
  bool seenOfTube(Cut& cut, double whole, Amounts& sum) const;

  const LineSource* line_;
  const TubeSource* tube_;
};

} // namespace lumitree

#endif
