// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Structures that are not built: refitted where points move, loaded from files.
#include "RaysFixtures.h"

#include "LumiCache.h"
#include "vtkLumiAccelerationStructure.h"
#include "vtkLumiRayCast.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace lumitree::testing;
using lumitree::filters::treeBuilds;

namespace
{

/// The same surface with its points moved along a wave; another object over the same cells.
vtkSmartPointer<vtkPolyData> waved(vtkPolyData* surface, double size)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(surface);
  vtkNew<vtkPoints> points;
  points->DeepCopy(surface->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    p[0] += size * std::sin(5.0 * p[2] + 9.0 * size);
    points->SetPoint(i, p);
  }
  moved->SetPoints(points);
  return moved;
}

std::string origin(vtkLumiRayCast* cast)
{
  cast->Update();
  return vtkTable::SafeDownCast(cast->GetOutputDataObject(3))
    ->GetValueByName(0, "Origin")
    .ToString();
}

double number(vtkLumiRayCast* cast, const char* column)
{
  return vtkTable::SafeDownCast(cast->GetOutputDataObject(3))->GetValueByName(0, column).ToDouble();
}

vtkPolyData* hitsOf(vtkLumiRayCast* cast)
{
  return vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0));
}

vtkSmartPointer<vtkLumiRayCast> casterOf(vtkPolyData* surface)
{
  auto cast = vtkSmartPointer<vtkLumiRayCast>::New();
  cast->SetStructure(vtkLumiRayCast::WideBvh);
  cast->SetPrecision(vtkLumiRayCast::Exact);
  cast->SetInputData(0, surface);
  cast->SetRaysData(pointRays(raysAtUnitBall(300)));
  return cast;
}

class StructureFile : public ::testing::Test
{
protected:
  void SetUp() override { std::filesystem::remove(this->path); }
  void TearDown() override { std::filesystem::remove(this->path); }

  const std::string path =
    (std::filesystem::temp_directory_path() / "LumitreeRaysReuse.lumitree").string();
};

} // namespace

TEST(Refit, MovedPointsAreFittedWithTheSameHits)
{
  const auto surface = polyData(lumitree::data::sphere(12));
  const auto cast = casterOf(surface);
  EXPECT_EQ(origin(cast), "built");
  for (int frame = 1; frame < 6; ++frame)
  {
    const auto there = waved(surface, 0.04 * frame);
    cast->SetInputData(0, there);
    const auto builds = treeBuilds();
    EXPECT_EQ(origin(cast), "refitted");
    EXPECT_EQ(treeBuilds(), builds);
    EXPECT_GT(number(cast, "SahCost"), 0.0);
    EXPECT_GT(number(cast, "SahCostBuilt"), 0.0);
    const auto fresh = casterOf(there);
    fresh->SetStructure(vtkLumiRayCast::BruteForce);
    fresh->Update();
    EXPECT_TRUE(sameBits(hitsOf(cast)->GetPointData(), hitsOf(fresh)->GetPointData()));
  }
}

TEST(Refit, InPlaceMovesAreFittedToo)
{
  const auto surface = polyData(lumitree::data::sphere(12));
  const auto cast = casterOf(surface);
  EXPECT_EQ(origin(cast), "built");
  surface->GetPoints()->SetPoint(0, 0, 0, 2);
  surface->GetPoints()->Modified();
  EXPECT_EQ(origin(cast), "refitted");
  EXPECT_EQ(origin(cast), "refitted"); // nothing is done where nothing has changed
}

TEST(Refit, BuildsWhereItMust)
{
  const auto surface = polyData(lumitree::data::sphere(12));
  const auto expectBuilt = [&](vtkLumiRayCast* cast, vtkPolyData* there)
  {
    EXPECT_EQ(origin(cast), "built");
    cast->SetInputData(0, there);
    EXPECT_EQ(origin(cast), "built");
  };
  {
    const auto cast = casterOf(surface);
    cast->RefitOff();
    expectBuilt(cast, waved(surface, 0.1));
  }
  {
    const auto cast = casterOf(surface);
    cast->SetStructure(vtkLumiRayCast::KdTree);
    expectBuilt(cast, waved(surface, 0.1));
  }
  {
    const auto cast = casterOf(surface); // other cells over as many points
    const auto there = waved(surface, 0.1);
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy(surface->GetPolys());
    cells->ReverseCellAtId(3);
    there->SetPolys(cells);
    expectBuilt(cast, there);
  }
  {
    const auto cast = casterOf(surface); // every point anywhere: too dear
    cast->SetRefitLimit(1.5);
    const auto there = waved(surface, 0.0);
    for (vtkIdType i = 0; i < there->GetNumberOfPoints(); ++i)
    {
      there->GetPoints()->SetPoint(i, std::sin(71.0 * i), std::sin(37.0 * i), std::cos(53.0 * i));
    }
    expectBuilt(cast, there);
  }
  {
    const auto cast = casterOf(surface); // other choices
    EXPECT_EQ(origin(cast), "built");
    cast->SetLeafSize(9);
    cast->SetInputData(0, waved(surface, 0.1));
    EXPECT_EQ(origin(cast), "built");
  }
}

TEST(Refit, AFilterThatWantsNoneGetsNone)
{
  const auto surface = polyData(lumitree::data::sphere(12));
  const auto cast = casterOf(surface);
  EXPECT_EQ(origin(cast), "built");
  const auto there = waved(surface, 0.1);
  cast->SetInputData(0, there);
  EXPECT_EQ(origin(cast), "refitted");
  const auto other = casterOf(there);
  other->RefitOff();
  EXPECT_EQ(origin(other), "built");
  EXPECT_EQ(origin(casterOf(there)), "refitted"); // shared
}

