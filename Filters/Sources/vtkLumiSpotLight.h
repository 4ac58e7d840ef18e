// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiSpotLight
 * @brief A small lamp that shines into one direction: a cosine lobe or a smooth spot.
 *
 * CosineLobe: I = I0 cos^n up to 90 degrees from the axis; n = 1 is a small Lambertian surface.
 * SmoothSpot: I0 within the cone angle, fading smoothly to nothing at the cutoff angle.
 *
 * The output is a vertex, the position, and around it the solid of its intensities (point array
 * `RadiantIntensity [W/sr]` or `LuminousIntensity [cd]`), to be seen only. Field data: `RadiantFlux
 * [W]` or `LuminousFlux [lm]`, or `RadiantIntensity [W/sr]` or `LuminousIntensity [cd]` on the
 * axis; `LightAxis`; `LobeExponent`, or `ConeAngle [deg]` and `CutoffAngle [deg]`; beside what
 * every light has (`LightType` = `lobe` or `spot`).
 *
 * @sa vtkLumiPointLight vtkLumiPhotometricLight vtkLumiIrradiance
 */
#ifndef vtkLumiSpotLight_h
#define vtkLumiSpotLight_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiSpotLight : public vtkLumiLight
{
public:
  static vtkLumiSpotLight* New();
  vtkTypeMacro(vtkLumiSpotLight, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How the intensity falls off. */
  enum FalloffType
  {
    CosineLobe = 0,
    SmoothSpot = 1
  };

  /** What Emission is. */
  enum EmissionType
  {
    Flux = 0,          ///< all that it emits: W or lm
    AxialIntensity = 1 ///< along its axis: W/sr or cd
  };

  ///@{
  /**
   * Where the light is, in units of the coordinates. Default (0, 0, 0).
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * Where it shines to: any length but 0. Default (0, 0, -1).
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * One of FalloffType. Default SmoothSpot.
   */
  vtkSetClampMacro(Falloff, int, CosineLobe, SmoothSpot);
  vtkGetMacro(Falloff, int);
  ///@}

  ///@{
  /**
   * Exponent of a cosine lobe: finite, at least 0, default 1.
   */
  vtkSetMacro(Exponent, double);
  vtkGetMacro(Exponent, double);
  ///@}

  ///@{
  /**
   * Angles of a smooth spot from its axis, in degrees: where it begins to fade, and where it ends.
   * 0 <= ConeAngle <= CutoffAngle <= 180, and CutoffAngle not 0. Defaults 20 and 30.
   */
  vtkSetMacro(ConeAngle, double);
  vtkGetMacro(ConeAngle, double);
  vtkSetMacro(CutoffAngle, double);
  vtkGetMacro(CutoffAngle, double);
  ///@}

  ///@{
  /**
   * What Emission is: one of EmissionType. Default Flux.
   */
  vtkSetClampMacro(EmissionKind, int, Flux, AxialIntensity);
  vtkGetMacro(EmissionKind, int);
  ///@}

  ///@{
  /**
   * How much it emits, in W or W/sr (Radiometric), lm or cd (Photometric). Finite, at least 0,
   * default 1.
   */
  vtkSetMacro(Emission, double);
  vtkGetMacro(Emission, double);
  ///@}

  ///@{
  /**
   * How far the solid that is drawn reaches, in units of the coordinates. Without meaning for the
   * light. Finite, at least 0 (only a point), default 1.
   */
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

protected:
  vtkLumiSpotLight() = default;
  ~vtkLumiSpotLight() override = default;

  const char* Type() const override { return this->Falloff == CosineLobe ? "lobe" : "spot"; }
  std::string Problem() const override;
  void Fill(vtkPolyData* output) const override;

private:
  vtkLumiSpotLight(const vtkLumiSpotLight&) = delete;
  void operator=(const vtkLumiSpotLight&) = delete;

  double Position[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, -1.0 };
  int Falloff = SmoothSpot;
  double Exponent = 1.0;
  double ConeAngle = 20.0;
  double CutoffAngle = 30.0;
  int EmissionKind = Flux;
  double Emission = 1.0;
  double Length = 1.0;
};

#endif
