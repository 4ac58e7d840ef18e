// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Export_h
#define Lumitree_Radiometry_Export_h

/// Marks what the shared library LumitreeRadiometry shows to others.
#if defined(_WIN32)
#ifdef LumitreeRadiometry_EXPORTS
#define LUMITREE_RADIOMETRY_EXPORT __declspec(dllexport)
#else
#define LUMITREE_RADIOMETRY_EXPORT __declspec(dllimport)
#endif
#else
#define LUMITREE_RADIOMETRY_EXPORT __attribute__((visibility("default")))
#endif

#endif
