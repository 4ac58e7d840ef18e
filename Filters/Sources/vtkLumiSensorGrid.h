// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiSensorGrid
 * @brief A grid of light sensors on a parallelogram, spaced by EN 12464-1.
 *
 * The output is a vtkPolyData of quads, one a sensor, which sits in its middle and faces along
 * (Point1 - Origin) x (Point2 - Origin); with Flip to the other side. Cell data: `Normals`. Give it
 * to vtkLumiIrradiance as receivers with cells as locations.
 *
 * Cells are not larger than p = 0.2 * 5^(log10 d) metres, d the length of the longer side, or,
 * where that is twice the shorter one or more, of the shorter side; p at most 10 m (EN
 * 12464-1, 4.4). Spacing replaces p where it is not 0.
 */
#ifndef vtkLumiSensorGrid_h
#define vtkLumiSensorGrid_h

#include "LumitreeFiltersSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiSensorGrid : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiSensorGrid* New();
  vtkTypeMacro(vtkLumiSensorGrid, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What one unit of the coordinates is.
   */
  enum LengthUnits
  {
    Metre = 0,
    Millimetre = 1,
    Centimetre = 2,
    Kilometre = 3,
    Inch = 4,
    Foot = 5
  };

  ///@{
  /**
   * A corner and the ends of the two sides from there, in units of the coordinates. Default the
   * unit square (0, 0, 0), (1, 0, 0), (0, 1, 0).
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /**
   * Width of a band along the sides that has no sensors (the standard: 0.5 m from the walls), in
   * units of the coordinates. At least 0, default 0.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * Largest size of a cell, in units of the coordinates; 0: by the standard. At least 0, default 0.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Whether sensors face the other way. Default off.
   */
  vtkSetMacro(Flip, bool);
  vtkGetMacro(Flip, bool);
  vtkBooleanMacro(Flip, bool);
  ///@}

  ///@{
  /**
   * What one unit of the coordinates is: 0 metre, 1 millimetre, 2 centimetre, 3 kilometre, 4 inch,
   * 5 foot. Default 0.
   */
  vtkSetClampMacro(LengthUnit, int, Metre, Foot);
  vtkGetMacro(LengthUnit, int);
  ///@}

protected:
  vtkLumiSensorGrid();
  ~vtkLumiSensorGrid() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiSensorGrid(const vtkLumiSensorGrid&) = delete;
  void operator=(const vtkLumiSensorGrid&) = delete;

  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Point1[3] = { 1.0, 0.0, 0.0 };
  double Point2[3] = { 0.0, 1.0, 0.0 };
  double Margin = 0.0;
  double Spacing = 0.0;
  bool Flip = false;
  int LengthUnit = Metre;
};

#endif
