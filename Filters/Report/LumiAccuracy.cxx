// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiAccuracy.h"

#include "LumiAccuracyRays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include "Accel/Accelerator.h"
#include "Accel/Registry.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace lumitree::filters
{

namespace
{

/// Of this thread, where the system tells it: other programs do not count.
double processorSeconds()
{
#if defined(CLOCK_THREAD_CPUTIME_ID)
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
#else
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
#endif
}

struct Contender
{
  std::string backEnd;
  std::string setting;
  std::string precision;
  std::function<void(const RayBatch&, Hit*)> closest;
  std::size_t mostRays = std::numeric_limits<std::size_t>::max(); ///< no more are asked
};

/// Brute force is asked so many rays that it tests this many triangles, and 100 at least.
constexpr std::size_t bruteForceTests = 20000000;

void addStructure(std::vector<Contender>& all, const std::shared_ptr<const Surface>& surface,
  const BuildOptions& options, const std::string& setting)
{
  const auto accelerator = build(surface, options);
  for (const Precision precision : { Precision::Fast, Precision::Watertight, Precision::Exact })
  {
    if (accelerator->supports(precision))
    {
      QueryOptions query;
      query.precision = precision;
      query.threads = 1;
      all.push_back({ std::string(name(options.structure)), setting, std::string(name(precision)),
        [=](const RayBatch& rays, Hit* hits) { accelerator->closest(rays, hits, query); } });
      if (options.structure == Structure::BruteForce)
      {
        all.back().mostRays =
          std::max<std::size_t>(100, bruteForceTests / std::max<std::size_t>(1, surface->size()));
      }
    }
  }
}

void addRegistered(std::vector<Contender>& all, const std::shared_ptr<const Surface>& surface,
  const AccuracyOptions& settings)
{
  for (const Structure structure : Registry::instance().structures())
  {
    if (structure == Structure::BruteForce && surface->size() > settings.bruteForceLimit)
    {
      continue;
    }
    BuildOptions options;
    options.structure = structure;
    if (structure != Structure::Embree)
    {
      addStructure(all, surface, options, "");
      continue;
    }
    for (const bool robust : { true, false })
    {
      options.embreeRobust = robust;
      addStructure(all, surface, options, robust ? "robust" : "not robust");
    }
  }
}

/// The triangles that can be hit, as VTK has them, and which they are.
struct VtkTriangles
{
  std::vector<PrimitiveId> ids;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkStaticCellLocator> locator;

  explicit VtkTriangles(const Surface& surface)
    : ids(hittableTriangles(surface))
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(surface.scalar() == ArrayView::Scalar::Float ? VTK_FLOAT : VTK_DOUBLE);
    for (std::size_t i = 0; i < surface.pointCount(); ++i)
    {
      points->InsertNextPoint(surface.point(i).data());
    }
    vtkNew<vtkCellArray> cells;
    for (const PrimitiveId id : this->ids)
    {
      const Triangle& t = surface.triangle(id);
      cells->InsertNextCell({ static_cast<vtkIdType>(t[0]), static_cast<vtkIdType>(t[1]),
        static_cast<vtkIdType>(t[2]) });
    }
    this->data->SetPoints(points);
    this->data->SetPolys(cells);
    this->locator->SetDataSet(this->data);
    this->locator->BuildLocator();
  }

  /// It takes a segment of two points: the ray's, as long as the scene asks for.
  [[nodiscard]] Hit closest(const Surface& surface, const Vec3& o, const Vec3& d, double tolerance)
  {
    const Box box = surface.bounds();
    const double reach =
      2.0 * (length(0.5 * (box.lower + box.upper) - o) + length(box.size())) / length(d);
    const Vec3 end = o + reach * d;
    double t = 0.0;
    double x[3];
    double parametric[3];
    int subId = 0;
    vtkIdType cell = -1;
    Hit hit;
    if (this->locator->IntersectWithLine(
          o.data(), end.data(), tolerance, t, x, parametric, subId, cell) != 0 &&
      cell >= 0)
    {
      hit.t = t * reach;
      hit.primitive = this->ids[static_cast<std::size_t>(cell)];
    }
    return hit;
  }
};

void addVtk(std::vector<Contender>& all, const std::shared_ptr<const Surface>& surface)
{
  if (hittableTriangles(*surface).empty())
  {
    return;
  }
  const auto triangles = std::make_shared<VtkTriangles>(*surface);
  for (const double tolerance : { 0.0, 1e-6 })
  {
    all.push_back({ "vtkStaticCellLocator", tolerance > 0.0 ? "tolerance 1e-6" : "tolerance 0", "",
      [=](const RayBatch& rays, Hit* hits)
      {
        for (std::size_t i = 0; i < rays.size; ++i)
        {
          const Ray ray = rays[i];
          hits[i] = triangles->closest(*surface, ray.origin, ray.direction, tolerance);
        }
      } });
  }
}

/// Compares hits with the exact ones, of which several may be at the least t.
void compare(const std::vector<Hit>& hits, const AllHits& truth, AccuracyRow& row)
{
  std::vector<double> errors;
  for (std::size_t i = 0; i < row.rays; ++i)
  {
    const auto first = truth.hits.begin() + static_cast<std::ptrdiff_t>(truth.offsets[i]);
    const auto last = truth.hits.begin() + static_cast<std::ptrdiff_t>(truth.offsets[i + 1]);
    const bool found = hits[i].primitive != noPrimitive;
    if (first == last || !found)
    {
      row.leaks += !found && first != last ? 1 : 0;
      row.phantoms += found && first == last ? 1 : 0;
      continue;
    }
    const double off = std::fabs(hits[i].t - first->t);
    const double error = first->t != 0.0 ? off / std::fabs(first->t) : off;
    if (std::any_of(
          first, last, [&](const Hit& tie) { return tie.primitive == hits[i].primitive; }))
    {
      errors.push_back(error);
    }
    else
    {
      ++row.otherPrimitives;
      row.farPrimitives += error > 1e-4 ? 1 : 0;
    }
  }
  if (!errors.empty())
  {
    std::sort(errors.begin(), errors.end());
    row.medianTError = errors[errors.size() / 2];
    row.maxTError = errors.back();
  }
}

} // namespace

