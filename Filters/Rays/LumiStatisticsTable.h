// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiStatisticsTable_h
#define Lumitree_Filters_Rays_LumiStatisticsTable_h

#include "LumiVisits.h"

#include "Accel/Accelerator.h"

#include "vtkTable.h"

namespace lumitree::filters
{

/// The output Statistics (Docs/data-model.md): its columns, with one row, or with none when withRow
/// is false.
void makeStatisticsTable(
  const Accelerator& accelerator, const Visits& visits, bool withRow, vtkTable* table);

} // namespace lumitree::filters

#endif
