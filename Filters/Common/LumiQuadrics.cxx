// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiQuadrics.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <string>

namespace lumitree::filters
{
namespace
{

/// Of quadrics alone, and of what also has a tree or is an implicit.
constexpr int plainSchema = 1;
constexpr int treeSchema = 2;

vtkDataArray* arrayOf(vtkFieldData* fields, const char* name, int components, vtkIdType tuples)
{
  vtkDataArray* array = vtkDataArray::SafeDownCast(fields->GetAbstractArray(name));
  const bool fits = array && array->GetDataType() == VTK_DOUBLE &&
    array->GetNumberOfComponents() == components &&
    (tuples < 0 || array->GetNumberOfTuples() == tuples);
  if (!fits)
  {
    throw std::invalid_argument(std::string("quadrics need the field array ") + name + " of " +
      std::to_string(components) + " doubles a quadric");
  }
  return array;
}

/// Whether every cell is one of a quadric's: cells that were appended are not.
bool showsQuadricsOnly(vtkPolyData* data, vtkIdType quadrics)
{
  vtkDataArray* const ids = data->GetCellData()->GetArray(quadricIdName);
  const vtkIdType cells = data->GetNumberOfCells();
  bool all = cells == 0 || (ids && ids->GetNumberOfTuples() == cells);
  for (vtkIdType i = 0; all && i < cells; ++i)
  {
    const double id = ids->GetComponent(i, 0);
    all = id >= 0.0 && id < static_cast<double>(quadrics) &&
      (i >= quadrics || id == static_cast<double>(i));
  }
  return all;
}

/// Cell q must be the vertex q, at the centre of body q.
void checkCells(vtkPolyData* data, const std::vector<Vec3>& centres)
{
  const auto known = static_cast<vtkIdType>(centres.size());
  bool kept = data && data->GetNumberOfVerts() == known && data->GetNumberOfPoints() >= known &&
    showsQuadricsOnly(data, known);
  const vtkNew<vtkIdList> ids;
  for (std::size_t q = 0; kept && q < centres.size(); ++q)
  {
    const auto id = static_cast<vtkIdType>(q);
    data->GetVerts()->GetCellAtId(id, ids);
    Vec3 at;
    data->GetPoint(id, at.data());
    const Vec3& centre = centres[q];
    kept = ids->GetNumberOfIds() == 1 && ids->GetId(0) == id;
    for (int k = 0; kept && k < 3; ++k)
    {
      kept = at[k] == centre[k] || (std::isnan(at[k]) && std::isnan(centre[k]));
    }
  }
  if (!kept)
  {
    throw std::invalid_argument(
      "quadrics whose cells are not those of their source: another filter "
      "has moved, cut or joined them; group them with other data instead");
  }
}

std::vector<Quadric> readQuadrics(vtkFieldData* fields)
{
  // Empty arrays are not always written to files.
  std::vector<Quadric> quadrics;
  if (!fields->HasArray(quadricFormName))
  {
    return quadrics;
  }
  vtkDataArray* forms = arrayOf(fields, quadricFormName, formSize, -1);
  const vtkIdType n = forms->GetNumberOfTuples();
  vtkDataArray* boxes = arrayOf(fields, quadricBoxName, 6, n);
  vtkDataArray* cuts = arrayOf(fields, quadricCutsName, 12, n);
  vtkDataArray* bounds = arrayOf(fields, quadricBoundName, formSize, n);
  quadrics.resize(static_cast<std::size_t>(n));
  for (vtkIdType i = 0; i < n; ++i)
  {
    Quadric& q = quadrics[static_cast<std::size_t>(i)];
    double tuple[formSize];
    forms->GetTuple(i, tuple);
    q.form = formOf(tuple);
    bounds->GetTuple(i, tuple);
    q.bound = formOf(tuple);
    boxes->GetTuple(i, tuple);
    q.clip.lower = { tuple[0], tuple[2], tuple[4] };
    q.clip.upper = { tuple[1], tuple[3], tuple[5] };
    cuts->GetTuple(i, tuple);
    for (std::size_t c = 0; c < 2; ++c)
    {
      const double* cut = tuple + 6 * c;
      q.cuts[c] = { { cut[0], cut[1], cut[2] }, { cut[3], cut[4], cut[5] } };
    }
  }
  return quadrics;
}

} // namespace

bool holdsQuadrics(vtkDataSet* data)
{
  return data && data->GetFieldData() && data->GetFieldData()->HasArray(quadricSchemaName);
}

void putForm(const QuadricForm& form, double* tuple)
{
  std::copy(form.centre.begin(), form.centre.end(), tuple);
  std::copy(form.coefficients.begin(), form.coefficients.end(), tuple + 3);
  tuple[13] = form.residue;
}

QuadricForm formOf(const double* tuple)
{
  QuadricForm form;
  std::copy(tuple, tuple + 3, form.centre.begin());
  std::copy(tuple + 3, tuple + 13, form.coefficients.begin());
  form.residue = tuple[13];
  return form;
}

Bodies readBodies(vtkDataSet* data)
{
  vtkFieldData* fields = data->GetFieldData();
  vtkDataArray* version = vtkDataArray::SafeDownCast(fields->GetAbstractArray(quadricSchemaName));
  const double known =
    version && version->GetNumberOfValues() == 1 ? version->GetComponent(0, 0) : 0.0;
  if (known != plainSchema && known != treeSchema)
  {
    throw std::invalid_argument("quadrics of a schema that is neither 1 nor 2");
  }
  Bodies bodies;
  if (known == treeSchema)
  {
    bodies.implicit = readImplicit(fields);
  }
  std::vector<Vec3> centres;
  if (bodies.implicit)
  {
    centres.push_back(centreOf(*bodies.implicit));
  }
  else
  {
    bodies.quadrics = readQuadrics(fields);
    const auto tree = known == treeSchema ? readTree(fields) : nullptr;
    for (Quadric& quadric : bodies.quadrics)
    {
      quadric.tree = tree;
      centres.push_back(quadric.form.centre);
    }
  }
  checkCells(vtkPolyData::SafeDownCast(data), centres);
  return bodies;
}

Vec3 centreOf(const Implicit& implicit)
{
  return implicit.clip.centre();
}

void writeSchema(bool plain, vtkPolyData* data)
{
  const vtkNew<vtkIntArray> version;
  version->SetName(quadricSchemaName);
  version->InsertNextValue(plain ? plainSchema : treeSchema);
  data->GetFieldData()->AddArray(version);
}

void writeQuadrics(const std::vector<Quadric>& quadrics, vtkPolyData* data)
{
  const auto n = static_cast<vtkIdType>(quadrics.size());
  vtkFieldData* fields = data->GetFieldData();
  const auto add = [&](const char* name, int components)
  {
    const vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(n);
    fields->AddArray(array);
    return array->GetPointer(0);
  };
  const bool plain = quadrics.empty() || !quadrics.front().tree;
  writeSchema(plain, data);
  if (!plain)
  {
    writeTree(*quadrics.front().tree, fields);
  }
  double* form = add(quadricFormName, formSize);
  double* box = add(quadricBoxName, 6);
  double* cuts = add(quadricCutsName, 12);
  double* bound = add(quadricBoundName, formSize);
  for (const Quadric& q : quadrics)
  {
    putForm(q.form, form);
    putForm(q.bound, bound);
    for (int k = 0; k < 3; ++k)
    {
      box[2 * k] = q.clip.lower[k];
      box[2 * k + 1] = q.clip.upper[k];
      for (std::size_t c = 0; c < 2; ++c)
      {
        cuts[6 * c + static_cast<std::size_t>(k)] = q.cuts[c].normal[k];
        cuts[6 * c + 3 + static_cast<std::size_t>(k)] = q.cuts[c].point[k];
      }
    }
    form += formSize;
    bound += formSize;
    box += 6;
    cuts += 12;
  }
}

vtkIdType quadricOf(vtkDataSet* data, vtkIdType id, bool point)
{
  vtkDataSetAttributes* attributes = point
    ? static_cast<vtkDataSetAttributes*>(data->GetPointData())
    : static_cast<vtkDataSetAttributes*>(data->GetCellData());
  vtkDataArray* ids = attributes->GetArray(quadricIdName);
  return ids && id >= 0 && id < ids->GetNumberOfTuples()
    ? static_cast<vtkIdType>(ids->GetComponent(id, 0))
    : -1;
}

void writeImplicitBody(const Implicit& implicit, const std::shared_ptr<const ImplicitTree>& tree,
  vtkImplicitFunction* function, vtkPolyData* data)
{
  writeSchema(false, data);
  if (tree)
  {
    writeTree(*tree, data->GetFieldData());
  }
  writeImplicit(implicit, tree ? nullptr : function, data->GetFieldData());
}

bool holdsImplicit(vtkDataSet* data)
{
  return holdsQuadrics(data) && data->GetFieldData()->HasArray(implicitBoxName);
}

} // namespace lumitree::filters
