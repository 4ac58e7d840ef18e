// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiAccelerationStructure by the data model: levels, nodes, visits, statistics.
#include "RaysFixtures.h"

#include "vtkLumiAccelerationStructure.h"
#include "vtkLumiRayCast.h"

#include "Accel/Registry.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <map>

using namespace lumitree::testing;

namespace
{

class Structure : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->surface_ = polyData(lumitree::data::sphere(6)); // 720 triangles
    this->filter_->SetInputData(0, this->surface_);
    this->filter_->SetStructure(vtkLumiAccelerationStructure::Bvh);
    this->filter_->SetMaximumLevel(64);
  }

  vtkMultiBlockDataSet* blocks()
  {
    this->filter_->Update();
    return vtkMultiBlockDataSet::SafeDownCast(this->filter_->GetOutputDataObject(0));
  }

  vtkPolyData* block(unsigned int i)
  {
    return vtkPolyData::SafeDownCast(this->blocks()->GetBlock(i));
  }

  std::string nameOf(unsigned int i)
  {
    return this->blocks()->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
  }

  vtkDataSetAttributes* row()
  {
    this->filter_->Update();
    return vtkTable::SafeDownCast(this->filter_->GetOutputDataObject(1))->GetRowData();
  }

  vtkSmartPointer<vtkPolyData> surface_;
  vtkNew<vtkLumiAccelerationStructure> filter_;
};

} // namespace

TEST_F(Structure, ArraysAndColumnsAreThoseOfTheDataModel)
{
  vtkCellData* cells = this->block(0)->GetCellData();
  EXPECT_EQ(shape(cells, "NodeId"), "id 1");
  EXPECT_EQ(shape(cells, "ParentId"), "id 1");
  EXPECT_EQ(shape(cells, "Depth"), "int 1");
  EXPECT_EQ(shape(cells, "IsLeaf"), "unsigned char 1");
  EXPECT_EQ(shape(cells, "PrimitiveCount"), "id 1");
  EXPECT_EQ(shape(cells, "SurfaceAreaCost"), "double 1");
  EXPECT_EQ(shape(cells, "SplitAxis"), "int 1");
  EXPECT_EQ(shape(cells, "SplitPosition"), "double 1");
  EXPECT_EQ(cells->GetNumberOfArrays(), 8);
  EXPECT_STREQ(cells->GetScalars()->GetName(), "SurfaceAreaCost");

  const std::pair<const char*, const char*> columns[] = { { "Structure", "string 1" },
    { "BvhBuild", "string 1" }, { "Primitives", "id 1" }, { "SkippedNonFinite", "id 1" },
    { "SkippedZeroArea", "id 1" }, { "Nodes", "id 1" }, { "Leaves", "id 1" }, { "Depth", "id 1" },
    { "References", "id 1" }, { "SahCost", "double 1" }, { "Duplication", "double 1" },
    { "MemoryBytes", "id 1" }, { "BuildSeconds", "double 1" }, { "Rays", "id 1" },
    { "RayNodesEntered", "id 1" }, { "RayPrimitivesTested", "id 1" },
    { "ObservedSahCost", "double 1" }, { "EmptyLeaves", "id 1" }, { "EndPointOverlap", "double 1" },
    { "Quadrics", "id 1" }, { "SkippedEmptyQuadrics", "id 1" }, { "Choice", "string 1" },
    { "Origin", "string 1" }, { "SahCostBuilt", "double 1" }, { "UnvisitedLeaves", "id 1" } };
  int i = 0;
  for (const auto& [name, type] : columns)
  {
    EXPECT_STREQ(this->row()->GetArrayName(i++), name);
    EXPECT_EQ(shape(this->row(), name), type);
    EXPECT_EQ(this->row()->GetAbstractArray(name)->GetNumberOfTuples(), 1);
  }
  EXPECT_EQ(this->row()->GetNumberOfArrays(), i);
}

