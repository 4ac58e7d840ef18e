// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSky.h"

#include "LumiLightShapes.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Radiometry/Constants.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/Quantities.h"
#include "Radiometry/SunPosition.h"

#include <cmath>
#include <memory>
#include <stdexcept>

vtkStandardNewMacro(vtkLumiSky);

std::string vtkLumiSky::Problem() const
{
  if (!(std::isfinite(this->SunAzimuth) && this->SunZenith >= 0.0 && this->SunZenith <= 90.0))
  {
    return "SunAzimuth must be finite, and SunZenith from 0 to 90.";
  }
  if (this->Model == AllWeather && this->System == Photometric)
  {
    return "The all-weather sky is made of irradiances in W/m^2: it is Radiometric. Its "
           "LuminousEfficacy makes light of it.";
  }
  if (!lumitree::filters::isFinite3(this->Anchor))
  {
    return "Anchor must be finite.";
  }
  if (!(std::isfinite(this->Length) && this->Length > 0.0))
  {
    return "Length must be finite and above 0.";
  }
  return {};
}

std::string vtkLumiSky::FillFrom(vtkInformationVector**, vtkInformation*, vtkPolyData* output)
{
  using namespace lumitree;
  const auto system = static_cast<lumitree::LightSystem>(this->System);
  const bool photometric = this->System == Photometric;
  const Vec3 up = { this->Up[0], this->Up[1], this->Up[2] };
  const Vec3 north = { this->North[0], this->North[1], this->North[2] };
  try
  {
    SunPosition position;
    position.zenith = this->SunZenith;
    position.azimuth = this->SunAzimuth;
    const Vec3 sun = towardsSun(position, north, up);
    SkyLevel level{ this->LevelQuantity == ZenithRadiance ? SkyLevel::Kind::ZenithRadiance
                                                          : SkyLevel::Kind::HorizontalIrradiance,
      this->Level };
    std::unique_ptr<Source> source;
    SkyDistribution distribution;
    const char* model = "general";
    switch (this->Model)
    {
      case Uniform:
        model = "uniform";
        source = std::make_unique<UniformSky>(uniformRadiance(level), up, this->GroundRadiance);
        break;
      case CieOvercast:
        model = "overcast";
        source = std::make_unique<OvercastSky>(level, up, this->GroundRadiance);
        break;
      case CieGeneral:
        distribution = cieSky(this->CieType);
        break;
      default:
      {
        const double zenith = this->SunZenith * pi / 180.0;
        distribution =
          perezSky(skyCondition(this->DirectNormal, this->DiffuseHorizontal, zenith), zenith);
        level = { SkyLevel::Kind::HorizontalIrradiance, this->DiffuseHorizontal };
      }
    }
    if (!source)
    {
      source = std::make_unique<GeneralSky>(distribution, sun, level, up, this->GroundRadiance);
      AddTuple(output, "SkyTowardsSun", sun.data(), 3);
      AddValues(output, "SkyDistribution",
        { distribution.a, distribution.b, distribution.c, distribution.d, distribution.e,
          distribution.base });
    }
    AddText(output, "SkyModel", model);
    AddTuple(output, "SkyUp", this->Up, 3);
    if (level.kind == SkyLevel::Kind::ZenithRadiance)
    {
      AddQuantity(output, photometric ? "ZenithLuminance" : "ZenithRadiance",
        photometric ? "cd/m^2" : "W/(m^2 sr)", level.value);
    }
    else
    {
      AddQuantity(output,
        photometric ? "DiffuseHorizontalIlluminance" : "DiffuseHorizontalIrradiance",
        photometric ? "lx" : "W/m^2", level.value);
    }
    AddQuantity(output, photometric ? "GroundLuminance" : "GroundRadiance",
      photometric ? "cd/m^2" : "W/(m^2 sr)", this->GroundRadiance);
    filters::drawSky(output, *source, up, { this->Anchor[0], this->Anchor[1], this->Anchor[2] },
      this->Length, arrayName(Quantity::Radiance, system).c_str());
  }
  catch (const std::invalid_argument& problem)
  {
    return problem.what();
  }
  return {};
}

void vtkLumiSky::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "CieType: " << this->CieType << "\n";
  os << indent << "LevelQuantity: " << this->LevelQuantity << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "DirectNormal: " << this->DirectNormal << "\n";
  os << indent << "DiffuseHorizontal: " << this->DiffuseHorizontal << "\n";
  os << indent << "SunZenith: " << this->SunZenith << "\n";
  os << indent << "SunAzimuth: " << this->SunAzimuth << "\n";
  print3("North", this->North);
  print3("Up", this->Up);
  os << indent << "GroundRadiance: " << this->GroundRadiance << "\n";
  print3("Anchor", this->Anchor);
  os << indent << "Length: " << this->Length << "\n";
}
