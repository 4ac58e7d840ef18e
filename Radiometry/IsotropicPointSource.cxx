// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/IsotropicPointSource.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"

namespace lumitree
{

IsotropicPointSource::IsotropicPointSource(double flux, const Vec3& position, double metresPerUnit)
  : PointLikeSource(position, metresPerUnit)
  , flux_(checks::notNegative(flux, "The flux of a point source"))
{
}

double IsotropicPointSource::intensityAlong(const Vec3&) const
{
  return this->flux_ / (4.0 * pi);
}

} // namespace lumitree
