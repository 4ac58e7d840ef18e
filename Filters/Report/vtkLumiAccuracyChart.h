// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiAccuracyChart
 * @brief Measures speed against accuracy on a surface: every structure and precision, the
 * references that this build has, and vtkStaticCellLocator.
 *
 * Input: any dataset or any composite of them, as one scene, cut into triangles as rays see it.
 *
 * Output: a vtkTable, a row for each back end and kind of rays (columns in Docs/data-model.md):
 * nanoseconds per ray; rays that leak, hit something where there is nothing, or name another
 * triangle; the error of t. What is right is the exact answer of this library, which
 * Docs/ground-truth.md compares with CGAL's.
 *
 * Kinds of rays: Random from the middle of the bounds; Camera, a picture from outside;
 * ThroughVertex and ThroughEdge, exactly through a vertex or an edge's middle as far as doubles
 * can; TowardVertex, the direction normalised and rounded to float. The nearest hit is asked for,
 * on one thread. References behind Lumitree's interface carry its cost: Embree called directly is
 * faster.
 *
 * CGAL's kernels are among the rows when the plugin LumitreeReference, or lumitree.reference, is
 * loaded. In a run over several ranks the surface is gathered, and rank 0 gives the table.
 */
#ifndef vtkLumiAccuracyChart_h
#define vtkLumiAccuracyChart_h

#include "LumitreeFiltersReportModule.h" // for export macro
#include "vtkTableAlgorithm.h"

#include <memory> // for the implementation

#ifndef VTK_ABI_NAMESPACE_BEGIN // before VTK 9.3
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class LUMITREEFILTERSREPORT_EXPORT vtkLumiAccuracyChart : public vtkTableAlgorithm
{
public:
  static vtkLumiAccuracyChart* New();
  vtkTypeMacro(vtkLumiAccuracyChart, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Rays of each kind. Range 1 to 10000000, default 2000.
   */
  vtkSetClampMacro(NumberOfRays, int, 1, 10000000);
  vtkGetMacro(NumberOfRays, int);
  ///@}

  ///@{
  /**
   * From which the rays are drawn: the same seed gives the same rays. At least 0, default 1.
   */
  vtkSetClampMacro(Seed, int, 0, VTK_INT_MAX);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * How often each measurement is made; the fastest counts. Range 1 to 100, default 2.
   */
  vtkSetClampMacro(Repeats, int, 1, 100);
  vtkGetMacro(Repeats, int);
  ///@}

  ///@{
  /**
   * Brute force is left out for surfaces of more triangles. At least 0, default 2000. It is asked
   * only so many rays that it tests 2e7 triangles, or 100; the column Rays has their number.
   */
  vtkSetClampMacro(BruteForceLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(BruteForceLimit, int);
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
  vtkLumiAccuracyChart();
  ~vtkLumiAccuracyChart() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkLumiAccuracyChart(const vtkLumiAccuracyChart&) = delete;
  void operator=(const vtkLumiAccuracyChart&) = delete;

  int NumberOfRays = 2000;
  int Seed = 1;
  int Repeats = 2;
  int BruteForceLimit = 2000;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
