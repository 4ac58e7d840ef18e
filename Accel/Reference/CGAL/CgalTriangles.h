// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Lumitree_Accel_Reference_CGAL_CgalTriangles_h
#define Lumitree_Accel_Reference_CGAL_CgalTriangles_h

#include "Accel/BuildProgress.h"
#include "Accel/Surface.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <cstddef>
#include <vector>

namespace lumitree
{

/// The triangles of a surface that can be hit, in a kernel's numbers, and CGAL's tree over them.
template <class Kernel>
class CgalTriangles
{
public:
  using Point = typename Kernel::Point_3;
  using Iterator = typename std::vector<typename Kernel::Triangle_3>::iterator;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  /// The surface must outlive it.
  CgalTriangles(const Surface& surface, BuildProgress& progress)
    : surface_(surface)
  {
    progress.stage(0.5, surface.hittable().size());
    this->triangles_.reserve(surface.hittable().size());
    for (const PrimitiveId id : surface.hittable())
    {
      const auto v = surface.vertices(id);
      this->triangles_.emplace_back(pointAt(v[0]), pointAt(v[1]), pointAt(v[2]));
      progress.advance(1);
    }
    this->tree_.insert(this->triangles_.begin(), this->triangles_.end());
    this->tree_.build();
  }
  // The tree points into the triangles.
  CgalTriangles(const CgalTriangles&) = delete;
  CgalTriangles& operator=(const CgalTriangles&) = delete;

  static Point pointAt(const Vec3& p) { return { p[0], p[1], p[2] }; }

  [[nodiscard]] const Surface& surface() const { return this->surface_; }
  [[nodiscard]] const Tree& tree() const { return this->tree_; }

  /// The primitive that a triangle found in the tree is.
  [[nodiscard]] PrimitiveId primitive(const Iterator& triangle) const
  {
    return this->surface_.hittable()[static_cast<std::size_t>(triangle - this->triangles_.begin())];
  }

  /// Bytes: a binary tree over n triangles has n - 1 nodes of a box and two pointers each.
  [[nodiscard]] std::size_t memory() const
  {
    return this->triangles_.size() *
      (sizeof(typename Kernel::Triangle_3) + sizeof(Primitive) + sizeof(CGAL::Bbox_3) +
        2 * sizeof(void*));
  }

private:
  const Surface& surface_;
  std::vector<typename Kernel::Triangle_3> triangles_;
  Tree tree_;
};

} // namespace lumitree

#endif
