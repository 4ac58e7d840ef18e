// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRayDisagreement.h"

#include "LumiArrays.h"
#include "LumiCache.h"
#include "LumiDisagreement.h"
#include "LumiGather.h"
#include "LumiPorts.h"
#include "LumiReport.h"
#include "LumiRow.h"
#include "LumiSettings.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <exception>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

namespace
{

using lumitree::operator+;
using lumitree::operator-;
using lumitree::operator*;

/// Of the progress bar, for both structures.
constexpr double BuildShare = 0.3;

/// A ray on which the two differ, with the answers copied.
struct Found
{
  std::size_t Ray = 0;
  filters::Disagreement Kind = filters::Disagreement::Missed;
  lumitree::Hit Hits[2];
  vtkIdType Counts[2] = { 0, 0 };
};

/// Rays, agreements and disagreements by kind.
using Tally = std::array<vtkIdType, filters::disagreementKinds + 2>;

/// Where the drawn line ends: at the farther hit, else beyond the scene.
double EndOf(const Found& found, const lumitree::Ray& ray, const lumitree::Box& scene)
{
  double end = -1.0;
  for (const lumitree::Hit& hit : found.Hits)
  {
    end = hit.primitive != lumitree::noPrimitive ? std::max(end, hit.t) : end;
  }
  if (end >= 0.0)
  {
    return end;
  }
  const double reach =
    lumitree::length(scene.size()) + lumitree::length(ray.origin - scene.centre());
  return std::min(ray.tMax, reach / lumitree::length(ray.direction));
}

void Draw(const std::vector<Found>& found, const lumitree::RayBatch& rays,
  const filters::SurfaceInput& surface, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(found.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(2 * count);
  vtkNew<vtkCellArray> lines;
  vtkCellData* data = output->GetCellData();
  auto* const rayIds = filters::addArray<vtkIdTypeArray>(data, "RayId", count);
  auto* const kinds = filters::addArray<vtkIntArray>(data, "Kind", count);
  struct Answer
  {
    double* t;
    vtkIdType* cell;
    int* composite;
    vtkIdType* hits;
  };
  const auto answer = [&](const std::string& prefix)
  {
    return Answer{ filters::addArray<vtkDoubleArray>(data, (prefix + "T").c_str(), count),
      filters::addArray<vtkIdTypeArray>(data, (prefix + "CellId").c_str(), count),
      filters::addArray<vtkIntArray>(data, (prefix + "CompositeIndex").c_str(), count),
      filters::addArray<vtkIdTypeArray>(data, (prefix + "HitCount").c_str(), count) };
  };
  const Answer answers[2] = { answer(""), answer("Other") };
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Found& one = found[static_cast<std::size_t>(i)];
    const lumitree::Ray ray = rays[one.Ray];
    const lumitree::Vec3 end =
      ray.origin + EndOf(one, ray, surface.surface->bounds()) * ray.direction;
    points->SetPoint(2 * i, ray.origin.data());
    points->SetPoint(2 * i + 1, end.data());
    lines->InsertNextCell({ 2 * i, 2 * i + 1 });
    rayIds[i] = static_cast<vtkIdType>(one.Ray);
    kinds[i] = static_cast<int>(one.Kind);
    for (int k = 0; k < 2; ++k)
    {
      const lumitree::Hit& hit = one.Hits[k];
      const bool isHit = hit.primitive != lumitree::noPrimitive;
      const lumitree::SourceCell source =
        isHit ? surface.surface->source(hit.primitive) : lumitree::SourceCell{ -1, -1 };
      answers[k].t[i] = hit.t;
      answers[k].cell[i] = source.cell;
      answers[k].composite[i] = static_cast<int>(source.composite);
      answers[k].hits[i] = one.Counts[k];
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  data->SetActiveScalars("Kind");
}

/// The sums over all ranks. Collective.
Tally SumOverRanks(const Tally& tally, vtkMultiProcessController* controller)
{
  if (!filters::isDistributed(controller))
  {
    return tally;
  }
  Tally sum{};
  controller->AllReduce(
    tally.data(), sum.data(), static_cast<vtkIdType>(tally.size()), vtkCommunicator::SUM_OP);
  return sum;
}

} // namespace

struct vtkLumiRayDisagreement::Internals
{
  std::shared_ptr<const filters::Tree> Trees[2]; ///< kept so that the next execution finds them

  /// Builds both structures. Collective; false when an error was reported.
  bool Build(vtkLumiRayDisagreement* self, vtkDataObject* surface)
  {
    lumitree::BuildOptions options[2] = { filters::buildOptions(self),
      filters::buildOptions(self) };
    options[1].structure = static_cast<lumitree::Structure>(self->OtherStructure);
    for (int k = 0; k < 2; ++k)
    {
      filters::Job job(self, k * BuildShare / 2, (k + 1) * BuildShare / 2);
      this->Trees[k] = filters::treeFor(
        surface, options[k], self->GetController(), self, filters::GatherArrays::No, job.control());
      if (!this->Trees[k])
      {
        return false;
      }
    }
    return true;
  }

  /// Asks both and lists where they differ. Throws what the accelerators throw.
  std::vector<Found> Compare(
    vtkLumiRayDisagreement* self, const filters::RayInput& rays, Tally& tally) const
  {
    const auto query = static_cast<lumitree::QueryKind>(self->GetQuery());
    filters::Job job(self, BuildShare, 0.6);
    lumitree::QueryOptions options = filters::queryOptions(self, *this->Trees[0]->accelerator, job);
    const filters::Cast cast(query, *this->Trees[0]->accelerator, rays.batch, options);
    filters::warnOfInvalidRays(self, cast.report(), rays);
    filters::Job otherJob(self, 0.6, 0.9);
    options.control = otherJob.control();
    options.precision =
      filters::precisionOf(self->OtherPrecision, this->Trees[1]->accelerator.get());
    const filters::Cast other(query, *this->Trees[1]->accelerator, rays.batch, options);
    std::vector<Found> found;
    if (!cast.report().completed || !other.report().completed)
    {
      return found; // stopped: what was not reached would seem to be missed
    }
    for (std::size_t i = 0; i < rays.batch.size; ++i)
    {
      const auto differs = filters::difference(cast, other, i, self->Tolerance);
      ++tally[0];
      ++tally[differs ? 2 + static_cast<std::size_t>(differs->kind) : 1];
      if (differs)
      {
        found.push_back({ i, differs->kind,
          { differs->hit ? *differs->hit : lumitree::Hit{},
            differs->other ? *differs->other : lumitree::Hit{} },
          { cast.count(i), other.count(i) } });
      }
    }
    return found;
  }

  void Count(vtkLumiRayDisagreement* self, const Tally& tally, bool present, vtkTable* table) const
  {
    filters::Row row(table, present);
    row.add("Structure", lumitree::name(this->Trees[0]->accelerator->options().structure));
    row.add("Precision",
      lumitree::name(
        filters::precisionOf(self->GetPrecision(), this->Trees[0]->accelerator.get())));
    row.add("OtherStructure", lumitree::name(this->Trees[1]->accelerator->options().structure));
    row.add("OtherPrecision",
      lumitree::name(
        filters::precisionOf(self->OtherPrecision, this->Trees[1]->accelerator.get())));
    row.add("Rays", static_cast<std::uint64_t>(tally[0]));
    row.add("Agree", static_cast<std::uint64_t>(tally[1]));
    for (int kind = 0; kind < filters::disagreementKinds; ++kind)
    {
      row.add(filters::name(static_cast<filters::Disagreement>(kind)),
        static_cast<std::uint64_t>(tally[static_cast<std::size_t>(kind) + 2]));
    }
  }
};

vtkStandardNewMacro(vtkLumiRayDisagreement);

vtkLumiRayDisagreement::vtkLumiRayDisagreement()
  : Impl(new Internals)
{
  this->SetPrecision(Fast);
}

vtkLumiRayDisagreement::~vtkLumiRayDisagreement() = default;

void vtkLumiRayDisagreement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OtherStructure: " << this->OtherStructure << "\n";
  os << indent << "OtherPrecision: " << this->OtherPrecision << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}

int vtkLumiRayDisagreement::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkLumiRayDisagreement::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  filters::makeOutputLike(vtkNew<vtkPolyData>(), outputs->GetInformationObject(0));
  filters::makeOutputLike(vtkNew<vtkTable>(), outputs->GetInformationObject(1));
  return 1;
}

int vtkLumiRayDisagreement::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = this->GetController();
  if (!this->Impl->Build(this, vtkDataObject::GetData(inputs[0], 0)))
  {
    return 1; // reported; returning 0 would make VTK report it a second time
  }
  std::vector<Found> found;
  Tally tally{};
  filters::RayInput rays;
  bool complete = false;
  try
  {
    if (filters::readRays(this, vtkDataObject::GetData(inputs[1], 0), rays))
    {
      found = this->Impl->Compare(this, rays, tally);
      complete = true;
    }
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
  // All ranks come here, so that one whose rays are wrong keeps no other waiting.
  const bool allComplete = filters::largestOfAll(controller, complete ? 0 : 1) == 0;
  const Tally sum = SumOverRanks(tally, controller);
  if (allComplete)
  {
    const bool isFirst =
      !filters::isDistributed(controller) || controller->GetLocalProcessId() == 0;
    Draw(found, rays.batch, *this->Impl->Trees[0]->input, vtkPolyData::GetData(outputs, 0));
    this->Impl->Count(this, sum, isFirst, vtkTable::GetData(outputs, 1));
  }
  return 1;
}

VTK_ABI_NAMESPACE_END