TEST_F(StructureFile, KeepsTheStructure)
{
  const auto surface = polyData(lumitree::data::sphere(13));
  for (int structure = vtkLumiRayCast::Auto; structure <= vtkLumiRayCast::BspTree; ++structure)
  {
    std::filesystem::remove(this->path);
    const auto first = casterOf(surface);
    first->SetStructure(structure);
    first->SetStructureFile(this->path.c_str());
    EXPECT_EQ(origin(first), "built");
    EXPECT_TRUE(std::filesystem::exists(this->path));
    vtkNew<vtkPolyData> hits;
    hits->DeepCopy(hitsOf(first));
    first->SetInputData(0, polyData(lumitree::data::cornellBox())); // lets go of it
    first->SetStructureFile("");
    first->Update();
    const auto second = casterOf(surface);
    second->SetStructure(structure);
    second->SetStructureFile(this->path.c_str());
    const auto builds = treeBuilds();
    EXPECT_EQ(origin(second), "loaded");
    EXPECT_EQ(treeBuilds(), builds);
    EXPECT_TRUE(sameBits(hitsOf(second)->GetPointData(), hits->GetPointData()));
  }
}

TEST_F(StructureFile, LoadTakesWhatTheFileHas)
{
  const auto surface = polyData(lumitree::data::sphere(13));
  vtkNew<vtkLumiAccelerationStructure> tree;
  tree->SetInputData(0, surface);
  tree->SetStructure(vtkLumiAccelerationStructure::KdTree);
  tree->SetStructureFile(this->path.c_str());
  tree->SetStructureFileUse(vtkLumiAccelerationStructure::Save);
  tree->Update();
  const auto cast = casterOf(surface);
  cast->SetStructureFile(this->path.c_str());
  cast->SetStructureFileUse(vtkLumiRayCast::Load);
  EXPECT_EQ(origin(cast), "loaded");
  EXPECT_EQ(
    vtkTable::SafeDownCast(cast->GetOutputDataObject(3))->GetValueByName(0, "Structure").ToString(),
    "kd_tree");
  // Another file under the same name is another structure.
  tree->SetStructure(vtkLumiAccelerationStructure::Octree);
  tree->Update();
  cast->Modified();
  EXPECT_EQ(origin(cast), "loaded");
  EXPECT_EQ(
    vtkTable::SafeDownCast(cast->GetOutputDataObject(3))->GetValueByName(0, "Structure").ToString(),
    "octree");
}

TEST_F(StructureFile, OfAnotherSurface)
{
  const auto surface = polyData(lumitree::data::sphere(13));
  const auto cast = casterOf(surface);
  cast->SetStructureFile(this->path.c_str());
  EXPECT_EQ(origin(cast), "built");
  const auto time = std::filesystem::last_write_time(this->path);
  cast->RefitOff();
  cast->SetInputData(0, waved(surface, 0.1));
  EXPECT_EQ(origin(cast), "built");
  EXPECT_EQ(std::filesystem::last_write_time(this->path), time);
  const Messages messages(cast);
  cast->SetStructureFileUse(vtkLumiRayCast::Load);
  cast->Update();
  EXPECT_EQ(messages.errors, 1);
  EXPECT_NE(messages.text.find("another surface"), std::string::npos) << messages.text;
  EXPECT_EQ(hitsOf(cast)->GetNumberOfPoints(), 0);
}

TEST_F(StructureFile, WrongFilesAreOneError)
{
  const auto surface = polyData(lumitree::data::sphere(13));
  for (const int use : { vtkLumiRayCast::LoadOrBuild, vtkLumiRayCast::Load, vtkLumiRayCast::Save })
  {
    std::ofstream(this->path) << "my only copy";
    const auto cast = casterOf(surface);
    cast->SetStructureFile(this->path.c_str());
    cast->SetStructureFileUse(use);
    const Messages messages(cast);
    cast->Update();
    EXPECT_EQ(messages.errors, 1);
    EXPECT_NE(messages.text.find("no saved structure"), std::string::npos) << messages.text;
    EXPECT_EQ(hitsOf(cast)->GetNumberOfPoints(), 0);
    std::ifstream file(this->path);
    std::string kept;
    std::getline(file, kept);
    EXPECT_EQ(kept, "my only copy");
  }
  for (const int use : { vtkLumiRayCast::LoadOrBuild, vtkLumiRayCast::Load, vtkLumiRayCast::Save })
  {
    const auto cast = casterOf(surface);
    cast->SetStructureFile("/no such directory/file");
    cast->SetStructureFileUse(use);
    const Messages messages(cast);
    cast->Update();
    EXPECT_EQ(messages.errors, 1);
    EXPECT_NE(messages.text.find("no such directory"), std::string::npos) << messages.text;
  }
}

TEST_F(StructureFile, ReferencesAreNotSaved)
{
  const auto cast = casterOf(polyData(lumitree::data::sphere(13)));
  cast->SetStructure(vtkLumiRayCast::Embree);
  cast->SetPrecision(vtkLumiRayCast::Fast);
  cast->SetStructureFile(this->path.c_str());
  const Messages messages(cast);
  cast->Update();
  EXPECT_EQ(messages.errors, 1);
  EXPECT_FALSE(std::filesystem::exists(this->path));
}
