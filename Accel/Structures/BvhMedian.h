// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_BvhMedian_h
#define Lumitree_Accel_Structures_BvhMedian_h

#include "Accel/Structures/BvhSegment.h"

namespace lumitree
{

/// The textbook's split: along the longest axis of the node's box, at the object in the middle.
class MedianStrategy
{
public:
  MedianStrategy(BuildReferences& references, int leafSize)
    : references_(references)
    , leafSize_(static_cast<std::size_t>(leafSize))
  {
  }

  bool split(BvhSegment& segment, bool, BvhSegment& left, BvhSegment& right, int& axis)
  {
    if (segment.count() <= this->leafSize_)
    {
      return false;
    }
    axis = segment.bounds.longestAxis();
    halveSegment(this->references_, axis, segment, left, right);
    return true;
  }

  void ids(BvhSegment& segment, PrimitiveId* out) const
  {
    for (std::size_t i = segment.begin; i < segment.end; ++i)
    {
      *out++ = this->references_[i].id;
    }
  }

private:
  BuildReferences& references_;
  std::size_t leafSize_;
};

} // namespace lumitree

#endif
