// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiUnits.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <limits>

namespace lumitree::filters
{
namespace
{

struct Unit
{
  const char* name;
  double metres;
};

constexpr Unit units[lengthUnitCount] = { { "metre", 1.0 }, { "millimetre", 0.001 },
  { "centimetre", 0.01 }, { "kilometre", 1000.0 }, { "inch", 0.0254 }, { "foot", 0.3048 } };

bool isUnit(int lengthUnit)
{
  return lengthUnit >= 0 && lengthUnit < lengthUnitCount;
}

} // namespace

double metresPerUnit(int lengthUnit)
{
  return isUnit(lengthUnit) ? units[lengthUnit].metres : std::numeric_limits<double>::quiet_NaN();
}

const char* lengthUnitName(int lengthUnit)
{
  return isUnit(lengthUnit) ? units[lengthUnit].name : "unknown";
}

std::string nameWithUnit(const char* quantity, const char* unit)
{
  return std::string(quantity) + " [" + unit + "]";
}

void setUnit(vtkDataArray* array, const char* quantity, const char* unit)
{
  array->SetName(nameWithUnit(quantity, unit).c_str());
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
}

void writeLengthUnit(vtkDataObject* object, int lengthUnit)
{
  vtkNew<vtkStringArray> unitName;
  unitName->SetName("LengthUnit");
  unitName->InsertNextValue(lengthUnitName(lengthUnit));
  vtkNew<vtkDoubleArray> metres;
  metres->SetName("MetresPerUnit");
  metres->InsertNextValue(metresPerUnit(lengthUnit));
  object->GetFieldData()->AddArray(unitName);
  object->GetFieldData()->AddArray(metres);
}

} // namespace lumitree::filters
