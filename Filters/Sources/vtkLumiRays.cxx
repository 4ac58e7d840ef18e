// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRays.h"

#include "LumiDirections.h"
#include "LumiRandom.h"
#include "LumiRayOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkLumiRays);

namespace
{

using namespace lumitree;
using filters::RayLine;
using RayFunction = std::function<RayLine(vtkIdType)>;

Vec3 FromArray(const double* values)
{
  return { values[0], values[1], values[2] };
}

struct Plane
{
  Vec3 corner;
  Vec3 edge1;
  Vec3 edge2;

  Vec3 Normal() const
  {
    using lumitree::filters::unit;
    // Unit edges, so that a large or small plane does not overflow; cross() of parallel ones is not
    // always exactly zero, hence the threshold.
    const Vec3 normal = cross(unit(this->edge1), unit(this->edge2));
    return length(normal) > 1e-12 ? unit(normal) : Vec3{ 0.0, 0.0, 0.0 };
  }
};

RayFunction GridRays(const Plane& plane, const Vec3& direction, const int resolution[2])
{
  const vtkIdType width = resolution[0];
  const vtkIdType height = resolution[1];
  return [=](vtkIdType i) -> RayLine
  {
    const vtkIdType row = i / width;
    const vtkIdType column = i % width;
    const double s = (static_cast<double>(column) + 0.5) / static_cast<double>(width);
    const double t = (static_cast<double>(row) + 0.5) / static_cast<double>(height);
    return { plane.corner + s * plane.edge1 + t * plane.edge2, direction };
  };
}

RayFunction SpiralRays(const Vec3& center, vtkIdType count)
{
  return [=](vtkIdType i) -> RayLine {
    return { center, lumitree::filters::spiralDirection(i, count) };
  };
}

// Streams of uniformOf(): 0 to 2 for the origin, 3 and 4 for the direction.
RayFunction BoxRays(const Vec3& low, const Vec3& high, std::uint64_t seed)
{
  using namespace lumitree::filters;
  return [=](vtkIdType i) -> RayLine
  {
    RayLine ray;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double u = uniformOf(seed, i, k);
      // This form cannot overflow, nor leave the box by rounding.
      ray.origin[k] = std::clamp((1.0 - u) * low[k] + u * high[k], low[k], high[k]);
    }
    ray.direction = sphereDirection(uniformOf(seed, i, 3), uniformOf(seed, i, 4));
    return ray;
  };
}

RayFunction SphereRays(const Vec3& center, double radius, std::uint64_t seed)
{
  using namespace lumitree::filters;
  return [=](vtkIdType i) -> RayLine
  {
    const Vec3 outward = sphereDirection(uniformOf(seed, i, 0), uniformOf(seed, i, 1));
    return { center + radius * outward,
      cosineDirection(-1.0 * outward, uniformOf(seed, i, 3), uniformOf(seed, i, 4)) };
  };
}

}

vtkLumiRays::vtkLumiRays()
{
  this->SetNumberOfInputPorts(0);
}

std::string vtkLumiRays::Problem() const
{
  const auto finite = [](const double* values, int count)
  { return std::all_of(values, values + count, [](double v) { return std::isfinite(v); }); };
  if (this->Mode == ParallelGrid)
  {
    if (!finite(this->Origin, 3) || !finite(this->Point1, 3) || !finite(this->Point2, 3))
    {
      return "Origin, Point1 and Point2 must be finite.";
    }
    if (this->Resolution[0] < 1 || this->Resolution[1] < 1)
    {
      return "Resolution must be at least 1 x 1.";
    }
    const Vec3 corner = FromArray(this->Origin);
    const Plane plane{ corner, FromArray(this->Point1) - corner, FromArray(this->Point2) - corner };
    if (this->UsePlaneNormal && lumitree::filters::isZero(plane.Normal()))
    {
      return "Origin, Point1 and Point2 lie on one line: there is no plane normal to follow.";
    }
    if (!this->UsePlaneNormal &&
      lumitree::filters::isZero(lumitree::filters::unit(FromArray(this->Direction))))
    {
      return "Direction must be finite and not zero.";
    }
    return {};
  }
  if (this->NumberOfRays < 1)
  {
    return "NumberOfRays must be at least 1.";
  }
  if (this->Mode == Random && this->RandomOrigins == InBox)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (!finite(this->Bounds + 2 * k, 2) || !(this->Bounds[2 * k] <= this->Bounds[2 * k + 1]))
      {
        return "Bounds must be finite, each low end at most its high end.";
      }
    }
    return {};
  }
  if (!finite(this->Center, 3))
  {
    return "Center must be finite.";
  }
  if (this->Mode == Random && !(std::isfinite(this->Radius) && this->Radius > 0.0))
  {
    return "Radius must be finite and above 0.";
  }
  return {};
}

int vtkLumiRays::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkLumiRays::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const std::string problem = this->Problem();
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }

  const Vec3 center = FromArray(this->Center);
  const auto seed = static_cast<std::uint64_t>(this->Seed);
  vtkIdType total = this->NumberOfRays;
  RayFunction ray;
  if (this->Mode == ParallelGrid)
  {
    const Vec3 corner = FromArray(this->Origin);
    const Plane plane{ corner, FromArray(this->Point1) - corner, FromArray(this->Point2) - corner };
    const Vec3 direction =
      this->UsePlaneNormal ? plane.Normal() : lumitree::filters::unit(FromArray(this->Direction));
    total = static_cast<vtkIdType>(this->Resolution[0]) * this->Resolution[1];
    ray = GridRays(plane, direction, this->Resolution);
  }
  else if (this->Mode == SphereAroundPoint)
  {
    ray = SpiralRays(center, total);
  }
  else if (this->RandomOrigins == InBox)
  {
    const double* b = this->Bounds;
    ray = BoxRays({ b[0], b[2], b[4] }, { b[1], b[3], b[5] }, seed);
  }
  else
  {
    ray = SphereRays(center, this->Radius, seed);
  }

  vtkInformation* information = outputVector->GetInformationObject(0);
  const lumitree::filters::Share share = lumitree::filters::shareOf(information, total);
  lumitree::filters::writeRays(this, vtkPolyData::GetData(information), share.count,
    this->OutputPointsPrecision, [&ray, &share](vtkIdType i) { return ray(share.first + i); });
  return 1;
}

void vtkLumiRays::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "Mode: " << this->Mode << "\n";
  print3("Origin", this->Origin);
  print3("Point1", this->Point1);
  print3("Point2", this->Point2);
  os << indent << "Resolution: " << this->Resolution[0] << " x " << this->Resolution[1] << "\n";
  os << indent << "UsePlaneNormal: " << this->UsePlaneNormal << "\n";
  print3("Direction", this->Direction);
  print3("Center", this->Center);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RandomOrigins: " << this->RandomOrigins << "\n";
  os << indent << "Bounds:";
  for (const double bound : this->Bounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "NumberOfRays: " << this->NumberOfRays << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
