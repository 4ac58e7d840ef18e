// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ray filters in a pipeline: what is built when, choices that are not there, abort, extents.
#include "RaysFixtures.h"

#include "vtkLumiAccelerationStructure.h"
#include "vtkLumiRayCast.h"

#include "LumiCache.h"

#include "Accel/Registry.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

using namespace lumitree::testing;
using lumitree::filters::treeBuilds;

namespace
{

double firstT(vtkLumiRayCast* cast)
{
  cast->Update();
  return value(vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1))->GetPointData(), "T", 0);
}

vtkSmartPointer<vtkPolyData> towardsX()
{
  return pointRays({ { { 3, 0.05, 0.02 }, { -1, 0, 0 } } });
}

} // namespace

TEST(RayPipeline, MovingRaysBuildsNothing)
{
  const auto surface = polyData(lumitree::data::sphere(10));
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputData(0, surface);
  cast->SetRaysData(pointRays(raysAtUnitBall(10)));
  cast->RefitOff();
  cast->Update();
  const auto builds = treeBuilds();
  for (std::uint64_t seed = 2; seed < 5; ++seed)
  {
    cast->SetRaysData(pointRays(raysAtUnitBall(10, 3.0, seed)));
    cast->SetQuery(static_cast<int>(seed) % 4);
    cast->Update();
  }
  EXPECT_EQ(treeBuilds(), builds);
  surface->GetPoints()->SetPoint(0, 0, 0, 2);
  surface->GetPoints()->Modified();
  cast->Update();
  EXPECT_EQ(treeBuilds(), builds + 1);
}

TEST(RayPipeline, ThreeFiltersShareOneTree)
{
  const auto surface = polyData(lumitree::data::sphere(11));
  const auto before = treeBuilds();
  vtkNew<vtkLumiRayCast> first;
  vtkNew<vtkLumiRayCast> second;
  vtkNew<vtkLumiAccelerationStructure> third;
  for (vtkLumiRayAlgorithm* filter : { static_cast<vtkLumiRayAlgorithm*>(first),
         static_cast<vtkLumiRayAlgorithm*>(second), static_cast<vtkLumiRayAlgorithm*>(third) })
  {
    vtkNew<vtkPolyData> copy; // another dataset over the same arrays, as filters hand it on
    copy->ShallowCopy(surface);
    filter->SetInputData(0, copy);
    filter->SetRaysData(towardsX());
    filter->SetStructure(vtkLumiRayAlgorithm::Bvh);
    filter->Update();
  }
  EXPECT_EQ(treeBuilds(), before + 1);
  second->SetLeafSize(8);
  second->Update();
  EXPECT_EQ(treeBuilds(), before + 2);
}

TEST(RayPipeline, SwappedMeshesAreNoticed)
{
  const auto near = triangles({ { 2, -9, -9 }, { 2, 9, -9 }, { 2, 0, 9 } });
  const auto far = triangles({ { 1, -9, -9 }, { 1, 9, -9 }, { 1, 0, 9 } });
  vtkNew<vtkLumiRayCast> cast;
  cast->SetRaysData(towardsX());
  for (int i = 0; i < 3; ++i) // the far one is newer, so "newer than" would keep it
  {
    cast->SetInputData(0, near);
    EXPECT_EQ(firstT(cast), 1);
    cast->SetInputData(0, far);
    EXPECT_EQ(firstT(cast), 2);
  }
}

TEST(RayPipeline, NewPointDataIsPassedWithoutANewTree)
{
  const auto surface = triangles({ { 2, -9, -9 }, { 2, 9, -9 }, { 2, 0, 9 } });
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputData(0, surface);
  cast->SetRaysData(towardsX());
  cast->PassSurfaceDataOn();
  cast->Update();
  const auto builds = treeBuilds();
  for (const double temperature : { 20.0, 30.0 })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Temperature");
    array->SetNumberOfTuples(3);
    array->FillValue(temperature);
    surface->GetPointData()->AddArray(array);
    surface->Modified();
    cast->Update();
    vtkDataObject* hits = cast->GetOutputDataObject(0);
    EXPECT_NEAR(
      value(hits->GetAttributes(vtkDataObject::POINT), "Temperature", 0), temperature, 1e-12);
  }
  EXPECT_EQ(treeBuilds(), builds);
}

TEST(RayPipeline, AChoiceThatIsNotThereIsOneError)
{
  const auto surface = polyData(lumitree::data::sphere(4));
  vtkNew<vtkLumiRayCast> cast;
  vtkNew<vtkLumiAccelerationStructure> structure;
  for (vtkLumiRayAlgorithm* filter :
    { static_cast<vtkLumiRayAlgorithm*>(cast), static_cast<vtkLumiRayAlgorithm*>(structure) })
  {
    filter->SetInputData(0, surface);
    filter->SetRaysData(towardsX());
    for (int s = vtkLumiRayAlgorithm::BruteForce; s <= vtkLumiRayAlgorithm::CgalCartesian; ++s)
    {
      const bool there = lumitree::Registry::instance().has(static_cast<lumitree::Structure>(s));
      Messages messages(filter);
      filter->SetStructure(s);
      filter->Update();
      EXPECT_EQ(messages.errors, there ? 0 : 1) << s << messages.text;
      if (!there)
      {
        const std::string name(lumitree::name(static_cast<lumitree::Structure>(s)));
        EXPECT_NE(messages.text.find(name), std::string::npos) << messages.text;
      }
    }
  }
}

