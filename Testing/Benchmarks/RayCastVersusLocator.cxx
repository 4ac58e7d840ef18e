// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLumiRayCast on one thread against vtkStaticCellLocator::IntersectWithLine, on the same rays:
//   RayCastVersusLocator [surface.vtp [rays]]
// Without a surface, a bumpy torus of 70,000 triangles; 300,000 rays of each kind. Both structures
// are built before the clock starts. The filter's time is that of the whole Update, with all output
// arrays; the locator's is that of its calls alone. Processor time, best of three.
#include "vtkLumiRayCast.h"

#include "Data/Scenes.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

namespace
{

using Point = std::array<double, 3>;

struct Rays
{
  const char* name;
  std::vector<Point> origins;
  std::vector<Point> ends; ///< beyond the surface
};

vtkSmartPointer<vtkPolyData> bumpyTorus()
{
  const lumitree::data::Mesh mesh = lumitree::data::torus(280, 125, 0.3);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
  {
    points->InsertNextPoint(&mesh.points[i]);
  }
  vtkNew<vtkCellArray> quads;
  for (std::size_t i = 0; i < mesh.connectivity.size(); i += 4)
  {
    const vtkIdType ids[4] = { mesh.connectivity[i], mesh.connectivity[i + 1],
      mesh.connectivity[i + 2], mesh.connectivity[i + 3] };
    quads->InsertNextCell(4, ids);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(quads);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->Update();
  return triangles->GetOutput();
}

/// Pixel by pixel from one eye, at twice the diagonal.
Rays cameraRays(vtkPolyData* surface, int count)
{
  Rays rays{ "camera", {}, {} };
  double centre[3];
  surface->GetCenter(centre);
  const double size = surface->GetLength();
  const int width = static_cast<int>(std::sqrt(count));
  const double forward[3] = { -0.48, -0.6, -0.64 };
  const double right[3] = { 0.78086881, -0.62469505, 0 };
  const double up[3] = { -0.39980483, -0.49975604, 0.76837406 };
  for (int i = 0; i < count; ++i)
  {
    const double x = (i % width + 0.5) / width - 0.5;
    const double y = (i / width + 0.5) / (count / width) - 0.5;
    Point eye;
    Point end;
    for (std::size_t k = 0; k < 3; ++k)
    {
      eye[k] = centre[k] - 2 * size * forward[k];
      end[k] = eye[k] + 4 * (size * forward[k] + 0.4 * size * (x * right[k] + y * up[k]));
    }
    rays.origins.push_back(eye);
    rays.ends.push_back(end);
  }
  return rays;
}

/// Between random points of a sphere about the surface.
Rays incoherentRays(vtkPolyData* surface, int count)
{
  Rays rays{ "incoherent", {}, {} };
  double centre[3];
  surface->GetCenter(centre);
  const double radius = 0.5 * surface->GetLength();
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto onSphere = [&]
  {
    const Point p = { normal(random), normal(random), normal(random) };
    const double scale = radius / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    return Point{ centre[0] + scale * p[0], centre[1] + scale * p[1], centre[2] + scale * p[2] };
  };
  for (int i = 0; i < count; ++i)
  {
    rays.origins.push_back(onSphere());
    rays.ends.push_back(onSphere());
  }
  return rays;
}

vtkSmartPointer<vtkPolyData> dataset(const Rays& rays)
{
  const auto count = static_cast<vtkIdType>(rays.origins.size());
  vtkNew<vtkDoubleArray> origins;
  vtkNew<vtkDoubleArray> directions;
  vtkNew<vtkDoubleArray> limits;
  limits->SetName("RayTMax");
  directions->SetName("RayDirection");
  origins->SetNumberOfComponents(3);
  directions->SetNumberOfComponents(3);
  origins->SetNumberOfTuples(count);
  directions->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Point& a = rays.origins[static_cast<std::size_t>(i)];
    const Point& b = rays.ends[static_cast<std::size_t>(i)];
    origins->SetTypedTuple(i, a.data());
    const Point d = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    directions->SetTypedTuple(i, d.data());
    limits->InsertNextValue(1.0);
  }
  vtkNew<vtkPoints> points;
  points->SetData(origins);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->GetPointData()->AddArray(directions);
  result->GetPointData()->AddArray(limits);
  return result;
}

template <class Work>
double bestOfThree(const Work& work)
{
  double best = 1e300;
  for (int i = 0; i < 3; ++i)
  {
    const std::clock_t start = std::clock();
    work();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

struct Measured
{
  double seconds = 0;
  long long hits = 0;
};

/// Closest: the first hit of each ray (9 arguments). All: every hit (6 arguments).
Measured locator(vtkStaticCellLocator* cells, const Rays& rays, bool all)
{
  Measured measured;
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdList> ids;
  measured.seconds = bestOfThree(
    [&]
    {
      measured.hits = 0;
      for (std::size_t i = 0; i < rays.origins.size(); ++i)
      {
        const double* a = rays.origins[i].data();
        const double* b = rays.ends[i].data();
        if (all)
        {
          cells->IntersectWithLine(a, b, 0.0, points, ids, cell);
          measured.hits += ids->GetNumberOfIds();
        }
        else
        {
          double t;
          double x[3];
          double uv[3];
          int sub;
          vtkIdType id;
          measured.hits += cells->IntersectWithLine(a, b, 0.0, t, x, uv, sub, id, cell) ? 1 : 0;
        }
      }
    });
  return measured;
}

Measured filter(vtkPolyData* surface, const Rays& rays, bool all)
{
  vtkNew<vtkLumiRayCast> cast;
  cast->SetInputData(0, surface);
  cast->SetRaysData(dataset(Rays{ "", { rays.origins[0] }, { rays.ends[0] } }));
  cast->SetQuery(all ? vtkLumiRayCast::All : vtkLumiRayCast::Closest);
  cast->SetNumberOfThreads(1);
  cast->Update(); // builds the tree
  cast->SetRaysData(dataset(rays));
  Measured measured;
  measured.seconds = bestOfThree(
    [&]
    {
      cast->Modified();
      cast->Update();
    });
  measured.hits = cast->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT);
  return measured;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkSmartPointer<vtkPolyData> surface;
  if (argc > 1)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(argv[1]);
    reader->Update();
    surface = reader->GetOutput();
  }
  else
  {
    surface = bumpyTorus();
  }
  const int count = argc > 2 ? std::atoi(argv[2]) : 300000;

  vtkNew<vtkStaticCellLocator> cells;
  cells->SetDataSet(surface);
  cells->BuildLocator();
  std::printf("%lld cells, %d rays of each kind, one thread\n",
    static_cast<long long>(surface->GetNumberOfCells()), count);
  std::printf("%-11s %-8s %12s %12s %8s %12s %12s\n", "rays", "query", "locator [s]",
    "Lumitree [s]", "ratio", "its hits", "our hits");
  for (const Rays& rays : { cameraRays(surface, count), incoherentRays(surface, count) })
  {
    for (const bool all : { false, true })
    {
      const Measured theirs = locator(cells, rays, all);
      const Measured ours = filter(surface, rays, all);
      std::printf("%-11s %-8s %12.4f %12.4f %8.1f %12lld %12lld\n", rays.name,
        all ? "all" : "closest", theirs.seconds, ours.seconds, theirs.seconds / ours.seconds,
        theirs.hits, ours.hits);
    }
  }
  return 0;
}
