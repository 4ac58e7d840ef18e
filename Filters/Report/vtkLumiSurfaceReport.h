// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiSurfaceReport
 * @brief Tells whether a surface is closed, manifold and consistently wound, what is wrong with it
 * and where, and which promises of rays hold for it.
 *
 * Input: any dataset or any composite of them, as one scene, cut into triangles as rays see it.
 *
 * Outputs (arrays and columns are listed in Docs/data-model.md):
 *  - port 0 *Surface*, a vtkPolyData: the triangles with CellId and CompositeIndex of the cells
 *    they came from, Component, and Defect, the active scalar: what is wrong with each, one of
 *    Defects. Points tell whether they lie on a Boundary and whether they are NonManifold.
 *  - port 1 *Edges*, a vtkPolyData: boundary loops, non-manifold and inconsistent edges as lines,
 *    with Kind (the active scalar, one of EdgeKinds), Faces (at each edge) and Closed.
 *  - port 2 *Report*, a vtkTable of one row.
 *
 * Two promises are told of. WatertightApplies: no boundary edge, so that with the precisions
 * Watertight and Exact no ray gets through. InsideOutsideApplies: an even number of faces at every
 * edge, so that the number of hits of a ray (Exact) is even or odd as its origin lies outside or
 * inside. Whether a surface passes through itself is not looked for, and changes neither.
 *
 * Triangles with a coordinate that is not finite are holes, for rays do not see them. Those of zero
 * area are no holes: they close the gap between a long edge and the two it was cut into. Borders
 * are walked on half-edges by OpenMesh, which refuses what is not manifold: those triangles are
 * told, and what is left is still walked. A build without OpenMesh answers with one error.
 *
 * Bodies that are no triangles (of vtkLumiImplicitSurface) are left out, with one warning.
 *
 * In a run over several ranks the surface is gathered, and rank 0 gives the outputs for all.
 */
#ifndef vtkLumiSurfaceReport_h
#define vtkLumiSurfaceReport_h

#include "LumitreeFiltersReportModule.h" // for export macro
#include "vtkDataObjectAlgorithm.h"

#include <memory> // for the implementation

#ifndef VTK_ABI_NAMESPACE_BEGIN // before VTK 9.3
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class LUMITREEFILTERSREPORT_EXPORT vtkLumiSurfaceReport : public vtkDataObjectAlgorithm
{
public:
  static vtkLumiSurfaceReport* New();
  vtkTypeMacro(vtkLumiSurfaceReport, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of the array Defect: of several the first that applies.
   */
  enum Defects
  {
    Sound = 0,
    NonFinite = 1,  ///< a coordinate is not finite: never hit
    Degenerate = 2, ///< zero area, decided exactly: never hit
    Duplicate = 3,  ///< the same three points as an earlier triangle
    Refused = 4, ///< half-edges do not take it: more than two faces at an edge, or fans at a point
    Flipped = 5  ///< wound against most of its neighbours
  };

  /**
   * Values of the array Kind.
   */
  enum EdgeKinds
  {
    Boundary = 0,    ///< one face
    NonManifold = 1, ///< more than two faces
    Inconsistent = 2 ///< two faces that run along it in the same direction
  };

  ///@{
  /**
   * Whether points of the same coordinates (equal to the last bit) are one point, as they are for
   * rays; without, faces are joined only where they name the same point of the same dataset, and an
   * unwelded mesh (of an STL file) falls apart. Default on.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * Over whose ranks the surface is spread; null means that this process holds all of it. Default
   * vtkMultiProcessController::GetGlobalController().
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkLumiSurfaceReport();
  ~vtkLumiSurfaceReport() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLumiSurfaceReport(const vtkLumiSurfaceReport&) = delete;
  void operator=(const vtkLumiSurfaceReport&) = delete;

  bool MergeCoincidentPoints = true;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
