// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_BatchRunner_h
#define Lumitree_Accel_Kernel_BatchRunner_h

#include "Accel/Accelerator.h"
#include "Accel/Kernel/BundleKernel.h"
#include "Accel/Kernel/RayKernel.h"
#include "Accel/Kernel/Visitors.h"

#include <functional>

namespace lumitree
{

/// How one ray goes through a structure.
struct StructureWalks
{
  /// Node test and leaf test in one function; null where the leaf stands behind the visitor.
  RayKernelChooser kernel = nullptr;
  /// Rays that start in one point, together; null where the structure has no such walk.
  BundleKernelChooser bundle = nullptr;
  void (*plain)(const void* structure, RayState&, LeafVisitor&) = nullptr;
  void (*counting)(const void* structure, RayState&, CountingVisitor&) = nullptr;
};

/// The walks of a structure that offers `template <class V> void walk(const RayBox&, V&) const`.
template <class Tree>
StructureWalks baselineWalks()
{
  StructureWalks walks;
  walks.plain = [](const void* tree, RayState& state, LeafVisitor& visitor)
  { static_cast<const Tree*>(tree)->walk(state.box(), visitor); };
  walks.counting = [](const void* tree, RayState& state, CountingVisitor& visitor)
  { static_cast<const Tree*>(tree)->walk(state.box(), visitor); };
  return walks;
}

/// Answers batches by walking ray after ray: threads, counters, validity, skipping and the order of
/// all hits, once for every structure.
class BatchRunner
{
public:
  /// memory: of the structure, in bytes; 0: rays are taken as they come in any case.
  BatchRunner(const Surface& surface, const void* structure, StructureWalks walks,
    const void* blocks, std::size_t nodeCount, std::size_t memory);

  QueryReport closest(const RayBatch& rays, Hit* hits, const QueryOptions& options) const;
  QueryReport any(const RayBatch& rays, std::uint8_t* hit, const QueryOptions& options) const;
  QueryReport all(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const;
  QueryReport ties(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const;
  QueryReport count(const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const;
  QueryReport crossings(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const;

private:
  class Chunk;

  /// How the rays of a batch go through the structure. Answers do not depend on it.
  enum class Course
  {
    AsTheyCome,
    ByOrigin, ///< in OriginOrder
    Together  ///< those that start in one point in bundles
  };
  Course courseOf(const RayBatch& rays, QueryKind query, const QueryOptions& options) const;

  /// Rays that one thread takes at a time.
  std::size_t chunkSize(Course course, const RayBatch& rays, const QueryOptions& options) const;

  /// All or Ties.
  QueryReport lists(
    const RayBatch& rays, QueryKind query, AllHits& hits, const QueryOptions& options) const;

  /// Count or Crossings.
  QueryReport numbers(const RayBatch& rays, QueryKind query, std::uint32_t* counts,
    const QueryOptions& options) const;

  using Clear = std::function<void(std::size_t begin, std::size_t end)>;
  using Body = std::function<void(std::size_t begin, std::size_t end, Chunk&)>;

  /// Calls clear and then body for each chunk of rays and gathers the chunks' reports; only clear
  /// for those that are not reached.
  QueryReport run(const RayBatch& rays, QueryKind query, const QueryOptions& options,
    const Clear& clear, const Body& body) const;

  const Surface& surface_;
  const void* structure_;
  StructureWalks walks_;
  const void* blocks_;
  std::size_t nodeCount_;
  std::size_t memory_;
};

} // namespace lumitree

#endif
