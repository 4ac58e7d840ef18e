// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiPhotometricText_h
#define LumiPhotometricText_h

#include "Radiometry/PhotometricWeb.h"

#include <string>

namespace lumitree::filters
{

/// As EULUMDAT where the name ends in `.ldt`, else as IES LM-63. Throws std::exception.
void writePhotometricFile(const PhotometricWeb& web, const std::string& fileName);

} // namespace lumitree::filters
#endif
