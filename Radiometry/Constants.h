// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Constants_h
#define Lumitree_Radiometry_Constants_h

namespace lumitree
{

inline constexpr double pi = 3.14159265358979323846;

} // namespace lumitree

#endif
