// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Lumitree_Accel_Reference_CGAL_CgalTree_h
#define Lumitree_Accel_Reference_CGAL_CgalTree_h

#include "Accel/BuildProgress.h"
#include "Accel/Surface.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace lumitree
{

/// CGAL's AABB tree over the triangles of a surface that can be hit. CGAL builds to its end: a stop
/// is heard before and after. Not thread-safe: CGAL's lazy numbers change when they are read. The
/// surface must outlive it.
class CgalTree
{
public:
  CgalTree() = default;
  virtual ~CgalTree() = default;
  CgalTree(const CgalTree&) = delete;
  CgalTree& operator=(const CgalTree&) = delete;

  /// Every hit of a valid ray, ordered by (t, primitive), into hits. Primitives skipFirst …
  /// skipLast - 1 (ascending) are left out.
  virtual void all(const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast,
    std::vector<Hit>& hits) const = 0;

  /// Of these, the hits at the least t: the exact one, where it is known.
  virtual void ties(const Ray& ray, const PrimitiveId* skipFirst, const PrimitiveId* skipLast,
    std::vector<Hit>& hits) const
  {
    this->all(ray, skipFirst, skipLast, hits);
    const auto beyond = [&](const Hit& hit) { return hit.t != hits.front().t; };
    hits.erase(std::find_if(hits.begin(), hits.end(), beyond), hits.end());
  }

  /// Bytes, as far as CGAL lets one know.
  [[nodiscard]] virtual std::size_t memory() const = 0;
};

/// Exact predicates and constructions; hits are ordered by the exact t.
[[nodiscard]] std::unique_ptr<const CgalTree> makeEpeckTree(
  const Surface& surface, BuildProgress& progress);

/// Exact predicates about rays as CGAL stores them (the origin and a second point, the rounded
/// origin
/// + direction), t of constructions in doubles.
[[nodiscard]] std::unique_ptr<const CgalTree> makeEpickTree(
  const Surface& surface, BuildProgress& progress);

/// Doubles throughout (Simple_cartesian<double>).
[[nodiscard]] std::unique_ptr<const CgalTree> makeCartesianTree(
  const Surface& surface, BuildProgress& progress);

} // namespace lumitree

#endif
