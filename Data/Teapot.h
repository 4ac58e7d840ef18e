// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LUMITREE_DATA_TEAPOT_H
#define LUMITREE_DATA_TEAPOT_H

#include "Data/MeshBuilder.h"

namespace lumitree::data
{

/// The order of the teapot's parts in a mesh.
enum class TeapotPart
{
  Body,
  Handle,
  Spout,
  Lid,
  Bottom
};

/// Adds the teapot and its parts; one unit of Newell's data becomes scale metres.
void addTeapot(MeshBuilder& builder, int divisions, double scale);

}

#endif
