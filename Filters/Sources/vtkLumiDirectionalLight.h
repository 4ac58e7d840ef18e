// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiDirectionalLight
 * @brief Parallel light from infinitely far, as the sun's.
 *
 * The output is a line that ends at Anchor, to be seen only, and field data: `LightDirection` and
 * `NormalIrradiance [W/m^2]` or `NormalIlluminance [lx]`, beside what every light has
 * (`LightSchema`, `LightType` = `directional`, `LightName`, `LightSystem`). With an angular
 * diameter the type is `sun`, and `AngularDiameter [deg]` says which.
 *
 * @sa vtkLumiSun vtkLumiPointLight vtkLumiIrradiance
 */
#ifndef vtkLumiDirectionalLight_h
#define vtkLumiDirectionalLight_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiDirectionalLight : public vtkLumiLight
{
public:
  static vtkLumiDirectionalLight* New();
  vtkTypeMacro(vtkLumiDirectionalLight, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Direction in which the light travels, from the light to the scene. Any length but 0; kept as
   * given. Default (0, 0, -1).
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * Irradiance of a plane that faces the light, in W/m^2 (Radiometric), or its illuminance in lx
   * (Photometric). Finite, at least 0, default 1.
   */
  vtkSetMacro(NormalIrradiance, double);
  vtkGetMacro(NormalIrradiance, double);
  ///@}

  ///@{
  /**
   * Angular diameter of the light, in degrees: 0.533 is the sun's. From 0, the default, which is
   * parallel light without penumbras, to 180.
   */
  vtkSetMacro(AngularDiameter, double);
  vtkGetMacro(AngularDiameter, double);
  ///@}

  ///@{
  /**
   * Where the line that is drawn ends, and how long it is (above 0), in units of the coordinates.
   * They have no meaning for the light. Defaults (0, 0, 0) and 1.
   */
  vtkSetVector3Macro(Anchor, double);
  vtkGetVector3Macro(Anchor, double);
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

protected:
  vtkLumiDirectionalLight() = default;
  ~vtkLumiDirectionalLight() override = default;

  const char* Type() const override { return this->AngularDiameter > 0.0 ? "sun" : "directional"; }
  std::string Problem() const override;
  void Fill(vtkPolyData* output) const override;

private:
  vtkLumiDirectionalLight(const vtkLumiDirectionalLight&) = delete;
  void operator=(const vtkLumiDirectionalLight&) = delete;

  double Direction[3] = { 0.0, 0.0, -1.0 };
  double NormalIrradiance = 1.0;
  double AngularDiameter = 0.0;
  double Anchor[3] = { 0.0, 0.0, 0.0 };
  double Length = 1.0;
};

#endif
