// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiQuadricOutput.h"

#include "LumiQuadricPreview.h"
#include "LumiQuadrics.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumitree::filters
{
namespace
{

/// Puts vertices, previews and attributes together.
class Assembly
{
public:
  Assembly(int resolution, vtkPolyData* output)
    : resolution_(resolution)
    , output_(output)
  {
    this->ids_->SetName(quadricIdName);
    this->points_->SetDataTypeToDouble();
  }

  void make(const QuadricSet& bodies, vtkDataSet* input)
  {
    const auto n = static_cast<vtkIdType>(bodies.implicit ? 1 : bodies.quadrics.size());
    this->input_ = input;
    this->bodies_ = &bodies;
    if (input)
    {
      this->output_->GetPointData()->CopyAllocate(input->GetPointData(), n);
    }
    for (vtkIdType q = 0; q < n; ++q)
    {
      const Vec3 at = bodies.implicit ? centreOf(*bodies.implicit) : this->quadric(q).form.centre;
      const vtkIdType point = this->addPoint(at, q, { 0, 0, 0 });
      this->verts_->InsertNextCell(1, &point);
    }
    if (bodies.implicit)
    {
      this->addShown(*bodies.implicit->function, bodies.implicit->clip);
    }
    else if (n > 0 && this->quadric(0).tree)
    {
      this->addShown(*functionOf(this->quadric(0).tree), this->quadric(0).clip);
    }
    else
    {
      for (vtkIdType q = 0; q < n; ++q)
      {
        this->addPreview(q);
      }
    }
    this->output_->SetPoints(this->points_);
    this->output_->SetVerts(this->verts_);
    this->output_->SetPolys(this->polys_);
    const auto cellIds = vtkSmartPointer<vtkIdTypeArray>::New();
    cellIds->SetName(quadricIdName);
    cellIds->SetNumberOfValues(this->output_->GetNumberOfCells());
    for (vtkIdType c = 0; c < n; ++c)
    {
      cellIds->SetValue(c, c);
    }
    for (std::size_t c = 0; c < this->polyIds_.size(); ++c)
    {
      cellIds->SetValue(n + static_cast<vtkIdType>(c), this->polyIds_[c]);
    }
    this->output_->GetCellData()->AddArray(cellIds);
    this->output_->GetPointData()->AddArray(this->ids_);
    this->output_->GetPointData()->SetNormals(this->normals_);
    if (bodies.implicit)
    {
      writeImplicitBody(*bodies.implicit, bodies.tree, bodies.function, this->output_);
    }
    else
    {
      writeQuadrics(bodies.quadrics, this->output_);
    }
    if (bodies.isFunction)
    {
      const vtkNew<vtkIntArray> guarantee;
      guarantee->SetName(implicitGuaranteeName);
      guarantee->InsertNextValue(static_cast<int>(bodies.guarantee));
      this->output_->GetFieldData()->AddArray(guarantee);
    }
  }

private:
  [[nodiscard]] const Quadric& quadric(vtkIdType q) const
  {
    return this->bodies_->quadrics[static_cast<std::size_t>(q)];
  }

  vtkIdType addPoint(const Vec3& at, vtkIdType q, const Vec3& normal)
  {
    const vtkIdType id = this->points_->InsertNextPoint(at.data());
    this->ids_->InsertNextValue(q);
    this->normals_->InsertNextTuple(normal.data());
    if (this->input_)
    {
      this->output_->GetPointData()->CopyData(
        this->input_->GetPointData(), this->bodies_->points[static_cast<std::size_t>(q)], id);
    }
    return id;
  }

  /// Whether the quadric is the one shown last, moved.
  [[nodiscard]] bool isMoved(const Quadric& q) const
  {
    const Quadric& last = this->shown_;
    bool same = q.form.coefficients == last.form.coefficients &&
      q.bound.coefficients == last.bound.coefficients;
    const Vec3 move = q.form.centre - last.form.centre;
    const Vec3 size = q.clip.size();
    const double slack = 1e-6 * (std::fabs(size[0]) + std::fabs(size[1]) + std::fabs(size[2]));
    const auto follows = [&](const Vec3& to, const Vec3& from)
    { return length(to - (from + move)) <= slack; };
    for (std::size_t c = 0; c < 2; ++c)
    {
      const bool cut = q.cuts[c].normal != Vec3{ 0, 0, 0 };
      same = same && q.cuts[c].normal == last.cuts[c].normal &&
        (!cut || follows(q.cuts[c].point, last.cuts[c].point));
    }
    return same && follows(q.clip.lower, last.clip.lower) && follows(q.clip.upper, last.clip.upper);
  }

  void addPreview(vtkIdType id)
  {
    const Quadric& q = this->quadric(id);
    if (!this->preview_ || !this->isMoved(q))
    {
      this->preview_ = previewOf(q, this->resolution_);
      this->shown_ = q;
    }
    this->append(q.form.centre - this->shown_.form.centre, [id](const Vec3&) { return id; });
  }

  /// One preview of a whole tree or implicit; each part says which quadric it shows.
  void addShown(const ImplicitFunction& function, const Box& clip)
  {
    this->preview_ = previewOf(function, clip, this->resolution_);
    this->append({ 0, 0, 0 },
      [&](const Vec3& x)
      {
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t q = 0; q < this->bodies_->quadrics.size(); ++q)
        {
          const QuadricForm& form = this->bodies_->quadrics[q].form;
          const double distance =
            std::fabs(valueAt(form, x)) / std::max(length(gradientAt(form, x)), 1e-300);
          nearest = distance < least ? q : nearest;
          least = std::min(least, distance);
        }
        return static_cast<vtkIdType>(nearest);
      });
  }

  /// The preview, moved; whose: the quadric shown at a point of it.
  template <class F>
  void append(const Vec3& move, F whose)
  {
    const vtkIdType first = this->points_->GetNumberOfPoints();
    vtkDataArray* const normals = this->preview_->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < this->preview_->GetNumberOfPoints(); ++i)
    {
      Vec3 x;
      Vec3 n;
      this->preview_->GetPoint(i, x.data());
      normals->GetTuple(i, n.data());
      this->addPoint(x + move, whose(x), n);
    }
    vtkCellArray* const polys = this->preview_->GetPolys();
    const vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; polys && c < polys->GetNumberOfCells(); ++c)
    {
      polys->GetCellAtId(c, ids);
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        ids->SetId(k, ids->GetId(k) + first);
      }
      this->polys_->InsertNextCell(ids);
      this->polyIds_.push_back(this->ids_->GetValue(ids->GetId(0)));
    }
  }

  int resolution_;
  vtkPolyData* output_;
  vtkDataSet* input_ = nullptr;
  const QuadricSet* bodies_ = nullptr;
  vtkSmartPointer<vtkPolyData> preview_;
  Quadric shown_;
  std::vector<vtkIdType> polyIds_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> verts_;
  vtkNew<vtkCellArray> polys_;
  vtkNew<vtkIdTypeArray> ids_;
  vtkSmartPointer<vtkDoubleArray> normals_ = namedNormals();

  static vtkSmartPointer<vtkDoubleArray> namedNormals()
  {
    auto normals = vtkSmartPointer<vtkDoubleArray>::New();
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    return normals;
  }
};

} // namespace

void makeOutput(
  const QuadricSet& set, vtkDataSet* input, int previewResolution, vtkPolyData* output)
{
  Assembly(previewResolution, output).make(set, input);
}

} // namespace lumitree::filters
