// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiRow_h
#define Lumitree_Filters_Rays_LumiRow_h

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace lumitree::filters
{

/// A row of a table, a column at a time; columns that the table lacks are added. When it is not
/// present, only the columns are.
class Row
{
public:
  Row(vtkTable* table, bool present)
    : table_(table)
    , present_(present)
  {
  }

  void add(const char* name, std::string_view value)
  {
    this->addTo<vtkStringArray>(name, std::string(value));
  }
  void add(const char* name, std::uint64_t value)
  {
    this->addTo<vtkIdTypeArray>(name, static_cast<vtkIdType>(value));
  }
  void add(const char* name, double value) { this->addTo<vtkDoubleArray>(name, value); }

private:
  template <class Array, class Value>
  void addTo(const char* name, const Value& value)
  {
    vtkSmartPointer<Array> column = Array::SafeDownCast(this->table_->GetColumnByName(name));
    const bool isNew = !column;
    if (isNew)
    {
      column = vtkSmartPointer<Array>::New();
      column->SetName(name);
    }
    if (this->present_)
    {
      column->InsertNextValue(value);
    }
    if (isNew)
    {
      this->table_->AddColumn(column); // wants as many rows as the table has
    }
  }

  vtkTable* table_;
  bool present_;
};

} // namespace lumitree::filters

#endif
