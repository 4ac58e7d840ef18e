// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLumiStandInSources_h
#define vtkLumiStandInSources_h
#include "LumitreeFiltersSourcesModule.h"
#include "vtkPolyDataAlgorithm.h"
class LUMITREEFILTERSSOURCES_EXPORT vtkLumiStandInSources : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiStandInSources* New();
  vtkTypeMacro(vtkLumiStandInSources, vtkPolyDataAlgorithm);
};
#endif
