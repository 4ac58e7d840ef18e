// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Lumitree_Accel_Reference_CGAL_Export_h
#define Lumitree_Accel_Reference_CGAL_Export_h

#if defined(_WIN32)
#ifdef LumitreeReferenceCGAL_EXPORTS
#define LUMITREE_REFERENCE_CGAL_EXPORT __declspec(dllexport)
#else
#define LUMITREE_REFERENCE_CGAL_EXPORT __declspec(dllimport)
#endif
#else
#define LUMITREE_REFERENCE_CGAL_EXPORT __attribute__((visibility("default")))
#endif

#endif
