// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiPhotometricLight
 * @brief A luminaire of a photometric file: IES LM-63 (1986 to 2019, types C and B) or EULUMDAT.
 *
 * Between the file's angles intensities are bilinear in both angles; outside of them they are 0.
 * The light is a point: valid from about five times the size of the luminaire on. It is
 * Photometric; with a LuminousEfficacy it may stand beside radiometric lights.
 *
 * The output is a vertex, the position, and around it the photometric solid (point array
 * `LuminousIntensity [cd]`), to be seen only. Field data, beside what every light has (`LightType`
 * = `photometric`): `PhotometricType` (`C` or `B`), `PhotometricVerticals [deg]`,
 * `PhotometricHorizontals [deg]` (symmetries unfolded), `PhotometricLuminousIntensity [cd]`
 * (horizontal by horizontal), `PhotometricScale`, `LightAxis`, `LightReference`; and, to be read,
 * `LuminousFlux [lm]` (of the interpolant, scaled), `StatedLuminousFlux [lm]` (what the file says
 * of it, not scaled; left out where it says nothing), `PhotometricFormat`, `LuminaireName`.
 *
 * A file that is malformed is an error with the number of the line and the reason.
 *
 * @sa vtkLumiSpotLight vtkLumiIrradiance
 */
#ifndef vtkLumiPhotometricLight_h
#define vtkLumiPhotometricLight_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiPhotometricLight : public vtkLumiLight
{
public:
  static vtkLumiPhotometricLight* New();
  vtkTypeMacro(vtkLumiPhotometricLight, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file. By what is in it, not by its name, it is one or the other format. Default none, which
   * is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Where the light is, in units of the coordinates. Default (0, 0, 0).
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * Where gamma = 0 (type C), or H = V = 0 (type B), points to: any length but 0. Default (0, 0,
   * -1), as a luminaire hangs.
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * Where C = 0 (type C), or H > 0 (type B), points to; taken at right angles to Direction, and not
   * parallel to it. C = 90, or V > 0, is a quarter of a turn counterclockwise from it, seen from
   * behind the luminaire. Default (1, 0, 0).
   */
  vtkSetVector3Macro(Reference, double);
  vtkGetVector3Macro(Reference, double);
  ///@}

  ///@{
  /**
   * Factor on all intensities (dimming, maintenance). Finite, at least 0, default 1.
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Tilt of the lamp, in degrees, for files with TILT=INCLUDE, whose table of factors it looks up.
   * From 0, the default, to 180.
   */
  vtkSetMacro(Tilt, double);
  vtkGetMacro(Tilt, double);
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
  vtkLumiPhotometricLight();
  ~vtkLumiPhotometricLight() override;

  const char* Type() const override { return "photometric"; }
  std::string Problem() const override;
  void Fill(vtkPolyData*) const override {}
  std::string FillFrom(vtkInformationVector**, vtkInformation*, vtkPolyData* output) override;

private:
  vtkLumiPhotometricLight(const vtkLumiPhotometricLight&) = delete;
  void operator=(const vtkLumiPhotometricLight&) = delete;

  char* FileName = nullptr;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, -1.0 };
  double Reference[3] = { 1.0, 0.0, 0.0 };
  double Scale = 1.0;
  double Tilt = 0.0;
  double Length = 1.0;
};

#endif
