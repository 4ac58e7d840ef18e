// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiCastArrays_h
#define Lumitree_Filters_Rays_LumiCastArrays_h

#include "LumiCast.h"
#include "LumiSurfaceInput.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace lumitree::filters
{

/// Where the hits of a cast go: those of ray i are offsets[i] … offsets[i] + count(i) - 1.
struct HitLayout
{
  vtkNew<vtkIdTypeArray> offsets; ///< one per ray, the array HitOffset itself
  vtkIdType total = 0;

  HitLayout(const Cast& cast, int threads);
};

/// How many rays of a cast hit, and all hits together.
struct HitTotals
{
  std::uint64_t raysHit = 0;
  std::uint64_t hits = 0;
};

/// Adds the arrays of the output Rays (Docs/data-model.md). layout: null when the cast gives no
/// hits; counters: one per ray, or null when nothing was counted.
HitTotals addRayArrays(const Cast& cast, const HitLayout* layout, const SurfaceInput& surface,
  const RayCounters* counters, int threads, vtkDataSetAttributes* rays);

struct HitOptions
{
  bool doublePoints = false;
  bool processIds = false; ///< a run over several ranks
  int threads = 0;
};

/// Makes the points, vertices and arrays of the output Hits (Docs/data-model.md) of a cast that
/// gives hits. primitives receives the primitive of each of the layout's hits.
void makeHits(const Cast& cast, const HitLayout& layout, const RayBatch& rays,
  const SurfaceInput& surface, const HitOptions& options, PrimitiveId* primitives,
  vtkPolyData* hits);

} // namespace lumitree::filters

#endif
