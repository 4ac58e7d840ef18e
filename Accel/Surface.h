// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Surface_h
#define Lumitree_Accel_Surface_h

#include "Accel/Box.h"
#include "Accel/Export.h"
#include "Accel/Hit.h"
#include "Accel/Implicit.h"
#include "Accel/Quadric.h"
#include "Accel/Ray.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lumitree
{

/// Point indices of a triangle.
using Triangle = std::array<std::uint32_t, 3>;

/// Points of a surface, float or double, kept as given (never converted, never moved).
struct PointArray
{
  ArrayView values; ///< count triples
  std::size_t count = 0;
  std::shared_ptr<const void> owner; ///< keeps the memory alive

  /// Takes over a vector of xyz triples.
  ///@{
  LUMITREE_ACCEL_EXPORT static PointArray from(std::vector<float> xyz);
  LUMITREE_ACCEL_EXPORT static PointArray from(std::vector<double> xyz);
  ///@}
};

/// The cell a primitive came from.
struct SourceCell
{
  std::int64_t cell = -1;     ///< id within its dataset
  std::int64_t composite = 0; ///< flat index of that dataset, 0 when there is only one
};

/// Primitives first … next block's first - 1 came from one dataset of a composite.
struct SourceBlock
{
  PrimitiveId first = 0;
  std::int64_t composite = 0;
};

/// Where primitives came from. Primitives are stored in the order of (dataset, cell), so that the
/// lowest primitive is also the lowest cell.
struct SourceMap
{
  std::vector<std::int64_t> cells; ///< one per primitive; empty: primitive i is cell i
  std::vector<SourceBlock> blocks; ///< ascending by first; empty: one dataset, flat index 0
};

/// What the surfaces of a scene are made of: immutable triangles, quadrics and implicits, shared by
/// every structure built over them. Primitives 0 … T - 1 are the triangles, T … T + Q - 1 the
/// quadrics, the implicits come last. Primitives with a number that is not finite (or beyond
/// coordinateLimit), triangles of zero area (decided exactly) and bodies that have no points (an
/// empty box, a form of no second or first degree, or bounds in the box that exclude 0) stay in the
/// numbering but are never hit.
class LUMITREE_ACCEL_EXPORT Surface
{
public:
  /// Throws std::invalid_argument when a triangle names a point that does not exist, when there are
  /// more than 2^32 - 2 triangles, or when the map does not fit the triangles.
  /// threads: to examine the triangles with; 0: as many as oneTBB gives.
  Surface(
    PointArray points, std::vector<Triangle> triangles, SourceMap sources = {}, int threads = 0);

  /// The same with quadrics; the limits hold for all primitives together.
  Surface(PointArray points, std::vector<Triangle> triangles, std::vector<Quadric> quadrics,
    SourceMap sources = {}, int threads = 0);

  /// The same with implicits. Throws std::invalid_argument also where one has no function, or a
  /// step that is negative, not finite or less than 1e-6 of its box's diagonal.
  Surface(PointArray points, std::vector<Triangle> triangles, std::vector<Quadric> quadrics,
    std::vector<Implicit> implicits, SourceMap sources = {}, int threads = 0);

  [[nodiscard]] std::size_t pointCount() const { return this->points_.count; }
  [[nodiscard]] std::size_t size() const
  {
    return this->triangles_.size() + this->quadrics_.size() + this->implicits_.size();
  }
  [[nodiscard]] std::size_t triangleCount() const { return this->triangles_.size(); }
  [[nodiscard]] std::size_t quadricCount() const { return this->quadrics_.size(); }
  [[nodiscard]] std::size_t implicitCount() const { return this->implicits_.size(); }
  /// Implicits that can be hit and whose functions are not bounded.
  [[nodiscard]] std::size_t sampledCount() const { return this->sampled_; }
  /// Quadrics and implicits: what has no vertices.
  [[nodiscard]] std::size_t bodyCount() const { return this->size() - this->triangles_.size(); }
  [[nodiscard]] ArrayView::Scalar scalar() const { return this->points_.values.type; }
  [[nodiscard]] Vec3 point(std::size_t i) const { return this->points_.values.triple(i); }
  /// All coordinates as they are stored, pointCount() triples of scalar().
  [[nodiscard]] const void* pointData() const { return this->points_.values.data; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return this->triangles_; }
  /// i is a triangle.
  [[nodiscard]] const Triangle& triangle(PrimitiveId i) const { return this->triangles_[i]; }

  [[nodiscard]] bool isTriangle(PrimitiveId i) const { return i < this->triangles_.size(); }
  [[nodiscard]] bool isQuadric(PrimitiveId i) const
  {
    return !this->isTriangle(i) && !this->isImplicit(i);
  }
  [[nodiscard]] bool isImplicit(PrimitiveId i) const
  {
    return i >= this->triangles_.size() + this->quadrics_.size();
  }
  /// i is a quadric.
  [[nodiscard]] const Quadric& quadric(PrimitiveId i) const
  {
    return this->quadrics_[i - this->triangles_.size()];
  }

  /// i is an implicit.
  [[nodiscard]] const Implicit& implicit(PrimitiveId i) const
  {
    return this->implicits_[i - this->triangles_.size() - this->quadrics_.size()];
  }

  /// Of a body every coordinate is NaN: the filter of leaf tests is never sure about those.
  [[nodiscard]] std::array<Vec3, 3> vertices(PrimitiveId i) const
  {
    if (!this->isTriangle(i))
    {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      return { Vec3{ none, none, none }, Vec3{ none, none, none }, Vec3{ none, none, none } };
    }
    const Triangle& t = this->triangles_[i];
    return { this->point(t[0]), this->point(t[1]), this->point(t[2]) };
  }

  /// Unit normal in double arithmetic: of a triangle by its winding, of a body the direction in
  /// which its function grows at the point. 0 where there is none (a cone's apex).
  [[nodiscard]] Vec3 normal(PrimitiveId i, const Vec3& point) const;

  [[nodiscard]] Box box(PrimitiveId i) const
  {
    if (!this->isTriangle(i))
    {
      return this->isImplicit(i) ? this->implicit(i).clip : this->quadric(i).clip;
    }
    Box b;
    for (const std::uint32_t p : this->triangles_[i])
    {
      b.extend(this->point(p));
    }
    return b;
  }

  /// Primitives that can be hit, ascending; the others are counted below.
  [[nodiscard]] const std::vector<PrimitiveId>& hittable() const { return this->hittable_; }
  [[nodiscard]] std::size_t nonFiniteCount() const { return this->nonFinite_; }
  [[nodiscard]] std::size_t zeroAreaCount() const { return this->zeroArea_; }
  /// Of all bodies.
  [[nodiscard]] std::size_t emptyQuadricCount() const { return this->emptyQuadrics_; }

  /// Bounds of what can be hit.
  [[nodiscard]] const Box& bounds() const { return this->bounds_; }

  [[nodiscard]] SourceCell source(PrimitiveId i) const;
  [[nodiscard]] const SourceMap& sources() const { return this->sources_; }

  /// Bytes held, the points' memory included.
  [[nodiscard]] std::size_t memory() const;

private:
  PointArray points_;
  std::vector<Triangle> triangles_;
  std::vector<Quadric> quadrics_;
  std::vector<Implicit> implicits_;
  SourceMap sources_;
  std::vector<PrimitiveId> hittable_;
  std::size_t nonFinite_ = 0;
  std::size_t zeroArea_ = 0;
  std::size_t emptyQuadrics_ = 0;
  std::size_t sampled_ = 0;
  Box bounds_;
};

/// For references that know triangles only: throws std::invalid_argument, with the reference's
/// name, where the surface has quadrics or implicits.
LUMITREE_ACCEL_EXPORT void refuseBodies(const Surface& surface, const std::string& reference);

} // namespace lumitree

#endif
