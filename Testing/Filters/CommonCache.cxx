// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One surface and one tree for all who ask, as long as someone has them, and never a stale one.
#include "CommonFixtures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <thread>

using namespace lumitree;
using namespace lumitree::filters;

namespace
{

std::shared_ptr<const Tree> treeOf(vtkDataObject* data, const BuildOptions& options = {})
{
  Reporter reporter;
  auto tree = treeFor(data, options, nullptr, reporter.algorithm());
  EXPECT_EQ(reporter.errors, 0) << reporter.text;
  EXPECT_TRUE(tree);
  return tree;
}

/// Whether both come from one build.
bool same(const std::shared_ptr<const Tree>& a, const std::shared_ptr<const Tree>& b)
{
  return a->accelerator == b->accelerator && a->input->surface == b->input->surface;
}

BuildOptions bruteForce()
{
  BuildOptions options;
  options.structure = Structure::BruteForce;
  return options;
}

} // namespace

TEST(Cache, ThreeUsersHoldOneTree)
{
  const auto data = squares(3);
  const std::uint64_t before = treeBuilds();
  const auto first = treeOf(data);
  const auto second = treeOf(data);
  const auto third = treeOf(data);
  EXPECT_EQ(treeBuilds(), before + 1);
  EXPECT_TRUE(same(first, second));
  EXPECT_TRUE(same(first, third));
}

TEST(Cache, OtherOptionsShareTheSurface)
{
  const auto data = squares(12); // more than Auto leaves to brute force
  const std::uint64_t before = treeBuilds();
  const auto tree = treeOf(data);
  const auto brute = treeOf(data, bruteForce());
  EXPECT_EQ(treeBuilds(), before + 2);
  EXPECT_EQ(tree->input->surface, brute->input->surface);
  EXPECT_NE(tree->accelerator, brute->accelerator);
  EXPECT_TRUE(same(brute, treeOf(data, bruteForce())));
}

TEST(Cache, WhatAutoChoseIsSharedWithWhoAsksForIt)
{
  const auto data = squares(3);
  const auto chosen = treeOf(data);
  EXPECT_TRUE(same(chosen, treeOf(data, chosen->accelerator->options())));
}

TEST(Cache, EndsWithTheLastUser)
{
  const auto data = squares(3);
  const std::uint64_t before = treeBuilds();
  std::weak_ptr<const Accelerator> tree;
  {
    const auto user = treeOf(data);
    tree = user->accelerator;
    EXPECT_FALSE(tree.expired());
  }
  EXPECT_TRUE(tree.expired());
  (void)treeOf(data);
  EXPECT_EQ(treeBuilds(), before + 2);
}

TEST(Cache, CopiesThatShareGeometryShareTheTree)
{
  const auto data = squares(3);
  const auto tree = treeOf(data);
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(data);
  EXPECT_TRUE(same(tree, treeOf(copy)));
  vtkNew<vtkPolyData> structure;
  structure->CopyStructure(data);
  EXPECT_TRUE(same(tree, treeOf(structure)));
  vtkNew<vtkPolyData> deep;
  deep->DeepCopy(data);
  EXPECT_FALSE(same(tree, treeOf(deep)));
}

TEST(Cache, NewPointDataBuildsNothingAndIsSeen)
{
  const auto data = squares(2);
  const auto before = treeOf(data);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Temperature");
  values->SetNumberOfValues(data->GetNumberOfPoints());
  data->GetPointData()->SetScalars(values);
  data->Modified();
  const auto after = treeOf(data);
  EXPECT_TRUE(same(before, after));
  EXPECT_FALSE(before->input->leaves[0].data->GetPointData()->HasArray("Temperature"))
    << "a user keeps what it was given";
  EXPECT_TRUE(after->input->leaves[0].data->GetPointData()->HasArray("Temperature"));
}

