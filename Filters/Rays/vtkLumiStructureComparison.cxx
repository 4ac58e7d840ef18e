// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiStructureComparison.h"

#include "LumiCache.h"
#include "LumiComparison.h"
#include "LumiGather.h"
#include "LumiPorts.h"
#include "LumiReport.h"
#include "LumiSettings.h"

#include "Accel/Registry.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <exception>
#include <optional>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

struct vtkLumiStructureComparison::Internals
{
  std::shared_ptr<const filters::SurfaceInput>
    Surface; ///< kept so that the next execution finds it
  filters::RayInput Rays;

  static std::vector<lumitree::BuildOptions> Rows(vtkLumiStructureComparison* self)
  {
    const lumitree::BuildOptions options = filters::buildOptions(self);
    if (self->Sweep == AllStructures)
    {
      return filters::everyStructure(options, self->IncludeBruteForce, self->IncludeReferences);
    }
    const double from = self->SweepMinimum;
    const double to = self->SweepMaximum;
    if (!(from > 0.0 && from <= to && to <= 1000.0))
    {
      throw std::invalid_argument("SweepMinimum and SweepMaximum must be above 0, at most 1000 and "
                                  "in ascending order.");
    }
    return self->Sweep == GridCells ? filters::gridSweep(options, from, to, self->SweepSteps)
                                    : filters::leafSweep(options, from, to, self->SweepSteps);
  }

  /// The answers that are taken for true. Throws what building and asking throw.
  std::unique_ptr<const filters::Cast> Truth(
    vtkLumiStructureComparison* self, lumitree::QueryKind query, filters::Job& job) const
  {
    lumitree::BuildOptions options;
    options.structure = static_cast<lumitree::Structure>(self->ReferenceStructure);
    const auto accelerator = lumitree::build(this->Surface->surface, options, job.control());
    lumitree::QueryOptions asked = filters::queryOptions(self, *accelerator, job);
    asked.precision = lumitree::Precision::Exact;
    return std::make_unique<const filters::Cast>(query, *accelerator, this->Rays.batch, asked);
  }

  /// Fills the table; ranks agree after every row. Throws what is to be reported.
  void Compare(vtkLumiStructureComparison* self, vtkTable* table) const
  {
    vtkMultiProcessController* controller = self->GetController();
    const bool isFirst =
      !filters::isDistributed(controller) || controller->GetLocalProcessId() == 0;
    const auto query = static_cast<lumitree::QueryKind>(self->GetQuery());
    const std::vector<lumitree::BuildOptions> rows = Rows(self);
    const double share = 1.0 / static_cast<double>(rows.size() + 1);
    std::unique_ptr<const filters::Cast> truth;
    if (self->CountDisagreements)
    {
      filters::Job job(self, 0.0, share);
      truth = this->Truth(self, query, job);
      filters::warnOfInvalidRays(self, truth->report(), this->Rays);
    }
    std::string leftOut;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      const double begin = share * static_cast<double>(i + 1);
      std::shared_ptr<const lumitree::Accelerator> accelerator;
      std::optional<filters::Trial> trial;
      bool stopped = false;
      std::string problem;
      try
      {
        filters::Job building(self, begin, begin + share / 2);
        accelerator = lumitree::build(this->Surface->surface, rows[i], building.control());
        filters::Job casting(self, begin + share / 2, begin + share);
        trial = filters::tryOut(*accelerator, query, this->Rays.batch,
          filters::queryOptions(self, *accelerator, casting), self->Repetitions, truth.get());
        stopped = !trial;
      }
      catch (const lumitree::BuildStopped&)
      {
        stopped = true;
      }
      catch (const std::exception& error)
      {
        problem = std::string(lumitree::name(rows[i].structure)) + " (" + error.what() + ")";
      }
      const long long worst = filters::largestOfAll(controller,
        stopped             ? 2
          : problem.empty() ? 0
                            : 1);
      if (worst == 2)
      {
        return;
      }
      if (worst == 1)
      {
        leftOut += (leftOut.empty() ? "" : "; ") + problem;
        continue;
      }
      trial->joinRanks(controller);
      filters::addComparison(*accelerator, accelerator->hierarchy(), *trial,
        { self->CountDisagreements, self->MeasureOverlap, isFirst }, table);
    }
    if (!leftOut.empty())
    {
      filters::reportWarning(self, "Left out: " + leftOut + ".");
    }
  }
};

vtkStandardNewMacro(vtkLumiStructureComparison);

vtkLumiStructureComparison::vtkLumiStructureComparison()
  : Impl(new Internals)
{
  this->SetNumberOfOutputPorts(1);
}

vtkLumiStructureComparison::~vtkLumiStructureComparison() = default;

void vtkLumiStructureComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sweep: " << this->Sweep << "\n";
  os << indent << "SweepMinimum: " << this->SweepMinimum << "\n";
  os << indent << "SweepMaximum: " << this->SweepMaximum << "\n";
  os << indent << "SweepSteps: " << this->SweepSteps << "\n";
  os << indent << "IncludeBruteForce: " << (this->IncludeBruteForce ? "on" : "off") << "\n";
  os << indent << "IncludeReferences: " << (this->IncludeReferences ? "on" : "off") << "\n";
  os << indent << "CountDisagreements: " << (this->CountDisagreements ? "on" : "off") << "\n";
  os << indent << "MeasureOverlap: " << (this->MeasureOverlap ? "on" : "off") << "\n";
  os << indent << "ReferenceStructure: " << this->ReferenceStructure << "\n";
  os << indent << "Repetitions: " << this->Repetitions << "\n";
}

int vtkLumiStructureComparison::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

int vtkLumiStructureComparison::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  return filters::makeOutputLike(vtkNew<vtkTable>(), outputs->GetInformationObject(0));
}

int vtkLumiStructureComparison::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = this->GetController();
  this->Impl->Surface = filters::surfaceFor(
    vtkDataObject::GetData(inputs[0], 0), controller, this, filters::GatherArrays::No);
  this->Impl->Rays = {};
  const bool ready = this->Impl->Surface &&
    filters::readRays(this, vtkDataObject::GetData(inputs[1], 0), this->Impl->Rays);
  // One whose rays are wrong keeps no other waiting.
  if (filters::largestOfAll(controller, ready ? 0 : 1) > 0)
  {
    return 1; // reported; returning 0 would make VTK report it a second time
  }
  vtkTable* table = vtkTable::GetData(outputs, 0);
  try
  {
    this->Impl->Compare(this, table);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
    table->Initialize();
  }
  return 1;
}

VTK_ABI_NAMESPACE_END
