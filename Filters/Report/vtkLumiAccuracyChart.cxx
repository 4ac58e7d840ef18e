// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiAccuracyChart.h"

#include "LumiAccuracy.h"
#include "LumiCache.h"
#include "LumiGather.h"
#include "LumiJob.h"
#include "LumiPorts.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <exception>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

namespace
{

/// A column that holds one member of every row.
template <class Array, class Value>
void addColumn(vtkTable* table, const char* name, const std::vector<filters::AccuracyRow>& rows,
  const Value& valueOf)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const filters::AccuracyRow& row : rows)
  {
    column->InsertNextValue(valueOf(row));
  }
  table->AddColumn(column);
}

void fill(vtkTable* table, const std::vector<filters::AccuracyRow>& rows)
{
  using Row = filters::AccuracyRow;
  const auto text = [&](const char* name, std::string Row::*member)
  { addColumn<vtkStringArray>(table, name, rows, [=](const Row& r) { return r.*member; }); };
  const auto number = [&](const char* name, std::size_t Row::*member)
  {
    addColumn<vtkIdTypeArray>(
      table, name, rows, [=](const Row& r) { return static_cast<vtkIdType>(r.*member); });
  };
  const auto real = [&](const char* name, double Row::*member)
  { addColumn<vtkDoubleArray>(table, name, rows, [=](const Row& r) { return r.*member; }); };
  text("BackEnd", &Row::backEnd);
  text("Setting", &Row::setting);
  text("Precision", &Row::precision);
  text("RayKind", &Row::rayKind);
  number("Rays", &Row::rays);
  number("Leaks", &Row::leaks);
  number("Phantoms", &Row::phantoms);
  number("OtherPrimitives", &Row::otherPrimitives);
  number("FarPrimitives", &Row::farPrimitives);
  real("MedianTError", &Row::medianTError);
  real("MaxTError", &Row::maxTError);
  real("NanosecondsPerRay", &Row::nanosecondsPerRay);
}

} // namespace

struct vtkLumiAccuracyChart::Internals
{
  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::shared_ptr<const filters::SurfaceInput> Input; ///< kept so that the next execution finds it
};

vtkStandardNewMacro(vtkLumiAccuracyChart);

vtkLumiAccuracyChart::vtkLumiAccuracyChart()
  : Impl(new Internals)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkLumiAccuracyChart::~vtkLumiAccuracyChart() = default;

void vtkLumiAccuracyChart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRays: " << this->NumberOfRays << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Repeats: " << this->Repeats << "\n";
  os << indent << "BruteForceLimit: " << this->BruteForceLimit << "\n";
  os << indent << "Controller: " << this->Impl->Controller.Get() << "\n";
}

void vtkLumiAccuracyChart::SetController(vtkMultiProcessController* controller)
{
  if (this->Impl->Controller != controller)
  {
    this->Impl->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkLumiAccuracyChart::GetController()
{
  return this->Impl->Controller;
}

int vtkLumiAccuracyChart::FillInputPortInformation(int, vtkInformation* info)
{
  filters::acceptAnyDataSet(info);
  return 1;
}

int vtkLumiAccuracyChart::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  filters::requestSurface(inputs[0]->GetInformationObject(0), this->Impl->Controller);
  return 1;
}

int vtkLumiAccuracyChart::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = this->Impl->Controller;
  this->Impl->Input = filters::surfaceFor(
    vtkDataObject::GetData(inputs[0], 0), controller, this, filters::GatherArrays::No);
  if (!this->Impl->Input)
  {
    return 1; // an error was reported; returning 0 would make VTK report it a second time
  }
  try
  {
    std::vector<filters::AccuracyRow> rows;
    if (!filters::isDistributed(controller) || controller->GetLocalProcessId() == 0)
    {
      filters::Job job(this, 0.1, 1.0);
      filters::AccuracyOptions options;
      options.rays = static_cast<std::size_t>(this->NumberOfRays);
      options.seed = static_cast<unsigned int>(this->Seed);
      options.repeats = this->Repeats;
      options.bruteForceLimit = static_cast<std::size_t>(this->BruteForceLimit);
      rows = filters::measureAccuracy(
        this->Impl->Input->surface, options, [&](double done) { return job.report(done); });
    }
    fill(vtkTable::GetData(outputs, 0), rows);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
  return 1;
}

VTK_ABI_NAMESPACE_END
