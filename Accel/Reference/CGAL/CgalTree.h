// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Lumitree_Accel_Reference_CGAL_CgalTree_h
#define Lumitree_Accel_Reference_CGAL_CgalTree_h

#include "Accel/BuildProgress.h"
#include "Accel/Surface.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace lumitree
{

/// CGAL's AABB tree over the triangles of a surface that can be hit. Not thread-safe: CGAL's lazy
/// numbers change when they are read. The surface must outlive it.
class CgalTree
{
public:
  /// CGAL itself builds to its end: a stop is heard before and after.
  CgalTree(const Surface& surface, BuildProgress& progress);
  ~CgalTree();
  CgalTree(const CgalTree&) = delete;
  CgalTree& operator=(const CgalTree&) = delete;

  /// Every hit of a valid ray, ordered by (exact t, primitive), into hits. Primitives skipFirst …
  /// skipLast - 1 (ascending) are left out.
  void all(const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast,
    std::vector<Hit>& hits) const;

  /// Bytes, as far as CGAL lets one know.
  [[nodiscard]] std::size_t memory() const;

private:
  struct Internals;
  std::unique_ptr<Internals> internals_;
};

} // namespace lumitree

#endif
