// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiRadiantIntensity
 * @brief The intensity of an emitting surface, or of a light, over the sphere of directions.
 *
 * Inputs: port 0 what shines: a surface (any dataset or composite), or one light (a vtkPolyData of
 * Docs/lights.md); port 1 what hides a surface (optional; without it the surface hides itself).
 *
 * A surface shines by Lambert's law on the side of its winding, evenly: Value is its total flux,
 * its exitance or its radiance (Emission). Intensities are those of the far field, with what is
 * hidden taken into account: exact where few triangles lie over one, else by rays. A light has the
 * intensity of its own closed form or file.
 *
 * Directions are those of C-gamma photometry: gamma is 0 along Axis, C 0 lies towards Reference, C
 * 90 a quarter of a turn counterclockwise from it seen from behind (against the axis).
 *
 * Output port 0, vtkPolyData, the photometric solid: a point per direction at a distance of the
 * intensity over the greatest times Radius, with point data `RadiantIntensity [W/sr]` (the active
 * scalars; `LuminousIntensity [cd]`), `C` and `Gamma` [degree]. Output port 1, vtkTable: a row per
 * gamma, columns `Gamma` and `C 0`, `C 15`, ... Field data of both: `EmittedFlux [W]` (`[lm]`),
 * before anything is hidden; `IntegratedFlux [W]`, that of the linear interpolant of the table;
 * and, of a surface, `FarFieldDistance`, five times its extent, in units of the coordinates: nearer
 * than that the inverse-square law is off by more than about 1 %.
 *
 * Wrong input (nothing that shines, a light without intensity, such as a sky) is one error and
 * empty outputs.
 */
#ifndef vtkLumiRadiantIntensity_h
#define vtkLumiRadiantIntensity_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkLumiLightAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiRadiantIntensity : public vtkLumiLightAlgorithm
{
public:
  static vtkLumiRadiantIntensity* New();
  vtkTypeMacro(vtkLumiRadiantIntensity, vtkLumiLightAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What Value is.
   */
  enum Emissions
  {
    TotalFlux = 0, ///< W or lm
    Exitance = 1,  ///< W/m^2 or lm/m^2
    Radiance = 2   ///< W/(m^2 sr) or cd/m^2
  };

  /**
   * Units of a surface's light.
   */
  enum Systems
  {
    Radiometric = 0,
    Photometric = 1
  };

  ///@{
  /**
   * What a surface emits: what the number is (one of Emissions, default TotalFlux), the number
   * (finite, at least 0, default 1), its units (one of Systems, default Radiometric), and whether
   * both sides shine (default off). Without effect on lights.
   */
  vtkSetClampMacro(Emission, int, TotalFlux, Radiance);
  vtkGetMacro(Emission, int);
  vtkSetMacro(Value, double);
  vtkGetMacro(Value, double);
  vtkSetClampMacro(System, int, Radiometric, Photometric);
  vtkGetMacro(System, int);
  vtkSetMacro(TwoSided, bool);
  vtkGetMacro(TwoSided, bool);
  vtkBooleanMacro(TwoSided, bool);
  ///@}

  ///@{
  /**
   * Directions of gamma = 0 and of C = 0, any length but 0, not parallel. Default (0, 0, -1) and
   * (1, 0, 0).
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  vtkSetVector3Macro(Reference, double);
  vtkGetVector3Macro(Reference, double);
  ///@}

  ///@{
  /**
   * Number of C planes in 360 degrees (range 1 to 720, default 24) and of steps of gamma in 180
   * degrees (range 2 to 720, default 36).
   */
  vtkSetClampMacro(Planes, int, 1, 720);
  vtkGetMacro(Planes, int);
  vtkSetClampMacro(Steps, int, 2, 720);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /**
   * Of the photometric solid: the distance of its farthest point from Centre. Default 1 and (0, 0,
   * 0).
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  vtkSetVector3Macro(Centre, double);
  vtkGetVector3Macro(Centre, double);
  ///@}

  /**
   * The table, after an update, as a photometric file: EULUMDAT where the name ends in `.ldt`, else
   * IES LM-63. Intensities are written as candela. False after one error when there is no table or
   * the file cannot be written.
   */
  bool WritePhotometricFile(const char* fileName);

protected:
  vtkLumiRadiantIntensity();
  ~vtkLumiRadiantIntensity() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiRadiantIntensity(const vtkLumiRadiantIntensity&) = delete;
  void operator=(const vtkLumiRadiantIntensity&) = delete;

  int Emission = TotalFlux;
  double Value = 1.0;
  int System = Radiometric;
  bool TwoSided = false;
  double Axis[3] = { 0.0, 0.0, -1.0 };
  double Reference[3] = { 1.0, 0.0, 0.0 };
  int Planes = 24;
  int Steps = 36;
  double Radius = 1.0;
  double Centre[3] = { 0.0, 0.0, 0.0 };

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
