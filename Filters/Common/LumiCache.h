// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiCache_h
#define LumiCache_h

#include "LumiSurfaceInput.h"
#include "LumitreeFiltersCommonModule.h"
#include "vtkLumiABI.h"

#include "Accel/Accelerator.h"

#include <cstdint>
#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataObject;
class vtkMultiProcessController;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// An accelerator and what it was made from.
struct Tree
{
  std::shared_ptr<const SurfaceInput> input;
  std::shared_ptr<const Accelerator> accelerator;
  BuildOptions asked; ///< what it was asked for with
  std::string file;   ///< what it was to be loaded from or saved to
  /// What this call of treeFor took, next to nothing where something was at hand: to find or make
  /// the surface, and the accelerator.
  double surfaceSeconds = 0.0;
  double buildSeconds = 0.0;
};

/// How a structure may come about beside being built from nothing.
struct TreeSource
{
  std::shared_ptr<const Tree> before; ///< what the filter had: refitted if refit is set
  bool refit = false;
  double refitLimit = 2.0; ///< a refit whose cost has grown by more is built anew
  std::string file;        ///< of a saved structure; empty: none
  int fileUse = 0;         ///< vtkLumiStructureAlgorithm::StructureFileUses
};

/// Whether the point and cell arrays of other ranks are gathered with the triangles. Only those who
/// interpolate need them. Without effect on one rank, where the leaves are at hand.
enum class GatherArrays
{
  No,
  Yes
};

/// The surface of a dataset, or of a composite as one scene.
///
/// Surfaces and accelerators are shared by all filters of the process and last as long as someone
/// uses them: a filter keeps what it got until its next execution. They are found again by the
/// identity and the equality of the MTimes of each leaf's points, connectivity and ghosts (of a
/// leaf that is no vtkPolyData: of the dataset), so that new point data, rays or lights rebuild
/// nothing.
///
/// With a controller of several ranks the call is collective and every rank gets the surface of all
/// of them, in order of rank. Without input data (null) a rank takes part with nothing.
///
/// On bad input: one vtkErrorMacro of the reporter (on every rank), and null. The reporter's
/// progress is not touched. threads: to convert with, as threadsFor gives them.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::shared_ptr<const SurfaceInput> surfaceFor(
  vtkDataObject* input, vtkMultiProcessController* controller, vtkAlgorithm* reporter,
  GatherArrays arrays = GatherArrays::Yes, int threads = 0);

/// The accelerator over that surface, built if nobody has it yet, with options.threads threads, as
/// the surface is converted. Unknown structures and options out of range are reported like bad
/// input. Null without a message when the control was told to stop, on any rank. With a source also
/// refitted, loaded and saved; a file that cannot be is one error, on every rank.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::shared_ptr<const Tree> treeFor(vtkDataObject* input,
  const BuildOptions& options, vtkMultiProcessController* controller, vtkAlgorithm* reporter,
  GatherArrays arrays = GatherArrays::Yes, JobControl* control = nullptr,
  const TreeSource& source = {});

/// How many accelerators this process has built, for tests.
[[nodiscard]] LUMITREEFILTERSCOMMON_EXPORT std::uint64_t treeBuilds();

} // namespace lumitree::filters
#endif
