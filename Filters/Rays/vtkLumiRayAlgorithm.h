// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiRayAlgorithm
 * @brief What the filters share that take a surface on input port 0 and rays on input port 1.
 *
 * It holds the choices of structure, precision and query, and the requests that go up the pipeline:
 * all of the surface (each rank its piece), and those rays that an output needs.
 *
 * @sa vtkLumiRayCast, vtkLumiAccelerationStructure
 */
#ifndef vtkLumiRayAlgorithm_h
#define vtkLumiRayAlgorithm_h

#include "LumitreeFiltersRaysModule.h" // for export macro
#include "vtkDataObjectAlgorithm.h"

#include <memory> // for the implementation

#ifndef VTK_ABI_NAMESPACE_BEGIN // before VTK 9.3
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class LUMITREEFILTERSRAYS_EXPORT vtkLumiRayAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkLumiRayAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What is asked of each ray.
   */
  enum Queries
  {
    Closest = 0, ///< the nearest hit
    Any = 1,     ///< whether anything is hit
    All = 2,     ///< every hit
    Count = 3    ///< how many hits
  };

  /**
   * How the surface is organised for rays.
   */
  enum Structures
  {
    Auto = 0, ///< the cheapest that the scene needs
    BruteForce = 1,
    Bvh = 2,
    WideBvh = 3,
    Grid = 4,
    Octree = 5,
    KdTree = 6,
    BspTree = 7,
    Embree = 8,
    Cgal = 9,
    CgalEpick = 10,
    CgalCartesian = 11
  };

  /**
   * What is promised about the primitives hit and their order.
   */
  enum Precisions
  {
    Fast = 0,
    Watertight = 1,
    Exact = 2
  };

  /**
   * How a bounding volume hierarchy is split.
   */
  enum BvhBuilds
  {
    LongestAxisMedian = 0,
    BinnedSah = 1
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
  vtkSetClampMacro(Query, int, Closest, Count);
  vtkGetMacro(Query, int);
  ///@}

  ///@{
  /**
   * The structure to build, one of Structures. One that this build lacks is an error. Default Auto.
   */
  vtkSetClampMacro(Structure, int, Auto, CgalCartesian);
  vtkGetMacro(Structure, int);
  ///@}

  ///@{
  /**
   * One of Precisions. One that the structure cannot promise is an error. Default Fast.
   */
  vtkSetClampMacro(Precision, int, Fast, Exact);
  vtkGetMacro(Precision, int);
  ///@}

  ///@{
  /**
   * How a bounding volume hierarchy is split, one of BvhBuilds. Default BinnedSah.
   */
  vtkSetClampMacro(BvhBuild, int, LongestAxisMedian, BinnedSah);
  vtkGetMacro(BvhBuild, int);
  ///@}

  ///@{
  /**
   * Nodes of a bounding volume hierarchy with more primitives than this are split. Range 1 to 1024,
   * default 4.
   */
  vtkSetClampMacro(LeafSize, int, 1, 1024);
  vtkGetMacro(LeafSize, int);
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

  ///@{
  /**
   * Threads to use; 0 means VTK_SMP_MAX_THREADS when that is set, else as many as this process may
   * use. Range 0 to 4096, default 0.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 4096);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Over whose ranks the surface is spread; null means that this process holds all of it.
   * Default vtkMultiProcessController::GetGlobalController().
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
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

private:
  vtkLumiRayAlgorithm(const vtkLumiRayAlgorithm&) = delete;
  void operator=(const vtkLumiRayAlgorithm&) = delete;

  int Query = Closest;
  int Structure = Auto;
  int Precision = Fast;
  int BvhBuild = BinnedSah;
  int LeafSize = 4;
  double TMin = 0.0;
  double TMax;
  int NumberOfThreads = 0;

  struct Settings;
  std::unique_ptr<Settings> Held;
};
VTK_ABI_NAMESPACE_END

#endif
