// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A pipeline in C++: a scene, a lamp, the light on the scene, and what a camera's rays hit of it.
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkLumiCameraRays.h>
#include <vtkLumiIrradiance.h>
#include <vtkLumiPointLight.h>
#include <vtkLumiRayCast.h>
#include <vtkLumiScene.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkLumiScene> teapot; // metres, on the plane z = 0
  teapot->SetScene(vtkLumiScene::Teapot);
  teapot->SetResolution(8);

  vtkNew<vtkLumiPointLight> lamp;
  lamp->SetPosition(4, -4, 6);
  lamp->SetFlux(1000.0); // W

  vtkNew<vtkLumiIrradiance> light;
  light->SetInputConnection(teapot->GetOutputPort());
  light->AddLightsConnection(lamp->GetOutputPort());

  vtkNew<vtkLumiCameraRays> camera;
  camera->SetPosition(3, -9, 6);
  camera->SetFocalPoint(0, 0, 1.4);
  camera->SetViewUp(0, 0, 1);
  camera->SetResolution(64, 48);

  // The same tree serves both filters; hits carry the irradiance where they are.
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputConnection(0, light->GetOutputPort());
  cast->SetRaysConnection(camera->GetOutputPort());
  cast->PassSurfaceDataOn();
  cast->Update();

  auto* lit = vtkDataSet::SafeDownCast(light->GetOutputDataObject(0));
  auto* hits = vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0));
  vtkDataArray* irradiance = lit->GetCellData()->GetArray("Irradiance [W/m^2]");
  if (!irradiance || hits->GetNumberOfPoints() == 0)
  {
    std::cerr << "nothing was computed\n";
    return EXIT_FAILURE;
  }
  std::cout << lit->GetNumberOfCells() << " cells, at most " << irradiance->GetRange()[1]
            << " W/m^2; " << hits->GetNumberOfPoints() << " of " << 64 * 48 << " rays hit\n";
  return irradiance->GetRange()[1] > 0.0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
