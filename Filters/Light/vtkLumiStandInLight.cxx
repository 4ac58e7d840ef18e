// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiStandInLight.h"
#include "vtkObjectFactory.h"
vtkStandardNewMacro(vtkLumiStandInLight);
