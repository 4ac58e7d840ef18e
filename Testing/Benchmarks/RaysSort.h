// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_RaysSort_h
#define Lumitree_Testing_Benchmarks_RaysSort_h

#include "RaysScenes.h"

#include <cstdint>
#include <vector>

namespace lumitree::benchmarks
{

/// What a caller of Embree may do to make incoherent rays coherent: their order by the octant of
/// the direction and, within it, along the Morton curve (9 bits an axis) of origins. Radix sort.
class RayOrder
{
public:
  /// The order of the rays; valid until the next call.
  const std::uint32_t* sort(const Rays& rays);

private:
  struct Keyed
  {
    std::uint32_t key;
    std::uint32_t ray;
  };
  std::vector<Keyed> keyed_;
  std::vector<Keyed> other_;
  std::vector<std::uint32_t> order_;
};

} // namespace lumitree::benchmarks

#endif
