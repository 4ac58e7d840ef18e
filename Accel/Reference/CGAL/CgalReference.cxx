// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accel/Reference/CGAL/CgalReference.h"

#include "Accel/Reference/CGAL/CgalAccelerator.h"
#include "Accel/Registry.h"

namespace lumitree
{

void registerCgal()
{
  Registry::instance().add({ Structure::Cgal,
    "CGAL's AABB tree with exact numbers, the ground truth (GPL; serial; shown as one node)",
    buildCgal });
  Registry::instance().add({ Structure::CgalEpick,
    "CGAL's AABB tree with exact predicates on rounded rays, t in doubles (GPL; serial; one node)",
    buildCgalEpick });
  Registry::instance().add({ Structure::CgalCartesian,
    "CGAL's AABB tree in doubles (GPL; serial; one node)", buildCgalCartesian });
}

namespace
{

[[maybe_unused]] const bool registeredOnLoad = (registerCgal(), true);

} // namespace

} // namespace lumitree
