// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiGather_h
#define LumiGather_h

#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// Whether there is more than one rank. Null is one.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT bool isDistributed(
  vtkMultiProcessController* controller);

/// The largest value that any rank brings. Collective; without other ranks the value itself.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT long long largestOfAll(
  vtkMultiProcessController* controller, long long value);

/// An object of another rank, with that rank.
struct GatheredObject
{
  vtkSmartPointer<vtkDataObject> object;
  int process = 0;
};

/// Every rank's objects on every rank, by rank and then in the order given: lights, or the surfaces
/// of occluders. Collective: a rank that has none calls it with an empty list. All objects must be
/// of the class of `prototype`. Throws std::runtime_error, on every rank, when a transfer fails.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::vector<GatheredObject> gatherObjects(
  vtkMultiProcessController* controller, const std::vector<vtkSmartPointer<vtkDataObject>>& mine,
  vtkDataObject* prototype);

} // namespace lumitree::filters
#endif
