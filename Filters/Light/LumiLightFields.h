// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiLightFields_h
#define LumiLightFields_h

#include "Accel/Vec3.h"
#include "Radiometry/Quantities.h"
#include "vtkLumiABI.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace lumitree::filters
{

/// The field data of a light. What is missing or wrong is a std::runtime_error that says so.
class LightFields
{
public:
  /// Amounts of light are multiplied by factor, the conversion to another system.
  LightFields(vtkPolyData* data, LightSystem system, double metresPerUnit, double factor)
    : data_(data)
    , system_(system)
    , metresPerUnit_(metresPerUnit)
    , factor_(factor)
  {
  }

  [[nodiscard]] vtkPolyData* data() const { return this->data_; }
  [[nodiscard]] LightSystem system() const { return this->system_; }
  [[nodiscard]] double metresPerUnit() const { return this->metresPerUnit_; }

  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] static std::string text(vtkPolyData* data, const char* name);
  [[nodiscard]] std::string text(const char* name) const { return text(this->data_, name); }
  [[nodiscard]] static double number(vtkPolyData* data, const std::string& name);
  [[nodiscard]] double number(const std::string& name) const { return number(this->data_, name); }
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const; ///< one component
  [[nodiscard]] Vec3 vector(const std::string& name) const;
  [[nodiscard]] Vec3 direction(const std::string& name) const; ///< finite and not zero
  [[nodiscard]] bool flag(const std::string& name) const;      ///< false where it is not there

  /// Finite, not negative, converted: of that quantity, or of an array with that name.
  [[nodiscard]] double amount(Quantity quantity) const;
  [[nodiscard]] double amount(const std::string& name) const;
  [[nodiscard]] bool has(Quantity quantity) const;

  /// Radiance of a Lambertian surface of that area [m²], all sides that shine counted, from the one
  /// of radiance, exitance and flux that is there.
  [[nodiscard]] double radiance(double area) const;

  /// Point 0.
  [[nodiscard]] Vec3 position() const;

private:
  vtkPolyData* data_;
  LightSystem system_;
  double metresPerUnit_;
  double factor_;
};

/// Names of amounts that are no Quantity.
[[nodiscard]] std::string intensityPerMetreName(LightSystem system);
[[nodiscard]] std::string zenithRadianceName(LightSystem system);
[[nodiscard]] std::string groundRadianceName(LightSystem system);
[[nodiscard]] std::string diffuseIrradianceName(LightSystem system);

} // namespace lumitree::filters
#endif