TEST_F(Structure, StatisticsDescribeTheTree)
{
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(this->row()->GetAbstractArray("Structure"))->GetValue(0), "bvh");
  EXPECT_EQ(vtkStringArray::SafeDownCast(this->row()->GetAbstractArray("BvhBuild"))->GetValue(0),
    "binned_sah");
  EXPECT_EQ(value(this->row(), "Primitives", 0), 720);
  EXPECT_EQ(value(this->row(), "References", 0), 720);
  EXPECT_EQ(value(this->row(), "Duplication", 0), 1);
  EXPECT_EQ(value(this->row(), "Nodes", 0), 2 * value(this->row(), "Leaves", 0) - 1);
  EXPECT_EQ(value(this->row(), "Depth", 0), this->blocks()->GetNumberOfBlocks() - 1.0);
  EXPECT_GT(value(this->row(), "MemoryBytes", 0), 0);
  EXPECT_EQ(value(this->row(), "Rays", 0), 0);
  this->filter_->SetStructure(vtkLumiAccelerationStructure::BruteForce);
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(this->row()->GetAbstractArray("BvhBuild"))->GetValue(0), "");
}

TEST_F(Structure, EveryOptionOfTheBuildReachesIt)
{
  this->filter_->SetMaxDepth(3);
  EXPECT_EQ(value(this->row(), "Depth", 0), 3);
  this->filter_->SetStructure(vtkLumiAccelerationStructure::KdTree);
  EXPECT_EQ(value(this->row(), "Depth", 0), 3);
  this->filter_->SetMaxDepth(64);
  const double sah = value(this->row(), "SahCost", 0);
  this->filter_->SetKdBuild(vtkLumiAccelerationStructure::SpatialMedian);
  EXPECT_GT(value(this->row(), "SahCost", 0), sah);

  this->filter_->SetKdBuild(vtkLumiAccelerationStructure::Sah);
  this->filter_->SetLeafSize(1);
  this->filter_->SetRaysData(pointRays(raysAtUnitBall(200)));
  this->filter_->SetQuery(vtkLumiAccelerationStructure::All);
  const double tested = value(this->row(), "RayPrimitivesTested", 0);
  this->filter_->MailboxingOn();
  EXPECT_LT(value(this->row(), "RayPrimitivesTested", 0), tested);
  this->filter_->SetInputConnection(1, nullptr);

  this->filter_->SetStructure(vtkLumiAccelerationStructure::Grid);
  const double automatic = value(this->row(), "Leaves", 0);
  this->filter_->SetGridDensity(10.0);
  EXPECT_GT(value(this->row(), "Leaves", 0), 2 * automatic);
  this->filter_->SetGridResolution(1, 1, 2);
  EXPECT_EQ(value(this->row(), "Leaves", 0), 2);
}

TEST_F(Structure, CellsOfABspTreeAreShownAsThePolyhedraTheyAre)
{
  this->filter_->SetStructure(vtkLumiAccelerationStructure::BspTree);
  this->filter_->SetMaximumLevel(6);
  for (const int shape : { 0, 1 })
  {
    this->filter_->SetRepresentation(shape);
    this->filter_->Update();
    ASSERT_GT(this->blocks()->GetNumberOfBlocks(), 6u);
    auto* root = vtkPolyData::SafeDownCast(this->blocks()->GetBlock(0));
    EXPECT_EQ(root->GetNumberOfCells(), shape == 0 ? 12 : 6);
    auto* deep = vtkPolyData::SafeDownCast(this->blocks()->GetBlock(6));
    ASSERT_GT(deep->GetNumberOfCells(), 0);
    vtkIdType largest = 0;
    for (vtkIdType c = 0; c < deep->GetNumberOfCells(); ++c)
    {
      largest = std::max(largest, deep->GetCell(c)->GetNumberOfPoints());
    }
    EXPECT_TRUE(shape == 0 ? largest == 2 : largest > 4);
    EXPECT_EQ(
      deep->GetCellData()->GetArray("NodeId")->GetNumberOfTuples(), deep->GetNumberOfCells());
  }
}

TEST_F(Structure, OverlapAndObservedCostAreMeasured)
{
  EXPECT_TRUE(std::isnan(value(this->row(), "ObservedSahCost", 0)));
  EXPECT_TRUE(std::isnan(value(this->row(), "EndPointOverlap", 0)));
  this->filter_->MeasureOverlapOn();
  EXPECT_GT(value(this->row(), "EndPointOverlap", 0), 0);
  this->filter_->SetRaysData(pointRays(raysAtUnitBall(2000)));
  const double expected = value(this->row(), "SahCost", 0);
  const double observed = value(this->row(), "ObservedSahCost", 0);
  EXPECT_GT(observed, 0.1 * expected);
  EXPECT_LT(
    observed, expected); // a ray ends at its first hit, of which the heuristic knows nothing
  this->filter_->SetStructure(vtkLumiAccelerationStructure::BruteForce);
  EXPECT_EQ(value(this->row(), "SahCost", 0), 180); // blocks of four
  EXPECT_EQ(value(this->row(), "ObservedSahCost", 0), 180);
  EXPECT_EQ(value(this->row(), "EndPointOverlap", 0), 0);
  EXPECT_EQ(value(this->row(), "UnvisitedLeaves", 0), 0);
}

