// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeDivision_h
#define Lumitree_Accel_Structures_KdTreeDivision_h

#include "Accel/Structures/KdTreeDivide.h"

namespace lumitree
{

/// A cell and what reaches into it while a KD-tree is built.
struct KdPart
{
  Box cell;
  std::vector<KdReference> references;        ///< ascending by id
  std::array<std::vector<KdEvent>, 3> events; ///< theirs, sorted; none where nobody looks at them
  std::size_t allowance = 0; ///< references that the leaves below may hold together
  int depth = 0;
};

/// Puts what a cell holds into the two cells beside a plane. Keeps its memory from cell to cell.
class KdDivision
{
public:
  /// The references; false, and the parts of no use, where they would be more than allowed. The
  /// parts' events follow by takeEvents, if wanted.
  [[nodiscard]] bool divide(const Surface& surface, const KdPart& whole, const KdSplit& split,
    KdPart& below, KdPart& above);

  /// Their events on one axis. From several threads, for different axes.
  void takeEvents(const KdPart& whole, int axis, KdPart& below, KdPart& above);

private:
  void addPart(const Surface& surface, const KdReference& whole, KdSide side, KdPart& part);

  KdSideMap sides_;
  std::array<std::array<std::vector<KdEvent>, 3>, 2> fresh_; ///< events of parts by side and axis
};

} // namespace lumitree

#endif
