// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiReceivers_h
#define LumiReceivers_h

#include "LumiSurfaceInput.h"
#include "vtkLumiABI.h"

#include "Accel/Ray.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// The values are part of the data model.
enum class ReceiverLocation : int
{
  Points = 0,
  Cells = 1
};

/// The points or cells of a dataset as receivers of light.
struct ReceiverInput
{
  enum class Kind : unsigned char
  {
    Undefined, ///< no normal: no cell, no area, or a normal of length 0
    Hidden,    ///< a ghost that receives nothing
    Plane,     ///< one side of a surface: irradiance
    Volume     ///< a cell of three dimensions, or a point in nothing else: scalar irradiance
  };

  std::vector<Kind> kinds;              ///< one per point or cell
  std::vector<double> positions;        ///< triples
  std::vector<double> normals;          ///< triples, unit length; NaN unless Plane
  std::vector<unsigned char> duplicate; ///< 1: a copy of another rank's receiver; empty: none is
  ArrayView::Scalar stored = ArrayView::Scalar::Double;

  /// Primitives of the cells that receiver i lies on: skipPrimitives[skipOffsets[i]] …
  /// skipOffsets[i + 1] - 1; empty when the receivers are not part of the occluders.
  std::vector<std::uint64_t> skipOffsets;
  std::vector<PrimitiveId> skipPrimitives;

  [[nodiscard]] std::size_t size() const { return this->kinds.size(); }
  [[nodiscard]] bool has(Kind kind) const;
};

/// Positions and normals of a dataset's points or cells. The dataset may be asked to build its
/// cells.
[[nodiscard]] ReceiverInput readReceivers(vtkDataSet* data, ReceiverLocation location, int threads);

/// Fills in what each receiver must not be shadowed by, given that the dataset is that leaf of the
/// occluders.
void findSkips(ReceiverInput& receivers, ReceiverLocation location, const SurfaceInput& occluders,
  std::size_t leaf, int threads);

} // namespace lumitree::filters
#endif
