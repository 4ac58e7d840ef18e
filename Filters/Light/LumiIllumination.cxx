// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiIllumination.h"

#include "LumiUnits.h"

#include "Radiometry/LightEstimate.h"
#include "Radiometry/SkySource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lumitree::filters
{

namespace
{

using Kind = ReceiverInput::Kind;

/// Whether two datasets are the same cells on the same points; shallow copies share both.
bool sameGeometry(vtkDataSet* a, vtkDataSet* b)
{
  if (auto* p = vtkPolyData::SafeDownCast(a))
  {
    auto* q = vtkPolyData::SafeDownCast(b);
    return q && p->GetPoints() == q->GetPoints() && p->GetVerts() == q->GetVerts() &&
      p->GetLines() == q->GetLines() && p->GetPolys() == q->GetPolys() &&
      p->GetStrips() == q->GetStrips();
  }
  if (auto* p = vtkUnstructuredGrid::SafeDownCast(a))
  {
    auto* q = vtkUnstructuredGrid::SafeDownCast(b);
    return q && p->GetPoints() == q->GetPoints() && p->GetCells() == q->GetCells();
  }
  return false;
}

/// The leaf of the occluders that a dataset is.
std::optional<std::size_t> findOwnLeaf(vtkDataSet* data, const SurfaceInput& occluders,
  std::int64_t compositeIndex, int rank, bool shadowsItself)
{
  if (shadowsItself)
  {
    return occluders.findLeaf(compositeIndex, rank);
  }
  const auto& leaves = occluders.leaves;
  const auto found = std::find_if(leaves.begin(), leaves.end(),
    [&](const SurfaceLeaf& leaf) { return sameGeometry(data, leaf.data); });
  return found == leaves.end()
    ? std::nullopt
    : std::optional<std::size_t>(static_cast<std::size_t>(found - leaves.begin()));
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Arrays of one dataset, made when they are first asked for; then added all at once.
class ArraySet
{
public:
  explicit ArraySet(std::size_t size)
    : size_(static_cast<vtkIdType>(size))
  {
  }

  /// Of a quantity with a unit; NaN where nothing is written.
  double* numbers(const std::string& name, const std::string& unit, const std::string& suffix = "",
    int components = 1)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    setUnit(array, name.c_str(), unit.c_str());
    array->SetName((array->GetName() + suffix).c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->size_);
    array->Fill(nan);
    this->arrays_.push_back(array);
    return array->GetPointer(0);
  }

  unsigned char* marks(const char* name)
  {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName(name);
    array->SetNumberOfValues(this->size_);
    array->Fill(0);
    this->arrays_.push_back(array);
    return array->GetPointer(0);
  }

  int* counts(const char* name)
  {
    auto array = vtkSmartPointer<vtkIntArray>::New();
    array->SetName(name);
    array->SetNumberOfValues(this->size_);
    array->Fill(0);
    this->arrays_.push_back(array);
    return array->GetPointer(0);
  }

  /// The array made first becomes the active scalars.
  void addTo(vtkDataSetAttributes* attributes) const
  {
    for (const auto& array : this->arrays_)
    {
      attributes->AddArray(array);
    }
    attributes->SetActiveScalars(this->arrays_.front()->GetName());
  }

private:
  vtkIdType size_;
  std::vector<vtkSmartPointer<vtkDataArray>> arrays_;
};

/// Where all the numbers of one dataset go.
struct Outputs
{
  double* plane = nullptr; ///< irradiance; null where there are only volumes
  double* volume =
    nullptr; ///< scalar irradiance; null where neither volumes are nor it is asked for
  bool scalarOfPlanes = false;
  double* back = nullptr;
  double* vector = nullptr;
  double* cylindrical = nullptr;
  double* hemispherical = nullptr;
  double* lower = nullptr;
  double* upper = nullptr;
  unsigned char* method = nullptr;
  int* rays = nullptr;
  unsigned char* shadow = nullptr;
  unsigned char* penumbra = nullptr;
  std::vector<double*> planeOf; ///< per light
  std::vector<double*> volumeOf;

  Outputs(ArraySet& set, const Lights& lights, const IlluminationArrays& wanted, bool planes,
    bool volumes)
  {
    const QuantityName e = describe(Quantity::Irradiance, lights.system);
    const QuantityName e0 = describe(Quantity::ScalarIrradiance, lights.system);
    const std::string unit(e.unit);
    const auto named = [&](const char* prefix, const QuantityName& q, const char* suffix = "")
    { return prefix + std::string(q.name) + suffix; };
    const auto perLight = [&](const QuantityName& q, std::vector<double*>& to)
    {
      for (const Light& light : lights.lights)
      {
        if (wanted.perLight)
        {
          to.push_back(set.numbers(std::string(q.name), unit, " " + light.name));
        }
      }
    };
    if (planes)
    {
      this->plane = set.numbers(std::string(e.name), unit);
      perLight(e, this->planeOf);
    }
    this->scalarOfPlanes = wanted.scalar;
    if (volumes || wanted.scalar)
    {
      this->volume = set.numbers(std::string(e0.name), unit);
    }
    if (volumes)
    {
      perLight(e0, this->volumeOf);
    }
    if (planes && wanted.back)
    {
      this->back = set.numbers(named("Back", e), unit);
    }
    if (wanted.vector)
    {
      this->vector = set.numbers("LightVector", unit, "", 3);
    }
    if (wanted.cylindrical)
    {
      this->cylindrical = set.numbers(named("Cylindrical", e), unit);
    }
    if (planes && wanted.hemispherical)
    {
      this->hemispherical = set.numbers(named("Hemispherical", e), unit);
    }
    if (wanted.estimates)
    {
      const QuantityName& main = planes ? e : e0;
      this->lower = set.numbers(named("", main, "Lower"), unit);
      this->upper = set.numbers(named("", main, "Upper"), unit);
      this->method = set.marks("EstimateMethod");
      this->rays = set.counts("RayCount");
    }
    if (wanted.masks)
    {
      this->shadow = set.marks("ShadowMask");
      this->penumbra = set.marks("PenumbraMask");
    }
  }
};

/// Numbers of the receivers of one kind, before they go where the others are.
class Run
{
public:
  Run(std::size_t size, const Outputs& to, bool sided)
    : size_(size)
    , to_(to)
    , sided_(sided)
  {
  }

  EstimateOutputs& outputs()
  {
    const auto room = [&](double* wanted, int components = 1) -> double*
    {
      if (!wanted)
      {
        return nullptr;
      }
      this->numbers_.emplace_back(
        wanted, std::vector<double>(this->size_ * static_cast<std::size_t>(components)));
      return this->numbers_.back().second.data();
    };
    this->numbers_.reserve(16 + this->to_.planeOf.size() + this->to_.volumeOf.size());
    EstimateOutputs& out = this->outputs_;
    out.irradiance = this->sided_ ? room(this->to_.plane) : nullptr;
    out.scalar = !this->sided_ || this->to_.scalarOfPlanes ? room(this->to_.volume) : nullptr;
    out.back = this->sided_ ? room(this->to_.back) : nullptr;
    out.vector = room(this->to_.vector, 3);
    out.cylindrical = room(this->to_.cylindrical);
    out.hemispherical = this->sided_ ? room(this->to_.hemispherical) : nullptr;
    out.lower = room(this->to_.lower);
    out.upper = room(this->to_.upper);
    for (double* light : this->sided_ ? this->to_.planeOf : this->to_.volumeOf)
    {
      out.perSource.push_back(room(light));
    }
    this->methods_.resize(this->size_);
    this->shadows_.resize(this->size_);
    this->rays_.resize(this->size_);
    out.method = this->methods_.data();
    out.shadow = this->shadows_.data();
    out.rays = this->rays_.data();
    return out;
  }

  /// Receiver i is of this kind: its numbers are taken over.
  void take(std::size_t i) const
  {
    for (const auto& [to, from] : this->numbers_)
    {
      const std::size_t components = from.size() / this->size_;
      std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(components * i), components,
        to + components * i);
    }
    if (this->to_.method)
    {
      this->to_.method[i] = static_cast<unsigned char>(this->methods_[i]);
      this->to_.rays[i] = static_cast<int>(this->rays_[i]);
    }
    if (this->to_.shadow)
    {
      this->to_.shadow[i] = this->shadows_[i] == ShadowState::Umbra ? 1 : 0;
      this->to_.penumbra[i] = this->shadows_[i] == ShadowState::Penumbra ? 1 : 0;
    }
  }

private:
  std::size_t size_;
  const Outputs& to_;
  bool sided_;
  EstimateOutputs outputs_;
  std::vector<std::pair<double*, std::vector<double>>> numbers_;
  std::vector<EstimateMethod> methods_;
  std::vector<ShadowState> shadows_;
  std::vector<std::uint32_t> rays_;
};

Receivers viewOf(const ReceiverInput& input)
{
  Receivers receivers;
  receivers.size = input.size();
  receivers.positions = input.positions.data();
  receivers.stored = input.stored;
  if (!input.skipOffsets.empty())
  {
    receivers.skip.offsets = input.skipOffsets.data();
    receivers.skip.primitives = input.skipPrimitives.data();
  }
  return receivers;
}

} // namespace

