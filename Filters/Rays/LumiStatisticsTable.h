// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiStatisticsTable_h
#define Lumitree_Filters_Rays_LumiStatisticsTable_h

#include "LumiCast.h"
#include "LumiCastArrays.h"
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

/// What a cast took [s].
struct CastSeconds
{
  double surface = 0.0; ///< to make the surface of the input, or to find it made
  double build = 0.0;   ///< the same of the structure
  double rays = 0.0;    ///< to read the rays
  double cast = 0.0;
  double output = 0.0; ///< to fill the outputs Hits and Rays
};

/// The output Statistics of a cast (Docs/data-model.md): one row.
void makeCastTable(const Accelerator& accelerator, const Cast& cast, Precision precision,
  const HitTotals& totals, const CastSeconds& seconds, vtkTable* table);

} // namespace lumitree::filters

#endif
