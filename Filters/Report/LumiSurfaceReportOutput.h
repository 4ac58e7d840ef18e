// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Report_LumiSurfaceReportOutput_h
#define Lumitree_Filters_Report_LumiSurfaceReportOutput_h

#include "LumiSurfaceCheck.h"

#include "vtkPolyData.h"
#include "vtkTable.h"

namespace lumitree::filters
{

/// The outputs of vtkLumiSurfaceReport (Docs/data-model.md).
///@{
void makeSurfaceOutput(const Surface& surface, const SurfaceCheck& check, vtkPolyData* output);
void makeEdgesOutput(const Surface& surface, const SurfaceCheck& check, vtkPolyData* output);
void makeReportTable(const Surface& surface, const SurfaceCheck& check, vtkTable* table);
///@}

} // namespace lumitree::filters

#endif
