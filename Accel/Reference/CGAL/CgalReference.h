// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Lumitree_Accel_Reference_CGAL_CgalReference_h
#define Lumitree_Accel_Reference_CGAL_CgalReference_h

#include "Accel/Reference/CGAL/Export.h"

namespace lumitree
{

/// Adds Structure::Cgal, CgalEpick and CgalCartesian to the registry of back ends. Loading the
/// library does so, too; a program that links it calls this, because a linker drops a library of
/// which nothing is called. Calling it again changes nothing. Thread-safe.
LUMITREE_REFERENCE_CGAL_EXPORT void registerCgal();

} // namespace lumitree

#endif