TEST_F(Structure, DeadCellsAreCountedAndAreThoseWithoutVisits)
{
  EXPECT_EQ(value(this->row(), "UnvisitedLeaves", 0), 0);
  // All rays go through one eighth of the ball.
  std::vector<TestRay> rays;
  for (TestRay ray : raysAtUnitBall(300))
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      ray.origin[k] = std::fabs(ray.origin[k]) + 1.0;
      ray.direction[k] = k == 0 ? -1.0 : 0.0;
    }
    rays.push_back(ray);
    rays.back().origin[1] = rays.back().origin[2] = 0.1 + 0.002 * static_cast<double>(rays.size());
  }
  this->filter_->SetRaysData(pointRays(rays));
  this->filter_->ShowLeavesOn();
  for (const int structure : { vtkLumiAccelerationStructure::Bvh,
         vtkLumiAccelerationStructure::WideBvh, vtkLumiAccelerationStructure::Grid,
         vtkLumiAccelerationStructure::Octree, vtkLumiAccelerationStructure::KdTree })
  {
    this->filter_->SetStructure(structure);
    const double unvisited = value(this->row(), "UnvisitedLeaves", 0);
    EXPECT_GT(unvisited, 0.2 * (value(this->row(), "Leaves", 0))) << structure;
    auto* leaves =
      vtkPolyData::SafeDownCast(this->blocks()->GetBlock(this->blocks()->GetNumberOfBlocks() - 1));
    ASSERT_NE(leaves, nullptr);
    std::set<double> dead;
    for (vtkIdType cell = 0; cell < leaves->GetNumberOfCells(); ++cell)
    {
      if (value(leaves->GetCellData(), "Visits", cell) == 0 &&
        value(leaves->GetCellData(), "PrimitiveCount", cell) > 0)
      {
        dead.insert(value(leaves->GetCellData(), "NodeId", cell));
      }
    }
    EXPECT_EQ(static_cast<double>(dead.size()), unvisited) << structure;
  }
}

TEST_F(Structure, OfAGridThereIsAnImage)
{
  this->filter_->ShowOccupancyOn();
  const unsigned int levels = this->blocks()->GetNumberOfBlocks();
  EXPECT_NE(this->nameOf(levels - 1), "Occupancy");
  this->filter_->SetStructure(vtkLumiAccelerationStructure::Grid);
  this->filter_->SetGridResolution(4, 5, 6);
  this->filter_->SetRaysData(pointRays(raysAtUnitBall(100)));
  ASSERT_EQ(this->blocks()->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(this->nameOf(2), "Occupancy");
  auto* image = vtkImageData::SafeDownCast(this->blocks()->GetBlock(2));
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(image->GetNumberOfCells(), 120);
  vtkCellData* cells = image->GetCellData();
  EXPECT_EQ(shape(cells, "PrimitiveCount"), "id 1");
  double held = 0.0;
  double occupied = 0.0;
  double visits = 0.0;
  for (vtkIdType cell = 0; cell < 120; ++cell)
  {
    held += value(cells, "PrimitiveCount", cell);
    occupied += value(cells, "PrimitiveCount", cell) > 0 ? 1 : 0;
    visits += value(cells, "Visits", cell);
  }
  EXPECT_EQ(held, value(this->row(), "References", 0));
  EXPECT_EQ(occupied, 120 - value(this->row(), "EmptyLeaves", 0));
  EXPECT_GT(visits, 0);
  double bounds[6];
  image->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 1.0, 1e-2);
}

TEST_F(Structure, OptionsOutOfRangeAreOneError)
{
  this->filter_->SetStructure(vtkLumiAccelerationStructure::Grid);
  const auto isOneError = [this](const char* says)
  {
    const Messages messages(this->filter_);
    this->filter_->Update();
    EXPECT_EQ(messages.errors, 1);
    EXPECT_NE(messages.text.find(says), std::string::npos) << messages.text;
    EXPECT_EQ(this->blocks()->GetNumberOfBlocks(), 0u);
    EXPECT_EQ(this->row()->GetNumberOfArrays(), 0);
  };
  for (const double density : { 0.0, -1.0, 1001.0, std::nan("") })
  {
    this->filter_->SetGridDensity(density);
    isOneError("grid density");
  }
  this->filter_->SetGridDensity(0.5);
  this->filter_->SetGridResolution(1 << 21, 1, 1);
  isOneError("grid");
  this->filter_->SetGridResolution(0, 0, -3);
  isOneError("grid");
}

