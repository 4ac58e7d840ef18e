// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_PrimitiveBoxOverlap_h
#define Lumitree_Accel_Structures_PrimitiveBoxOverlap_h

#include "Accel/Structures/BodyBoxOverlap.h"
#include "Accel/Structures/TriangleBoxOverlap.h"

#include <optional>

namespace lumitree
{

/// Whether a primitive and closed boxes may have a point in common: never false where they have.
class PrimitiveBoxOverlap
{
public:
  PrimitiveBoxOverlap(const Surface& surface, PrimitiveId id)
    : surface_(surface)
    , id_(id)
  {
    if (surface.isTriangle(id))
    {
      this->triangle_.emplace(surface.vertices(id));
    }
    else
    {
      this->clip_ = surface.box(id);
    }
  }

  /// The primitive's own bounds.
  [[nodiscard]] const Box& bounds() const
  {
    return this->triangle_ ? this->triangle_->bounds() : this->clip_;
  }

  [[nodiscard]] bool mayMeet(const Box& box) const
  {
    return this->triangle_ ? this->triangle_->mayMeet(box)
                           : lumitree::mayMeet(this->surface_, this->id_, box);
  }

private:
  const Surface& surface_;
  PrimitiveId id_;
  Box clip_;
  std::optional<TriangleBoxOverlap> triangle_;
};

} // namespace lumitree

#endif
