// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiRayCast.h"

#include "LumiCache.h"
#include "LumiCast.h"
#include "LumiCastArrays.h"
#include "LumiGather.h"
#include "LumiPorts.h"
#include "LumiRaysOutput.h"
#include "LumiSettings.h"
#include "LumiSourceSkips.h"
#include "LumiStatisticsTable.h"
#include "LumiStopwatch.h"
#include "LumiSurfaceCost.h"
#include "LumiSurfaceData.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <exception>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace filters = lumitree::filters;

namespace
{
/// Of the progress bar, for the structure.
constexpr double buildShare = 0.3;
}

struct vtkLumiRayCast::Internals
{
  std::shared_ptr<const filters::Tree> Tree; ///< kept so that the next execution finds it

  /// Casts the rays over the tree, adds to tests (one per primitive, or none) and fills the outputs
  /// of hits, rays and statistics; seconds holds what went before. Throws what the accelerator
  /// throws.
  static void Cast(vtkLumiRayCast* self, const filters::RayInput& rays, vtkDataSet* raysInput,
    filters::CastSeconds seconds, std::vector<lumitree::PrimitiveCounters>& tests,
    vtkPolyData* hitsOutput, vtkDataSet* raysOutput, vtkTable* statistics);

  /// Sets what the rays skip, when they are to skip their sources; false after one vtkErrorMacro.
  static bool SkipSources(vtkLumiRayCast* self, vtkDataSet* raysInput, filters::RayInput& rays,
    filters::SourceSkips& skips);

  /// Fills the output that is the surface.
  static void MakeSurface(vtkLumiRayCast* self,
    const std::vector<lumitree::PrimitiveCounters>& tests, vtkDataObject* input,
    vtkDataObject* output);

  /// Fills the output of a cast that gives hits.
  static void MakeHits(vtkLumiRayCast* self, const filters::RayInput& rays,
    const filters::Cast& cast, const filters::HitLayout& layout, vtkPolyData* hits);
};

vtkStandardNewMacro(vtkLumiRayCast);

vtkLumiRayCast::vtkLumiRayCast()
  : Impl(new Internals)
{
  this->SetNumberOfOutputPorts(4);
}

vtkLumiRayCast::~vtkLumiRayCast() = default;

