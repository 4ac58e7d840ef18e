// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiSky
 * @brief Light of the sky, and of an even ground: uniform, overcast, the CIE general skies,
 * all-weather.
 *
 * - Uniform: the same radiance everywhere.
 * - CieOvercast: Moon and Spencer's, L = Lz (1 + 2 cos Z) / 3 ("type 16"; not the CIE's type 1,
 * whose horizontal irradiance for one zenith radiance is 0.25 % more).
 * - CieGeneral: the 15 types of ISO 15469:2004 (CIE S 011).
 * - AllWeather: Perez, Seals and Michalsky (1993), from DirectNormal and DiffuseHorizontal; these
 * also are its level. Its model needs irradiances in W/m^2, so it is Radiometric; a
 * LuminousEfficacy makes light of it.
 *
 * The sun itself is no part of a sky: add a vtkLumiSun or a vtkLumiDirectionalLight.
 *
 * The output is a hemisphere around Anchor with the point array `Radiance [W/(m^2 sr)]` or
 * `Luminance [cd/m^2]`, to be seen only, and field data, beside what every light has (`LightType` =
 * `sky`): `SkyModel` (`uniform`, `overcast`, `general`), `SkyUp`, `SkyTowardsSun`,
 * `SkyDistribution` (a, b, c, d, e and base of Docs/lights.md), `ZenithRadiance [W/(m^2 sr)]`
 * (`ZenithLuminance [cd/m^2]`) or `DiffuseHorizontalIrradiance [W/m^2]`
 * (`DiffuseHorizontalIlluminance [lx]`), `GroundRadiance [W/(m^2 sr)]` (`GroundLuminance
 * [cd/m^2]`).
 *
 * Input port 0, optional: a sun of vtkLumiSun, or any data with its field data `SunZenith [deg]`
 * and `SunAzimuth [deg]`. The sky then follows it, through its time steps too, and is dark, as is
 * the ground, while it is below the horizon.
 *
 * @sa vtkLumiSun vtkLumiIrradiance
 */
#ifndef vtkLumiSky_h
#define vtkLumiSky_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiSky : public vtkLumiLight
{
public:
  static vtkLumiSky* New();
  vtkTypeMacro(vtkLumiSky, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Which sky. */
  enum ModelType
  {
    Uniform = 0,
    CieOvercast = 1,
    CieGeneral = 2,
    AllWeather = 3
  };

  /** What Level is. */
  enum LevelType
  {
    ZenithRadiance = 0,      ///< W/(m^2 sr) or cd/m^2
    HorizontalIrradiance = 1 ///< by the sky alone (diffuse horizontal), W/m^2 or lx
  };

  ///@{
  /**
   * One of ModelType. Default Uniform.
   */
  vtkSetClampMacro(Model, int, Uniform, AllWeather);
  vtkGetMacro(Model, int);
  ///@}

  ///@{
  /**
   * Type of a general sky, 1 (overcast) to 15 (white-blue turbid); 12 is the clear sky. Default 12.
   */
  vtkSetClampMacro(CieType, int, 1, 15);
  vtkGetMacro(CieType, int);
  ///@}

  ///@{
  /**
   * What Level is: one of LevelType. Default ZenithRadiance. Not for AllWeather.
   */
  vtkSetClampMacro(LevelQuantity, int, ZenithRadiance, HorizontalIrradiance);
  vtkGetMacro(LevelQuantity, int);
  ///@}

  ///@{
  /**
   * How bright the sky is. Finite, at least 0, default 1. Not for AllWeather.
   */
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /**
   * Direct normal and diffuse horizontal irradiance for AllWeather, in W/m^2. Finite, at least 0;
   * DiffuseHorizontal above 0. Defaults 800 and 100.
   */
  vtkSetMacro(DirectNormal, double);
  vtkGetMacro(DirectNormal, double);
  vtkSetMacro(DiffuseHorizontal, double);
  vtkGetMacro(DiffuseHorizontal, double);
  ///@}

  ///@{
  /**
   * Where the sun is, in degrees: from the zenith, 0 to 90 (below 90 for AllWeather), and from
   * north over east. Defaults 45 and 180. Skies without a corona do not ask. Without effect where
   * there is a sun on the input.
   */
  vtkSetMacro(SunZenith, double);
  vtkGetMacro(SunZenith, double);
  vtkSetMacro(SunAzimuth, double);
  vtkGetMacro(SunAzimuth, double);
  ///@}

  ///@{
  /**
   * Directions to the north and to the zenith in the coordinates of the scene: of any length but 0,
   * and not parallel; north is taken at right angles to up. Defaults (0, 1, 0) and (0, 0, 1).
   */
  vtkSetVector3Macro(North, double);
  vtkGetVector3Macro(North, double);
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Radiance of everything below the horizon, in W/(m^2 sr) or cd/m^2. Finite, at least 0, default
   * 0.
   */
  vtkSetMacro(GroundRadiance, double);
  vtkGetMacro(GroundRadiance, double);
  ///@}

  ///@{
  /**
   * Middle and radius (above 0) of the hemisphere that is drawn, in units of the coordinates. They
   * have no meaning for the light. Defaults (0, 0, 0) and 1.
   */
  vtkSetVector3Macro(Anchor, double);
  vtkGetVector3Macro(Anchor, double);
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

protected:
  vtkLumiSky();
  ~vtkLumiSky() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  const char* Type() const override { return "sky"; }
  std::string Problem() const override;
  void Fill(vtkPolyData*) const override {}
  std::string FillFrom(vtkInformationVector**, vtkInformation*, vtkPolyData* output) override;

private:
  vtkLumiSky(const vtkLumiSky&) = delete;
  void operator=(const vtkLumiSky&) = delete;

  int Model = Uniform;
  int CieType = 12;
  int LevelQuantity = ZenithRadiance;
  double Level = 1.0;
  double DirectNormal = 800.0;
  double DiffuseHorizontal = 100.0;
  double SunZenith = 45.0;
  double SunAzimuth = 180.0;
  double North[3] = { 0.0, 1.0, 0.0 };
  double Up[3] = { 0.0, 0.0, 1.0 };
  double GroundRadiance = 0.0;
  double Anchor[3] = { 0.0, 0.0, 0.0 };
  double Length = 1.0;
};

#endif
