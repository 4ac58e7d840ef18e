// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiReport_h
#define LumiReport_h

#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// vtkErrorMacro and vtkWarningMacro on behalf of a filter, from code that is none. Null is
/// allowed.
///@{
LUMITREEFILTERSCOMMON_EXPORT void reportError(vtkObject* reporter, const std::string& message);
LUMITREEFILTERSCOMMON_EXPORT void reportWarning(vtkObject* reporter, const std::string& message);
///@}

} // namespace lumitree::filters
#endif
