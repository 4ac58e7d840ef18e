// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiUnits_h
#define LumiUnits_h

#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// What one unit of the coordinates is. The values are part of the data model.
enum class LengthUnit : int
{
  Metre = 0,
  Millimetre = 1,
  Centimetre = 2,
  Kilometre = 3,
  Inch = 4,
  Foot = 5
};
inline constexpr int lengthUnitCount = 6;

/// Metres in one unit of length; NaN for a value that is none of LengthUnit.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT double metresPerUnit(int lengthUnit);

/// "metre", "millimetre", …; "unknown" for a value that is none of LengthUnit.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT const char* lengthUnitName(int lengthUnit);

/// "Quantity [unit]", as arrays are named.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::string nameWithUnit(
  const char* quantity, const char* unit);

/// Names the array "Quantity [unit]" and sets its UNITS_LABEL.
LUMITREEFILTERSCOMMON_EXPORT void setUnit(
  vtkDataArray* array, const char* quantity, const char* unit);

/// Writes LengthUnit (string) and MetresPerUnit (double) to the field data.
LUMITREEFILTERSCOMMON_EXPORT void writeLengthUnit(vtkDataObject* object, int lengthUnit);

} // namespace lumitree::filters
#endif
