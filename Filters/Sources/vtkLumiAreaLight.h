// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiAreaLight
 * @brief Polygons of a dataset that shine: a Lambertian area light of any shape.
 *
 * The input is any dataset; its surface is what shines, to the side from which the corners of a
 * polygon turn left. A composite gives one light a block. The output is that surface with its
 * arrays and with field data: `LightTwoSided` and one of `Radiance [W/(m^2 sr)]`, `RadiantExitance
 * [W/m^2]`, `RadiantFlux [W]` (of all polygons together) or their photometric twins. With an
 * EmissionArray each cell has its own: a cell array of that name instead of field data. `LightType`
 * is `area`.
 *
 * In a parallel run the whole input is asked for, and piece 0 is the light.
 *
 * @sa vtkLumiShapeLight vtkLumiIrradiance
 */
#ifndef vtkLumiAreaLight_h
#define vtkLumiAreaLight_h

#include "vtkLumiLight.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiAreaLight : public vtkLumiLight
{
public:
  static vtkLumiAreaLight* New();
  vtkTypeMacro(vtkLumiAreaLight, vtkLumiLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What Emission is. */
  enum EmissionType
  {
    Radiance = 0, ///< W/(m^2 sr) or cd/m^2
    Exitance = 1, ///< W/m^2 or lm/m^2
    Flux = 2      ///< W or lm: of all polygons together; in an array of each cell
  };

  ///@{
  /**
   * What Emission and EmissionArray are: one of EmissionType. Default Radiance.
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

  ///@{
  /**
   * Cell array of one component with the emission of each cell, instead of Emission. Null (the
   * default), empty or "None": no array.
   */
  vtkSetStringMacro(EmissionArray);
  vtkGetStringMacro(EmissionArray);
  ///@}

  ///@{
  /**
   * Whether both sides shine. Default off.
   */
  vtkSetMacro(TwoSided, bool);
  vtkGetMacro(TwoSided, bool);
  vtkBooleanMacro(TwoSided, bool);
  ///@}

protected:
  vtkLumiAreaLight();
  ~vtkLumiAreaLight() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  const char* Type() const override { return "area"; }
  std::string Problem() const override;
  void Fill(vtkPolyData*) const override {}
  std::string FillFrom(
    vtkInformationVector** inputs, vtkInformation*, vtkPolyData* output) override;

private:
  vtkLumiAreaLight(const vtkLumiAreaLight&) = delete;
  void operator=(const vtkLumiAreaLight&) = delete;

  int EmissionQuantity = Radiance;
  double Emission = 1.0;
  char* EmissionArray = nullptr;
  bool TwoSided = false;
};

#endif
