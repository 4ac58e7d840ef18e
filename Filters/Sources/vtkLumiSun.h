// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiSun
 * @brief The sun at a place and a time, with or without its disk.
 *
 * Its direction is computed within 0.01 degrees (1800 to 2200), with refraction. With TimeSteps the
 * source has time: hours of the day, by the clock of the place, from FirstHour to LastHour;
 * without, Hour says when. While the sun is below the horizon the light has a normal irradiance of
 * 0.
 *
 * The output is a line that ends at Anchor, to be seen only, and field data: `LightDirection`,
 * `NormalIrradiance [W/m^2]` or `NormalIlluminance [lx]`, `AngularDiameter [deg]` (`LightType` =
 * `sun`; `directional` without a disk), and, to be read, `SunZenith [deg]` and `SunAzimuth [deg]`
 * (from north over east).
 *
 * @sa vtkLumiDirectionalLight vtkLumiSky vtkLumiIrradiance
 */
#ifndef vtkLumiSun_h
#define vtkLumiSun_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiSun : public vtkLumiLight
{
public:
  static vtkLumiSun* New();
  vtkTypeMacro(vtkLumiSun, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The place, in degrees: north and east positive. Latitude from -90 to 90. Defaults 0 and 0.
   */
  vtkSetMacro(Latitude, double);
  vtkGetMacro(Latitude, double);
  vtkSetMacro(Longitude, double);
  vtkGetMacro(Longitude, double);
  ///@}

  ///@{
  /**
   * Year (-2000 to 6000), month (1 to 12) and day of the month. Default (2024, 6, 21).
   */
  vtkSetVector3Macro(Date, int);
  vtkGetVector3Macro(Date, int);
  ///@}

  ///@{
  /**
   * Hour of the day by the clock of the place, with its parts; finite. Without meaning where there
   * are TimeSteps. Default 12.
   */
  vtkSetMacro(Hour, double);
  vtkGetMacro(Hour, double);
  ///@}

  ///@{
  /**
   * Hours by which that clock is ahead of universal time. Finite, default 0.
   */
  vtkSetMacro(UTCOffset, double);
  vtkGetMacro(UTCOffset, double);
  ///@}

  ///@{
  /**
   * Number of time steps from FirstHour to LastHour, both included; 0, the default, is no time.
   */
  vtkSetClampMacro(TimeSteps, int, 0, 100000);
  vtkGetMacro(TimeSteps, int);
  ///@}

  ///@{
  /**
   * The time steps' hours. Finite, FirstHour <= LastHour; defaults 0 and 24.
   */
  vtkSetMacro(FirstHour, double);
  vtkGetMacro(FirstHour, double);
  vtkSetMacro(LastHour, double);
  vtkGetMacro(LastHour, double);
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
   * Irradiance of a plane that faces the sun, in W/m^2 (Radiometric), or its illuminance in lx
   * (Photometric), while it is up. Finite, at least 0, default 1000.
   */
  vtkSetMacro(NormalIrradiance, double);
  vtkGetMacro(NormalIrradiance, double);
  ///@}

  ///@{
  /**
   * Angular diameter, in degrees; 0: parallel light without penumbras. From 0 to 180, default
   * 0.533.
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
  vtkLumiSun() = default;
  ~vtkLumiSun() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  const char* Type() const override { return this->AngularDiameter > 0.0 ? "sun" : "directional"; }
  std::string Problem() const override;
  void Fill(vtkPolyData*) const override {}
  std::string FillFrom(
    vtkInformationVector**, vtkInformation* outputInformation, vtkPolyData* output) override;

private:
  vtkLumiSun(const vtkLumiSun&) = delete;
  void operator=(const vtkLumiSun&) = delete;

  double Latitude = 0.0;
  double Longitude = 0.0;
  int Date[3] = { 2024, 6, 21 };
  double Hour = 12.0;
  double UTCOffset = 0.0;
  int TimeSteps = 0;
  double FirstHour = 0.0;
  double LastHour = 24.0;
  double North[3] = { 0.0, 1.0, 0.0 };
  double Up[3] = { 0.0, 0.0, 1.0 };
  double NormalIrradiance = 1000.0;
  double AngularDiameter = 0.533;
  double Anchor[3] = { 0.0, 0.0, 0.0 };
  double Length = 1.0;
};

#endif
