// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiIrradiance
 * @brief Irradiance in W/m^2 (or illuminance in lx) on the points or cells of a dataset, with
 * shadows.
 *
 * Inputs: port 0 the receivers (any dataset or composite), port 1 the occluders (any dataset or
 * composite, as one scene; optional: without them the receivers shadow each other), port 2 the
 * lights (repeatable: any number of connections, each a light or a composite of lights, see
 * Docs/lights.md).
 *
 * Output: the receivers with arrays in the point or cell data, all double with one component:
 *  - `Irradiance [W/m^2]`: direct irradiance on the side of the normal, summed over the lights, the
 * active scalars. Lights of photometric units give `Illuminance [lx]` in its place.
 *  - `ScalarIrradiance [W/m^2]` (`ScalarIlluminance [lx]`): irradiance from all sides alike,
 * without a cosine, for cells of three dimensions and for points that belong to nothing else and
 * have no normals.
 *  - the same followed by a blank and the name of a light, for each light (PerLightArrays).
 * Field data: `LengthUnit` (string) and `MetresPerUnit` (double).
 *
 * Point light: E = I cos(theta) / r^2, I = flux / (4 pi). Parallel light: E = E0 cos(theta). A
 * light behind the receiver gives 0, one that is hidden too. Normals are the point or cell normals;
 * without any, cells use their winding and points the area-weighted mean of their cells. Receivers
 * without a normal (no cell, zero area), with a coordinate that is not finite, or at the place of a
 * point light get NaN and are counted in one warning; ghosts that are hidden get NaN quietly.
 *
 * Shadows: a point is not shadowed by the cells it belongs to, nor a cell by itself, nor either by
 * what is nearer to its plane than the rounding of coordinates (2 units in the last place of float
 * coordinates; 10^-12 of the scene's size for double ones). A light that touches a surface is not
 * hidden by it.
 *
 * The structure over the occluders is kept and shared with other Lumitree filters; moving lights
 * rebuilds nothing. The output is the same, bit for bit, for any number of threads. In a run over
 * several ranks occluders and lights are replicated and receivers stay where they are.
 *
 * Wrong input (no light, an unknown light, lights of both systems, a choice that this build lacks)
 * is one error and an empty output.
 */
#ifndef vtkLumiIrradiance_h
#define vtkLumiIrradiance_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <memory> // for the implementation

#ifndef VTK_ABI_NAMESPACE_BEGIN // before VTK 9.3
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class LUMITREEFILTERSLIGHT_EXPORT vtkLumiIrradiance : public vtkPassInputTypeAlgorithm
{
public:
  static vtkLumiIrradiance* New();
  vtkTypeMacro(vtkLumiIrradiance, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Where light is received.
   */
  enum ReceiverLocations
  {
    Points = 0,
    Cells = 1
  };

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

  /**
   * How the occluders are organised for rays.
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
   * What is promised about what shadow rays hit.
   */
  enum Precisions
  {
    Fast = 0,
    Watertight = 1,
    Exact = 2
  };

  ///@{
  /**
   * The occluders, input port 1.
   */
  void SetOccludersConnection(vtkAlgorithmOutput* output);
  void SetOccludersData(vtkDataObject* occluders);
  ///@}

  ///@{
  /**
   * The lights, input port 2.
   */
  void AddLightsConnection(vtkAlgorithmOutput* output);
  void AddLightsData(vtkDataObject* lights);
  void RemoveAllLights();
  ///@}

  ///@{
  /**
   * Whether points or cells (at their parametric centres) receive, one of ReceiverLocations.
   * Default Cells.
   */
  vtkSetClampMacro(ReceiverLocation, int, Points, Cells);
  vtkGetMacro(ReceiverLocation, int);
  ///@}

  ///@{
  /**
   * Whether occluders cast shadows. Without, port 1 is not looked at. Default on.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Whether each light gets an array of its own beside the sum. Default off.
   */
  vtkSetMacro(PerLightArrays, bool);
  vtkGetMacro(PerLightArrays, bool);
  vtkBooleanMacro(PerLightArrays, bool);
  ///@}

  ///@{
  /**
   * What one unit of the coordinates of all inputs is, one of LengthUnits. Default Metre.
   */
  vtkSetClampMacro(LengthUnit, int, Metre, Foot);
  vtkGetMacro(LengthUnit, int);
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
   * Threads to use; 0 means VTK_SMP_MAX_THREADS when that is set, else as many as this process may
   * use. Range 0 to 4096, default 0.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 4096);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Over whose ranks occluders and lights are spread; null means that this process holds all of
   * them. Default vtkMultiProcessController::GetGlobalController().
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkLumiIrradiance();
  ~vtkLumiIrradiance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiIrradiance(const vtkLumiIrradiance&) = delete;
  void operator=(const vtkLumiIrradiance&) = delete;

  int ReceiverLocation = Cells;
  bool Shadows = true;
  bool PerLightArrays = false;
  int LengthUnit = Metre;
  int Structure = Auto;
  int Precision = Fast;
  int NumberOfThreads = 0;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
