// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiRayDisagreement
 * @brief Asks two back ends about the same rays, and shows those rays on which they differ.
 *
 * Inputs: port 0 the surface, port 1 the rays, in the forms that vtkLumiRayCast takes. The first
 * back end is Structure with Precision, the other OtherStructure with OtherPrecision; the other
 * options of the build are the same for both.
 *
 * Outputs (arrays and columns are listed in Docs/data-model.md):
 *  - port 0 *Disagreements*, a vtkPolyData: a line for each ray on which they differ, from its
 *    origin to the farther of the two hits (where only numbers of hits are known: through the
 *    scene), with Kind, the active scalar, one of Kinds, and both answers.
 *  - port 1 *Counts*, a vtkTable of one row: who was asked, and how many rays of each kind.
 *
 * Of queries with hits the first hit that differs is told. Any, Count and Crossings know only
 * Missed and Phantom.
 *
 * Refit and StructureFile are of no effect: which of the two structures would be meant?
 *
 * In a run over several ranks every rank shows its own rays, and rank 0 counts all.
 */
#ifndef vtkLumiRayDisagreement_h
#define vtkLumiRayDisagreement_h

#include "LumitreeFiltersRaysModule.h" // for export macro
#include "vtkLumiRayAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSRAYS_EXPORT vtkLumiRayDisagreement : public vtkLumiRayAlgorithm
{
public:
  static vtkLumiRayDisagreement* New();
  vtkTypeMacro(vtkLumiRayDisagreement, vtkLumiRayAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the first answer differs from the other.
   */
  enum Kinds
  {
    Missed = 0,         ///< fewer hits than the other
    Phantom = 1,        ///< more hits than the other
    OtherPrimitive = 2, ///< another primitive, at another t
    Far = 3,            ///< the same primitive, at another t
    Tie = 4             ///< another primitive, at the same t
  };

  ///@{
  /**
   * The structure of the other back end, one of Structures. Default BruteForce.
   */
  vtkSetClampMacro(OtherStructure, int, Auto, CgalCartesian);
  vtkGetMacro(OtherStructure, int);
  ///@}

  ///@{
  /**
   * The precision of the other back end, one of Precisions. Default Exact.
   */
  vtkSetClampMacro(OtherPrecision, int, Fast, Automatic);
  vtkGetMacro(OtherPrecision, int);
  ///@}

  ///@{
  /**
   * How far two t may be apart and still be the same, as a part of the larger. Range 0 to 1,
   * default 1e-6.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkLumiRayDisagreement();
  ~vtkLumiRayDisagreement() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLumiRayDisagreement(const vtkLumiRayDisagreement&) = delete;
  void operator=(const vtkLumiRayDisagreement&) = delete;

  int OtherStructure = BruteForce;
  int OtherPrecision = Exact;
  double Tolerance = 1e-6;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
