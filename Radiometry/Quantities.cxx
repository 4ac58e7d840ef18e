// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Quantities.h"

namespace lumitree
{

namespace
{

constexpr QuantityName names[quantityCount][lightSystemCount] = {
  { { "RadiantEnergy", "J" }, { "LuminousEnergy", "lm s" } },
  { { "RadiantFlux", "W" }, { "LuminousFlux", "lm" } },
  { { "RadiantIntensity", "W/sr" }, { "LuminousIntensity", "cd" } },
  { { "Irradiance", "W/m^2" }, { "Illuminance", "lx" } },
  { { "ScalarIrradiance", "W/m^2" }, { "ScalarIlluminance", "lx" } },
  { { "NormalIrradiance", "W/m^2" }, { "NormalIlluminance", "lx" } },
  { { "RadiantExitance", "W/m^2" }, { "LuminousExitance", "lm/m^2" } },
  { { "Radiance", "W/(m^2 sr)" }, { "Luminance", "cd/m^2" } },
};

} // namespace

QuantityName describe(Quantity quantity, LightSystem system)
{
  return names[static_cast<int>(quantity)][static_cast<int>(system)];
}

std::string arrayName(Quantity quantity, LightSystem system)
{
  const QuantityName q = describe(quantity, system);
  return std::string(q.name) + " [" + std::string(q.unit) + "]";
}

std::string_view name(LightSystem system)
{
  return system == LightSystem::Photometric ? "photometric" : "radiometric";
}

} // namespace lumitree