void IlluminationStatistics::add(double value)
{
  ++this->count;
  this->sum += value;
  this->minimum = std::min(this->minimum, value);
  this->maximum = std::max(this->maximum, value);
}

void IlluminationStatistics::add(const IlluminationStatistics& other)
{
  this->count += other.count;
  this->sum += other.sum;
  this->minimum = std::min(this->minimum, other.minimum);
  this->maximum = std::max(this->maximum, other.maximum);
}

double Illumination::outdoorIrradiance() const
{
  double sum = 0.0;
  for (const Light& light : this->lights.lights)
  {
    if (const auto* sky = dynamic_cast<const SkySource*>(light.source.get()))
    {
      sum += sky->irradiance({ 0.0, 0.0, 0.0 }, sky->up());
    }
  }
  return sum;
}

IlluminationReport Illumination::addTo(vtkDataSet* data, std::int64_t compositeIndex, int rank,
  bool shadowsItself, JobControl* control) const
{
  ReceiverInput input = readReceivers(data, this->location, this->threads);
  EstimateOptions options;
  options.precision = this->precision;
  options.threads = this->threads;
  options.control = control;
  options.relativeTolerance = this->relativeTolerance;
  options.absoluteTolerance = this->absoluteTolerance;
  options.maximumRays = this->maximumRays;
  if (this->tree)
  {
    options.occluders = this->tree->accelerator.get();
    const SurfaceInput& occluders = *this->tree->input;
    if (const auto leaf = findOwnLeaf(data, occluders, compositeIndex, rank, shadowsItself))
    {
      findSkips(input, this->location, occluders, *leaf, this->threads);
    }
  }

  vtkDataSetAttributes* attributes = data->GetCellData();
  if (this->location == ReceiverLocation::Points)
  {
    attributes = data->GetPointData();
  }
  else
  {
    // Viewers prefer active scalars on points, here those of the input.
    data->GetPointData()->SetActiveScalars(nullptr);
  }
  const std::vector<const Source*> sources = this->lights.sources();
  const bool volumes = input.has(Kind::Volume);
  const bool planes = input.has(Kind::Plane) || !volumes;
  ArraySet made(input.size());
  const Outputs outputs(made, this->lights, this->arrays, planes, volumes);
  IlluminationReport report;
  report.quantity = planes ? Quantity::Irradiance : Quantity::ScalarIrradiance;
  const auto compute = [&](Kind kind)
  {
    Receivers receivers = viewOf(input);
    // Receivers of the other kinds are none here.
    std::vector<double> positions = input.positions;
    for (std::size_t i = 0; i < input.size(); ++i)
    {
      if (input.kinds[i] != kind)
      {
        positions[3 * i] = nan;
      }
    }
    receivers.positions = positions.data();
    if (kind == Kind::Plane)
    {
      receivers.normals = input.normals.data();
    }
    Run run(input.size(), outputs, kind == Kind::Plane);
    const EstimateReport estimate = estimateLight(receivers, sources, run.outputs(), options);
    report.completed = report.completed && estimate.completed;
    report.missed += estimate.missedTolerance;
    const double* main = kind == Kind::Plane ? outputs.plane : outputs.volume;
    for (std::size_t i = 0; i < input.size(); ++i)
    {
      if (input.kinds[i] == kind)
      {
        run.take(i);
      }
      const bool counts = (input.kinds[i] == kind || input.kinds[i] == Kind::Undefined) &&
        (input.duplicate.empty() || !input.duplicate[i]);
      report.receivers += counts ? 1 : 0;
      report.undefined += counts && std::isnan(main[i]) ? 1 : 0;
      if (counts && std::isfinite(main[i]) && (kind == Kind::Plane) == planes)
      {
        report.statistics.add(main[i]);
      }
    }
  };
  if (volumes)
  {
    compute(Kind::Volume);
  }
  if (planes)
  {
    compute(Kind::Plane);
  }
  made.addTo(attributes);
  return report;
}

} // namespace lumitree::filters
