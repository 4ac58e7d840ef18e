// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiRayAlgorithm
 * @brief What the filters share that take a surface on input port 0 and rays on input port 1.
 *
 * Beside the structure (vtkLumiStructureAlgorithm) it holds the query and the limits of rays, and
 * it makes the requests that go up the pipeline: all of the surface (each rank its piece), and
 * those rays that an output needs.
 *
 * @sa vtkLumiRayCast, vtkLumiAccelerationStructure
 */
#ifndef vtkLumiRayAlgorithm_h
#define vtkLumiRayAlgorithm_h

#include "LumitreeFiltersRaysModule.h" // for export macro
#include "vtkLumiStructureAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSRAYS_EXPORT vtkLumiRayAlgorithm : public vtkLumiStructureAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkLumiRayAlgorithm, vtkLumiStructureAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What is asked of each ray.
   */
  enum Queries
  {
    Closest = 0,   ///< the nearest hit
    Any = 1,       ///< whether anything is hit
    All = 2,       ///< every hit
    Count = 3,     ///< how many hits
    Crossings = 4, ///< how many passages through the surface: odd from inside; of Exact alone
    Ties = 5       ///< every hit at the least t
  };

  ///@{
  /**
   * The rays, input port 1.
   */
  void SetRaysConnection(vtkAlgorithmOutput* output);
  void SetRaysData(vtkDataObject* rays);
  ///@}

  ///@{
  /**
   * What is asked of each ray, one of Queries. Default Closest.
   */
  vtkSetClampMacro(Query, int, Closest, Ties);
  vtkGetMacro(Query, int);
  ///@}

  ///@{
  /**
   * Limits of t, closed, for rays without `RayTMin` and `RayTMax`; segments have [0, 1]. In units
   * of |direction|. Defaults 0 and +infinity.
   */
  vtkSetMacro(TMin, double);
  vtkGetMacro(TMin, double);
  vtkSetMacro(TMax, double);
  vtkGetMacro(TMax, double);
  ///@}

protected:
  vtkLumiRayAlgorithm();
  ~vtkLumiRayAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * The output port whose grid is that of the rays, or -1.
   */
  virtual int RaysOutputPort() { return -1; }

  /**
   * The output port whose grid is that of the surface, or -1.
   */
  virtual int SurfaceOutputPort() { return -1; }

private:
  vtkLumiRayAlgorithm(const vtkLumiRayAlgorithm&) = delete;
  void operator=(const vtkLumiRayAlgorithm&) = delete;

  int Query = Closest;
  double TMin = 0.0;
  double TMax;
};
VTK_ABI_NAMESPACE_END

#endif
