// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiIlluminationAlgorithm
 * @brief What the filters share that say what lights do at places: the lights, and how well that is
 * estimated.
 *
 * Inputs: port 0 the places, port 1 what is in the way (any dataset or composite, as one scene;
 * optional), port 2 the lights (repeatable, see Docs/lights.md). In a run over several ranks ports
 * 1 and 2 are replicated and places stay where they are.
 *
 * @sa vtkLumiIrradiance, vtkLumiRadiance
 */
#ifndef vtkLumiIlluminationAlgorithm_h
#define vtkLumiIlluminationAlgorithm_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkLumiLightAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiIlluminationAlgorithm : public vtkLumiLightAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkLumiIlluminationAlgorithm, vtkLumiLightAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Which places of a dataset.
   */
  enum ReceiverLocations
  {
    Points = 0,
    Cells = 1
  };

  ///@{
  /**
   * The lights, input port 2.
   */
  void AddLightsConnection(vtkAlgorithmOutput* output);
  void AddLightsData(vtkDataObject* lights);
  void RemoveAllLights();
  ///@}

  ///@{
  /**
   * Whether places are points or cells (their parametric centres), one of ReceiverLocations.
   * Default: vtkLumiIrradiance Cells; vtkLumiRadiance Points, and only ByDirection.
   */
  vtkSetClampMacro(ReceiverLocation, int, Points, Cells);
  vtkGetMacro(ReceiverLocation, int);
  ///@}

  ///@{
  /**
   * How far irradiance may be off (of vtkLumiRadiance: that of a surface that reflects): half the
   * interval of an estimate by rays stays below RelativeTolerance times the value (in deep shadow,
   * times a twentieth of the light with nothing in the way). What closed forms, clipping and
   * skylines give is exact, whatever this says. Range 0 to 1, default 0.01.
   */
  vtkSetClampMacro(RelativeTolerance, double, 0.0, 1.0);
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  ///@{
  /**
   * Rays from a place to a light at most; places for which they do not do are counted in one
   * warning. Range 64 to 2^24, default 16384.
   */
  vtkSetClampMacro(MaximumRays, int, 64, 16777216);
  vtkGetMacro(MaximumRays, int);
  ///@}

protected:
  vtkLumiIlluminationAlgorithm();
  ~vtkLumiIlluminationAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int ReceiverLocation = Points;

private:
  vtkLumiIlluminationAlgorithm(const vtkLumiIlluminationAlgorithm&) = delete;
  void operator=(const vtkLumiIlluminationAlgorithm&) = delete;

  double RelativeTolerance = 0.01;
  int MaximumRays = 16384;
};
VTK_ABI_NAMESPACE_END

#endif
