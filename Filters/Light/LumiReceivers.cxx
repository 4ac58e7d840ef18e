// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiReceivers.h"

#include "LumiCells.h"

#include "Accel/Parallel.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace lumitree::filters
{

namespace
{

using Kind = ReceiverInput::Kind;

constexpr std::size_t chunkSize = 4096;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The unit vector of a normal, however long; false when it has no direction.
bool normalise(Vec3& normal)
{
  const double scale =
    std::max({ std::fabs(normal[0]), std::fabs(normal[1]), std::fabs(normal[2]) });
  if (!isFinite(normal) || scale == 0.0)
  {
    return false;
  }
  normal = { normal[0] / scale, normal[1] / scale, normal[2] / scale };
  const double size = length(normal);
  normal = { normal[0] / size, normal[1] / size, normal[2] / size };
  return true;
}

Vec3 tripleOf(vtkDataArray* array, vtkIdType i)
{
  return { array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
}

/// The marks of ghosts, or none.
class Ghosts
{
public:
  explicit Ghosts(vtkDataSetAttributes* attributes)
    : marks_(vtkUnsignedCharArray::SafeDownCast(
        attributes->GetAbstractArray(vtkDataSetAttributes::GhostArrayName())))
  {
  }

  [[nodiscard]] explicit operator bool() const { return this->marks_ != nullptr; }

  [[nodiscard]] bool has(vtkIdType i, int mark) const
  {
    return this->marks_ && (this->marks_->GetValue(i) & mark) != 0;
  }

private:
  vtkUnsignedCharArray* marks_;
};

ArrayView::Scalar storedAs(vtkDataSet* data)
{
  int type = VTK_DOUBLE;
  if (auto* points = vtkPointSet::SafeDownCast(data))
  {
    type = points->GetPoints() ? points->GetPoints()->GetDataType() : VTK_DOUBLE;
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    type = grid->GetXCoordinates() ? grid->GetXCoordinates()->GetDataType() : VTK_DOUBLE;
  }
  return type == VTK_FLOAT ? ArrayView::Scalar::Float : ArrayView::Scalar::Double;
}

void put(std::vector<double>& triples, std::size_t i, const Vec3& value)
{
  std::copy(value.begin(), value.end(), triples.begin() + 3 * static_cast<std::ptrdiff_t>(i));
}

/// Area times normal of a cell; its direction is that of the cell normals where there are any.
Vec3 facing(Cells& cells, vtkIdType cell, vtkDataArray* cellNormals)
{
  const Vec3 area = cells.areaVector(cell);
  if (!cellNormals)
  {
    return area;
  }
  Vec3 normal = tripleOf(cellNormals, cell);
  return normalise(normal) ? length(area) * normal : Vec3{ 0.0, 0.0, 0.0 };
}

void readCells(vtkDataSet* data, int threads, ReceiverInput& out)
{
  const Ghosts ghosts(data->GetCellData());
  vtkDataArray* normals = data->GetCellData()->GetNormals();
  parallelFor(out.size(), chunkSize, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      Cells cells(data);
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto cell = static_cast<vtkIdType>(i);
        const int dimension = cellDimension(data->GetCellType(cell));
        put(out.positions, i, cells.centre(cell));
        if (ghosts.has(cell, vtkDataSetAttributes::HIDDENCELL))
        {
          out.kinds[i] = Kind::Hidden;
        }
        else if (dimension == 3)
        {
          out.kinds[i] = Kind::Volume;
        }
        else if (normals || dimension == 2)
        {
          Vec3 normal = normals ? tripleOf(normals, cell) : cells.areaVector(cell);
          if (normalise(normal))
          {
            out.kinds[i] = Kind::Plane;
            put(out.normals, i, normal);
          }
        }
      }
    });
}

/// What the cells around each point give it: the sum of area vectors, and whether one has a volume.
struct Surroundings
{
  std::vector<Vec3> area;
  std::vector<unsigned char> inVolume;
  std::vector<unsigned char> hiddenOnly;

  // One thread, in the order of the cells: the sums must not depend on the number of threads.
  explicit Surroundings(vtkDataSet* data)
    : area(data->GetNumberOfPoints(), Vec3{ 0.0, 0.0, 0.0 })
    , inVolume(data->GetNumberOfPoints(), 0)
    , hiddenOnly(data->GetNumberOfPoints(), 0)
  {
    const Ghosts ghosts(data->GetCellData());
    vtkDataArray* normals = data->GetCellData()->GetNormals();
    std::vector<unsigned char> seen(data->GetNumberOfPoints(), 0);
    Cells cells(data);
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      const bool hidden = ghosts.has(cell, vtkDataSetAttributes::HIDDENCELL);
      const int dimension = hidden ? -1 : cellDimension(data->GetCellType(cell));
      const Vec3 vector = dimension == 2 ? facing(cells, cell, normals) : Vec3{ 0.0, 0.0, 0.0 };
      vtkIdList* ids = cells.points(cell);
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        const vtkIdType point = ids->GetId(k);
        this->area[point] = this->area[point] + vector;
        this->inVolume[point] |= dimension == 3 ? 1 : 0;
        (hidden ? this->hiddenOnly : seen)[point] = 1;
      }
    }
    for (std::size_t i = 0; i < seen.size(); ++i)
    {
      this->hiddenOnly[i] = this->hiddenOnly[i] && !seen[i] ? 1 : 0;
    }
  }
};