TEST(RayPipeline, APrecisionThatIsNotPromisedIsOneError)
{
  vtkNew<vtkLumiRayCast> cast;
  const auto surface = polyData(lumitree::data::sphere(4));
  cast->SetInputData(0, surface);
  cast->SetRaysData(towardsX());
  for (int s = vtkLumiRayAlgorithm::BruteForce; s <= vtkLumiRayAlgorithm::CgalCartesian; ++s)
  {
    if (!lumitree::Registry::instance().has(static_cast<lumitree::Structure>(s)))
    {
      continue;
    }
    cast->SetStructure(s);
    for (int p = vtkLumiRayAlgorithm::Fast; p <= vtkLumiRayAlgorithm::Exact; ++p)
    {
      lumitree::BuildOptions options;
      options.structure = static_cast<lumitree::Structure>(s);
      const auto tree = lumitree::filters::treeFor(surface, options, nullptr, nullptr);
      const bool promised = tree->accelerator->supports(static_cast<lumitree::Precision>(p));
      Messages messages(cast);
      cast->SetPrecision(p);
      cast->Update();
      EXPECT_EQ(messages.errors, promised ? 0 : 1) << s << " " << p << messages.text;
      EXPECT_EQ(
        cast->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::POINT), promised ? 1 : 0);
    }
  }
}

TEST(RayPipeline, AnAbortedCastIsWhole)
{
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputData(0, polyData(lumitree::data::sphere(20)));
  cast->SetRaysData(pointRays(raysAtUnitBall(200000)));
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
  const unsigned long tag = cast->AddObserver(vtkCommand::ProgressEvent, command);
  for (int query = vtkLumiRayCast::Closest; query <= vtkLumiRayCast::Count; ++query)
  {
    cast->SetQuery(query);
    cast->SetAbortExecute(0);
    cast->Update();
    auto* rays = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1));
    vtkDataObject* hits = cast->GetOutputDataObject(0);
    const bool given = query == vtkLumiRayCast::Closest || query == vtkLumiRayCast::All;
    vtkIdType total = 0;
    for (vtkIdType r = 0; r < rays->GetNumberOfPoints(); ++r)
    {
      ASSERT_TRUE(!given || value(rays->GetPointData(), "HitOffset", r) == total);
      total += static_cast<vtkIdType>(value(rays->GetPointData(), "HitCount", r));
    }
    EXPECT_EQ(hits->GetNumberOfElements(vtkDataObject::POINT), given ? total : 0);
  }
  cast->RemoveObserver(tag);
  cast->SetAbortExecute(0);
  cast->SetQuery(vtkLumiRayCast::Count);
  cast->Modified();
  cast->Update();
  auto* rays = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1));
  EXPECT_EQ(rays->GetNumberOfPoints(), 200000);
}

TEST(RayPipeline, AnAbortedBuildLeavesNothingAndNoMessage)
{
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputData(0, polyData(lumitree::data::terrain(64)));
  cast->SetRaysData(pointRays(raysAtUnitBall(100)));
  cast->SetStructure(static_cast<int>(lumitree::Structure::KdTree));
  Messages messages(cast);
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(
    [](vtkObject* object, unsigned long, void*, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(object);
      filter->SetAbortExecute(filter->GetProgress() > 0.1 ? 1 : 0);
    });
  const unsigned long tag = cast->AddObserver(vtkCommand::ProgressEvent, command);
  const std::uint64_t before = lumitree::filters::treeBuilds();
  cast->Update();
  EXPECT_EQ(lumitree::filters::treeBuilds(), before);
  EXPECT_EQ(messages.errors, 0) << messages.text;
  EXPECT_EQ(cast->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::POINT), 0);
  cast->RemoveObserver(tag);
  cast->SetAbortExecute(0);
  cast->Modified();
  cast->Update();
  EXPECT_EQ(lumitree::filters::treeBuilds(), before + 1);
  EXPECT_EQ(cast->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::POINT), 100);
}

TEST(RayPipeline, TheImageOfRaysKeepsItsExtent)
{
  vtkNew<vtkImageData> volume; // an image as well, of another size
  volume->SetDimensions(5, 5, 5);
  vtkNew<vtkTrivialProducer> surface;
  surface->SetOutput(volume);
  vtkNew<vtkTrivialProducer> rays;
  rays->SetOutput(imageRays(raysAtUnitBall(48), 8));
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputConnection(0, surface->GetOutputPort());
  cast->SetRaysConnection(rays->GetOutputPort());
  Messages messages(cast);
  for (const int port : { 0, 1, 0 })
  {
    cast->Update(port);
    const auto* image = vtkImageData::SafeDownCast(cast->GetOutputDataObject(1));
    int dimensions[3];
    const_cast<vtkImageData*>(image)->GetDimensions(dimensions);
    EXPECT_EQ(dimensions[0], 8);
    EXPECT_EQ(dimensions[1], 6);
    EXPECT_EQ(dimensions[2], 1);
  }
  EXPECT_EQ(messages.errors, 0) << messages.text;
}

TEST(RayPipeline, APieceOfTheRaysMeetsAllOfTheSurface)
{
  vtkNew<vtkLumiRayCast> cast;
  vtkNew<vtkTrivialProducer> surface;
  surface->SetOutput(polyData(lumitree::data::sphere(6)));
  vtkNew<vtkTrivialProducer> rays;
  rays->SetOutput(imageRays(raysAtUnitBall(64), 8));
  cast->SetInputConnection(0, surface->GetOutputPort());
  cast->SetRaysConnection(rays->GetOutputPort());
  cast->Update(1);
  const double all = vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0))->GetNumberOfPoints();
  double sum = 0;
  for (int piece = 0; piece < 2; ++piece)
  {
    cast->UpdatePiece(piece, 2, 0);
    sum += vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0))->GetNumberOfPoints();
  }
  EXPECT_GE(sum, all); // points on the common border of two pieces are cast twice
}
