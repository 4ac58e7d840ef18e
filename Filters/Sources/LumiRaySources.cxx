// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiRaySources.h"

#include "LumiDirections.h"
#include "LumiExtract.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace
{

using namespace lumitree;
using filters::RaySources;
using filters::unit;

using Corners = std::array<Vec3, 3>;

/// Twice the area, along the normal of the winding.
Vec3 areaOf(const Corners& t)
{
  return cross(t[1] - t[0], t[2] - t[0]);
}

/// The middle of one cell, its area along its normal, and how far from the plane of a flat cell
/// rounding may have put the middle.
struct Facet
{
  Vec3 centre;
  Vec3 area;
  double rounding = 0.0;
};

/// The sum of the largest magnitude of each coordinate.
double extent(const std::vector<Vec3>& points)
{
  Vec3 largest = { 0.0, 0.0, 0.0 };
  for (const Vec3& p : points)
  {
    for (int k = 0; k < 3; ++k)
    {
      largest[k] = std::max(largest[k], std::fabs(p[k]));
    }
  }
  return largest[0] + largest[1] + largest[2];
}

Facet polygonFacet(const std::vector<Vec3>& points)
{
  // The fan's triangles have signed areas, so that the sums hold for polygons that are not convex
  // too.
  Vec3 area = { 0.0, 0.0, 0.0 };
  for (std::size_t k = 2; k < points.size(); ++k)
  {
    area = area + areaOf({ points[0], points[k - 1], points[k] });
  }
  const Vec3 normal = unit(area);
  Vec3 moment = { 0.0, 0.0, 0.0 };
  double sum = 0.0;
  double magnitudes = 0.0;
  for (std::size_t k = 2; k < points.size(); ++k)
  {
    const double weight = dot(normal, areaOf({ points[0], points[k - 1], points[k] }));
    sum += weight;
    magnitudes += std::fabs(weight);
    // Relative to the first point: far from the origin products would lose what they differ by.
    moment = moment + (weight / 3.0) * ((points[k - 1] - points[0]) + (points[k] - points[0]));
  }
  if (sum > 0.0)
  {
    // In exact numbers any weights give a point of the plane. Each term is a third of two edges, at
    // most 4 M / 3 a coordinate of magnitude M, and rounds 4 times, its sum and quotient n times
    // more; the weights add up to magnitudes / sum. Adding the first point rounds M or more once.
    const auto n = static_cast<double>(points.size());
    const double rounding = 0x1p-53 * (4.0 + 2.0 * (4.0 + n) * (magnitudes / sum)) * extent(points);
    return { points[0] + (1.0 / sum) * moment, area, rounding };
  }
  // Without an area (the data may give a normal), or not finite, which the mean shows.
  Vec3 mean = { 0.0, 0.0, 0.0 };
  for (const Vec3& p : points)
  {
    mean = mean + (1.0 / static_cast<double>(points.size())) * p;
  }
  return { mean, area, 0x1p-53 * (4.0 + static_cast<double>(points.size())) * extent(points) };
}

/// A strip bends: its middle triangle stands for it, for the mean of all would lie off the surface.
Facet stripFacet(const std::vector<Vec3>& points)
{
  const std::size_t k = (points.size() - 3) / 2;
  const std::size_t flip = k % 2;
  return polygonFacet({ points[k], points[k + 1 + flip], points[k + 2 - flip] });
}

/// The surface of one leaf, and what its cells and points are.
class Leaf
{
public:
  Leaf(vtkDataSet* data, int compositeIndex)
    : data_(data)
    , selection_(filters::selectCells(data))
    , surface_(filters::extractSurface(data, selection_))
    , compositeIndex_(compositeIndex)
  {
    double bounds[6];
    this->surface_.polygons->GetBounds(bounds);
    this->extent_ =
      extent({ { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } });
  }

  void addCells(RaySources& sources) const
  {
    vtkDataArray* const given = this->data_->GetCellData()->GetNormals();
    const auto addCell = [&](
                           vtkIdType index, vtkIdList*, const std::vector<Vec3>& points, bool strip)
    {
      const vtkIdType id = this->cellId(index);
      if (this->selection_[id] == filters::CellState::Occludes)
      {
        const Facet facet = strip ? stripFacet(points) : polygonFacet(points);
        const bool ownNormal = given && this->isFlat(id);
        this->add(sources, facet, ownNormal ? tuple(given, id) : facet.area, id, index);
      }
    };
    this->eachCell(addCell);
  }

  void addPoints(RaySources& sources) const
  {
    vtkDataArray* const given = this->data_->GetPointData()->GetNormals();
    vtkUnsignedCharArray* const ghosts = this->data_->GetPointGhostArray();
    const std::vector<vtkIdType> ids = this->surfacePoints();
    const std::vector<Vec3> sums = given ? std::vector<Vec3>() : this->pointAreas(ids);
    constexpr int left = vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT;
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const vtkIdType id = ids[i];
      if (!(ghosts && (ghosts->GetValue(id) & left) != 0))
      {
        Vec3 position;
        this->data_->GetPoint(id, position.data());
        const Vec3 normal = given ? tuple(given, id) : sums[i];
        this->add(sources, { position, normal }, normal, id, id);
      }
    }
  }

private:
  static Vec3 tuple(vtkDataArray* normals, vtkIdType i)
  {
    Vec3 n;
    normals->GetTuple(i, n.data());
    return n;
  }

  Vec3 point(vtkIdType i) const
  {
    Vec3 p;
    this->surface_.polygons->GetPoint(i, p.data());
    return p;
  }

  vtkIdType cellId(vtkIdType index) const
  {
    return this->surface_.cellIds ? this->surface_.cellIds->GetValue(index) : index;
  }

  /// Of a solid cell a normal in the cell data cannot be that of each of its faces.
  bool isFlat(vtkIdType id) const
  {
    return !this->surface_.cellIds || this->data_->GetCell(id)->GetCellDimension() < 3;
  }

  void add(RaySources& sources, const Facet& facet, const Vec3& normal, vtkIdType id,
    vtkIdType index) const
  {
    const Vec3 n = unit(normal);
    if (filters::isZero(n) || !isFinite(facet.centre))
    {
      ++sources.withoutNormal;
      return;
    }
    Vec3 clear = unit(facet.area);
    if (filters::isZero(clear))
    {
      clear = n;
    }
    else if (dot(clear, n) < 0.0)
    {
      clear = -1.0 * clear;
    }
    // Next to the origin of coordinates, where nothing rounds, the surface around is the measure.
    const double rounding = facet.rounding + 0x1p-53 * this->extent_;
    sources.list.push_back({ facet.centre, n, clear, rounding, id, index, this->compositeIndex_ });
  }

  /// Calls body(index, ids, points, whether it is a strip) for polygons and strips of three points
  /// or more.
  template <class Body>
  void eachCell(const Body& body) const
  {
    vtkPolyData* const polygons = this->surface_.polygons;
    vtkIdType index = polygons->GetNumberOfVerts() + polygons->GetNumberOfLines();
    vtkNew<vtkIdList> ids;
    std::vector<Vec3> points;
    for (vtkCellArray* cells : { polygons->GetPolys(), polygons->GetStrips() })
    {
      for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++index)
      {
        cells->GetCellAtId(i, ids);
        points.clear();
        for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
        {
          points.push_back(this->point(ids->GetId(k)));
        }
        if (points.size() >= 3)
        {
          body(index, ids.Get(), points, cells == polygons->GetStrips());
        }
      }
    }
  }

  /// The leaf's points on its surface, ascending. Extraction may repeat a point (an image's edges
  /// have one per face), and makes points without an id where it subdivides curved faces.
  std::vector<vtkIdType> surfacePoints() const
  {
    std::vector<vtkIdType> ids(
      static_cast<std::size_t>(this->surface_.polygons->GetNumberOfPoints()));
    std::iota(ids.begin(), ids.end(), vtkIdType(0));
    if (this->surface_.pointIds)
    {
      const vtkIdType* const original = this->surface_.pointIds->GetPointer(0);
      std::copy_n(original, ids.size(), ids.begin());
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
      ids.erase(ids.begin(), std::lower_bound(ids.begin(), ids.end(), vtkIdType(0)));
    }
    return ids;
  }

  /// For each of those points the sum of its cells' areas along their normals, which is the
  /// area-weighted mean but for its length. Duplicate cells count: they make the mean at a piece's
  /// border that of the whole.
  std::vector<Vec3> pointAreas(const std::vector<vtkIdType>& pointIds) const
  {
    std::vector<Vec3> sums(pointIds.size());
    vtkIdTypeArray* const original = this->surface_.pointIds;
    const auto addTo = [&](vtkIdType i, const Vec3& area)
    {
      const vtkIdType id = original ? original->GetValue(i) : i;
      if (id >= 0 && isFinite(area))
      {
        const auto place =
          original ? std::lower_bound(pointIds.begin(), pointIds.end(), id) - pointIds.begin() : id;
        Vec3& sum = sums[static_cast<std::size_t>(place)];
        sum = sum + area;
      }
    };
    const auto addCell = [&](
                           vtkIdType index, vtkIdList* ids, const std::vector<Vec3>& p, bool strip)
    {
      if (this->selection_[this->cellId(index)] == filters::CellState::Hidden)
      {
        return;
      }
      if (!strip)
      {
        const Vec3 area = polygonFacet(p).area;
        std::for_each(ids->begin(), ids->end(), [&](vtkIdType i) { addTo(i, area); });
        return;
      }
      for (std::size_t k = 0; k + 2 < p.size(); ++k)
      {
        const std::size_t flip = k % 2;
        const Vec3 area = areaOf({ p[k], p[k + 1 + flip], p[k + 2 - flip] });
        const vtkIdType* const corners = ids->begin() + k;
        std::for_each(corners, corners + 3, [&](vtkIdType i) { addTo(i, area); });
      }
    };
    this->eachCell(addCell);
    return sums;
  }

  vtkDataSet* data_;
  filters::CellSelection selection_;
  filters::ExtractedSurface surface_;
  int compositeIndex_;
  double extent_ = 0.0; ///< of the surface's bounds
};

}

namespace lumitree::filters
{

RaySources collectRaySources(vtkDataObject* object, bool points)
{
  RaySources result;
  const auto add = [&](vtkDataObject* leafObject, int compositeIndex)
  {
    auto* data = vtkDataSet::SafeDownCast(leafObject);
    if (!data)
    {
      ++result.notDatasets;
      return;
    }
    const Leaf leaf(data, compositeIndex);
    points ? leaf.addPoints(result) : leaf.addCells(result);
  };

  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaves;
    leaves.TakeReference(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      add(leaves->GetCurrentDataObject(), static_cast<int>(leaves->GetCurrentFlatIndex()));
    }
  }
  else
  {
    add(object, 0);
  }
  return result;
}

}
