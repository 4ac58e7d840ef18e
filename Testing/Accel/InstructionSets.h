// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_InstructionSets_h
#define Lumitree_Testing_Accel_InstructionSets_h

#include "Accel/Kernel/InstructionSets.h"

#include <hwy/highway.h>

#include <cstdint>
#include <string>
#include <vector>

/// Makes the kernels run with one instruction set of those they are compiled for. Kernels are
/// chosen batch by batch through Highway's table, which is one for the process.
namespace lumitree::testing
{

struct InstructionSet
{
  std::string name;
  std::int64_t target = 0; ///< Highway's bit

  /// Why it cannot be tried; empty: it can.
  [[nodiscard]] std::string lacking() const
  {
    if ((HWY_TARGETS & this->target) == 0)
    {
      return this->name + " is not among the instruction sets of this build";
    }
    if ((hwy::SupportedTargets() & this->target) == 0)
    {
      return "this machine lacks " + this->name;
    }
    return {};
  }
};

/// What the compiler may assume anyway, and the sets that kernels are compiled for beside it.
inline std::vector<InstructionSet> instructionSets()
{
  std::vector<InstructionSet> all = { { "Baseline", HWY_STATIC_TARGET } };
#if HWY_ARCH_X86
  all.push_back({ "SSE4", HWY_SSE4 });
  all.push_back({ "AVX2", HWY_AVX2 });
  all.push_back({ "AVX512", HWY_AVX3 });
#endif
  return all;
}

/// Forces one instruction set for its lifetime. Not while other threads trace.
class ForcedInstructionSet
{
public:
  explicit ForcedInstructionSet(const InstructionSet& set)
  {
    hwy::SetSupportedTargetsForTest(set.target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  ~ForcedInstructionSet()
  {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  ForcedInstructionSet(const ForcedInstructionSet&) = delete;
  ForcedInstructionSet& operator=(const ForcedInstructionSet&) = delete;
};

} // namespace lumitree::testing

#endif
