// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Export_h
#define Lumitree_Accel_Export_h

/// Marks what the shared library LumitreeAccel shows to others (its sources compile with hidden
/// visibility).
#if defined(_WIN32)
#ifdef LumitreeAccel_EXPORTS
#define LUMITREE_ACCEL_EXPORT __declspec(dllexport)
#else
#define LUMITREE_ACCEL_EXPORT __declspec(dllimport)
#endif
#else
#define LUMITREE_ACCEL_EXPORT __attribute__((visibility("default")))
#endif

#endif
