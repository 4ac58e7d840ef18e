// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiQuadrics_h
#define LumiQuadrics_h

#include "LumiImplicitData.h"
#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include "vtkType.h"

#include "Accel/Quadric.h"

#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Quadrics as pipeline data: a vtkPolyData whose field data holds the definition (schemas 1
/// and 2 in Docs/data-model.md), with a vertex cell per quadric at its form's centre first, and
/// polygons to look at behind, which rays do not see. The point and cell array QuadricId says whose
/// they are.

/// Whether the dataset holds quadrics: its cells are then no surface of their own.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT bool holdsQuadrics(vtkDataSet* data);

/// Whether it holds an implicit: it then has no quadrics.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT bool holdsImplicit(vtkDataSet* data);

/// What such a dataset holds.
struct Bodies
{
  std::vector<Quadric> quadrics;
  std::optional<Implicit> implicit;
};

/// Throws std::invalid_argument for a schema that is not known, arrays that are missing or of
/// another size, what LumiImplicitData.h refuses, and where vertices are not at the centres or
/// cells are no body's: then a filter has moved, taken away or added cells without knowing what
/// they stand for.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT Bodies readBodies(vtkDataSet* data);

/// Appends the definition to the field data. The caller makes cells and points. All quadrics have
/// the same tree, if any.
LUMITREEFILTERSCOMMON_EXPORT void writeQuadrics(
  const std::vector<Quadric>& quadrics, vtkPolyData* data);

/// The same of an implicit with the values of the tree, or if that is null of the function.
LUMITREEFILTERSCOMMON_EXPORT void writeImplicitBody(const Implicit& implicit,
  const std::shared_ptr<const ImplicitTree>& tree, vtkImplicitFunction* function,
  vtkPolyData* data);

/// Where its vertex is.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT Vec3 centreOf(const Implicit& implicit);

/// A form as 14 numbers: centre, coefficients, residue.
///@{
inline constexpr int formSize = 14;
void putForm(const QuadricForm& form, double* tuple);
[[nodiscard]] QuadricForm formOf(const double* tuple);
///@}

/// The quadric that a cell or a point of such a dataset shows; −1 where there is none.
[[nodiscard]] vtkIdType quadricOf(vtkDataSet* data, vtkIdType id, bool point);

/// Names of its arrays.
///@{
inline constexpr const char* quadricSchemaName = "QuadricSchema";
inline constexpr const char* quadricFormName = "QuadricForm";
inline constexpr const char* quadricBoxName = "QuadricBox";
inline constexpr const char* quadricCutsName = "QuadricCuts";
inline constexpr const char* quadricBoundName = "QuadricBound";
inline constexpr const char* quadricIdName = "QuadricId";
///@}

} // namespace lumitree::filters
#endif
