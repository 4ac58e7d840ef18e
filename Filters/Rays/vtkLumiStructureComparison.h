// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiStructureComparison
 * @brief Builds several structures over one surface, casts the same rays at each, and tells what
 * both took: a table with a row per structure and set of parameters.
 *
 * Inputs: port 0 the surface, port 1 the rays, in the forms that vtkLumiRayCast takes.
 *
 * Output: a vtkTable, whose columns are listed in Docs/data-model.md. What is compared is chosen by
 * Sweep:
 *  - Structures: every structure that this build has, with the options of the build as they are;
 *    brute force, which tests every primitive for every ray, and the references (Embree, CGAL) only
 *    on request;
 *  - GridCells: grids, from one of a single cell by SweepSteps densities between SweepMinimum and
 *    SweepMaximum cells per primitive;
 *  - LeafSizes: the tree that Structure names (Auto: the BVH) with SweepSteps leaf sizes between
 *    SweepMinimum and SweepMaximum.
 *
 * Structures are built for this table and not kept: Refit and StructureFile are of no effect.
 * Seconds are those of this machine at this moment; a cast is repeated, and the quickest counts.
 * All other columns but those are the same whenever and wherever they are computed. What cannot be built (too many cells for the memory
 * limit, a precision that a reference lacks) is left out, with one warning.
 *
 * In a run over several ranks the surface is replicated and every rank casts its own rays; rank 0
 * gives the table: sums over all ranks, and the seconds of the slowest.
 */
#ifndef vtkLumiStructureComparison_h
#define vtkLumiStructureComparison_h

#include "LumitreeFiltersRaysModule.h" // for export macro
#include "vtkLumiRayAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSRAYS_EXPORT vtkLumiStructureComparison : public vtkLumiRayAlgorithm
{
public:
  static vtkLumiStructureComparison* New();
  vtkTypeMacro(vtkLumiStructureComparison, vtkLumiRayAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What changes from row to row.
   */
  enum Sweeps
  {
    AllStructures = 0,
    GridCells = 1,
    LeafSizes = 2
  };

  ///@{
  /**
   * What changes from row to row, one of Sweeps. Default AllStructures.
   */
  vtkSetClampMacro(Sweep, int, AllStructures, LeafSizes);
  vtkGetMacro(Sweep, int);
  ///@}

  ///@{
  /**
   * Cells per primitive, or leaf sizes, from which a sweep goes to which; the steps between are
   * equal factors. Leaf sizes are rounded, and each is tried once. Above 0, at most 1000, Minimum
   * not above Maximum; anything else is an error. Defaults 0.01 and 100.
   */
  vtkSetMacro(SweepMinimum, double);
  vtkGetMacro(SweepMinimum, double);
  vtkSetMacro(SweepMaximum, double);
  vtkGetMacro(SweepMaximum, double);
  ///@}

  ///@{
  /**
   * Steps of a sweep. Range 1 to 100, default 9.
   */
  vtkSetClampMacro(SweepSteps, int, 1, 100);
  vtkGetMacro(SweepSteps, int);
  ///@}

  ///@{
  /**
   * Whether brute force is among all structures. Default off.
   */
  vtkSetMacro(IncludeBruteForce, bool);
  vtkGetMacro(IncludeBruteForce, bool);
  vtkBooleanMacro(IncludeBruteForce, bool);
  ///@}

  ///@{
  /**
   * Whether Embree and CGAL, where they are there, are among all structures. Default off.
   */
  vtkSetMacro(IncludeReferences, bool);
  vtkGetMacro(IncludeReferences, bool);
  vtkBooleanMacro(IncludeReferences, bool);
  ///@}

  ///@{
  /**
   * Whether each row's answers are compared with those of ReferenceStructure, asked with Exact.
   * Default off.
   */
  vtkSetMacro(CountDisagreements, bool);
  vtkGetMacro(CountDisagreements, bool);
  vtkBooleanMacro(CountDisagreements, bool);
  ///@}

  ///@{
  /**
   * Whose answers are taken for true, one of Structures. Default BruteForce.
   */
  vtkSetClampMacro(ReferenceStructure, int, Auto, CgalCartesian);
  vtkGetMacro(ReferenceStructure, int);
  ///@}

  ///@{
  /**
   * Whether the table tells the EndPointOverlap of the boxes of bounding volume hierarchies (Aila,
   * Karras and Laine 2013), which takes about as long as building. Default off.
   */
  vtkSetMacro(MeasureOverlap, bool);
  vtkGetMacro(MeasureOverlap, bool);
  vtkBooleanMacro(MeasureOverlap, bool);
  ///@}

  ///@{
  /**
   * How often the rays are cast for the time. Range 1 to 100, default 3.
   */
  vtkSetClampMacro(Repetitions, int, 1, 100);
  vtkGetMacro(Repetitions, int);
  ///@}

protected:
  vtkLumiStructureComparison();
  ~vtkLumiStructureComparison() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLumiStructureComparison(const vtkLumiStructureComparison&) = delete;
  void operator=(const vtkLumiStructureComparison&) = delete;

  int Sweep = AllStructures;
  double SweepMinimum = 0.01;
  double SweepMaximum = 100.0;
  int SweepSteps = 9;
  bool IncludeBruteForce = false;
  bool IncludeReferences = false;
  bool CountDisagreements = false;
  bool MeasureOverlap = false;
  int ReferenceStructure = BruteForce;
  int Repetitions = 3;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
