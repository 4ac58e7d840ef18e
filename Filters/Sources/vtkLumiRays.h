// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiRays
 * @brief Generates rays: a parallel grid, a sphere of directions around a point, or random ones.
 *
 * The output has a point and a vertex cell per ray, and the point array `RayDirection` (three
 * components, unit length, so that T is a distance), as Docs/data-model.md says. It is the rays
 * input of vtkLumiRayCast.
 *
 * A ray depends on the properties and its index only. When pieces are asked for (on the ranks of a
 * parallel run), each gives its contiguous share; together, in order, they are the whole, bit for
 * bit.
 *
 * Properties that make no rays (a coordinate that is not finite, a plane without area, a direction
 * of zero, a number of rays below 1) are one error, and the output is empty.
 *
 * @sa vtkLumiCameraRays vtkLumiSurfaceRays vtkLumiRayCast
 */
#ifndef vtkLumiRays_h
#define vtkLumiRays_h

#include "LumitreeFiltersSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for Problem

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiRays : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiRays* New();
  vtkTypeMacro(vtkLumiRays, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What the set of rays is.
   */
  enum Modes
  {
    ParallelGrid = 0,      ///< parallel rays from the middles of the cells of a plane's grid
    SphereAroundPoint = 1, ///< rays outward from one point, evenly spread over all directions
    Random = 2             ///< random rays, see RandomOrigins
  };

  /**
   * Where random rays start, and what their directions are.
   */
  enum RandomOrigin
  {
    InBox = 0,   ///< anywhere in Bounds; every direction equally likely
    OnSphere = 1 ///< on the sphere of Center and Radius, inward, the cosine of the angle to the
                 ///< normal as density: as lines, evenly spread over all lines that meet the sphere
  };

  ///@{
  /**
   * One of Modes. Default ParallelGrid.
   */
  vtkSetClampMacro(Mode, int, ParallelGrid, Random);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * ParallelGrid: the parallelogram that rays start from: a corner and the ends of the two edges
   * from it, the first edge having the faster index. In units of the coordinates. Defaults (-0.5,
   * -0.5, 0), (0.5, -0.5, 0) and (-0.5, 0.5, 0).
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
   * ParallelGrid: cells along the two edges, each with a ray from its middle. At least 1, default
   * 10 x 10.
   */
  vtkSetVector2Macro(Resolution, int);
  vtkGetVector2Macro(Resolution, int);
  ///@}

  ///@{
  /**
   * ParallelGrid: whether rays follow the plane's normal, (Point1 - Origin) x (Point2 - Origin), or
   * Direction. Default on.
   */
  vtkSetMacro(UsePlaneNormal, bool);
  vtkGetMacro(UsePlaneNormal, bool);
  vtkBooleanMacro(UsePlaneNormal, bool);
  ///@}

  ///@{
  /**
   * ParallelGrid without UsePlaneNormal: where rays go; any length but 0, it is made one. Default
   * (0, 0, 1).
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * SphereAroundPoint: where rays start. Random from a sphere: its centre. Default (0, 0, 0).
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Random from a sphere: its radius, above 0. In units of the coordinates. Default 1.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Random: one of RandomOrigin. Default InBox.
   */
  vtkSetClampMacro(RandomOrigins, int, InBox, OnSphere);
  vtkGetMacro(RandomOrigins, int);
  ///@}

  ///@{
  /**
   * Random in a box: x, y and z of it, as (low, high) pairs with low <= high. Default (-0.5, 0.5)
   * each.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * SphereAroundPoint and Random: how many rays, over all pieces. At least 1, default 1000.
   */
  vtkSetMacro(NumberOfRays, vtkIdType);
  vtkGetMacro(NumberOfRays, vtkIdType);
  ///@}

  ///@{
  /**
   * Random: which of the random sets. The same seed gives the same rays on every platform. Any
   * value, default 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Type of points and directions: vtkAlgorithm::SINGLE_PRECISION, or DOUBLE_PRECISION, which
   * DEFAULT_PRECISION means too. Default DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkLumiRays();
  ~vtkLumiRays() override = default;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkLumiRays(const vtkLumiRays&) = delete;
  void operator=(const vtkLumiRays&) = delete;

  /// What is wrong with the properties that the mode uses; empty when nothing is.
  std::string Problem() const;

  int Mode = ParallelGrid;
  double Origin[3] = { -0.5, -0.5, 0.0 };
  double Point1[3] = { 0.5, -0.5, 0.0 };
  double Point2[3] = { -0.5, 0.5, 0.0 };
  int Resolution[2] = { 10, 10 };
  bool UsePlaneNormal = true;
  double Direction[3] = { 0.0, 0.0, 1.0 };
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 1.0;
  int RandomOrigins = InBox;
  double Bounds[6] = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
  vtkIdType NumberOfRays = 1000;
  int Seed = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif
