// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiLeaves_h
#define LumiLeaves_h

#include "vtkDataObject.h"
#include "vtkDataSet.h"

#include <cstdint>
#include <vector>

namespace lumitree::filters
{

/// A dataset of the input.
struct InputLeaf
{
  vtkDataSet* data = nullptr;
  std::int64_t compositeIndex = 0;
};

/// A dataset itself, or the datasets of a composite (multiblock, partitioned, AMR) in its order,
/// empty nodes skipped. Tables within a composite have no geometry and are passed over; null has no
/// leaves. Throws std::invalid_argument for anything else, rather than leaving out geometry that
/// was meant to cast a shadow.
[[nodiscard]] std::vector<InputLeaf> leavesOf(vtkDataObject* input);

/// What the geometry of leaves is recognised by: identities and MTimes, and what changes when
/// someone changes an array in place and forgets to say so. Two keys are compared for equality:
/// with "newer than" an older mesh put in the place of a newer one would not be noticed.
///
/// An address may be used again by another array after the first was freed, but an MTime never: VTK
/// counts them up for the whole process. So equal keys mean the same array in the same state, and
/// nothing has to be kept alive for the comparison.
using GeometryKey = std::vector<std::uint64_t>;
[[nodiscard]] GeometryKey keyOf(const std::vector<InputLeaf>& leaves);

} // namespace lumitree::filters
#endif
