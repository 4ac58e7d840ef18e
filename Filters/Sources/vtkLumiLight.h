// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiLight
 * @brief What all sources of light have in common: a name, a system of units, and the schema.
 *
 * The output is a vtkPolyData that draws the light; what the light is stands in its field data, as
 * Docs/lights.md says. On the ranks of a parallel run piece 0 is the light and the others are
 * empty, without points and field data; the filters that compute with lights gather them.
 *
 * Properties that make no light (a value that is not finite, a negative flux, a direction of zero)
 * are one error, and the output is empty.
 *
 * @sa vtkLumiPointLight vtkLumiSpotLight vtkLumiPhotometricLight vtkLumiAreaLight vtkLumiShapeLight
 * vtkLumiDirectionalLight vtkLumiSun vtkLumiSky vtkLumiIrradiance
 */
#ifndef vtkLumiLight_h
#define vtkLumiLight_h

#include "LumitreeFiltersSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for Problem
#include <vector> // for AddValues

class vtkDataArray;

namespace lumitree
{
enum class Quantity : int;
}

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiLight : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkLumiLight, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Which units the light is measured in. All lights of one computation are of one system.
   */
  enum LightSystem
  {
    Radiometric = 0, ///< W, W/m^2
    Photometric = 1  ///< lm, lx
  };

  ///@{
  /**
   * One of LightSystem. Default Radiometric.
   */
  vtkSetClampMacro(System, int, Radiometric, Photometric);
  vtkGetMacro(System, int);
  ///@}

  ///@{
  /**
   * Name of the light, used for the arrays of single lights. Null or empty: the type of the light,
   * which is the default.
   */
  vtkSetStringMacro(Name);
  vtkGetStringMacro(Name);
  ///@}

  ///@{
  /**
   * Luminous efficacy of the light's radiation, in lm/W: at most 683, as light of 555 nm has. Above
   * 0 it allows lights of both systems in one computation, where this one is converted by it.
   * Default 0: the light has none and is not converted.
   */
  vtkSetMacro(LuminousEfficacy, double);
  vtkGetMacro(LuminousEfficacy, double);
  ///@}

  /**
   * Luminous efficacy of a spectrum, in lm/W: 683 times its integral weighed by V(lambda) (CIE
   * 1924) over its integral. The array has two components, wavelength in nm, growing, and any
   * radiant quantity per wavelength, at least 0; it is linear in between. NaN for anything else.
   */
  static double LuminousEfficacyOfSpectrum(vtkDataArray* spectrum);

protected:
  vtkLumiLight();
  ~vtkLumiLight() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

  /// The light's type, as Docs/lights.md spells it.
  virtual const char* Type() const = 0;

  /// What is wrong with the properties; empty when nothing is.
  virtual std::string Problem() const = 0;

  /// Adds the geometry and the field arrays of this type to an empty output; there is no problem.
  virtual void Fill(vtkPolyData* output) const = 0;

  /// The same with what the pipeline knows, for those that have an input or time; by default Fill.
  /// Gives back what is wrong; empty when nothing is.
  virtual std::string FillFrom(
    vtkInformationVector** inputs, vtkInformation* outputInformation, vtkPolyData* output);

  /// Adds the field array `quantity [unit]` of one value.
  static void AddQuantity(
    vtkPolyData* output, const char* quantity, const char* unit, double value);

  /// Adds the field array of that quantity in the light's system.
  void AddQuantity(vtkPolyData* output, lumitree::Quantity quantity, double value) const;

  /// Adds field arrays: of one tuple, of many values, of a string, of an integer.
  static void AddTuple(vtkPolyData* output, const char* name, const double* values, int components);
  static void AddValues(vtkPolyData* output, const char* name, const std::vector<double>& values);
  static void AddText(vtkPolyData* output, const char* name, const std::string& text);
  static void AddInteger(vtkPolyData* output, const char* name, int value);

  int System = Radiometric;
  char* Name = nullptr;
  double LuminousEfficacy = 0.0;

private:
  vtkLumiLight(const vtkLumiLight&) = delete;
  void operator=(const vtkLumiLight&) = delete;
};

#endif
