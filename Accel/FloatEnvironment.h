// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_FloatEnvironment_h
#define Lumitree_Accel_FloatEnvironment_h

#include <cfenv>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace lumitree
{

/// Sets round-to-nearest with subnormals kept for its lifetime and restores what was there. Hosts
/// change both: interval arithmetic rounds upward, audio and game code flushes subnormals.
class FloatEnvironment
{
public:
  FloatEnvironment()
  {
    std::fegetenv(&this->saved_);
    std::fesetround(FE_TONEAREST);
#if defined(__SSE__)
    // FTZ is bit 15 and DAZ bit 6 of the control register; FE_TONEAREST has cleared bits 13 and 14.
    _mm_setcsr(_mm_getcsr() & ~0x8040u);
#elif defined(__aarch64__)
    std::fesetenv(FE_DFL_ENV);
#endif
  }

  ~FloatEnvironment()
  {
    std::fesetenv(&this->saved_);
  }

  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

private:
  std::fenv_t saved_;
};

} // namespace lumitree

#endif
