// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiSurfaceRays.h"

#include "LumiDirections.h"
#include "LumiRandom.h"
#include "LumiRayOutput.h"
#include "LumiRaySources.h"

#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

vtkStandardNewMacro(vtkLumiSurfaceRays);

namespace
{

using namespace lumitree;
using filters::RaySource;

Vec3 DirectionOf(const RaySource& source, vtkIdType k, int distribution, std::uint64_t seed)
{
  if (distribution == vtkLumiSurfaceRays::Normal)
  {
    return source.normal;
  }
  const std::uint64_t scramble = filters::hashOf(seed, source.index, source.compositeIndex);
  const auto uv = filters::scrambledSobol(static_cast<std::uint32_t>(k), scramble);
  return distribution == vtkLumiSurfaceRays::Cosine
    ? filters::cosineDirection(source.normal, uv[0], uv[1])
    : filters::uniformDirection(source.normal, uv[0], uv[1]);
}

/// How far a source is to move to be beyond its surface, whatever rounding did to its position, to
/// its sum with offsets, and will do to the point of the output. Along a normal 75 degrees off,
/// 4 cos(75) > 1.03 of the bound remain.
double ClearanceOf(const RaySource& source, double offset, bool single)
{
  const double size = std::fabs(source.position[0]) + std::fabs(source.position[1]) +
    std::fabs(source.position[2]) + 3.0 * std::fabs(offset);
  return 4.0 * (source.rounding + ((single ? 0x1p-24 : 0x1p-53) + 3 * 0x1p-53) * size);
}

/// Which source each ray leaves from.
void AddSourceIds(
  vtkPolyData* output, const std::vector<RaySource>& sources, vtkIdType raysPerSource, bool points)
{
  const auto count = static_cast<vtkIdType>(sources.size()) * raysPerSource;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(points ? "SourcePointId" : "SourceCellId");
  ids->SetNumberOfValues(count);
  vtkNew<vtkIdTypeArray> none;
  none->SetName(points ? "SourceCellId" : "SourcePointId");
  none->SetNumberOfValues(count);
  none->FillValue(-1);
  vtkNew<vtkIntArray> leaves;
  leaves->SetName("SourceCompositeIndex");
  leaves->SetNumberOfValues(count);

  vtkIdType ray = 0;
  for (const RaySource& source : sources)
  {
    for (vtkIdType k = 0; k < raysPerSource; ++k, ++ray)
    {
      ids->SetValue(ray, source.id);
      leaves->SetValue(ray, source.compositeIndex);
    }
  }
  output->GetPointData()->AddArray(points ? none : ids);
  output->GetPointData()->AddArray(points ? ids : none);
  output->GetPointData()->AddArray(leaves);
}

}

int vtkLumiSurfaceRays::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkLumiSurfaceRays::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->RaysPerSource < 1)
  {
    vtkErrorMacro("RaysPerSource must be at least 1.");
    return 0;
  }
  if (!std::isfinite(this->Offset))
  {
    vtkErrorMacro("Offset must be finite.");
    return 0;
  }

  const bool points = this->SourceLocation == Points;
  const filters::RaySources found =
    filters::collectRaySources(vtkDataObject::GetData(inputVector[0]), points);
  if (found.notDatasets > 0)
  {
    vtkErrorMacro(<< found.notDatasets
                  << " blocks of the input are no datasets and have no surface.");
    return 0;
  }
  if (found.withoutNormal > 0)
  {
    vtkWarningMacro(<< found.withoutNormal << " of " << found.withoutNormal + found.list.size()
                    << (points ? " points" : " cells")
                    << " have no normal or no finite position, and send no rays.");
  }

  const vtkIdType each = this->Distribution == Normal ? 1 : this->RaysPerSource;
  const auto seed = static_cast<std::uint64_t>(this->Seed);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const bool completed = filters::writeRays(this, output,
    static_cast<vtkIdType>(found.list.size()) * each, this->OutputPointsPrecision,
    [&](vtkIdType i)
    {
      const RaySource& source = found.list[static_cast<std::size_t>(i / each)];
      lumitree::Vec3 origin = source.position + this->Offset * source.normal;
      if (this->ClearOfRounding)
      {
        const bool single = this->OutputPointsPrecision == SINGLE_PRECISION;
        origin = origin + ClearanceOf(source, this->Offset, single) * source.clear;
      }
      return filters::RayLine{ origin, DirectionOf(source, i % each, this->Distribution, seed) };
    });
  if (completed)
  {
    AddSourceIds(output, found.list, each, points);
  }
  return 1;
}

void vtkLumiSurfaceRays::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceLocation: " << this->SourceLocation << "\n";
  os << indent << "Distribution: " << this->Distribution << "\n";
  os << indent << "RaysPerSource: " << this->RaysPerSource << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "ClearOfRounding: " << (this->ClearOfRounding ? "on" : "off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
