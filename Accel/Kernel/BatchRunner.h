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
  BatchRunner(const Surface& surface, const void* structure, StructureWalks walks,
    const void* blocks, std::size_t nodeCount);

  QueryReport closest(const RayBatch& rays, Hit* hits, const QueryOptions& options) const;
  QueryReport any(const RayBatch& rays, std::uint8_t* hit, const QueryOptions& options) const;
  QueryReport all(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const;
  QueryReport ties(const RayBatch& rays, AllHits& hits, const QueryOptions& options) const;
  QueryReport count(const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const;
  QueryReport crossings(
    const RayBatch& rays, std::uint32_t* counts, const QueryOptions& options) const;

private:
  class Chunk;

  /// Whether rays that start in one point are to be traced together.
  bool goTogether(const RayBatch& rays, QueryKind query, const QueryOptions& options) const;

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
};

} // namespace lumitree

#endif
