// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLumiStandInCommon_h
#define vtkLumiStandInCommon_h
#include "LumitreeFiltersCommonModule.h"
#include "vtkPolyDataAlgorithm.h"
class LUMITREEFILTERSCOMMON_EXPORT vtkLumiStandInCommon : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiStandInCommon* New();
  vtkTypeMacro(vtkLumiStandInCommon, vtkPolyDataAlgorithm);
};
#endif
