// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_RaysLocator_h
#define Lumitree_Testing_Benchmarks_RaysLocator_h

#include "RaysScenes.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <cstddef>

namespace lumitree::benchmarks
{

/// The surface of a scene, and rays as vtkLumiRayCast reads them: points with the array
/// RayDirection. Arrays hold floats, and are not copied where they need not be.
///@{
[[nodiscard]] vtkSmartPointer<vtkPolyData> surfaceData(const Scene& scene);
[[nodiscard]] vtkSmartPointer<vtkPolyData> rayData(const Rays& rays);
///@}

/// vtkStaticCellLocator::IntersectWithLine, called for one ray after the other.
class RawLocator
{
public:
  /// Builds the locator.
  explicit RawLocator(vtkPolyData* surface);

  /// The nearest hits of rays begin … end - 1, written to the same places of hits.
  void closest(const Rays& rays, std::size_t begin, std::size_t end, Hit* hits) const;

private:
  vtkSmartPointer<vtkStaticCellLocator> locator_;
  double reach_ = 0.0; ///< a line of this length from a ray's origin passes what can be hit
};

} // namespace lumitree::benchmarks

#endif
