// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_HiddenLine_h
#define Lumitree_Radiometry_Estimate_HiddenLine_h

#include "Accel/Vec3.h"

#include <array>
#include <vector>

namespace lumitree
{

/// Which parts of a segment are seen past triangles; all relative to the eye.
class HiddenLine
{
public:
  /// A part of the segment, 0 at its beginning and 1 at its end.
  struct Part
  {
    double from, to;
  };

  /// The parts that are seen, in order. A triangle hides what lies behind it: where it cuts the
  /// triangle of the eye and the segment. What is nearer to the segment than the clearance is the
  /// segment. Seen along its own direction, all of the segment is.
  const std::vector<Part>& seen(const Vec3& toBegin, const Vec3& toEnd,
    const std::vector<std::array<Vec3, 3>>& triangles, double clearance);

private:
  std::vector<Part> hidden_;
  std::vector<Part> seen_;
};

} // namespace lumitree

#endif
