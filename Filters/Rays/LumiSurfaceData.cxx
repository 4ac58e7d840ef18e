// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSurfaceData.h"

#include "Accel/Parallel.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <string>
#include <vector>

namespace lumitree::filters
{

namespace
{

/// One array of the hits and where each leaf keeps its own; null for a leaf that nothing can hit.
struct PassedArray
{
  vtkAbstractArray* target;
  std::vector<vtkAbstractArray*> sources;
};

vtkDataSetAttributes* attributesOf(vtkDataSet* leaf, bool points)
{
  return points ? static_cast<vtkDataSetAttributes*>(leaf->GetPointData()) : leaf->GetCellData();
}

bool passes(vtkDataSetAttributes* data, int index, bool points)
{
  vtkAbstractArray* array = data->GetAbstractArray(index);
  const int attribute = data->IsArrayAnAttribute(index);
  const bool isId =
    attribute == vtkDataSetAttributes::GLOBALIDS || attribute == vtkDataSetAttributes::PEDIGREEIDS;
  return array && array->GetName() &&
    array->GetName() != std::string(vtkDataSetAttributes::GhostArrayName()) &&
    !(points && (isId || !vtkDataArray::SafeDownCast(array)));
}

/// The leaves that something can hit.
std::vector<std::size_t> occupiedLeaves(const SurfaceInput& surface)
{
  std::vector<std::size_t> occupied;
  for (std::size_t i = 0; i < surface.leaves.size(); ++i)
  {
    const std::size_t end =
      i + 1 < surface.leaves.size() ? surface.firstPrimitive[i + 1] : surface.surface->size();
    if (surface.firstPrimitive[i] < end)
    {
      occupied.push_back(i);
    }
  }
  return occupied;
}

/// Makes the arrays of the hits that all leaves can fill.
std::vector<PassedArray> commonArrays(const SurfaceInput& surface, bool points, vtkPolyData* hits)
{
  std::vector<PassedArray> passed;
  const std::vector<std::size_t> occupied = occupiedLeaves(surface);
  if (occupied.empty())
  {
    return passed;
  }
  vtkDataSetAttributes* first = attributesOf(surface.leaves[occupied[0]].data, points);
  for (int a = 0; a < first->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* model = first->GetAbstractArray(a);
    if (!passes(first, a, points) || hits->GetPointData()->HasArray(model->GetName()))
    {
      continue;
    }
    PassedArray array{ nullptr, std::vector<vtkAbstractArray*>(surface.leaves.size(), nullptr) };
    bool everywhere = true;
    for (const std::size_t leaf : occupied)
    {
      vtkAbstractArray* source =
        attributesOf(surface.leaves[leaf].data, points)->GetAbstractArray(model->GetName());
      everywhere = everywhere && source && source->GetDataType() == model->GetDataType() &&
        source->GetNumberOfComponents() == model->GetNumberOfComponents();
      array.sources[leaf] = source;
    }
    if (everywhere)
    {
      const auto target = vtkSmartPointer<vtkAbstractArray>::Take(
        vtkAbstractArray::CreateArray(model->GetDataType()));
      target->SetName(model->GetName());
      target->SetNumberOfComponents(model->GetNumberOfComponents());
      target->CopyComponentNames(model);
      target->CopyInformation(model->GetInformation());
      target->SetNumberOfTuples(hits->GetNumberOfPoints());
      hits->GetPointData()->AddArray(target);
      array.target = target;
      passed.push_back(array);
    }
  }
  return passed;
}

/// The vertices of the triangle that was hit and their weights.
class Weights
{
public:
  void set(const std::array<vtkIdType, 3>& points, const double* uv)
  {
    const double all[3] = { 1.0 - uv[0] - uv[1], uv[0], uv[1] };
    this->ids_->Reset();
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      if (points[k] >= 0)
      {
        this->weights_[this->ids_->GetNumberOfIds()] = all[k];
        this->ids_->InsertNextId(points[k]);
        sum += all[k];
      }
    }
    if (this->ids_->GetNumberOfIds() < 3)
    {
      for (vtkIdType k = 0; k < this->ids_->GetNumberOfIds(); ++k)
      {
        this->weights_[k] =
          sum > 0.0 ? this->weights_[k] / sum : 1.0 / this->ids_->GetNumberOfIds();
      }
    }
  }

  void interpolate(vtkIdType hit, vtkAbstractArray* source, vtkAbstractArray* target)
  {
    target->InterpolateTuple(hit, this->ids_, source, this->weights_);
  }

private:
  vtkNew<vtkIdList> ids_;
  double weights_[3] = { 0.0, 0.0, 0.0 };
};

} // namespace

void addSurfaceData(
  const SurfaceInput& surface, const PrimitiveId* primitives, int threads, vtkPolyData* hits)
{
  const double* uv =
    vtkDoubleArray::SafeDownCast(hits->GetPointData()->GetArray("UV"))->GetPointer(0);
  const std::vector<PassedArray> pointArrays = commonArrays(surface, true, hits);
  const std::vector<PassedArray> cellArrays = commonArrays(surface, false, hits);
  if (pointArrays.empty() && cellArrays.empty())
  {
    return;
  }
  // A multiple of eight, so that no two threads write the same byte of an array of bits.
  constexpr std::size_t chunk = 4096;
  parallelFor(static_cast<std::size_t>(hits->GetNumberOfPoints()), chunk, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      Weights weights;
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto hit = static_cast<vtkIdType>(i);
        const std::size_t leaf = surface.leafOf(primitives[i]);
        if (!pointArrays.empty())
        {
          weights.set(surface.leafPointIds(primitives[i]), uv + 2 * i);
        }
        for (const PassedArray& array : pointArrays)
        {
          weights.interpolate(hit, array.sources[leaf], array.target);
        }
        for (const PassedArray& array : cellArrays)
        {
          array.target->SetTuple(hit, surface.leafCellId(primitives[i]), array.sources[leaf]);
        }
      }
    });
}

} // namespace lumitree::filters
