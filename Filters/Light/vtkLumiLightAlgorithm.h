// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiLightAlgorithm
 * @brief What the filters share that measure light: what is in the way, and the unit of length.
 *
 * @sa vtkLumiIlluminationAlgorithm, vtkLumiRadiantIntensity
 */
#ifndef vtkLumiLightAlgorithm_h
#define vtkLumiLightAlgorithm_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkLumiStructureAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiLightAlgorithm : public vtkLumiStructureAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkLumiLightAlgorithm, vtkLumiStructureAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What one unit of the coordinates is.
   */
  enum LengthUnits
  {
    Metre = 0,
    Millimetre = 1,
    Centimetre = 2,
    Kilometre = 3,
    Inch = 4,
    Foot = 5
  };

  ///@{
  /**
   * What is in the way, input port 1.
   */
  void SetOccludersConnection(vtkAlgorithmOutput* output);
  void SetOccludersData(vtkDataObject* occluders);
  ///@}

  ///@{
  /**
   * What one unit of the coordinates of all inputs is, one of LengthUnits. Default Metre.
   */
  vtkSetClampMacro(LengthUnit, int, Metre, Foot);
  vtkGetMacro(LengthUnit, int);
  ///@}

protected:
  vtkLumiLightAlgorithm();
  ~vtkLumiLightAlgorithm() override;

  /**
   * This process among those of the controller, and how many these are.
   */
  int Rank();
  int Ranks();

private:
  vtkLumiLightAlgorithm(const vtkLumiLightAlgorithm&) = delete;
  void operator=(const vtkLumiLightAlgorithm&) = delete;

  int LengthUnit = Metre;
};
VTK_ABI_NAMESPACE_END

#endif
