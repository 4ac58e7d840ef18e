// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLumiStandInRays_h
#define vtkLumiStandInRays_h
#include "LumitreeFiltersRaysModule.h"
#include "vtkPolyDataAlgorithm.h"
class LUMITREEFILTERSRAYS_EXPORT vtkLumiStandInRays : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiStandInRays* New();
  vtkTypeMacro(vtkLumiStandInRays, vtkPolyDataAlgorithm);
};
#endif
