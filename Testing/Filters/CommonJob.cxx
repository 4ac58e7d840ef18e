// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Progress, abort and threads; units of length.
#include "LumiJob.h"
#include "LumiUnits.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"

#include "Accel/Parallel.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

using namespace lumitree;
using namespace lumitree::filters;

namespace
{

/// Hears the progress of an algorithm.
struct Listener
{
  explicit Listener(vtkAlgorithm* algorithm)
  {
    this->command->SetClientData(this);
    this->command->SetCallback(
      [](vtkObject* caller, unsigned long, void* self, void*)
      {
        auto* listener = static_cast<Listener*>(self);
        listener->values.push_back(static_cast<vtkAlgorithm*>(caller)->GetProgress());
        listener->sameThread =
          listener->sameThread && std::this_thread::get_id() == listener->thread;
      });
    algorithm->AddObserver(vtkCommand::ProgressEvent, this->command);
  }
  vtkNew<vtkCallbackCommand> command;
  std::thread::id thread = std::this_thread::get_id();
  std::vector<double> values;
  bool sameThread = true;
};

} // namespace

TEST(Job, ProgressRisesOnTheCallingThread)
{
  vtkNew<vtkSphereSource> algorithm;
  Listener listener(algorithm);
  Job job(algorithm, 0.25, 0.75);
  EXPECT_TRUE(parallelFor(5000, 1, 2, job.control(), [](std::size_t, std::size_t) {}));
  ASSERT_FALSE(listener.values.empty());
  EXPECT_TRUE(std::is_sorted(listener.values.begin(), listener.values.end()));
  EXPECT_GE(listener.values.front(), 0.25);
  EXPECT_LE(listener.values.back(), 0.75);
  EXPECT_LT(listener.values.size(), 1100u) << "not for each of the chunks";
  EXPECT_TRUE(listener.sameThread);
  EXPECT_FALSE(job.aborted());
}

TEST(Job, AbortStopsTheWork)
{
  vtkNew<vtkSphereSource> algorithm;
  Job job(algorithm);
  std::size_t done = 0;
  const bool completed = parallelFor(1000, 1, 1, job.control(),
    [&](std::size_t begin, std::size_t)
    {
      ++done;
      algorithm->SetAbortExecute(begin >= 9);
    });
  EXPECT_FALSE(completed);
  EXPECT_EQ(done, 10u);
  EXPECT_TRUE(job.aborted());
  EXPECT_FALSE(job.report(0.5));
}

TEST(Job, WithoutAnAlgorithm)
{
  Job job(nullptr);
  EXPECT_TRUE(job.report(0.5));
  EXPECT_FALSE(job.aborted());
}

TEST(Job, NumberOfThreads)
{
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(threadsFor(0), 0);
  EXPECT_EQ(threadsFor(3), 3);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  EXPECT_EQ(threadsFor(0), 2);
  EXPECT_EQ(threadsFor(3), 3);
  for (const char* nonsense : { "", "-4", "many" })
  {
    setenv("VTK_SMP_MAX_THREADS", nonsense, 1);
    EXPECT_EQ(threadsFor(0), 0) << nonsense;
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(Units, OfLength)
{
  const double metres[] = { 1.0, 0.001, 0.01, 1000.0, 0.0254, 0.3048 };
  const char* names[] = { "metre", "millimetre", "centimetre", "kilometre", "inch", "foot" };
  for (int unit = 0; unit < lengthUnitCount; ++unit)
  {
    EXPECT_EQ(metresPerUnit(unit), metres[unit]);
    EXPECT_STREQ(lengthUnitName(unit), names[unit]);
  }
  EXPECT_TRUE(std::isnan(metresPerUnit(-1)));
  EXPECT_STREQ(lengthUnitName(6), "unknown");
}

TEST(Units, StandInNameMetadataAndFieldData)
{
  vtkNew<vtkDoubleArray> array;
  setUnit(array, "Irradiance", "W/m^2");
  EXPECT_STREQ(array->GetName(), "Irradiance [W/m^2]");
  EXPECT_STREQ(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()), "W/m^2");

  vtkNew<vtkPolyData> data;
  writeLengthUnit(data, static_cast<int>(LengthUnit::Foot));
  writeLengthUnit(data, static_cast<int>(LengthUnit::Inch));
  auto* name = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("LengthUnit"));
  ASSERT_TRUE(name);
  EXPECT_EQ(name->GetValue(0), "inch");
  EXPECT_EQ(data->GetFieldData()->GetArray("MetresPerUnit")->GetComponent(0, 0), 0.0254);
  EXPECT_EQ(data->GetFieldData()->GetNumberOfArrays(), 2);
}
