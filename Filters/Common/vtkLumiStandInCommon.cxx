// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiStandInCommon.h"
#include "vtkObjectFactory.h"
vtkStandardNewMacro(vtkLumiStandInCommon);
