// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause

// A sphere of radius 1 and one ray towards it from outside: one hit, at the near side.

#include "vtkLumiRayCast.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);

  vtkNew<vtkPoints> origins;
  origins->InsertNextPoint(0.1, 0.2, -5.0);
  vtkNew<vtkDoubleArray> directions;
  directions->SetName("RayDirection");
  directions->SetNumberOfComponents(3);
  directions->InsertNextTuple3(0.0, 0.0, 1.0);
  vtkNew<vtkPolyData> rays;
  rays->SetPoints(origins);
  rays->GetPointData()->AddArray(directions);

  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputConnection(0, sphere->GetOutputPort());
  cast->SetInputData(1, rays);
  cast->Update();

  vtkPolyData* hits = vtkPolyData::SafeDownCast(cast->GetOutputDataObject(0));
  const vtkIdType count = hits ? hits->GetNumberOfPoints() : -1;
  std::cout << count << " hit\n";
  if (count != 1)
  {
    return 1;
  }
  const double z = hits->GetPoint(0)[2];
  std::cout << "at z = " << z << '\n';
  return z < -0.9 && z > -1.0 ? 0 : 1;
}
