// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_InstructionSets_h
#define Lumitree_Accel_Kernel_InstructionSets_h

/// The instruction sets that kernels are compiled for: what the compiler may assume anyway, and on
/// x86 SSE4, AVX2 and AVX-512. Highway's others add compile time and no speed here. To be included
/// before Highway; it looks the names up later.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_AVX3_ZEN4 | HWY_AVX3_SPR)
#include <hwy/detect_targets.h>
#ifndef HWY_AVX3_ZEN4
#define HWY_AVX3_ZEN4 0
#endif
#ifndef HWY_AVX3_SPR
#define HWY_AVX3_SPR 0
#endif

#endif
