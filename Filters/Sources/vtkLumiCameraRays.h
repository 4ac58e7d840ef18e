// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiCameraRays
 * @brief The rays of a camera, one per pixel, as an image.
 *
 * The output is a vtkImageData of width x height x 1 points, row 0 at the bottom, origin 0 and
 * spacing 1, with the point arrays `RayOrigin` and `RayDirection` (double, three components). A ray
 * goes through the middle of its pixel. Directions have unit length, so that T is the distance from
 * the camera (perspective) or from the plane of the image (parallel). Whatever is computed per ray
 * is an image at once.
 *
 * The camera is plain properties, those of vtkCamera. With AutomaticCamera and a dataset on the
 * optional input port 0, *Scene* (any dataset or composite), the camera keeps its view direction
 * and moves so that the sphere around the scene's bounds fills the image; on several ranks, the
 * bounds are those of all ranks' pieces.
 *
 * A pixel depends on the properties and its place only. Any part of the image can be asked for: on
 * several ranks each gives its part of the whole extent (as VTK splits extents, neighbours share a
 * row or column of points), with the bits that a single rank would give.
 *
 * Properties that make no camera (a coordinate that is not finite, Position at FocalPoint, ViewUp
 * along the view direction, a resolution below 1) are one error, and the output is an empty image.
 *
 * @sa vtkLumiRays vtkLumiSurfaceRays vtkLumiRayCast
 */
#ifndef vtkLumiCameraRays_h
#define vtkLumiCameraRays_h

#include "LumitreeFiltersSourcesModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkMultiProcessController.h" // for Controller
#include "vtkSmartPointer.h"           // for Controller

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiCameraRays : public vtkImageAlgorithm
{
public:
  static vtkLumiCameraRays* New();
  vtkTypeMacro(vtkLumiCameraRays, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The scene that AutomaticCamera looks at, input port 0. Optional.
   */
  void SetSceneConnection(vtkAlgorithmOutput* output);
  void SetSceneData(vtkDataObject* scene);
  ///@}

  ///@{
  /**
   * Where the camera is, in units of the coordinates. Default (0, 0, 1).
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * The point that the middle of the image shows; not the Position. Default (0, 0, 0).
   */
  vtkSetVector3Macro(FocalPoint, double);
  vtkGetVector3Macro(FocalPoint, double);
  ///@}

  ///@{
  /**
   * Which direction is up in the image; any length but 0, not along the view direction. Default (0,
   * 1, 0).
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Perspective: the angle between the bottom and the top of the image, in degrees, above 0 and
   * below 180. Default 30.
   */
  vtkSetMacro(ViewAngle, double);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /**
   * Whether rays are parallel, each from its place in the plane of the image through Position,
   * instead of from one point. Default off.
   */
  vtkSetMacro(ParallelProjection, bool);
  vtkGetMacro(ParallelProjection, bool);
  vtkBooleanMacro(ParallelProjection, bool);
  ///@}

  ///@{
  /**
   * Parallel: half the height of the image, in units of the coordinates, above 0. Default 1.
   */
  vtkSetMacro(ParallelScale, double);
  vtkGetMacro(ParallelScale, double);
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels, which are square. At least 1, default 640 x 480.
   */
  vtkSetVector2Macro(Resolution, int);
  vtkGetVector2Macro(Resolution, int);
  ///@}

  ///@{
  /**
   * Whether Position, FocalPoint and ParallelScale are chosen so that the whole scene is seen;
   * their view direction, ViewUp and ViewAngle are kept. Without a scene, or with an empty one, the
   * camera is as given. Default off.
   */
  vtkSetMacro(AutomaticCamera, bool);
  vtkGetMacro(AutomaticCamera, bool);
  vtkBooleanMacro(AutomaticCamera, bool);
  ///@}

  ///@{
  /**
   * The ranks that hold pieces of the scene. Default the global controller; null is one rank.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkLumiCameraRays();
  ~vtkLumiCameraRays() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiCameraRays(const vtkLumiCameraRays&) = delete;
  void operator=(const vtkLumiCameraRays&) = delete;

  double Position[3] = { 0.0, 0.0, 1.0 };
  double FocalPoint[3] = { 0.0, 0.0, 0.0 };
  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0;
  bool ParallelProjection = false;
  double ParallelScale = 1.0;
  int Resolution[2] = { 640, 480 };
  bool AutomaticCamera = false;
  vtkSmartPointer<vtkMultiProcessController> Controller;
};

#endif
