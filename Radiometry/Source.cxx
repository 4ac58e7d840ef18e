// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Source.h"

namespace lumitree
{

// Here, so that the class has one table of virtual functions in the process.
Source::Source() = default;
Source::~Source() = default;

} // namespace lumitree
