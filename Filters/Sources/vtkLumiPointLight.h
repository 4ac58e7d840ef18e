// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiPointLight
 * @brief An isotropic point source of light.
 *
 * The intensity is Flux / 4 pi in every direction. The output is one point with a vertex cell, and
 * field data: `RadiantFlux [W]` or `LuminousFlux [lm]`, beside what every light has (`LightSchema`,
 * `LightType` = `point`, `LightName`, `LightSystem`).
 *
 * @sa vtkLumiDirectionalLight vtkLumiIrradiance
 */
#ifndef vtkLumiPointLight_h
#define vtkLumiPointLight_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiPointLight : public vtkLumiLight
{
public:
  static vtkLumiPointLight* New();
  vtkTypeMacro(vtkLumiPointLight, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where the light is, in units of the coordinates. Default (0, 0, 0).
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * Total flux, in W (Radiometric) or lm (Photometric). Finite, at least 0, default 1.
   */
  vtkSetMacro(Flux, double);
  vtkGetMacro(Flux, double);
  ///@}

protected:
  vtkLumiPointLight() = default;
  ~vtkLumiPointLight() override = default;

  const char* Type() const override { return "point"; }
  std::string Problem() const override;
  void Fill(vtkPolyData* output) const override;

private:
  vtkLumiPointLight(const vtkLumiPointLight&) = delete;
  void operator=(const vtkLumiPointLight&) = delete;

  double Position[3] = { 0.0, 0.0, 0.0 };
  double Flux = 1.0;
};

#endif
