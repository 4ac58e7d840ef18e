// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiAccelerationStructure
 * @brief Shows the structure that rays are cast with: its nodes level by level, what they cost, and
 * how many rays entered each.
 *
 * Inputs: port 0 the surface (any dataset or any composite of them, as one scene), port 1 rays
 * (optional, in the forms that vtkLumiRayCast takes).
 *
 * Outputs: port 0 a vtkMultiBlockDataSet, whose block i, "Level i", holds the nodes of depth i as
 * boxes, with a last block "Leaves" on request; port 1 a vtkTable of one row, what building and the
 * rays took. The arrays and columns are listed in Docs/data-model.md. The active scalar is Visits
 * with rays, else SurfaceAreaCost.
 *
 * The structure is the one that other Lumitree filters on the same surface use, with the same
 * choices: it is built once, and not again for new rays. Visits count what the walk of each ray
 * alone enters, so they do not depend on threads. In the table RayNodesEntered counts the cells
 * stepped through where a grid has no nodes.
 *
 * In a run over several ranks the surface is replicated, every rank casts its own rays, and rank 0
 * gives the nodes and the row for all of them; the other ranks give the same blocks, empty.
 *
 * @sa vtkLumiRayCast
 */
#ifndef vtkLumiAccelerationStructure_h
#define vtkLumiAccelerationStructure_h

#include "LumitreeFiltersRaysModule.h" // for export macro
#include "vtkLumiRayAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSRAYS_EXPORT vtkLumiAccelerationStructure : public vtkLumiRayAlgorithm
{
public:
  static vtkLumiAccelerationStructure* New();
  vtkTypeMacro(vtkLumiAccelerationStructure, vtkLumiRayAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How a node is drawn.
   */
  enum Representations
  {
    Outlines = 0, ///< 12 lines
    Cells = 1     ///< 6 quads
  };

  ///@{
  /**
   * How a node is drawn, one of Representations. Default Outlines.
   */
  vtkSetClampMacro(Representation, int, Outlines, Cells);
  vtkGetMacro(Representation, int);
  ///@}

  ///@{
  /**
   * The first level that is drawn; the blocks before it are null. Range 0 to 64, default 0.
   */
  vtkSetClampMacro(MinimumLevel, int, 0, 64);
  vtkGetMacro(MinimumLevel, int);
  ///@}

  ///@{
  /**
   * The last level that is drawn. Range 0 to 64, default 10.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 64);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * How many nodes are drawn at most. The first level that would exceed it and all deeper ones are
   * left out, with one warning; likewise the block of leaves, counted by itself. Range 1 to
   * VTK_ID_MAX, default 100,000.
   */
  vtkSetClampMacro(MaximumNodes, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNodes, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether a last block "Leaves" holds all leaves again, whatever their level. Default off.
   */
  vtkSetMacro(ShowLeaves, bool);
  vtkGetMacro(ShowLeaves, bool);
  vtkBooleanMacro(ShowLeaves, bool);
  ///@}

  ///@{
  /**
   * Whether, of a grid, a last block "Occupancy" holds its cells as a vtkImageData, with the cell
   * array PrimitiveCount and, with rays, Visits. Other structures give no such block. Default off.
   */
  vtkSetMacro(ShowOccupancy, bool);
  vtkGetMacro(ShowOccupancy, bool);
  vtkBooleanMacro(ShowOccupancy, bool);
  ///@}

  ///@{
  /**
   * Whether the table tells the EndPointOverlap of the boxes of a bounding volume hierarchy (Aila,
   * Karras and Laine 2013). It takes about as long as building. Default off.
   */
  vtkSetMacro(MeasureOverlap, bool);
  vtkGetMacro(MeasureOverlap, bool);
  vtkBooleanMacro(MeasureOverlap, bool);
  ///@}

protected:
  vtkLumiAccelerationStructure();
  ~vtkLumiAccelerationStructure() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLumiAccelerationStructure(const vtkLumiAccelerationStructure&) = delete;
  void operator=(const vtkLumiAccelerationStructure&) = delete;

  int Representation = Outlines;
  int MinimumLevel = 0;
  int MaximumLevel = 10;
  vtkIdType MaximumNodes = 100000;
  bool ShowLeaves = false;
  bool ShowOccupancy = false;
  bool MeasureOverlap = false;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
