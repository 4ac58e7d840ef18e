// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLumiStandInLight_h
#define vtkLumiStandInLight_h
#include "LumitreeFiltersLightModule.h"
#include "vtkPolyDataAlgorithm.h"
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiStandInLight : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiStandInLight* New();
  vtkTypeMacro(vtkLumiStandInLight, vtkPolyDataAlgorithm);
};
#endif
