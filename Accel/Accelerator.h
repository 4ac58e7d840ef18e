// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Accelerator_h
#define Lumitree_Accel_Accelerator_h

#include "Accel/BuildOptions.h"
#include "Accel/ConvexRegion.h"
#include "Accel/Export.h"
#include "Accel/Hierarchy.h"
#include "Accel/Hit.h"
#include "Accel/Query.h"
#include "Accel/Ray.h"
#include "Accel/Surface.h"

#include <iosfwd>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace lumitree
{

class OverlapIndex;
class SaveWriter;

/// A query that a structure does not answer (a precision it cannot promise, for example).
class LUMITREE_ACCEL_EXPORT UnsupportedQuery : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// What build throws when its job was stopped: nothing was built.
class LUMITREE_ACCEL_EXPORT BuildStopped : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A structure over a surface, ready for batches of rays. Immutable: any number of threads may
/// query it.
///
/// A primitive is hit when the closed segment of the ray meets the closed triangle and the ray is
/// not parallel to the triangle's plane. Of several hits at the same t, the lowest primitive wins.
/// A quadric is hit once per distinct root of its form along the line whose point is in the segment
/// and in the quadric (Quadric.h): a sphere twice, a tangent once, a form that is 0 all along the
/// line never. All lists and Count counts these hits, so a quadric up to twice.
/// The outputs hold one element per ray of the batch and are written whole.
class LUMITREE_ACCEL_EXPORT Accelerator
{
public:
  Accelerator(std::shared_ptr<const Surface> surface, const BuildOptions& options);
  virtual ~Accelerator();
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  [[nodiscard]] const Surface& surface() const { return *this->surface_; }
  [[nodiscard]] std::shared_ptr<const Surface> sharedSurface() const { return this->surface_; }

  /// What was built; structure is never Auto here.
  [[nodiscard]] const BuildOptions& options() const { return this->options_; }
  [[nodiscard]] const BuildStatistics& statistics() const { return this->statistics_; }

  /// Whether queries of that precision are answered; others throw UnsupportedQuery.
  [[nodiscard]] virtual bool supports(Precision) const = 0;

  /// The most exact precision of those that it supports: Exact of all structures of ours.
  [[nodiscard]] Precision bestPrecision() const;

  /// The nearest hit of each ray.
  virtual QueryReport closest(
    const RayBatch& rays, Hit* hits, const QueryOptions& options = {}) const = 0;

  /// Whether each ray hits anything: 1 or 0.
  virtual QueryReport any(
    const RayBatch& rays, std::uint8_t* hit, const QueryOptions& options = {}) const = 0;

  /// Every hit of each ray, ordered by (t, primitive).
  virtual QueryReport all(
    const RayBatch& rays, AllHits& hits, const QueryOptions& options = {}) const = 0;

  /// Every hit of each ray at its least t, ascending by primitive: the closest hit and all that tie
  /// with it. Exact compares the exact t, and all ties of a ray report the same t; the other
  /// precisions compare what they computed.
  virtual QueryReport ties(
    const RayBatch& rays, AllHits& hits, const QueryOptions& options = {}) const;

  /// How many hits each ray has: of a triangle one, of a quadric up to two.
  virtual QueryReport count(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options = {}) const = 0;

  /// How many times each ray passes through the surface. An edge or a vertex of a closed surface
  /// counts as one passage, two (or none) where the ray only touches, on whatever side; this also
  /// of surfaces whose triangles share no points (STL). So with tMax infinite the count is odd for
  /// an origin inside a closed surface and even outside. Only Exact keeps that, of triangles; with
  /// another precision, over quadrics, and from references, UnsupportedQuery is thrown.
  ///
  /// What is counted are the crossings of the ray moved by (e, e^2, e^3), for every small enough
  /// e > 0: nothing then meets an edge, or ends on a triangle, or lies in its plane. An origin on
  /// the surface is as far inside as the point moved by that, in every direction; consecutive
  /// segments of one line add up.
  virtual QueryReport crossings(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options = {}) const;

  /// Primitives that may meet the region, which is closed: of those that can be hit, all but those
  /// that lie wholly outside one of its half-spaces by more than rounding could account for (some
  /// 2^-50 of the coordinates). Ascending, each once; the same from every structure; primitives is
  /// overwritten. Throws std::invalid_argument for NaN and for normals that are not finite. On the
  /// calling thread; the first call also makes an index of the structure's nodes, 64 bytes each.
  ///
  /// limit: stops as soon as more than that were found; then primitives holds more than limit, but
  /// not all, and which of them depends on the structure.
  virtual void overlap(const ConvexRegion& region, std::vector<PrimitiveId>& primitives,
    std::size_t limit = std::numeric_limits<std::size_t>::max()) const;

  /// The same nodes over a surface whose points have moved since, with boxes that fit them anew: far
  /// quicker than building, and answers are those of the new surface, exactly as after a build.
  /// Rays cost more the more the points have moved against each other: compare sahCost with
  /// sahCostBuilt in statistics(). Meant for the same triangles and quadrics in the same order.
  ///
  /// Null where it cannot be done, and building is the way: of structures that are not hierarchies
  /// of boxes around primitives (all but Bvh and WideBvh; of these SpatialSplits, whose boxes are
  /// around parts), where the number of primitives is another, and where one can be hit now that
  /// could not be before (a coordinate was not finite, an area was 0). Throws BuildStopped.
  /// threads: 0: as many as oneTBB gives.
  [[nodiscard]] std::shared_ptr<const Accelerator> refit(
    std::shared_ptr<const Surface> surface, int threads = 0, JobControl* control = nullptr) const;

  /// The structure as a flat list of nodes; one node (a leaf) where there is no hierarchy.
  [[nodiscard]] virtual HierarchyView hierarchy() const = 0;

protected:
  /// refit, of a surface with as many primitives.
  [[nodiscard]] virtual std::shared_ptr<const Accelerator> refitted(
    std::shared_ptr<const Surface> surface, int threads, JobControl* control) const;

  /// Writes what a back end's load reads; false where there is no such thing.
  virtual bool saveTo(SaveWriter& writer) const;

  BuildStatistics statistics_;
  BuildOptions options_;

private:
  friend LUMITREE_ACCEL_EXPORT void save(const Accelerator&, std::ostream&);
  friend LUMITREE_ACCEL_EXPORT std::shared_ptr<const Accelerator> build(
    std::shared_ptr<const Surface>, const BuildOptions&, JobControl*);

  std::shared_ptr<const Surface> surface_;
  mutable std::once_flag overlapOnce_;
  mutable std::unique_ptr<const OverlapIndex> overlapIndex_;
};

/// Builds what the options ask for (for Auto what chooseStructure of AutoChoice.h says) through the
/// registry of back ends; never null. Throws std::invalid_argument for options out of range,
/// UnknownStructure (Registry.h) for a structure that this build lacks, and BuildStopped when
/// control was told to stop. Progress is told on the calling thread, rising from 0 to 1; after an
/// exception nothing is left of the build.
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::shared_ptr<const Accelerator> build(
  std::shared_ptr<const Surface> surface, const BuildOptions& options = {},
  JobControl* control = nullptr);

} // namespace lumitree

#endif
