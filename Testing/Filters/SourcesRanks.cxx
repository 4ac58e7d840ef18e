// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Run on three ranks: together they have the rays and lights that one rank would have.
#include "SourcesTools.h"

#include "vtkLumiCameraRays.h"
#include "vtkLumiPointLight.h"
#include "vtkLumiRays.h"

#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"

using namespace sources;

namespace
{

vtkMPIController* world = nullptr;

int rank()
{
  return world->GetLocalProcessId();
}

/// A camera that looks at the box, or at nothing when it has no extent.
vtkSmartPointer<vtkLumiCameraRays> cameraOf(double length, double start)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(start, start + length, -1.0, 1.0, 0.0, length);
  cube->Update();
  vtkNew<vtkPolyData> nothing;
  auto camera = vtkSmartPointer<vtkLumiCameraRays>::New();
  camera->AutomaticCameraOn();
  camera->SetResolution(40, 30);
  camera->SetSceneData(length > 0.0 ? cube->GetOutput() : nothing.Get());
  return camera;
}

}

TEST(Ranks, TheAutomaticCameraSeesTheScenesOfAllRanks)
{
  // Boxes from 0 to 3 and from 5 to 9; the last rank has none.
  const auto camera = cameraOf(rank() == 2 ? 0.0 : 3.0 + rank(), 5.0 * rank());
  camera->SetController(world);
  camera->UpdatePiece(rank(), 3, 0);
  vtkImageData* part = camera->GetOutput();
  ASSERT_LT(part->GetNumberOfPoints(), 1200);

  vtkNew<vtkCubeSource> all;
  all->SetBounds(0.0, 9.0, -1.0, 1.0, 0.0, 4.0);
  all->Update();
  const auto alone = cameraOf(1.0, 0.0);
  alone->SetController(nullptr);
  alone->SetSceneData(all->GetOutput());
  alone->Update();
  vtkImageData* whole = alone->GetOutput();

  const int* e = part->GetExtent();
  for (int j = e[2]; j <= e[3]; ++j)
  {
    for (int i = e[0]; i <= e[1]; ++i)
    {
      int pixel[3] = { i, j, 0 };
      const vtkIdType here = part->ComputePointId(pixel);
      const vtkIdType there = whole->ComputePointId(pixel);
      ASSERT_EQ(tuple(directions(part), here), tuple(directions(whole), there));
      for (const char* name : { "RayOrigin", "RayDirection" })
      {
        ASSERT_EQ(tuple(part->GetPointData()->GetArray(name), here),
          tuple(whole->GetPointData()->GetArray(name), there));
      }
    }
  }
}

TEST(Ranks, RaysAreSplitNotRepeated)
{
  vtkNew<vtkLumiRays> rays;
  rays->SetMode(vtkLumiRays::Random);
  rays->SetNumberOfRays(1001);
  rays->UpdatePiece(rank(), 3, 0);
  const vtkIdType mine = rays->GetOutput()->GetNumberOfPoints();
  vtkIdType all = 0;
  world->AllReduce(&mine, &all, 1, vtkCommunicator::SUM_OP);
  EXPECT_EQ(all, 1001);
}

TEST(Ranks, OneRankHasTheLight)
{
  vtkNew<vtkLumiPointLight> light;
  light->UpdatePiece(rank(), 3, 0);
  EXPECT_EQ(light->GetOutput()->GetNumberOfPoints(), rank() == 0 ? 1 : 0);
}

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  world = controller;
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  controller->Finalize();
  return failed;
}
