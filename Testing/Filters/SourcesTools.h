// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_SourcesTools_h
#define Lumitree_Testing_SourcesTools_h

#include "Accel/Vec3.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <string>

namespace sources
{

using namespace lumitree;

/// Counts what an algorithm reports instead of printing it.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }

  /// The executive's own message, that a request failed, is kept quiet and not counted.
  void watch(vtkAlgorithm* algorithm)
  {
    this->watched_ = algorithm;
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->AddObserver(vtkCommand::WarningEvent, this);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
  }

  void Execute(vtkObject* caller, unsigned long event, void* text) override
  {
    if (caller != this->watched_)
    {
      return;
    }
    ++(event == vtkCommand::ErrorEvent ? this->errors : this->warnings);
    this->last = static_cast<const char*>(text);
  }

  int errors = 0;
  int warnings = 0;
  std::string last;

private:
  vtkObject* watched_ = nullptr;
};

inline Vec3 tuple(vtkDataArray* array, vtkIdType i)
{
  Vec3 v;
  array->GetTuple(i, v.data());
  return v;
}

inline vtkDataArray* directions(vtkDataSet* rays)
{
  return rays->GetPointData()->GetArray("RayDirection");
}

inline Vec3 point(vtkDataSet* rays, vtkIdType i)
{
  Vec3 v;
  rays->GetPoint(i, v.data());
  return v;
}

inline void expectNear(const Vec3& a, const Vec3& b, double tolerance = 1e-14)
{
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(a[k], b[k], tolerance) << "component " << k;
  }
}

/// A point and a vertex cell per ray, and a unit direction in a double array, as the data model
/// says.
inline void expectRays(vtkPolyData* rays, vtkIdType count)
{
  ASSERT_EQ(rays->GetNumberOfPoints(), count);
  ASSERT_EQ(rays->GetNumberOfVerts(), count);
  ASSERT_EQ(rays->GetNumberOfCells(), count);
  auto* array = vtkDoubleArray::SafeDownCast(directions(rays));
  ASSERT_TRUE(array);
  ASSERT_EQ(array->GetNumberOfComponents(), 3);
  ASSERT_EQ(array->GetNumberOfTuples(), count);
  EXPECT_EQ(rays->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < count; ++i)
  {
    ASSERT_NEAR(length(tuple(array, i)), 1.0, 1e-14) << i;
    ASSERT_EQ(rays->GetCellType(i), VTK_VERTEX);
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    rays->GetCellPoints(i, size, ids);
    ASSERT_EQ(ids[0], i);
  }
}

}

#endif
