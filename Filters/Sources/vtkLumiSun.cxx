// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSun.h"

#include "LumiLightShapes.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "Radiometry/Quantities.h"
#include "Radiometry/SunPosition.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkLumiSun);

std::string vtkLumiSun::Problem() const
{
  if (!(std::isfinite(this->NormalIrradiance) && this->NormalIrradiance >= 0.0))
  {
    return "NormalIrradiance must be finite and not negative.";
  }
  if (!(this->AngularDiameter >= 0.0 && this->AngularDiameter <= 180.0))
  {
    return "AngularDiameter must be from 0 to 180.";
  }
  if (!(std::isfinite(this->FirstHour) && std::isfinite(this->LastHour) &&
        this->FirstHour <= this->LastHour))
  {
    return "FirstHour and LastHour must be finite and in order.";
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

int vtkLumiSun::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Remove(Pipeline::TIME_STEPS());
  information->Remove(Pipeline::TIME_RANGE());
  if (this->TimeSteps > 0 && this->FirstHour <= this->LastHour)
  {
    std::vector<double> hours;
    for (int i = 0; i < this->TimeSteps; ++i)
    {
      const double share =
        this->TimeSteps > 1 ? static_cast<double>(i) / (this->TimeSteps - 1) : 0.0;
      hours.push_back(this->FirstHour + share * (this->LastHour - this->FirstHour));
    }
    const double range[2] = { hours.front(), hours.back() };
    information->Set(Pipeline::TIME_STEPS(), hours.data(), this->TimeSteps);
    information->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return this->Superclass::RequestInformation(request, inputs, outputVector);
}

std::string vtkLumiSun::FillFrom(
  vtkInformationVector**, vtkInformation* outputInformation, vtkPolyData* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  double hour = this->TimeSteps > 0 ? this->FirstHour : this->Hour;
  if (this->TimeSteps > 0 && outputInformation->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    hour = std::clamp(
      outputInformation->Get(Pipeline::UPDATE_TIME_STEP()), this->FirstHour, this->LastHour);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), hour);
  }
  try
  {
    const lumitree::SunPosition sun =
      lumitree::sunPosition({ this->Date[0], this->Date[1], this->Date[2], hour, this->UTCOffset },
        { this->Latitude, this->Longitude });
    const lumitree::Vec3 towards =
      lumitree::towardsSun(sun, { this->North[0], this->North[1], this->North[2] },
        { this->Up[0], this->Up[1], this->Up[2] });
    const lumitree::Vec3 direction = { -towards[0], -towards[1], -towards[2] };
    const double* a = this->Anchor;
    lumitree::filters::drawRay(output, { a[0], a[1], a[2] }, direction, this->Length);
    AddTuple(output, "LightDirection", direction.data(), 3);
    if (this->AngularDiameter > 0.0)
    {
      AddQuantity(output, "AngularDiameter", "deg", this->AngularDiameter);
    }
    AddQuantity(output, lumitree::Quantity::NormalIrradiance,
      sun.zenith < 90.0 ? this->NormalIrradiance : 0.0);
    AddQuantity(output, "SunZenith", "deg", sun.zenith);
    AddQuantity(output, "SunAzimuth", "deg", sun.azimuth);
  }
  catch (const std::invalid_argument& problem)
  {
    return problem.what();
  }
  return {};
}

void vtkLumiSun::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const auto* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "Latitude: " << this->Latitude << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n";
  print3("Date", this->Date);
  os << indent << "Hour: " << this->Hour << "\n";
  os << indent << "UTCOffset: " << this->UTCOffset << "\n";
  os << indent << "TimeSteps: " << this->TimeSteps << "\n";
  os << indent << "FirstHour: " << this->FirstHour << "\n";
  os << indent << "LastHour: " << this->LastHour << "\n";
  print3("North", this->North);
  print3("Up", this->Up);
  os << indent << "NormalIrradiance: " << this->NormalIrradiance << "\n";
  os << indent << "AngularDiameter: " << this->AngularDiameter << "\n";
  print3("Anchor", this->Anchor);
  os << indent << "Length: " << this->Length << "\n";
}
