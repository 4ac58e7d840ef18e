// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhBuilder.h"

#include "Accel/Structures/BvhBinned.h"
#include "Accel/Structures/BvhDriver.h"
#include "Accel/Structures/BvhFrame.h"
#include "Accel/Structures/BvhMedian.h"
#include "Accel/Structures/BvhMorton.h"
#include "Accel/Structures/BvhSpatial.h"
#include "Accel/Structures/BvhSweep.h"

namespace lumitree
{
namespace
{

constexpr std::size_t chunk = 16384;
/// Spatial splits may add so many references per primitive.
constexpr double roomForParts = 0.5;

/// The surface's primitives as references, and the root's segment.
struct Start
{
  BuildReferences references;
  BvhSegment root;

  Start(const Surface& surface, const WideBvhFrame& frame, double room, BuildProgress& progress)
  {
    const std::vector<PrimitiveId>& ids = surface.hittable();
    this->root.end = ids.size();
    this->root.limit =
      ids.size() + static_cast<std::size_t>(room * static_cast<double>(ids.size()));
    this->references = BuildReferences(this->root.limit);
    std::vector<BvhSegment> parts((ids.size() + chunk - 1) / chunk);
    progress.stage(0.08, ids.size());
    progress.forEach(ids.size(), chunk,
      [&](std::size_t begin, std::size_t end)
      {
        BvhSegment part;
        for (std::size_t i = begin; i < end; ++i)
        {
          BuildReference& r = this->references[i];
          const Box box = surface.box(ids[i]);
          for (int k = 0; k < 3; ++k)
          {
            r.lower[k] = roundedDown(box.lower[k], frame.centre[k], frame.scale);
            r.upper[k] = roundedUp(box.upper[k], frame.centre[k], frame.scale);
          }
          r.id = ids[i];
          r.unused = 0;
          part.bounds.extend(r.low(), r.high());
          part.centres.extend(r.centre());
        }
        parts[begin / chunk] = part;
      });
    for (const BvhSegment& part : parts)
    {
      this->root.bounds.extend(part.bounds);
      this->root.centres.extend(part.centres);
    }
  }
};

template <class Strategy>
void divide(Strategy&& strategy, const BvhSegment& root, const BuildOptions& options,
  BuildProgress& progress, BvhTree& tree)
{
  progress.stage(0.7, root.count());
  BvhDriver<std::remove_reference_t<Strategy>>(
    strategy, options.leafSize, options.maxDepth, progress)
    .build(root, tree);
}

} // namespace

BvhTree buildBvhTree(const Surface& surface, const BuildOptions& options, BuildProgress& progress)
{
  BvhTree tree;
  tree.frame = frameOf(surface.bounds());
  tree.clipped = options.bvhBuild == BvhBuild::SpatialSplits;
  Start start(surface, tree.frame, tree.clipped ? roomForParts : 0.0, progress);
  BuildReferences& references = start.references;
  switch (options.bvhBuild)
  {
    case BvhBuild::LongestAxisMedian:
      divide(MedianStrategy(references, options.leafSize), start.root, options, progress, tree);
      break;
    case BvhBuild::BinnedSah:
      divide(BinnedStrategy(references, options.leafSize, progress), start.root, options, progress,
        tree);
      break;
    case BvhBuild::SweepSah:
      divide(
        SweepStrategy(references, options.leafSize, progress), start.root, options, progress, tree);
      break;
    case BvhBuild::SpatialSplits:
      divide(
        SpatialStrategy(surface, tree.frame, references, start.root, options.leafSize, progress),
        start.root, options, progress, tree);
      break;
    case BvhBuild::Morton:
      divide(MortonStrategy(references, start.root, options.leafSize, progress), start.root,
        options, progress, tree);
      boundFromBelow(tree);
      break;
  }
  return tree;
}

} // namespace lumitree
