// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiStandInSources.h"
#include "vtkObjectFactory.h"
vtkStandardNewMacro(vtkLumiStandInSources);
