// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiReport.h"

#include "vtkObject.h"
#include "vtkSetGet.h"

namespace lumitree::filters
{

void reportError(vtkObject* reporter, const std::string& message)
{
  if (reporter)
  {
    vtkErrorWithObjectMacro(reporter, << message);
  }
  else
  {
    vtkGenericWarningMacro(<< message);
  }
}

void reportWarning(vtkObject* reporter, const std::string& message)
{
  if (reporter)
  {
    vtkWarningWithObjectMacro(reporter, << message);
  }
  else
  {
    vtkGenericWarningMacro(<< message);
  }
}

} // namespace lumitree::filters