TEST(Cache, MeshModifiedInPlaceIsRebuilt)
{
  const auto data = squares(2);
  const auto original = treeOf(data);

  data->GetPoints()->SetPoint(0, 0.0, 0.0, 1.0);
  data->GetPoints()->Modified();
  const auto moved = treeOf(data);
  EXPECT_FALSE(same(original, moved));

  data->GetPoints()->GetData()->Modified(); // only the array, as numpy interfaces do
  const auto touched = treeOf(data);
  EXPECT_FALSE(same(moved, touched));

  data->GetPolys()->InsertNextCell({ 0, 1, 4 });
  const auto grown = treeOf(data); // forgot to call Modified; the size tells
  EXPECT_FALSE(same(touched, grown));
  EXPECT_EQ(grown->input->surface->size(), 9u);

  data->GetPolys()->ReplaceCellAtId(4, { 0, 1, 3 });
  data->GetPolys()->Modified();
  const auto rewired = treeOf(data);
  EXPECT_FALSE(same(grown, rewired));
}

TEST(Cache, GhostsChangedAreRebuilt)
{
  const auto data = squares(1);
  const auto original = treeOf(data);
  setGhosts(data, { 32 });
  const auto hidden = treeOf(data);
  EXPECT_EQ(hidden->input->surface->size(), 0u);
  data->GetCellGhostArray()->SetValue(0, 0);
  data->GetCellGhostArray()->Modified();
  const auto shown = treeOf(data);
  EXPECT_EQ(shown->input->surface->size(), 2u);
}

TEST(Cache, MeshesSwappedUnderAFilterAreSeen)
{
  // The mesh that comes second is the older one: "newer than" would not notice.
  const auto older = squares(1);
  const auto newer = squares(2);
  auto held = treeOf(newer);
  EXPECT_EQ(held->input->surface->size(), 8u);
  vtkNew<vtkPolyData> port;
  port->ShallowCopy(newer);
  EXPECT_TRUE(same(held, treeOf(port)));
  port->ShallowCopy(older);
  held = treeOf(port);
  EXPECT_EQ(held->input->surface->size(), 2u);
}

TEST(Cache, BlocksOfACompositeCount)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, squares(1, 0.0));
  blocks->SetBlock(1, squares(1, 1.0));
  const auto original = treeOf(blocks);
  vtkNew<vtkMultiBlockDataSet> copy;
  copy->ShallowCopy(blocks);
  EXPECT_TRUE(same(original, treeOf(copy)));
  copy->SetBlock(2, blocks->GetBlock(0));
  copy->SetBlock(0, nullptr);
  const auto moved = treeOf(copy);
  EXPECT_FALSE(same(original, moved));
  EXPECT_EQ(moved->input->surface->source(0).composite, 2);
}

TEST(Cache, OtherDatasetsAreKnownByTheirTime)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  const auto original = treeOf(image);
  EXPECT_TRUE(same(original, treeOf(image)));
  image->SetSpacing(2, 2, 2);
  const auto grown = treeOf(image);
  EXPECT_FALSE(same(original, grown));
  EXPECT_EQ(grown->accelerator->surface().bounds().upper[0], 2.0);
}

TEST(Cache, UsersOnManyThreadsGetOneTree)
{
  const auto data = squares(60);
  std::vector<std::shared_ptr<const Tree>> trees(4);
  std::vector<std::thread> threads;
  for (auto& tree : trees)
  {
    threads.emplace_back([&] { tree = treeFor(data, {}, nullptr, nullptr); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& tree : trees)
  {
    EXPECT_TRUE(same(trees[0], tree));
  }
}

TEST(Cache, WhatCannotBeBuiltIsOneError)
{
  const auto data = squares(1);
  Reporter reporter;
  BuildOptions options;
  options.leafSize = 0;
  EXPECT_FALSE(treeFor(data, options, nullptr, reporter.algorithm()));
  EXPECT_EQ(reporter.errors, 1);
  EXPECT_NE(reporter.text.find("cannot be built"), std::string::npos) << reporter.text;
}