void readPoints(vtkDataSet* data, int threads, ReceiverInput& out)
{
  const Ghosts ghosts(data->GetPointData());
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  const Surroundings around(data);
  parallelFor(out.size(), chunkSize, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto point = static_cast<vtkIdType>(i);
        Vec3 position;
        data->GetPoint(point, position.data());
        put(out.positions, i, position);
        Vec3 normal = normals ? tripleOf(normals, point) : around.area[i];
        if (around.hiddenOnly[i] || ghosts.has(point, vtkDataSetAttributes::HIDDENPOINT))
        {
          out.kinds[i] = Kind::Hidden;
        }
        else if (normalise(normal))
        {
          out.kinds[i] = Kind::Plane;
          put(out.normals, i, normal);
        }
        else if (!normals && around.inVolume[i])
        {
          out.kinds[i] = Kind::Volume;
        }
      }
    });
}

} // namespace

bool ReceiverInput::has(Kind kind) const
{
  return std::find(this->kinds.begin(), this->kinds.end(), kind) != this->kinds.end();
}

ReceiverInput readReceivers(vtkDataSet* data, ReceiverLocation location, int threads)
{
  const bool points = location == ReceiverLocation::Points;
  const auto size =
    static_cast<std::size_t>(points ? data->GetNumberOfPoints() : data->GetNumberOfCells());
  ReceiverInput out;
  out.kinds.assign(size, Kind::Undefined);
  out.positions.resize(3 * size);
  out.normals.assign(3 * size, nan);
  out.stored = storedAs(data);

  prepareCells(data);
  if (points)
  {
    readPoints(data, threads, out);
  }
  else
  {
    readCells(data, threads, out);
  }

  const Ghosts ghosts(
    points ? static_cast<vtkDataSetAttributes*>(data->GetPointData()) : data->GetCellData());
  if (ghosts)
  {
    out.duplicate.resize(size);
    const int mark = points ? int{ vtkDataSetAttributes::DUPLICATEPOINT }
                            : int{ vtkDataSetAttributes::DUPLICATECELL };
    for (std::size_t i = 0; i < size; ++i)
    {
      out.duplicate[i] = ghosts.has(static_cast<vtkIdType>(i), mark) ? 1 : 0;
    }
  }
  return out;
}

void findSkips(ReceiverInput& receivers, ReceiverLocation location, const SurfaceInput& occluders,
  std::size_t leaf, int threads)
{
  const std::size_t size = receivers.size();
  std::vector<std::vector<PrimitiveId>> parts((size + chunkSize - 1) / chunkSize);
  receivers.skipOffsets.assign(size + 1, 0);
  parallelFor(size, chunkSize, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<PrimitiveId>& part = parts[begin / chunkSize];
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto id = static_cast<vtkIdType>(i);
        const std::vector<PrimitiveId> own = location == ReceiverLocation::Points
          ? occluders.primitivesAroundPoint(leaf, id)
          : occluders.primitivesOfCell(leaf, id);
        part.insert(part.end(), own.begin(), own.end());
        receivers.skipOffsets[i + 1] = own.size();
      }
    });
  for (std::size_t i = 0; i < size; ++i)
  {
    receivers.skipOffsets[i + 1] += receivers.skipOffsets[i];
  }
  receivers.skipPrimitives.reserve(receivers.skipOffsets[size]);
  for (const std::vector<PrimitiveId>& part : parts)
  {
    receivers.skipPrimitives.insert(receivers.skipPrimitives.end(), part.begin(), part.end());
  }
}

} // namespace lumitree::filters
