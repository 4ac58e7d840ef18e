// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiImplicitData_h
#define LumiImplicitData_h

#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include "Accel/Implicit.h"
#include "Accel/ImplicitTree.h"

#include <memory>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
class vtkImplicitFunction;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Implicit trees and implicits as field data (Docs/data-model.md, "Implicits").

/// What is promised of a function's surface: the field array ImplicitGuarantee.
enum class Guarantee : int
{
  Exact = 0,     ///< quadrics, or a sign of forms of second degree
  Intervals = 1, ///< isolated by intervals, to a tolerance
  Sampled = 2    ///< sampled at a step
};

/// Adds the tree; all quadrics of the dataset are its zeros, or its implicit has its values.
LUMITREEFILTERSCOMMON_EXPORT void writeTree(const ImplicitTree& tree, vtkFieldData* fields);

/// Null where there is none. Throws std::invalid_argument for arrays that do not fit, and for trees
/// that are not valid.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::shared_ptr<const ImplicitTree> readTree(
  vtkFieldData* fields);

/// Adds a box and a step, and the function where no tree says what it is: it then stays in this
/// process.
LUMITREEFILTERSCOMMON_EXPORT void writeImplicit(
  const Implicit& implicit, vtkImplicitFunction* sampled, vtkFieldData* fields);

/// Nothing where there is none. Throws std::invalid_argument also where a sampled function is not
/// there any more, because the data came from a file or another process.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::optional<Implicit> readImplicit(
  vtkFieldData* fields);

/// A function of VTK by its values: one thread at a time asks, in the whole process, because
/// functions may share what they look at.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::shared_ptr<const ImplicitFunction> sampledFunction(
  vtkImplicitFunction* function);

/// Names of the arrays.
///@{
inline constexpr const char* implicitStepsName = "ImplicitSteps";
inline constexpr const char* implicitFormsName = "ImplicitForms";
inline constexpr const char* implicitSuperquadricsName = "ImplicitSuperquadrics";
inline constexpr const char* implicitBoxName = "ImplicitBox";
inline constexpr const char* implicitGuaranteeName = "ImplicitGuarantee";
///@}

} // namespace lumitree::filters
#endif
