// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLumiScene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <sstream>

TEST(Scene, EverySceneHasItsArrays)
{
  // Cells at resolution 4.
  const vtkIdType cells[] = { 17 * 16, 32 * 16, 16 * 59 * 6 + 1, 32 * 16 + 6, 160, 320, 16 * 8,
    16 };
  vtkNew<vtkLumiScene> scene;
  scene->SetResolution(4);
  for (int i = vtkLumiScene::CornellBox; i <= vtkLumiScene::Terrain; ++i)
  {
    scene->SetScene(i);
    scene->Update();
    vtkPolyData* output = scene->GetOutput();
    EXPECT_EQ(output->GetNumberOfPolys(), cells[i]) << i;
    auto* part = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray("Part"));
    auto* reflectance =
      vtkDoubleArray::SafeDownCast(output->GetCellData()->GetArray("Reflectance"));
    auto* names =
      vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("PartNames"));
    ASSERT_TRUE(part && reflectance && names) << i;
    EXPECT_EQ(part->GetNumberOfTuples(), cells[i]);
    EXPECT_EQ(reflectance->GetNumberOfTuples(), cells[i]);
    EXPECT_EQ(part->GetRange()[1], names->GetNumberOfValues() - 1);
  }
}

TEST(Scene, OnlyPieceZeroHasCells)
{
  vtkNew<vtkLumiScene> scene;
  scene->UpdatePiece(1, 2, 0);
  EXPECT_EQ(scene->GetOutput()->GetNumberOfCells(), 0);
  scene->UpdatePiece(0, 2, 0);
  EXPECT_EQ(scene->GetOutput()->GetNumberOfCells(), 1700);
}

TEST(Scene, ClampsItsProperties)
{
  vtkNew<vtkLumiScene> scene;
  scene->SetScene(99);
  EXPECT_EQ(scene->GetScene(), vtkLumiScene::Terrain);
  scene->SetScene(-1);
  EXPECT_EQ(scene->GetScene(), vtkLumiScene::CornellBox);
  scene->SetResolution(0);
  EXPECT_EQ(scene->GetResolution(), 1);
  scene->SetResolution(100000);
  EXPECT_EQ(scene->GetResolution(), 1000);
  std::ostringstream text;
  scene->Print(text);
  EXPECT_NE(text.str().find("Resolution: 1000"), std::string::npos);
}

TEST(Scene, CoarsestResolutionAndNegativeSeedWork)
{
  vtkNew<vtkLumiScene> scene;
  scene->SetResolution(1);
  scene->SetSeed(-7);
  for (int i = vtkLumiScene::CornellBox; i <= vtkLumiScene::Terrain; ++i)
  {
    scene->SetScene(i);
    scene->Update();
    EXPECT_GT(scene->GetOutput()->GetNumberOfCells(), 0) << i;
  }
}
