// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiStatisticsTable_h
#define Lumitree_Filters_Rays_LumiStatisticsTable_h

#include "LumiCast.h"
#include "LumiVisits.h"

#include "Accel/Accelerator.h"

#include "vtkTable.h"

namespace lumitree::filters
{

/// The output Statistics (Docs/data-model.md): its columns, with one row, or with none when withRow
/// is false. view is the accelerator's. measureOverlap: also the end-point overlap, which takes
/// time.
void makeStatisticsTable(const Accelerator& accelerator, const HierarchyView& view,
  const Visits& visits, bool measureOverlap, bool withRow, vtkTable* table);

/// The output Statistics of a cast (Docs/data-model.md): one row.
void makeCastTable(
  const Accelerator& accelerator, const Cast& cast, Precision precision, vtkTable* table);

} // namespace lumitree::filters

#endif