TEST_F(Structure, BlocksAreLevelsAndParentsEncloseChildren)
{
  struct Node
  {
    double bounds[6];
    int depth;
    double primitives;
  };
  this->filter_->SetRepresentation(vtkLumiAccelerationStructure::Cells);
  std::map<vtkIdType, Node> nodes;
  std::map<vtkIdType, double> below;
  double cost = 0.0;
  for (unsigned int level = 0; level < this->blocks()->GetNumberOfBlocks(); ++level)
  {
    EXPECT_EQ(this->nameOf(level), "Level " + std::to_string(level));
    vtkPolyData* block = this->block(level);
    vtkCellData* data = block->GetCellData();
    ASSERT_EQ(block->GetNumberOfCells() % 6, 0);
    for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); cell += 6)
    {
      Node node{ {}, static_cast<int>(value(data, "Depth", cell)),
        value(data, "PrimitiveCount", cell) };
      ASSERT_EQ(node.depth, static_cast<int>(level));
      block->GetCellBounds(cell, node.bounds);
      for (vtkIdType face = 1; face < 6; ++face)
      {
        double bounds[6];
        block->GetCellBounds(cell + face, bounds);
        for (int k = 0; k < 6; ++k)
        {
          node.bounds[k] =
            k % 2 ? std::max(node.bounds[k], bounds[k]) : std::min(node.bounds[k], bounds[k]);
        }
        ASSERT_EQ(value(data, "NodeId", cell + face), value(data, "NodeId", cell));
      }
      const auto id = static_cast<vtkIdType>(value(data, "NodeId", cell));
      const auto parentId = static_cast<vtkIdType>(value(data, "ParentId", cell));
      if (level == 0)
      {
        EXPECT_EQ(id, 0);
        EXPECT_EQ(parentId, -1);
        EXPECT_EQ(node.primitives, 720);
      }
      else
      {
        const Node& parent = nodes.at(parentId);
        ASSERT_LT(parentId, id);
        ASSERT_EQ(parent.depth, node.depth - 1);
        for (int k = 0; k < 6; ++k)
        {
          ASSERT_TRUE(
            k % 2 ? node.bounds[k] <= parent.bounds[k] : node.bounds[k] >= parent.bounds[k]);
        }
        below[parentId] += node.primitives;
      }
      const bool isLeaf = value(data, "IsLeaf", cell) != 0;
      ASSERT_EQ(std::isnan(value(data, "SplitPosition", cell)), value(data, "SplitAxis", cell) < 0);
      ASSERT_TRUE(!isLeaf || value(data, "SplitAxis", cell) == -1);
      cost += value(data, "SurfaceAreaCost", cell);
      nodes[id] = node;
    }
  }
  EXPECT_EQ(nodes.size(), value(this->row(), "Nodes", 0));
  EXPECT_NEAR(cost, value(this->row(), "SahCost", 0), 1e-9 * cost);
  for (const auto& [id, primitives] : below)
  {
    EXPECT_EQ(primitives, nodes.at(id).primitives);
  }
}

TEST_F(Structure, OutlinesAreTwelveEdgesOfTheBox)
{
  vtkPolyData* root = this->block(0);
  EXPECT_EQ(root->GetNumberOfLines(), 12);
  EXPECT_EQ(root->GetNumberOfPoints(), 8);
  double box[6];
  this->surface_->GetBounds(box);
  int perAxis[3] = {};
  for (vtkIdType c = 0; c < 12; ++c)
  {
    double bounds[6];
    root->GetCellBounds(c, bounds);
    int along = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double size = bounds[2 * k + 1] - bounds[2 * k];
      perAxis[k] += size > 0 ? 1 : 0;
      along += size > 0 ? 1 : 0;
      EXPECT_TRUE(size == 0 || std::abs(size - (box[2 * k + 1] - box[2 * k])) < 1e-5);
    }
    EXPECT_EQ(along, 1);
  }
  for (const int edges : perAxis)
  {
    EXPECT_EQ(edges, 4);
  }
}

