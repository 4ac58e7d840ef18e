// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLumiImplicitSurface
 * @brief   quadrics and other implicit surfaces that rays hit as they are, without a mesh
 *
 * The output is a vtkPolyData that every surface port of this library takes for the quadrics
 * themselves: their definition is in its field data, with a vertex cell for each and, behind these,
 * polygons that only show them (data model, "Quadrics"). It may stand beside meshes in a composite.
 * A filter that moves, cuts or joins its cells does not know the definition; the surface ports then
 * refuse it with a message. A hit reports the vertex cell's id.
 *
 * Without an input there is one body. With an input (any dataset) there is one at each of its
 * points, for Sphere to Disc: Center is then added to the point, Radius (Radii) multiplied by
 * RadiusArray, Direction replaced by DirectionArray. Point arrays of the input are passed on.
 *
 * Numbers are doubles and meant exactly, up to what Docs/data-model.md says of each shape. Bodies
 * whose numbers make no sense (a radius that is 0, negative or not finite) stay as cells and are
 * never hit; the statistics of the structure count them.
 *
 * When pieces are asked for, piece 0 is the whole and all others are empty.
 */
#ifndef vtkLumiImplicitSurface_h
#define vtkLumiImplicitSurface_h

#include "LumitreeFiltersSourcesModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for ImplicitFunction

class vtkImplicitFunction;

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiImplicitSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiImplicitSurface* New();
  vtkTypeMacro(vtkLumiImplicitSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeType
  {
    Sphere = 0,
    Ellipsoid = 1,
    Cylinder = 2,
    Cone = 3,
    Paraboloid = 4,
    Disc = 5,
    Plane = 6,
    Box = 7,
    Quadric = 8,
    Function = 9
  };

  ///@{
  /**
   * What is made. Default Sphere.
   * - Sphere: Center, Radius. Ellipsoid: Center, Radii along x, y and z.
   * - Cylinder: Radius, Height along Direction, Center in the middle; Capped adds the two discs.
   * - Cone: its base has the Radius, its apex lies Height further along Direction, Center is in the
   *   middle between them; Capped adds the base.
   * - Paraboloid: its vertex in Center, at Height along Direction it has the Radius.
   * - Disc: Center, Radius, Direction is its normal.
   * - Plane: the part within Bounds of the plane through Center with the normal Direction.
   * - Box: the six sides of Bounds.
   * - Quadric: the part within Bounds of a0 x^2 + a1 y^2 + a2 z^2 + a3 x y + a4 y z + a5 x z + a6 x
   *   + a7 y + a8 z + a9 = 0 with Coefficients a, in coordinates relative to Center.
   * - Function: the part within Bounds where ImplicitFunction is 0.
   */
  vtkSetClampMacro(Shape, int, Sphere, Function);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /**
   * Where it is. Default (0, 0, 0).
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Default 0.5. It must be above 0.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Semi-axes of the ellipsoid along x, y and z. Default (0.5, 0.5, 0.5). They must be above 0.
   */
  vtkSetVector3Macro(Radii, double);
  vtkGetVector3Macro(Radii, double);
  ///@}

  ///@{
  /**
   * Of any length but 0. Default (0, 0, 1).
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * Default 1. It must be above 0.
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Whether cylinders and cones have their ends. Default on.
   */
  vtkSetMacro(Capped, bool);
  vtkGetMacro(Capped, bool);
  vtkBooleanMacro(Capped, bool);
  ///@}

  ///@{
  /**
   * x min, x max, y min and so on, closed. Default -1, 1 for each.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * In the order of vtkQuadric. Default: the sphere of radius 1.
   */
  void SetCoefficients(const double a[10]);
  void SetCoefficients(double a0, double a1, double a2, double a3, double a4, double a5, double a6,
    double a7, double a8, double a9);
  vtkGetVectorMacro(Coefficients, double, 10);
  ///@}

  ///@{
  /**
   * The function of the shape Function; any. What is promised of its surface is in the output's
   * field array ImplicitGuarantee:
   * - 0, exact: vtkSphere, vtkPlane, vtkCylinder, vtkCone, vtkQuadric, vtkBox, vtkPlanes, and
   *   vtkImplicitBoolean of such, also under linear transforms. They are made of quadrics.
   * - 1, by intervals: vtkSuperquadric, and vtkImplicitBoolean that holds one. Sign changes are
   *   isolated with certainty; hits where that was not possible say so (HitFlags).
   * - 2, sampled: all others. Sign changes between samples Step apart, found one ray at a time.
   * Default none.
   */
  virtual void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction();
  ///@}

  ///@{
  /**
   * Length between samples along a ray, of functions that are sampled. 0: 1/256 of the diagonal of
   * Bounds. At least 1e-6 of that diagonal. Default 0.
   */
  vtkSetMacro(Step, double);
  vtkGetMacro(Step, double);
  ///@}

  ///@{
  /**
   * Names of point arrays of the input: a factor for the radius (radii), and a direction. Null, ""
   * and, where there is no such array, "None" are none. Default null.
   */
  vtkSetStringMacro(RadiusArray);
  vtkGetStringMacro(RadiusArray);
  vtkSetStringMacro(DirectionArray);
  vtkGetStringMacro(DirectionArray);
  ///@}

  ///@{
  /**
   * The polygons that show a body follow it in this many steps an axis; 0 makes none. Range [0,
   * 200], default 16.
   */
  vtkSetClampMacro(PreviewResolution, int, 0, 200);
  vtkGetMacro(PreviewResolution, int);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkLumiImplicitSurface();
  ~vtkLumiImplicitSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Shape = Sphere;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.5;
  double Radii[3] = { 0.5, 0.5, 0.5 };
  double Direction[3] = { 0.0, 0.0, 1.0 };
  double Height = 1.0;
  bool Capped = true;
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  double Coefficients[10] = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0 };
  vtkSmartPointer<vtkImplicitFunction> ImplicitFunction;
  double Step = 0.0;
  char* RadiusArray = nullptr;
  char* DirectionArray = nullptr;
  int PreviewResolution = 16;

private:
  vtkLumiImplicitSurface(const vtkLumiImplicitSurface&) = delete;
  void operator=(const vtkLumiImplicitSurface&) = delete;
};

#endif
