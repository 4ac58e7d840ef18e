// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSky.h"

#include "LumiLightShapes.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Radiometry/Constants.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/Quantities.h"
#include "Radiometry/SunPosition.h"

#include <algorithm>
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

vtkLumiSky::vtkLumiSky()
{
  this->SetNumberOfInputPorts(1);
}

int vtkLumiSky::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

std::string vtkLumiSky::FillFrom(
  vtkInformationVector** inputs, vtkInformation*, vtkPolyData* output)
{
  using namespace lumitree;
  double sunZenith = this->SunZenith;
  double sunAzimuth = this->SunAzimuth;
  bool night = false;
  if (vtkDataSet* sunData = vtkDataSet::GetData(inputs[0]))
  {
    vtkDataArray* zeniths = sunData->GetFieldData()->GetArray("SunZenith [deg]");
    vtkDataArray* azimuths = sunData->GetFieldData()->GetArray("SunAzimuth [deg]");
    if (!zeniths || !azimuths || zeniths->GetNumberOfTuples() != 1 ||
      azimuths->GetNumberOfTuples() != 1)
    {
      return "The input is no sun: it has no \"SunZenith [deg]\" and \"SunAzimuth [deg]\".";
    }
    constexpr double lowest = 89.9; // where the formulas of skies still have a meaning
    sunZenith = zeniths->GetComponent(0, 0);
    sunAzimuth = azimuths->GetComponent(0, 0);
    night = sunZenith >= 90.0;
    sunZenith = std::min(sunZenith, lowest);
    if (!(std::isfinite(sunAzimuth) && sunZenith >= 0.0))
    {
      return "The place of the sun on the input is not finite.";
    }
  }
  const double ground = night ? 0.0 : this->GroundRadiance;
  const auto system = static_cast<lumitree::LightSystem>(this->System);
  const bool photometric = this->System == Photometric;
  const Vec3 up = { this->Up[0], this->Up[1], this->Up[2] };
  const Vec3 north = { this->North[0], this->North[1], this->North[2] };
  try
  {
    SunPosition position;
    position.zenith = sunZenith;
    position.azimuth = sunAzimuth;
    const Vec3 sun = towardsSun(position, north, up);
    SkyLevel level{ this->LevelQuantity == ZenithRadiance ? SkyLevel::Kind::ZenithRadiance
                                                          : SkyLevel::Kind::HorizontalIrradiance,
      night ? 0.0 : this->Level };
    std::unique_ptr<Source> source;
    SkyDistribution distribution;
    const char* model = "general";
    switch (this->Model)
    {
      case Uniform:
        model = "uniform";
        source = std::make_unique<UniformSky>(uniformRadiance(level), up, ground);
        break;
      case CieOvercast:
        model = "overcast";
        source = std::make_unique<OvercastSky>(level, up, ground);
        break;
      case CieGeneral:
        distribution = cieSky(this->CieType);
        break;
      default:
      {
        const double zenith = sunZenith * pi / 180.0;
        distribution =
          perezSky(skyCondition(this->DirectNormal, this->DiffuseHorizontal, zenith), zenith);
        level = { SkyLevel::Kind::HorizontalIrradiance, night ? 0.0 : this->DiffuseHorizontal };
      }
    }
    if (!source)
    {
      source = std::make_unique<GeneralSky>(distribution, sun, level, up, ground);
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
      photometric ? "cd/m^2" : "W/(m^2 sr)", ground);
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
