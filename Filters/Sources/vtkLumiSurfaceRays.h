// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiSurfaceRays
 * @brief Rays that leave a surface: a hemisphere of directions, or the normal, over each point or
 * cell.
 *
 * Input port 0 is a surface: any dataset or composite; of datasets that are no vtkPolyData the
 * outer surface is taken, and ids stay those of the dataset. The output has a point and a vertex
 * cell per ray, the rays of one source in a row, with the point arrays
 *  - `RayDirection` (three components, unit length, so that T is a distance),
 *  - `SourceCellId` (id; -1 over points), `SourcePointId` (id; -1 over cells): local to the leaf
 * dataset,
 *  - `SourceCompositeIndex` (int): flat index of that leaf, 0 for a plain dataset,
 * as Docs/data-model.md says. It is the rays input of vtkLumiRayCast.
 *
 * Normals are those of the data. Cells without normals use their winding, points the area-weighted
 * mean of their cells. A source without a defined normal (no cell, no area, a coordinate that is
 * not finite) sends no rays; all of them are counted in one warning. Cells and points that are
 * hidden or duplicate ghosts send none, so that every ray exists once in a parallel run.
 *
 * Directions depend on Seed, the leaf's index and the source's place in the leaf's surface only.
 *
 * Properties out of their range are one error, and the output is empty. A surface without sources
 * is none.
 *
 * @sa vtkLumiRays vtkLumiCameraRays vtkLumiRayCast
 */
#ifndef vtkLumiSurfaceRays_h
#define vtkLumiSurfaceRays_h

#include "LumitreeFiltersSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiSurfaceRays : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiSurfaceRays* New();
  vtkTypeMacro(vtkLumiSurfaceRays, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What sends rays.
   */
  enum Locations
  {
    Points = 0, ///< every point of the surface
    Cells = 1   ///< the centroid of every polygon, and of the middle triangle of every strip
  };

  /**
   * How directions are spread over the hemisphere above the surface.
   */
  enum Distributions
  {
    Cosine = 0,  ///< density cos / pi: equal shares of irradiance
    Uniform = 1, ///< density 1 / 2 pi: equal solid angles
    Normal = 2   ///< the normal alone, one ray per source
  };

  ///@{
  /**
   * One of Locations. Default Points.
   */
  vtkSetClampMacro(SourceLocation, int, Points, Cells);
  vtkGetMacro(SourceLocation, int);
  ///@}

  ///@{
  /**
   * One of Distributions. Default Cosine.
   */
  vtkSetClampMacro(Distribution, int, Cosine, Normal);
  vtkGetMacro(Distribution, int);
  ///@}

  ///@{
  /**
   * Rays of each source, at least 1, default 16; with the distribution Normal it is always one.
   * Directions are points of a scrambled Sobol sequence: powers of two cover the hemisphere most
   * evenly.
   */
  vtkSetMacro(RaysPerSource, int);
  vtkGetMacro(RaysPerSource, int);
  ///@}

  ///@{
  /**
   * Which of the random sets. The same seed gives the same directions on every platform. Any value,
   * default 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * How far along its normal a source is moved off the surface, in units of the coordinates.
   * Finite, may be negative, default 0.
   */
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * Whether a source is also moved along its normal (of a cell, the one of its winding, on the side
   * that rays leave to) by four times the distance that rounding, here and to the type of the
   * output, may have put it off a flat cell: rays then start beyond every triangle around the
   * source whose normal is within 75 degrees of it, as those of polygons that are nearly flat are
   * not. Some 1e-14 of the coordinates, with points of single precision 1e-6. The other way is
   * SkipSource of vtkLumiRayCast, which moves nothing. Default off.
   */
  vtkSetMacro(ClearOfRounding, bool);
  vtkGetMacro(ClearOfRounding, bool);
  vtkBooleanMacro(ClearOfRounding, bool);
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
  vtkLumiSurfaceRays() = default;
  ~vtkLumiSurfaceRays() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiSurfaceRays(const vtkLumiSurfaceRays&) = delete;
  void operator=(const vtkLumiSurfaceRays&) = delete;

  int SourceLocation = Points;
  int Distribution = Cosine;
  int RaysPerSource = 16;
  int Seed = 0;
  double Offset = 0.0;
  bool ClearOfRounding = false;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif
