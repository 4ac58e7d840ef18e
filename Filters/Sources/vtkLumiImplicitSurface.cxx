// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiImplicitSurface.h"

#include "LumiImplicitFunctions.h"
#include "LumiQuadricOutput.h"

#include "vtkDataSet.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkLumiImplicitSurface);

namespace
{

using Body = lumitree::Quadric;
using lumitree::Vec3;
using lumitree::operator+;
using lumitree::operator-;
using lumitree::operator*;

Vec3 Vector(const double* x)
{
  return { x[0], x[1], x[2] };
}

/// A point array of the input; null where no name is given.
vtkDataArray* ArrayOf(vtkDataSet* input, const char* name, int components)
{
  if (!name || !*name)
  {
    return nullptr;
  }
  vtkDataArray* array = input->GetPointData()->GetArray(name);
  if (!array && std::string(name) == "None") // as ParaView says it
  {
    return nullptr;
  }
  if (!array || array->GetNumberOfComponents() != components)
  {
    throw std::invalid_argument(std::string("the input has no point array ") + name + " of " +
      std::to_string(components) + " component" + (components > 1 ? "s" : ""));
  }
  return array;
}

/// A place, and the factors that an input gives there.
struct Place
{
  Vec3 centre;
  double factor = 1.0;
  Vec3 direction;
};

std::vector<Body> Capped(std::vector<Body> body, bool capped)
{
  if (!capped)
  {
    body.resize(1);
  }
  return body;
}

std::vector<Body> BodiesAt(vtkLumiImplicitSurface* self, const Place& place)
{
  const double radius = self->GetRadius() * place.factor;
  const double height = self->GetHeight();
  const Vec3 along = (height / lumitree::length(place.direction)) * place.direction;
  const Vec3& centre = place.centre;
  const Vec3 from = centre - 0.5 * along;
  const Vec3 to = centre + 0.5 * along;
  // A height that is 0, negative or not a number would turn the axis round or have none.
  const bool hasHeight = height > 0.0;
  switch (self->GetShape())
  {
    case vtkLumiImplicitSurface::Ellipsoid:
    {
      const Vec3 r = place.factor * Vector(self->GetRadii());
      const bool positive = r[0] > 0.0 && r[1] > 0.0 && r[2] > 0.0;
      return { positive
          ? Body::ellipsoid(centre, { Vec3{ r[0], 0, 0 }, Vec3{ 0, r[1], 0 }, Vec3{ 0, 0, r[2] } })
          : Body{} };
    }
    case vtkLumiImplicitSurface::Cylinder:
      return hasHeight ? Capped(Body::cappedCylinder(from, to, radius), self->GetCapped())
                       : std::vector<Body>(1);
    case vtkLumiImplicitSurface::Cone:
      return hasHeight ? Capped(Body::cappedCone(to, from, radius), self->GetCapped())
                       : std::vector<Body>(1);
    case vtkLumiImplicitSurface::Paraboloid:
      return { hasHeight ? Body::paraboloid(centre, centre + along, radius) : Body{} };
    case vtkLumiImplicitSurface::Disc:
      return { Body::disc(centre, place.direction, radius) };
    default:
      return { Body::sphere(centre, radius) };
  }
}

lumitree::filters::QuadricSet BodiesOfFunction(
  vtkLumiImplicitSurface* self, const lumitree::Box& box)
{
  vtkImplicitFunction* const function = self->GetImplicitFunction();
  if (!function)
  {
    throw std::invalid_argument("the shape Function needs an ImplicitFunction");
  }
  auto bodies = lumitree::filters::bodiesOf(function, box, self->GetStep());
  lumitree::filters::QuadricSet set;
  set.quadrics = std::move(bodies.quadrics);
  set.implicit = bodies.implicit;
  set.tree = bodies.tree;
  set.function = function;
  set.isFunction = true;
  set.guarantee = bodies.guarantee;
  return set;
}

lumitree::filters::QuadricSet BodiesInBounds(vtkLumiImplicitSurface* self)
{
  const double* b = self->GetBounds();
  const lumitree::Box box = { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
  lumitree::filters::QuadricSet set;
  switch (self->GetShape())
  {
    case vtkLumiImplicitSurface::Plane:
      set.quadrics = { Body::plane(Vector(self->GetCenter()), Vector(self->GetDirection()), box) };
      return set;
    case vtkLumiImplicitSurface::Box:
      set.quadrics = Body::sides(box);
      return set;
    case vtkLumiImplicitSurface::Quadric:
    {
      lumitree::QuadricForm form;
      form.centre = Vector(self->GetCenter());
      std::copy_n(self->GetCoefficients(), 10, form.coefficients.begin());
      set.quadrics = { Body::inBox(form, box) };
      return set;
    }
    default:
      return BodiesOfFunction(self, box);
  }
}

lumitree::filters::QuadricSet BodiesAtPoints(vtkLumiImplicitSurface* self, vtkDataSet* input)
{
  vtkDataArray* const factors = ArrayOf(input, self->GetRadiusArray(), 1);
  vtkDataArray* const directions = ArrayOf(input, self->GetDirectionArray(), 3);
  lumitree::filters::QuadricSet set;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    Place place{ {}, 1.0, Vector(self->GetDirection()) };
    input->GetPoint(i, place.centre.data());
    place.centre = place.centre + Vector(self->GetCenter());
    place.factor = factors ? factors->GetComponent(i, 0) : 1.0;
    if (directions)
    {
      directions->GetTuple(i, place.direction.data());
    }
    for (const Body& body : BodiesAt(self, place))
    {
      set.quadrics.push_back(body);
      set.points.push_back(i);
    }
  }
  return set;
}

}

vtkLumiImplicitSurface::vtkLumiImplicitSurface()
{
  this->SetNumberOfInputPorts(1);
}

vtkLumiImplicitSurface::~vtkLumiImplicitSurface()
{
  this->SetRadiusArray(nullptr);
  this->SetDirectionArray(nullptr);
}

void vtkLumiImplicitSurface::SetCoefficients(const double a[10])
{
  if (!std::equal(a, a + 10, this->Coefficients))
  {
    std::copy(a, a + 10, this->Coefficients);
    this->Modified();
  }
}

void vtkLumiImplicitSurface::SetCoefficients(double a0, double a1, double a2, double a3, double a4,
  double a5, double a6, double a7, double a8, double a9)
{
  const double a[10] = { a0, a1, a2, a3, a4, a5, a6, a7, a8, a9 };
  this->SetCoefficients(a);
}

void vtkLumiImplicitSurface::SetImplicitFunction(vtkImplicitFunction* function)
{
  if (this->ImplicitFunction != function)
  {
    this->ImplicitFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkLumiImplicitSurface::GetImplicitFunction()
{
  return this->ImplicitFunction;
}

vtkMTimeType vtkLumiImplicitSurface::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

int vtkLumiImplicitSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkLumiImplicitSurface::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkLumiImplicitSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  const auto pieceKey = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  const bool laterPiece = information->Has(pieceKey) && information->Get(pieceKey) > 0;
  if (laterPiece && !input)
  {
    return 1;
  }
  try
  {
    lumitree::filters::QuadricSet set;
    if (this->Shape < Plane && input)
    {
      set = BodiesAtPoints(this, input);
    }
    else if (this->Shape < Plane)
    {
      set.quadrics = BodiesAt(this, { Vector(this->Center), 1.0, Vector(this->Direction) });
    }
    else if (input)
    {
      throw std::invalid_argument("this shape goes by Bounds and cannot be put at points");
    }
    else
    {
      set = BodiesInBounds(this);
    }
    lumitree::filters::makeOutput(set, input, this->PreviewResolution, output);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro("The implicit surface could not be made: " << error.what());
    return 0;
  }
  return 1;
}

void vtkLumiImplicitSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* label, const double* values, int n)
  {
    os << indent << label << ":";
    for (int i = 0; i < n; ++i)
    {
      os << " " << values[i];
    }
    os << "\n";
  };
  os << indent << "Shape: " << this->Shape << "\n";
  print("Center", this->Center, 3);
  os << indent << "Radius: " << this->Radius << "\n";
  print("Radii", this->Radii, 3);
  print("Direction", this->Direction, 3);
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Capped: " << this->Capped << "\n";
  print("Bounds", this->Bounds, 6);
  print("Coefficients", this->Coefficients, 10);
  os << indent << "ImplicitFunction: " << this->ImplicitFunction.Get() << "\n";
  os << indent << "RadiusArray: " << (this->RadiusArray ? this->RadiusArray : "(none)") << "\n";
  os << indent << "DirectionArray: " << (this->DirectionArray ? this->DirectionArray : "(none)")
     << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "PreviewResolution: " << this->PreviewResolution << "\n";
}
