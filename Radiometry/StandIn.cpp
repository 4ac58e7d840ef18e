// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
namespace lumitree
{
int standInRadiometry();
int standInRadiometry()
{
  return 0;
}
}