TEST_F(Structure, FacesOfACellPointOutward)
{
  this->filter_->SetRepresentation(vtkLumiAccelerationStructure::Cells);
  vtkPolyData* root = this->block(0);
  ASSERT_EQ(root->GetNumberOfPolys(), 6);
  for (vtkIdType c = 0; c < 6; ++c)
  {
    vtkNew<vtkIdList> ids;
    root->GetCellPoints(c, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), 4);
    Point p[3];
    for (vtkIdType k = 0; k < 3; ++k)
    {
      root->GetPoint(ids->GetId(k), p[k].data());
    }
    double outward = 0.0; // the root is centred on the origin
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = (k + 1) % 3;
      const std::size_t j = (k + 2) % 3;
      outward += p[0][k] *
        ((p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) - (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]));
    }
    EXPECT_GT(outward, 0.0);
  }
}

TEST_F(Structure, LevelsAreLimited)
{
  this->filter_->SetMinimumLevel(2);
  this->filter_->SetMaximumLevel(3);
  ASSERT_EQ(this->blocks()->GetNumberOfBlocks(), 4u);
  EXPECT_EQ(this->block(0), nullptr);
  EXPECT_EQ(this->block(1), nullptr);
  EXPECT_EQ(this->nameOf(1), "Level 1");
  EXPECT_EQ(this->block(2)->GetNumberOfCells(), 4 * 12);
  EXPECT_EQ(this->nameOf(3), "Level 3");
}

TEST_F(Structure, LeavesComeLastAndOnlyOnRequest)
{
  const unsigned int levels = this->blocks()->GetNumberOfBlocks();
  this->filter_->ShowLeavesOn();
  ASSERT_EQ(this->blocks()->GetNumberOfBlocks(), levels + 1);
  EXPECT_EQ(this->nameOf(levels), "Leaves");
  vtkPolyData* leaves = this->block(levels);
  EXPECT_EQ(leaves->GetNumberOfCells(), 12 * value(this->row(), "Leaves", 0));
  double primitives = 0;
  for (vtkIdType c = 0; c < leaves->GetNumberOfCells(); c += 12)
  {
    EXPECT_EQ(value(leaves->GetCellData(), "IsLeaf", c), 1);
    primitives += value(leaves->GetCellData(), "PrimitiveCount", c);
  }
  EXPECT_EQ(primitives, 720);
  this->filter_->SetMaximumLevel(1);
  EXPECT_EQ(this->nameOf(2), "Leaves");
}

