// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LUMITREE_DATA_EXPORT_H
#define LUMITREE_DATA_EXPORT_H

#if defined(_WIN32)
#if defined(LumitreeData_EXPORTS)
#define LUMITREE_DATA_EXPORT __declspec(dllexport)
#else
#define LUMITREE_DATA_EXPORT __declspec(dllimport)
#endif
#else
#define LUMITREE_DATA_EXPORT __attribute__((visibility("default")))
#endif

#endif
