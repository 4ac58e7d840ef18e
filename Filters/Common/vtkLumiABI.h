// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLumiABI_h
#define vtkLumiABI_h

// VTK's inline namespace came with 9.3; before, the markers are empty.
#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230101)
#include "vtkABINamespace.h"
#else
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
