// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiIllumination.h"

#include "LumiUnits.h"

#include "Radiometry/DirectIrradiance.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

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

/// The arrays of one quantity: the sum, and one per light where asked for.
class Outputs
{
public:
  Outputs(Quantity quantity, const Lights& lights, bool perLight, std::size_t size)
  {
    const QuantityName q = describe(quantity, lights.system);
    this->total_ = this->add(q, "", size);
    for (const Light& light : lights.lights)
    {
      if (perLight)
      {
        this->perLight_.push_back(this->add(q, " " + light.name, size));
      }
    }
  }

  [[nodiscard]] double* total() const { return this->total_; }
  [[nodiscard]] const std::vector<double*>& perLight() const { return this->perLight_; }

  /// Adds the arrays; the sum becomes the active scalars.
  void addTo(vtkDataSetAttributes* attributes) const
  {
    for (const auto& array : this->arrays_)
    {
      attributes->AddArray(array);
    }
    attributes->SetActiveScalars(this->arrays_.front()->GetName());
  }

private:
  double* add(const QuantityName& q, const std::string& suffix, std::size_t size)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    setUnit(array, std::string(q.name).c_str(), std::string(q.unit).c_str());
    array->SetName((array->GetName() + suffix).c_str());
    array->SetNumberOfValues(static_cast<vtkIdType>(size));
    this->arrays_.push_back(array);
    return array->GetPointer(0);
  }

  std::vector<vtkSmartPointer<vtkDoubleArray>> arrays_;
  double* total_;
  std::vector<double*> perLight_;
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

IlluminationReport Illumination::addTo(vtkDataSet* data, std::int64_t compositeIndex, int rank,
  bool shadowsItself, JobControl* control) const
{
  ReceiverInput input = readReceivers(data, this->location, this->threads);
  DirectOptions options;
  options.precision = this->precision;
  options.threads = this->threads;
  options.control = control;
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
  IlluminationReport report;
  const std::vector<const Source*> sources = this->lights.sources();
  Receivers receivers = viewOf(input);
  const auto compute = [&](Quantity quantity, Kind kind)
  {
    const Outputs outputs(quantity, this->lights, this->perLight, input.size());
    report.completed = report.completed &&
      directIrradiance(receivers, sources, outputs.total(), outputs.perLight(), options).completed;
    outputs.addTo(attributes);
    for (std::size_t i = 0; i < input.size(); ++i)
    {
      const bool counts = (input.kinds[i] == kind || input.kinds[i] == Kind::Undefined) &&
        (input.duplicate.empty() || !input.duplicate[i]);
      report.receivers += counts ? 1 : 0;
      report.undefined += counts && std::isnan(outputs.total()[i]) ? 1 : 0;
    }
  };

  const bool volumes = input.has(Kind::Volume);
  const bool planes = input.has(Kind::Plane) || !volumes;
  if (volumes)
  {
    // Scalar irradiance first: the active scalars are those set last.
    std::vector<double> positions = input.positions;
    for (std::size_t i = 0; i < input.size(); ++i)
    {
      if (input.kinds[i] != Kind::Volume)
      {
        positions[3 * i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
    receivers.positions = positions.data();
    compute(Quantity::ScalarIrradiance, Kind::Volume);
    receivers.positions = input.positions.data();
  }
  if (planes)
  {
    receivers.normals = input.normals.data();
    compute(Quantity::Irradiance, Kind::Plane);
  }
  return report;
}

} // namespace lumitree::filters
