// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiStandInRays.h"
#include "vtkObjectFactory.h"
vtkStandardNewMacro(vtkLumiStandInRays);
