// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiRayCast
 * @brief Casts a set of rays at a surface: nearest hits, all hits, counts, plain occlusion, or
 * inside and outside.
 *
 * Inputs: port 0 the surface (any dataset or any composite of them, as one scene), port 1 the rays
 * (one dataset, not a composite). Rays come in one of three forms, looked for in this order:
 *  - point arrays `RayOrigin` and the direction array: a ray is a point (camera images);
 *  - points with the direction array (SetInputArrayToProcess(0, 1, 0, points, name), by default
 *    `RayDirection`): a ray leaves its point;
 *  - line and polyline cells without a direction array: a ray is a segment, t runs over [0, 1].
 *
 * Outputs: port 0 *Hits*, a point and a vertex cell per hit, ordered by ray, then by (T,
 * primitive); none for the queries Any, Count and Crossings. Port 1 *Rays*, the rays as they came
 * with HitMask, HitCount and more, in the point data, for lines in the cell data. Where polylines
 * have several segments, or lines come among other cells, port 1 holds a line cell per segment, and
 * only those. Port 2 *Surface*, the surface as it came, on request (CountTraversal) with what the
 * rays cost each cell. Port 3 *Statistics*, a table of one row: how many rays, hits, rays that
 * cannot be traced, and questions that exact arithmetic decided.
 *
 * Crossings counts how often rays pass through the surface, once also at edges and vertices and of
 * meshes that share no points: with TMax infinite it is odd from inside a closed surface, which the
 * array Inside says. It needs the precision Exact.
 *
 * T is in units of |direction|, which is never normalised: the hit lies at origin + T * direction.
 * Limits are closed. A miss is -1 for ids and +infinity for T. Every array of both outputs is
 * listed, with type and miss value, in Docs/data-model.md.
 *
 * The structure over the surface is kept and shared with other Lumitree filters on the same
 * surface; it is rebuilt only when points, connectivity or ghost marks change, never for new rays.
 * The output is the same, bit for bit, for any number of threads.
 *
 * In a run over several ranks the surface is replicated and every rank casts its own rays.
 *
 * A ray that cannot be traced (a coordinate that is not finite, direction zero, t_min > t_max) hits
 * nothing; all of them are counted in one warning. A missing array, an array of a wrong type and a
 * choice that this build lacks are one error, and both outputs are empty.
 *
 * @sa vtkLumiAccelerationStructure
 */
#ifndef vtkLumiRayCast_h
#define vtkLumiRayCast_h

#include "LumitreeFiltersRaysModule.h" // for export macro
#include "vtkLumiRayAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSRAYS_EXPORT vtkLumiRayCast : public vtkLumiRayAlgorithm
{
public:
  static vtkLumiRayCast* New();
  vtkTypeMacro(vtkLumiRayCast, vtkLumiRayAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether hits get the surface's arrays: point arrays interpolated in the triangle that was hit,
   * cell arrays copied. Only arrays that every leaf dataset has, with the same type and components,
   * and whose name is not one of the data model. Default off.
   */
  vtkSetMacro(PassSurfaceData, bool);
  vtkGetMacro(PassSurfaceData, bool);
  vtkBooleanMacro(PassSurfaceData, bool);
  ///@}

  ///@{
  /**
   * Whether rays get NodesEntered, CellsStepped, LeavesVisited and PrimitivesTested, what the walk
   * of each ray alone costs, and the cells of the surface RayTests, RayHits and LeafReferences, how
   * often they were tested and hit, and how many leaves hold them. Counting is slower than not
   * counting. Default off.
   */
  vtkSetMacro(CountTraversal, bool);
  vtkGetMacro(CountTraversal, bool);
  vtkBooleanMacro(CountTraversal, bool);
  ///@}

  ///@{
  /**
   * Whether rays pass by the cell they leave from (point array `SourceCellId`,
   * `SourceCompositeIndex` of the rays) or the cells around the point they leave from
   * (`SourcePointId`): a start that was rounded lies on either side of its cell. vtkLumiSurfaceRays
   * gives these arrays; ids are those of the surface on input port 0. Rays with neither array are
   * an error. Default off.
   */
  vtkSetMacro(SkipSource, bool);
  vtkGetMacro(SkipSource, bool);
  vtkBooleanMacro(SkipSource, bool);
  ///@}

  ///@{
  /**
   * Whether T is the double nearest to the exact t, of two equally near the even one, and not only
   * within one float ulp of it. Has an effect with the precision Exact alone. Default off.
   */
  vtkSetMacro(RoundedParameter, bool);
  vtkGetMacro(RoundedParameter, bool);
  vtkBooleanMacro(RoundedParameter, bool);
  ///@}

  ///@{
  /**
   * Type of the hit points: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or DEFAULT_PRECISION,
   * which is double when the rays or the surface have double coordinates. Default
   * DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkLumiRayCast();
  ~vtkLumiRayCast() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RaysOutputPort() override { return 1; }
  int SurfaceOutputPort() override { return 2; }

private:
  vtkLumiRayCast(const vtkLumiRayCast&) = delete;
  void operator=(const vtkLumiRayCast&) = delete;

  bool PassSurfaceData = false;
  bool CountTraversal = false;
  bool RoundedParameter = false;
  bool SkipSource = false;
  int OutputPointsPrecision = DEFAULT_PRECISION;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
