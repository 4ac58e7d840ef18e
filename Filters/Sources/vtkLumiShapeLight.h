// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiShapeLight
 * @brief A Lambertian sphere, disk, rectangle or tube, or a line: lights with closed forms.
 *
 * The output draws the shape; what counts is its field data, beside what every light has:
 * - `sphere`: `LightCentre`, `LightRadius`;
 * - `disk`: `LightCentre`, `LightNormal`, `LightRadius`, `LightTwoSided`;
 * - `area` (rectangle, or any parallelogram): `LightTwoSided`, and the polygon itself;
 * - `tube`: `LightBegin`, `LightEnd`, `LightRadius`; without its ends;
 * - `line`: `LightBegin`, `LightEnd`, `LineDistribution` (`lambertian` or `isotropic`);
 *
 * and one of `Radiance [W/(m^2 sr)]`, `RadiantExitance [W/m^2]`, `RadiantFlux [W]` or their
 * photometric twins. A line has a flux, or `RadiantIntensityPerMetre [W/(sr m)]` or
 * `LuminousIntensityPerMetre [cd/m]`.
 *
 * @sa vtkLumiAreaLight vtkLumiIrradiance
 */
#ifndef vtkLumiShapeLight_h
#define vtkLumiShapeLight_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiShapeLight : public vtkLumiLight
{
public:
  static vtkLumiShapeLight* New();
  vtkTypeMacro(vtkLumiShapeLight, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What shines. */
  enum ShapeType
  {
    Sphere = 0,
    Disk = 1,
    Rectangle = 2,
    Tube = 3,
    Line = 4
  };

  /** What Emission is. */
  enum EmissionType
  {
    Radiance = 0, ///< W/(m^2 sr) or cd/m^2; of a line: intensity per metre, W/(sr m) or cd/m
    Exitance = 1, ///< W/m^2 or lm/m^2; not of a line
    Flux = 2      ///< all that it emits: W or lm
  };

  /** How a line shines. */
  enum LineDistributionType
  {
    Lambertian = 0, ///< as a thin tube: with the sine of the angle from the line
    Isotropic = 1   ///< into all directions alike
  };

  ///@{
  /**
   * One of ShapeType. Default Sphere.
   */
  vtkSetClampMacro(Shape, int, Sphere, Line);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /**
   * Centre of a sphere or disk, first corner of a rectangle, beginning of a tube or line; in units
   * of the coordinates. Default (0, 0, 0).
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Second corner of a rectangle, end of a tube or line. Default (1, 0, 0).
   */
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  ///@}

  ///@{
  /**
   * Third corner of a rectangle; it shines to the side of (Point1 - Origin) x (Point2 - Origin).
   * Default (0, 1, 0).
   */
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /**
   * The side to which a disk shines: any length but 0. Default (0, 0, -1).
   */
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * Radius of a sphere, disk or tube, in units of the coordinates. Finite, above 0, default 0.5.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Whether both sides of a disk or rectangle shine. Default off.
   */
  vtkSetMacro(TwoSided, bool);
  vtkGetMacro(TwoSided, bool);
  vtkBooleanMacro(TwoSided, bool);
  ///@}

  ///@{
  /**
   * One of LineDistributionType, for a line. Default Lambertian.
   */
  vtkSetClampMacro(LineDistribution, int, Lambertian, Isotropic);
  vtkGetMacro(LineDistribution, int);
  ///@}

  ///@{
  /**
   * What Emission is: one of EmissionType. Default Radiance.
   */
  vtkSetClampMacro(EmissionQuantity, int, Radiance, Flux);
  vtkGetMacro(EmissionQuantity, int);
  ///@}

  ///@{
  /**
   * How much it emits. Finite, at least 0, default 1.
   */
  vtkSetMacro(Emission, double);
  vtkGetMacro(Emission, double);
  ///@}

protected:
  vtkLumiShapeLight() = default;
  ~vtkLumiShapeLight() override = default;

  const char* Type() const override;
  std::string Problem() const override;
  void Fill(vtkPolyData* output) const override;

private:
  vtkLumiShapeLight(const vtkLumiShapeLight&) = delete;
  void operator=(const vtkLumiShapeLight&) = delete;

  int Shape = Sphere;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Point1[3] = { 1.0, 0.0, 0.0 };
  double Point2[3] = { 0.0, 1.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, -1.0 };
  double Radius = 0.5;
  bool TwoSided = false;
  int LineDistribution = Lambertian;
  int EmissionQuantity = Radiance;
  double Emission = 1.0;
};

#endif
