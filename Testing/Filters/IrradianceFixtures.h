// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_IrradianceFixtures_h
#define Lumitree_Testing_IrradianceFixtures_h

#include "vtkLumiIrradiance.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace lumitree::testing
{

using Point = std::array<double, 3>;

/// Lights, written out field by field as Docs/lights.md has them.
///@{
vtkSmartPointer<vtkPolyData> pointLight(
  const Point& position, double flux, const std::string& name = "Lamp", bool photometric = false);
vtkSmartPointer<vtkPolyData> directionalLight(const Point& direction, double normalIrradiance,
  const std::string& name = "Sun", bool photometric = false);
///@}

/// A field array of that name, in place of any other of the name.
///@{
void setField(vtkDataObject* object, const char* name, const std::vector<double>& tuple);
void setText(vtkDataObject* object, const char* name, const std::string& text);
///@}

/// Polygons over points; each list of ids is a polygon.
vtkSmartPointer<vtkPolyData> polygons(
  const std::vector<Point>& points, const std::vector<std::vector<vtkIdType>>& cells);

/// A strip of squares of that size on the floor z = 0, facing up, from x = from on, centred on y =
/// 0.
vtkSmartPointer<vtkPolyData> floorStrip(double from, double size, int count);

/// The wall x = 1, |y| <= 10, 0 <= z <= 2.
vtkSmartPointer<vtkPolyData> wall();

/// A filter with inputs (null: without receivers), and what it says.
class Irradiance
{
public:
  explicit Irradiance(
    vtkDataObject* receivers, const std::vector<vtkSmartPointer<vtkPolyData>>& lights = {});
  ~Irradiance();
  Irradiance(const Irradiance&) = delete;
  Irradiance& operator=(const Irradiance&) = delete;

  vtkLumiIrradiance* operator->() { return this->filter_; }

  /// Runs and gives the output.
  vtkDataObject* run();

  /// Runs and gives a value array of the output, which must be a dataset; null when it is not
  /// there.
  vtkDataArray* run(const char* arrayName);

  int errors = 0;
  int warnings = 0;
  std::string text; ///< of the last

private:
  vtkSmartPointer<vtkLumiIrradiance> filter_;
};

} // namespace lumitree::testing

#endif
