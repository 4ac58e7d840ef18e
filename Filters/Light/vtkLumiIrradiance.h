// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiIrradiance
 * @brief Irradiance in W/m^2 (or illuminance in lx) on the points or cells of a dataset, with
 * shadows.
 *
 * Inputs: port 0 the receivers (any dataset or composite), port 1 the occluders (any dataset or
 * composite, as one scene; optional: without them the receivers shadow each other), port 2 the
 * lights (repeatable: any number of connections, each a light or a composite of lights, see
 * Docs/lights.md).
 *
 * Output: the receivers with arrays in the point or cell data, all double with one component:
 *  - `Irradiance [W/m^2]`: direct irradiance on the side of the normal, summed over the lights, the
 * active scalars. Lights of photometric units give `Illuminance [lx]` in its place.
 *  - `ScalarIrradiance [W/m^2]` (`ScalarIlluminance [lx]`): irradiance from all sides alike,
 * without a cosine, for cells of three dimensions and for points that belong to nothing else and
 * have no normals.
 *  - the same followed by a blank and the name of a light, for each light (PerLightArrays).
 *  - on request: irradiance on the back, scalar, cylindrical and hemispherical irradiance, the
 * light vector, bounds and method of the estimate, masks of shadow and penumbra (see the
 * properties). Field data: `LengthUnit` (string), `MetresPerUnit`, and of the main quantity over
 * all receivers that have a value `IrradianceMinimum [W/m^2]`, `IrradianceMean [W/m^2]`,
 * `IrradianceMaximum [W/m^2]` and `Uniformity` (U0 = minimum / mean); with skies among the lights
 * `OutdoorIrradiance [W/m^2]` (on a horizontal plane with nothing in the way) and `DaylightFactor
 * [%]`, the mean over it (all double).
 *
 * Each receiver is estimated by the cheapest method that its surroundings need: closed forms where
 * nothing is between it and a light, exact clipping where few things are, skylines for skies, and
 * else rays, as many as the tolerance asks for (Radiometry/LightEstimate.h).
 *
 * Point light: E = I cos(theta) / r^2, I = flux / (4 pi). Parallel light: E = E0 cos(theta). A
 * light behind the receiver gives 0, one that is hidden too. Normals are the point or cell normals;
 * without any, cells use their winding and points the area-weighted mean of their cells. Receivers
 * without a normal (no cell, zero area), with a coordinate that is not finite, or at the place of a
 * point light get NaN and are counted in one warning; ghosts that are hidden get NaN quietly.
 *
 * Shadows: a point is not shadowed by the cells it belongs to, nor a cell by itself, nor either by
 * what is nearer to its plane than the rounding of coordinates (2 units in the last place of float
 * coordinates; 10^-12 of the scene's size for double ones). A light that touches a surface is not
 * hidden by it.
 *
 * The structure over the occluders is kept and shared with other Lumitree filters; moving lights
 * rebuilds nothing. The output is the same, bit for bit, for any number of threads. In a run over
 * several ranks occluders and lights are replicated and receivers stay where they are.
 *
 * Wrong input (no light, an unknown light, lights of both systems, a choice that this build lacks)
 * is one error and an empty output.
 */
#ifndef vtkLumiIrradiance_h
#define vtkLumiIrradiance_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkLumiIlluminationAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiIrradiance : public vtkLumiIlluminationAlgorithm
{
public:
  static vtkLumiIrradiance* New();
  vtkTypeMacro(vtkLumiIrradiance, vtkLumiIlluminationAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether occluders cast shadows. Without, port 1 is not looked at. Default on.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Whether each light gets an array of its own beside the sum. Default off.
   */
  vtkSetMacro(PerLightArrays, bool);
  vtkGetMacro(PerLightArrays, bool);
  vtkBooleanMacro(PerLightArrays, bool);
  ///@}

  ///@{
  /**
   * Whether irradiance on the other side of the receivers is given, too, as `BackIrradiance
   * [W/m^2]`. Default off.
   */
  vtkSetMacro(TwoSided, bool);
  vtkGetMacro(TwoSided, bool);
  vtkBooleanMacro(TwoSided, bool);
  ///@}

  ///@{
  /**
   * Whether receivers with a normal get `ScalarIrradiance [W/m^2]`, too: from all sides alike.
   * Default off.
   */
  vtkSetMacro(ScalarIrradiance, bool);
  vtkGetMacro(ScalarIrradiance, bool);
  vtkBooleanMacro(ScalarIrradiance, bool);
  ///@}

  ///@{
  /**
   * Whether there is `LightVector [W/m^2]` (Gershun), three components: its component along any
   * normal is the irradiance on that side less that on the other. Default off.
   */
  vtkSetMacro(LightVector, bool);
  vtkGetMacro(LightVector, bool);
  vtkBooleanMacro(LightVector, bool);
  ///@}

  ///@{
  /**
   * Whether there is `CylindricalIrradiance [W/m^2]`: on a small upright (z) cylinder. Default off.
   */
  vtkSetMacro(CylindricalIrradiance, bool);
  vtkGetMacro(CylindricalIrradiance, bool);
  vtkBooleanMacro(CylindricalIrradiance, bool);
  ///@}

  ///@{
  /**
   * Whether there is `HemisphericalIrradiance [W/m^2]`: on a small hemisphere over the receiver.
   * Default off.
   */
  vtkSetMacro(HemisphericalIrradiance, bool);
  vtkGetMacro(HemisphericalIrradiance, bool);
  vtkBooleanMacro(HemisphericalIrradiance, bool);
  ///@}

  ///@{
  /**
   * Whether there are `IrradianceLower [W/m^2]`, `IrradianceUpper [W/m^2]`, `EstimateMethod` and
   * `RayCount`. Default off.
   */
  vtkSetMacro(EstimateArrays, bool);
  vtkGetMacro(EstimateArrays, bool);
  vtkBooleanMacro(EstimateArrays, bool);
  ///@}

  ///@{
  /**
   * Whether there are `ShadowMask` (1 where all light that comes its way is hidden) and
   * `PenumbraMask` (1 where a part of it is). Default off.
   */
  vtkSetMacro(ShadowMasks, bool);
  vtkGetMacro(ShadowMasks, bool);
  vtkBooleanMacro(ShadowMasks, bool);
  ///@}

  ///@{
  /**
   * A value may be off by this [W/m^2 or lx] where that is more than RelativeTolerance allows.
   * Default 0; range 0 upwards.
   */
  vtkSetClampMacro(AbsoluteTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AbsoluteTolerance, double);
  ///@}

protected:
  vtkLumiIrradiance();
  ~vtkLumiIrradiance() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiIrradiance(const vtkLumiIrradiance&) = delete;
  void operator=(const vtkLumiIrradiance&) = delete;

  bool Shadows = true;
  bool PerLightArrays = false;
  bool TwoSided = false;
  bool ScalarIrradiance = false;
  bool LightVector = false;
  bool CylindricalIrradiance = false;
  bool HemisphericalIrradiance = false;
  bool EstimateArrays = false;
  bool ShadowMasks = false;
  double AbsoluteTolerance = 0.0;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
