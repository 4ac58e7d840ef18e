// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Any options on any surface: they are refused by std::invalid_argument, or every structure is
// built, describes itself, and holds what can be hit.
#include "FuzzInput.h"

#include <algorithm>
#include <stdexcept>

using namespace lumitree;
using namespace lumitree::testing;

namespace
{

void requireWholeView(const Accelerator& accelerator)
{
  const BuildOptions& options = accelerator.options();
  const HierarchyView view = accelerator.hierarchy();
  const auto& hittable = accelerator.surface().hittable();
  std::vector<PrimitiveId> referenced = view.references;
  std::sort(referenced.begin(), referenced.end());
  referenced.erase(std::unique(referenced.begin(), referenced.end()), referenced.end());
  require(referenced == hittable, "what can be hit and what is held differ", options);
  const BuildStatistics& s = accelerator.statistics();
  require(s.nodes == view.nodes.size(), "another number of nodes", options);
  require(s.depth <= std::max(options.maxDepth, 1), "deeper than allowed", options);
  require(!(s.sahCost < 0.0) && !std::isnan(s.duplication), "costs that are no numbers", options);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  BuildOptions changes;
  changes.leafSize = static_cast<int>(input.byte()) - 2;
  changes.maxDepth = static_cast<int>(input.byte() % 72) - 2;
  changes.gridDensity = input.byte() % 8 == 0 ? input.number() : 0.5;
  if (input.byte() % 4 == 0)
  {
    changes.gridResolution = { input.byte() % 64, input.byte() % 64, input.byte() % 64 };
  }
  const auto surface = input.surface(120);
  for (BuildOptions options : ownStructures())
  {
    options.leafSize = changes.leafSize;
    options.maxDepth = changes.maxDepth;
    options.gridDensity = changes.gridDensity;
    options.gridResolution = changes.gridResolution;
    options.mailboxing = changes.maxDepth % 2 == 0;
    try
    {
      const auto accelerator = build(surface, options);
      requireWholeView(*accelerator);
      (void)allOf(*accelerator, { { 0.5, 0.25, -3 }, { 0.1, 0.2, 1 } }, Precision::Watertight);
    }
    catch (const std::invalid_argument&)
    {
      continue;
    }
  }
  return 0;
}
