// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The chart of speed against accuracy: what it holds, promises, bad input, stopping.
#include "RaysFixtures.h"

#include "vtkLumiAccuracyChart.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <set>

using namespace lumitree::testing;

namespace
{

TEST(AccuracyChart, HasARowForEachBackEndAndKind)
{
  vtkNew<vtkLumiAccuracyChart> chart;
  chart->SetInputData(polyData(lumitree::data::sphere(3)));
  chart->SetNumberOfRays(40);
  chart->SetRepeats(1);
  chart->Update();
  vtkTable* const table = chart->GetOutput();
  std::set<std::string> kinds;
  std::set<std::string> backEnds;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const auto value = [&](const char* column) { return table->GetValueByName(i, column); };
    kinds.insert(value("RayKind").ToString());
    backEnds.insert(value("BackEnd").ToString());
    EXPECT_EQ(value("Rays").ToLongLong(), 40);
    EXPECT_GT(value("NanosecondsPerRay").ToDouble(), 0.0);
    if (value("Precision").ToString() == "exact")
    {
      for (const char* column : { "Leaks", "Phantoms", "OtherPrimitives", "FarPrimitives" })
      {
        EXPECT_EQ(value(column).ToLongLong(), 0) << value("BackEnd").ToString() << " " << column;
      }
      EXPECT_LE(value("MaxTError").ToDouble(), 0x1p-23);
    }
    if (value("Precision").ToString() == "watertight")
    {
      EXPECT_EQ(value("Leaks").ToLongLong(), 0);
    }
  }
  EXPECT_EQ(kinds.size(), 5u);
  EXPECT_EQ(backEnds.count("vtkStaticCellLocator"), 1u);
  EXPECT_EQ(backEnds.count("brute_force"), 1u);
  EXPECT_EQ(backEnds.count("wide_bvh"), 1u);
  EXPECT_EQ(table->GetNumberOfRows() % 5, 0);

  chart->SetBruteForceLimit(10);
  chart->Update();
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    EXPECT_NE(table->GetValueByName(i, "BackEnd").ToString(), "brute_force");
  }
}

TEST(AccuracyChart, WithoutASurfaceThereIsNothingToMeasure)
{
  vtkNew<vtkLumiAccuracyChart> chart;
  chart->SetInputData(vtkNew<vtkPolyData>());
  chart->Update();
  EXPECT_EQ(chart->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_EQ(chart->GetOutput()->GetNumberOfColumns(), 12);
}

TEST(AccuracyChart, StopsWhenTold)
{
  vtkNew<vtkLumiAccuracyChart> chart;
  chart->SetInputData(polyData(lumitree::data::sphere(3)));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  chart->AddObserver(vtkCommand::ProgressEvent, stop);
  chart->Update();
  EXPECT_EQ(chart->GetOutput()->GetNumberOfRows(), 0);
}

} // namespace
