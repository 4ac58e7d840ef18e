// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_PrimitiveBoxOverlap_h
#define Lumitree_Accel_Structures_PrimitiveBoxOverlap_h

#include "Accel/Structures/QuadricBoxOverlap.h"
#include "Accel/Structures/TriangleBoxOverlap.h"
#include "Accel/Surface.h"

#include <optional>

namespace lumitree
{

/// Whether a primitive and closed boxes may have a point in common: never false where they have.
class PrimitiveBoxOverlap
{
public:
  PrimitiveBoxOverlap(const Surface& surface, PrimitiveId id)
  {
    if (surface.isQuadric(id))
    {
      this->quadric_ = &surface.quadric(id);
    }
    else
    {
      this->triangle_.emplace(surface.vertices(id));
    }
  }

  /// The primitive's own bounds.
  [[nodiscard]] const Box& bounds() const
  {
    return this->quadric_ ? this->quadric_->clip : this->triangle_->bounds();
  }

  [[nodiscard]] bool mayMeet(const Box& box) const
  {
    return this->quadric_ ? lumitree::mayMeet(*this->quadric_, box) : this->triangle_->mayMeet(box);
  }

private:
  const Quadric* quadric_ = nullptr;
  std::optional<TriangleBoxOverlap> triangle_;
};

} // namespace lumitree

#endif