std::vector<AccuracyRow> measureAccuracy(std::shared_ptr<const Surface> surface,
  const AccuracyOptions& options, const std::function<bool(double)>& goOn)
{
  std::vector<Contender> contenders;
  addRegistered(contenders, surface, options);
  addVtk(contenders, surface);
  BuildOptions judge;
  judge.structure = Structure::WideBvh;
  const auto exact = build(surface, judge);
  QueryOptions query;
  query.precision = Precision::Exact;
  query.roundedT = true;

  const std::vector<RaySet> sets = accuracyRays(*surface, options.rays, options.seed);
  std::vector<AccuracyRow> rows;
  for (const RaySet& rays : sets)
  {
    AllHits truth;
    exact->ties(rays.batch(), truth, query);
    for (const Contender& c : contenders)
    {
      AccuracyRow row;
      row.backEnd = c.backEnd;
      row.setting = c.setting;
      row.precision = c.precision;
      row.rayKind = rays.kind;
      row.rays = std::min(rays.size(), c.mostRays);
      RayBatch asked = rays.batch();
      asked.size = row.rays;
      std::vector<Hit> hits(rays.size());
      double best = std::numeric_limits<double>::infinity();
      for (int r = 0; r < options.repeats; ++r)
      {
        const double start = processorSeconds();
        c.closest(asked, hits.data());
        best = std::min(best, processorSeconds() - start);
      }
      row.nanosecondsPerRay = 1e9 * best / static_cast<double>(row.rays);
      compare(hits, truth, row);
      rows.push_back(std::move(row));
      if (!goOn(static_cast<double>(rows.size()) /
            static_cast<double>(sets.size() * contenders.size())))
      {
        return {};
      }
    }
  }
  return rows;
}

} // namespace lumitree::filters
