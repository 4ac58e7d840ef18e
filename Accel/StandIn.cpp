// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
namespace lumitree
{
int standInAccel();
int standInAccel()
{
  return 0;
}
}
