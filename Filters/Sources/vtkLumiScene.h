// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLumiScene
 * @brief   generated scenes to try rays and light on
 *
 * Polygons in metres, z up, facing the side that light and rays meet (outward for solid things,
 * inward for rooms). Cell data: `Part` (int), the index of the thing a cell belongs to, and
 * `Reflectance` (double, diffuse, in [0, 1]). Field data: `PartNames` (string), a name for each
 * value of `Part`; the Cornell box's light is the part named "light".
 *
 * The same properties give the same points, bit for bit, on every platform. Data/README.md says
 * where each scene comes from.
 *
 * When pieces are asked for, piece 0 is the whole scene and all others are empty.
 */
#ifndef vtkLumiScene_h
#define vtkLumiScene_h

#include "LumitreeFiltersSourcesModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class LUMITREEFILTERSSOURCES_EXPORT vtkLumiScene : public vtkPolyDataAlgorithm
{
public:
  static vtkLumiScene* New();
  vtkTypeMacro(vtkLumiScene, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SceneType
  {
    CornellBox = 0,
    Teapot = 1,
    City = 2,
    TeapotInStadium = 3,
    RandomCloud = 4,
    Sphere = 5,
    Torus = 6,
    Terrain = 7
  };

  ///@{
  /**
   * Which scene. Default CornellBox.
   */
  vtkSetClampMacro(Scene, int, CornellBox, Terrain);
  vtkGetMacro(Scene, int);
  ///@}

  ///@{
  /**
   * How fine the scene is, or how much there is of it. Range [1, 1000], default 10.
   * With R the resolution:
   * - CornellBox: each of the 17 faces has R x R quads;
   * - Teapot, TeapotInStadium: each of the teapot's 32 patches has R x R quads, R at least 2;
   * - City: R x R towers, R at most 200;
   * - RandomCloud: 10 R^2 triangles;
   * - Sphere: 20 R^2 triangles;
   * - Torus: 4R x 2R quads, at least 4 x 3;
   * - Terrain: R x R quads.
   */
  vtkSetClampMacro(Resolution, int, 1, 1000);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * What City, RandomCloud and Terrain draw their random numbers from; any int. Default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkLumiScene();
  ~vtkLumiScene() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Scene = CornellBox;
  int Resolution = 10;
  int Seed = 1;

private:
  vtkLumiScene(const vtkLumiScene&) = delete;
  void operator=(const vtkLumiScene&) = delete;
};

#endif