TEST_F(Structure, TooManyNodesAreLeftOutWithOneWarning)
{
  Messages messages(this->filter_);
  this->filter_->SetMaximumNodes(10); // 1 + 2 + 4 and not 8
  this->filter_->ShowLeavesOn();
  EXPECT_EQ(this->blocks()->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(messages.warnings, 1);
  EXPECT_NE(messages.text.find("levels from 3 on"), std::string::npos) << messages.text;
  EXPECT_NE(messages.text.find("leaves"), std::string::npos) << messages.text;
  EXPECT_EQ(messages.errors, 0);
}

TEST_F(Structure, VisitsAreWhatTheRaysEnter)
{
  const auto rays = pointRays(raysAtUnitBall(1000));
  for (const lumitree::Structure s : lumitree::Registry::instance().structures())
  {
    if (s >= lumitree::Structure::Embree)
    {
      continue; // they do not tell what they enter
    }
    SCOPED_TRACE(std::string(lumitree::name(s)));
    for (int query = vtkLumiRayCast::Closest; query <= vtkLumiRayCast::Count; ++query)
    {
      vtkNew<vtkLumiRayCast> cast;
      cast->SetInputData(0, this->surface_);
      cast->SetRaysData(rays);
      cast->SetStructure(static_cast<int>(s));
      cast->SetQuery(query);
      cast->CountTraversalOn();
      cast->Update();
      vtkPointData* perRay = vtkDataSet::SafeDownCast(cast->GetOutputDataObject(1))->GetPointData();
      double entered = 0;
      double tested = 0;
      for (vtkIdType r = 0; r < 1000; ++r)
      {
        entered += value(perRay, "NodesEntered", r) + value(perRay, "CellsStepped", r);
        tested += value(perRay, "PrimitivesTested", r);
      }
      this->filter_->SetStructure(static_cast<int>(s));
      this->filter_->SetRaysData(rays);
      this->filter_->SetQuery(query);
      EXPECT_EQ(value(this->row(), "Rays", 0), 1000);
      EXPECT_EQ(value(this->row(), "RayNodesEntered", 0), entered);
      EXPECT_EQ(value(this->row(), "RayPrimitivesTested", 0), tested);
      double visits = 0;
      for (unsigned int b = 0; b < this->blocks()->GetNumberOfBlocks(); ++b)
      {
        vtkCellData* data = this->block(b)->GetCellData();
        EXPECT_STREQ(data->GetScalars()->GetName(), "Visits");
        EXPECT_EQ(shape(data, "Visits"), "id 1");
        double last = -1; // the cells of a node stand side by side
        for (vtkIdType c = 0; c < this->block(b)->GetNumberOfCells(); ++c)
        {
          const double node = value(data, "NodeId", c);
          visits += node == last ? 0.0 : value(data, "Visits", c);
          last = node;
        }
      }
      if (s != lumitree::Structure::Grid)
      {
        EXPECT_EQ(visits, entered);
      }
    }
  }
}

TEST_F(Structure, EveryStructureHasAHierarchy)
{
  for (const lumitree::Structure s : lumitree::Registry::instance().structures())
  {
    SCOPED_TRACE(std::string(lumitree::name(s)));
    Messages messages(this->filter_);
    this->filter_->SetStructure(static_cast<int>(s));
    EXPECT_GE(this->blocks()->GetNumberOfBlocks(), 1u);
    EXPECT_EQ(value(this->block(0)->GetCellData(), "NodeId", 0), 0);
    EXPECT_EQ(messages.errors, 0) << messages.text;
  }
}

TEST_F(Structure, ThreadsChangeNoBit)
{
  this->filter_->SetRaysData(pointRays(raysAtUnitBall(20000)));
  this->filter_->SetNumberOfThreads(1);
  vtkNew<vtkMultiBlockDataSet> one;
  one->DeepCopy(this->blocks());
  this->filter_->SetNumberOfThreads(2);
  ASSERT_EQ(this->blocks()->GetNumberOfBlocks(), one->GetNumberOfBlocks());
  for (unsigned int b = 0; b < one->GetNumberOfBlocks(); ++b)
  {
    auto* other = vtkPolyData::SafeDownCast(one->GetBlock(b));
    EXPECT_TRUE(sameBits(this->block(b)->GetCellData(), other->GetCellData()));
    EXPECT_TRUE(sameBits(this->block(b)->GetPoints()->GetData(), other->GetPoints()->GetData()));
  }
}

TEST_F(Structure, AnEmptySurfaceHasNothingToDraw)
{
  Messages messages(this->filter_);
  this->filter_->SetInputData(0, vtkNew<vtkPolyData>());
  this->filter_->SetRaysData(pointRays(raysAtUnitBall(10)));
  this->filter_->ShowLeavesOn();
  this->blocks();
  EXPECT_EQ(value(this->row(), "Primitives", 0), 0);
  EXPECT_EQ(this->blocks()->GetNumberOfCells(), 0);
  EXPECT_EQ(messages.errors, 0) << messages.text;
}

TEST_F(Structure, WrongRaysAreOneErrorAndNothingElse)
{
  Messages messages(this->filter_);
  this->filter_->SetRaysData(this->surface_); // neither directions nor lines
  EXPECT_EQ(this->blocks()->GetNumberOfBlocks(), 0u);
  EXPECT_EQ(messages.errors, 1);
  EXPECT_EQ(this->row()->GetNumberOfArrays(), 0);
}

TEST_F(Structure, DegenerateTrianglesAreCounted)
{
  const double nan = std::nan("");
  this->filter_->SetInputData(0,
    triangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 },
      { nan, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  EXPECT_EQ(value(this->row(), "Primitives", 0), 3);
  EXPECT_EQ(value(this->row(), "SkippedZeroArea", 0), 1);
  EXPECT_EQ(value(this->row(), "SkippedNonFinite", 0), 1);
}

TEST_F(Structure, PrintsItself)
{
  std::ostringstream text;
  this->filter_->Print(text);
  for (const char* name :
    { "Representation", "MinimumLevel", "MaximumLevel", "MaximumNodes", "ShowLeaves" })
  {
    EXPECT_NE(text.str().find(std::string(name) + ": "), std::string::npos) << name;
  }
}
