// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiRadiance
 * @brief Radiance in W/(m^2 sr) (or luminance in cd/m^2) along rays, or by direction at points.
 *
 * Inputs: port 0 from where it is looked: rays, in the forms that vtkLumiRayCast takes (Look is
 * AlongRays), or any dataset or composite (ByDirection); port 1 what is in the way (any dataset or
 * composite, as one scene; optional: without it nothing is); port 2 the lights (repeatable, see
 * Docs/lights.md).
 *
 * The radiance of a ray is what arrives at its origin out of its direction: the sum over the area
 * lights, spheres, disks, tubes, suns with a disk and skies that it meets between TMin and TMax
 * before it hits the surface. It does not change when the origin moves along the ray. Points, lines
 * and parallel light have no radiance: they show by what they make of the surface (Reflection).
 * Lights do not hide each other, and the surface does not hide a light that touches it; so the
 * integral of the radiance times the cosine is what vtkLumiIrradiance gives.
 *
 * Reflection: the surface reflects direct light by Lambert's law on both sides, L = R E / pi, with
 * its cell array `Reflectance` (0 to 1) where it has one, else with Reflectance. Nothing is
 * reflected twice.
 *
 * Output: AlongRays: the rays (of polylines: their segments) with the point or cell array
 * `Radiance [W/(m^2 sr)]` (`Luminance [cd/m^2]`), the active scalars; rays of an image give an
 * image. ByDirection: the dataset with that array on its points or cells, a component for each
 * direction of the sphere: Rings around Axis, each of Sectors, counted from Reference
 * counterclockwise; component ring * Sectors + sector is the middle of its cell. Field data:
 * `RadianceDirections` (three components) and `RadianceSolidAngles [sr]`, which add up to 4 pi.
 * Where a receiver has a normal, what lies behind it gives 0. All arrays are double; NaN where a
 * ray cannot be traced, counted in one warning.
 *
 * The output is the same, bit for bit, for any number of threads. In a run over several ranks
 * surface and lights are replicated and rays stay where they are. Wrong input (no light, an unknown
 * light, rays that are none) is one error and an empty output.
 */
#ifndef vtkLumiRadiance_h
#define vtkLumiRadiance_h

#include "LumitreeFiltersLightModule.h" // for export macro
#include "vtkLumiIlluminationAlgorithm.h"

#include <memory> // for the implementation

VTK_ABI_NAMESPACE_BEGIN
class LUMITREEFILTERSLIGHT_EXPORT vtkLumiRadiance : public vtkLumiIlluminationAlgorithm
{
public:
  static vtkLumiRadiance* New();
  vtkTypeMacro(vtkLumiRadiance, vtkLumiIlluminationAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Where it is looked.
   */
  enum Looks
  {
    AlongRays = 0,
    ByDirection = 1
  };

  ///@{
  /**
   * Whether port 0 holds rays, or places with all directions around them, one of Looks. Default
   * AlongRays.
   */
  vtkSetClampMacro(Look, int, AlongRays, ByDirection);
  vtkGetMacro(Look, int);
  ///@}

  ///@{
  /**
   * Limits of rays without `RayTMin` and `RayTMax`; segments have [0, 1]. In units of |direction|;
   * below 0 nothing is looked at. Suns and skies are seen from a TMax of 1e290 on. Defaults 0 and
   * +infinity.
   */
  vtkSetMacro(TMin, double);
  vtkGetMacro(TMin, double);
  vtkSetMacro(TMax, double);
  vtkGetMacro(TMax, double);
  ///@}

  ///@{
  /**
   * ByDirection: bands of the sphere from Axis to its opposite (range 1 to 180, default 12) and
   * parts of each (range 1 to 360, default 24).
   */
  vtkSetClampMacro(Rings, int, 1, 180);
  vtkGetMacro(Rings, int);
  vtkSetClampMacro(Sectors, int, 1, 360);
  vtkGetMacro(Sectors, int);
  ///@}

  ///@{
  /**
   * ByDirection: the pole of the rings, and where sectors begin; any length but 0, not parallel.
   * Default (0, 0, 1) and (1, 0, 0).
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  vtkSetVector3Macro(Reference, double);
  vtkGetVector3Macro(Reference, double);
  ///@}

  ///@{
  /**
   * Whether the surface reflects direct light (default off), and how much of it where it has no
   * cell array `Reflectance` (range 0 to 1, default 0.5).
   */
  vtkSetMacro(Reflection, bool);
  vtkGetMacro(Reflection, bool);
  vtkBooleanMacro(Reflection, bool);
  vtkSetClampMacro(Reflectance, double, 0.0, 1.0);
  vtkGetMacro(Reflectance, double);
  ///@}

protected:
  vtkLumiRadiance();
  ~vtkLumiRadiance() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLumiRadiance(const vtkLumiRadiance&) = delete;
  void operator=(const vtkLumiRadiance&) = delete;

  int Look = AlongRays;
  double TMin = 0.0;
  double TMax;
  int Rings = 12;
  int Sectors = 24;
  double Axis[3] = { 0.0, 0.0, 1.0 };
  double Reference[3] = { 1.0, 0.0, 0.0 };
  bool Reflection = false;
  double Reflectance = 0.5;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};
VTK_ABI_NAMESPACE_END

#endif