void vtkLumiRayCast::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PassSurfaceData: " << (this->PassSurfaceData ? "on" : "off") << "\n";
  os << indent << "CountTraversal: " << (this->CountTraversal ? "on" : "off") << "\n";
  os << indent << "SkipSource: " << (this->SkipSource ? "on" : "off") << "\n";
  os << indent << "RoundedParameter: " << (this->RoundedParameter ? "on" : "off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}

int vtkLumiRayCast::FillOutputPortInformation(int port, vtkInformation* info)
{
  constexpr const char* types[] = { "vtkPolyData", "vtkDataObject", "vtkDataObject", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

int vtkLumiRayCast::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!vtkPolyData::GetData(outputs, 0))
  {
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
  }
  if (!vtkTable::GetData(outputs, 3))
  {
    outputs->GetInformationObject(3)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  }
  const int surface =
    filters::makeOutputLike(vtkDataObject::GetData(inputs[0], 0), outputs->GetInformationObject(2));
  const int rays =
    filters::makeOutputLike(vtkDataObject::GetData(inputs[1], 0), outputs->GetInformationObject(1));
  return surface && rays ? 1 : 0;
}

int vtkLumiRayCast::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // First what all ranks do together, so that a rank whose rays are wrong keeps no other waiting.
  filters::Job buildJob(this, 0.0, buildShare);
  this->Impl->Tree = filters::treeFor(vtkDataObject::GetData(inputs[0], 0),
    filters::buildOptions(this), this->GetController(), this,
    this->PassSurfaceData ? filters::GatherArrays::Yes : filters::GatherArrays::No,
    buildJob.control(), filters::treeSource(this, this->Impl->Tree));

  if (!this->Impl->Tree)
  {
    return 1; // reported, or stopped; returning 0 would make VTK report it a second time
  }
  std::vector<lumitree::PrimitiveCounters> tests(
    this->CountTraversal ? this->Impl->Tree->input->surface->size() : 0);
  bool complete = false;
  try
  {
    filters::CastSeconds seconds;
    seconds.surface = this->Impl->Tree->surfaceSeconds;
    seconds.build = this->Impl->Tree->buildSeconds;
    filters::Stopwatch stopwatch;
    filters::RayInput rays;
    filters::SourceSkips skips;
    vtkDataObject* raysInput = vtkDataObject::GetData(inputs[1], 0);
    if (filters::readRays(this, raysInput, rays) &&
      Internals::SkipSources(this, vtkDataSet::SafeDownCast(raysInput), rays, skips))
    {
      seconds.rays = stopwatch.lap();
      Internals::Cast(this, rays, vtkDataSet::SafeDownCast(raysInput), seconds, tests,
        vtkPolyData::GetData(outputs, 0), vtkDataSet::GetData(outputs, 1),
        vtkTable::GetData(outputs, 3));
      complete = true;
    }
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
  filters::sumOverRanks(tests, this->GetController());
  if (complete)
  {
    Internals::MakeSurface(
      this, tests, vtkDataObject::GetData(inputs[0], 0), vtkDataObject::GetData(outputs, 2));
  }
  return 1;
}

bool vtkLumiRayCast::Internals::SkipSources(
  vtkLumiRayCast* self, vtkDataSet* raysInput, filters::RayInput& rays, filters::SourceSkips& skips)
{
  if (!self->SkipSource)
  {
    return true;
  }
  vtkMultiProcessController* controller = self->GetController();
  const int rank = filters::isDistributed(controller) ? controller->GetLocalProcessId() : 0;
  if (!filters::readSourceSkips(raysInput, rays, *self->Impl->Tree->input, rank,
        filters::threadsFor(self->GetNumberOfThreads()), skips, self))
  {
    return false;
  }
  rays.batch.skip = skips.sets();
  return true;
}

void vtkLumiRayCast::Internals::Cast(vtkLumiRayCast* self, const filters::RayInput& rays,
  vtkDataSet* raysInput, filters::CastSeconds seconds,
  std::vector<lumitree::PrimitiveCounters>& tests, vtkPolyData* hitsOutput, vtkDataSet* raysOutput,
  vtkTable* statistics)
{
  filters::Stopwatch stopwatch;
  const filters::Tree& tree = *self->Impl->Tree;
  const filters::Buffer<lumitree::RayCounters> counters(self->CountTraversal ? rays.batch.size : 0);
  filters::Job job(self, buildShare, 0.9);
  lumitree::QueryOptions options = filters::queryOptions(self, *tree.accelerator, job);
  options.perRay = counters.data();
  options.perPrimitive = tests.empty() ? nullptr : tests.data();
  options.roundedT = self->RoundedParameter && options.precision == lumitree::Precision::Exact;
  const filters::Cast cast(
    static_cast<lumitree::QueryKind>(self->GetQuery()), *tree.accelerator, rays.batch, options);
  seconds.cast = stopwatch.lap();
  filters::warnOfInvalidRays(self, cast.report(), rays);

  // When the user stopped the cast, the rays that were not reached are misses. What follows is
  // short and runs to its end, so that the outputs are whole.
  std::optional<filters::HitLayout> layout;
  if (cast.givesHits())
  {
    layout.emplace(cast, options.threads);
    MakeHits(self, rays, cast, *layout, hitsOutput);
  }
  vtkDataSetAttributes* data = filters::makeRaysOutput(raysInput, rays, raysOutput);
  const filters::HitTotals totals = filters::addRayArrays(
    cast, layout ? &*layout : nullptr, *tree.input, counters.data(), options.threads, data);
  seconds.output = stopwatch.lap();
  filters::makeCastTable(*tree.accelerator, cast, options.precision, totals, seconds, statistics);
}

void vtkLumiRayCast::Internals::MakeSurface(vtkLumiRayCast* self,
  const std::vector<lumitree::PrimitiveCounters>& tests, vtkDataObject* input,
  vtkDataObject* output)
{
  filters::copySurface(input, output);
  if (self->CountTraversal)
  {
    vtkMultiProcessController* controller = self->GetController();
    const filters::Tree& tree = *self->Impl->Tree;
    filters::addSurfaceCost(*tree.input, *tree.accelerator, tests,
      controller ? controller->GetLocalProcessId() : 0, output);
  }
}

void vtkLumiRayCast::Internals::MakeHits(vtkLumiRayCast* self, const filters::RayInput& rays,
  const filters::Cast& cast, const filters::HitLayout& layout, vtkPolyData* hits)
{
  const filters::SurfaceInput& surface = *self->Impl->Tree->input;
  const bool anyDouble =
    rays.doublePoints || surface.surface->scalar() == lumitree::ArrayView::Scalar::Double;
  filters::HitOptions options;
  options.doublePoints = self->OutputPointsPrecision == DEFAULT_PRECISION
    ? anyDouble
    : self->OutputPointsPrecision == DOUBLE_PRECISION;
  options.processIds = filters::isDistributed(self->GetController());
  options.threads = filters::threadsFor(self->GetNumberOfThreads());
  const filters::Buffer<lumitree::PrimitiveId> primitives(static_cast<std::size_t>(layout.total));
  filters::makeHits(cast, layout, rays.batch, surface, options, primitives.data(), hits);
  if (self->PassSurfaceData)
  {
    filters::addSurfaceData(surface, primitives.data(), options.threads, hits);
  }
}

VTK_ABI_NAMESPACE_END
