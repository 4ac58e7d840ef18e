// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiSolidAngle
 * @brief The solid angle in sr that a surface takes up as seen from points.
 *
 * Inputs: port 0 the points (any dataset or composite), port 1 the surface (any dataset or
 * composite, as one), port 2 what hides it (any dataset or composite; optional: without it the
 * surface hides itself only).
 *
 * Output: the points with arrays in the point data, all double with one component:
 *  - `SolidAngle [sr]`: the sum over the surface's triangles of the formula of Van Oosterom and
 * Strackee (1983), positive where a triangle's normal by winding points away from the point: what
 * lies one behind the other adds up, or cancels. Around a point inside a closed surface with
 * outward normals it is 4 pi, outside 0; of a piece of surface that is seen from its back it is its
 * size.
 *  - `VisibleSolidAngle [sr]` (VisiblePart): the directions in which the surface is seen, from
 * either side: 0 to 4 pi. Exact where few things are in the way, else by rays to a tolerance. NaN
 * where a coordinate is not finite.
 *
 * Wrong input (no surface) is one error and an empty output.
 */
#ifndef vtkLumiSolidAngle_h
#define vtkLumiSolidAngle_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkLumiStructureAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiSolidAngle : public vtkLumiStructureAlgorithm
{
public:
  static vtkLumiSolidAngle* New();
  vtkTypeMacro(vtkLumiSolidAngle, vtkLumiStructureAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surface, input port 1.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* output);
  void SetSurfaceData(vtkDataObject* surface);
  ///@}

  ///@{
  /**
   * What hides the surface, input port 2. It should hold the surface itself if that is to hide
   * itself.
   */
  void SetOccludersConnection(vtkAlgorithmOutput* output);
  void SetOccludersData(vtkDataObject* occluders);
  ///@}

  ///@{
  /**
   * Whether the visible part is measured, too. Default off.
   */
  vtkSetMacro(VisiblePart, bool);
  vtkGetMacro(VisiblePart, bool);
  vtkBooleanMacro(VisiblePart, bool);
  ///@}

  ///@{
  /**
   * How far the visible part may be off where rays are cast, relative to it. Range 0 to 1, default
   * 0.01.
   */
  vtkSetClampMacro(RelativeTolerance, double, 0.0, 1.0);
  vtkGetMacro(RelativeTolerance, double);
  ///@}

protected:
  vtkLumiSolidAngle();
  ~vtkLumiSolidAngle() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiSolidAngle(const vtkLumiSolidAngle&) = delete;
  void operator=(const vtkLumiSolidAngle&) = delete;

  bool VisiblePart = false;
  double RelativeTolerance = 0.01;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
