// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Surface.h"

#include "Accel/Exact/Predicates.h"
#include "Accel/FloatEnvironment.h"
#include "Accel/Parallel.h"
#include "Accel/Structures/BodyBoxOverlap.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace lumitree
{
namespace
{

template <class T>
PointArray take(std::vector<T> xyz)
{
  if (xyz.size() % 3 != 0)
  {
    throw std::invalid_argument("points need three coordinates each");
  }
  auto owner = std::make_shared<const std::vector<T>>(std::move(xyz));
  PointArray points;
  points.values = ArrayView(owner->data());
  points.count = owner->size() / 3;
  points.owner = owner;
  return points;
}

enum class Kind : char
{
  Hittable,
  NonFinite,
  ZeroArea,
  EmptyQuadric
};

template <std::size_t N>
bool within(const std::array<double, N>& numbers)
{
  return std::all_of(
    numbers.begin(), numbers.end(), [](double x) { return std::fabs(x) <= coordinateLimit; });
}

Kind classify(const std::array<Vec3, 3>& vertices)
{
  if (!within(vertices[0]) || !within(vertices[1]) || !within(vertices[2]))
  {
    return Kind::NonFinite;
  }
  return exact::isZeroArea(vertices) ? Kind::ZeroArea : Kind::Hittable;
}

bool within(const QuadricForm& form)
{
  return within(form.centre) && within(form.coefficients) &&
    within(std::array<double, 1>{ form.residue });
}

bool within(const QuadricCut& cut)
{
  return within(cut.normal) && within(cut.point);
}

bool isEmpty(const Box& box)
{
  return box.lower[0] > box.upper[0] || box.lower[1] > box.upper[1] || box.lower[2] > box.upper[2];
}

Kind classify(const Quadric& q)
{
  if (q.tree)
  {
    q.tree->check();
    if (!q.tree->isSignOfForms())
    {
      throw std::invalid_argument("a quadric's tree must be a sign of forms");
    }
  }
  const bool empty = isEmpty(q.clip);
  if (!empty &&
    !(within(q.form) && within(q.bound) && within(q.cuts[0]) && within(q.cuts[1]) &&
      within(q.clip.lower) && within(q.clip.upper)))
  {
    return Kind::NonFinite;
  }
  const auto& a = q.form.coefficients;
  const bool constant = std::all_of(a.begin(), a.end() - 1, [](double x) { return x == 0.0; });
  return empty || constant || !mayHavePoints(q) ? Kind::EmptyQuadric : Kind::Hittable;
}

Kind classify(const Implicit& implicit)
{
  const Box& box = implicit.clip;
  if (!implicit.function)
  {
    throw std::invalid_argument("an implicit has no function");
  }
  if (isEmpty(box))
  {
    return Kind::EmptyQuadric;
  }
  if (!within(box.lower) || !within(box.upper))
  {
    return Kind::NonFinite;
  }
  if (!(implicit.step >= 0.0 && std::isfinite(implicit.step)) ||
    (implicit.step > 0.0 && implicit.step < 1e-6 * length(box.size())))
  {
    throw std::invalid_argument(
      "the step of an implicit must be 0, or finite and at least 1e-6 of its box's diagonal");
  }
  return mayHavePoints(implicit) ? Kind::Hittable : Kind::EmptyQuadric;
}

void checkSources(const SourceMap& sources, std::size_t primitives)
{
  if (!sources.cells.empty() && sources.cells.size() != primitives)
  {
    throw std::invalid_argument("the source map needs one cell per primitive");
  }
  for (std::size_t i = 1; i < sources.blocks.size(); ++i)
  {
    if (sources.blocks[i].first < sources.blocks[i - 1].first)
    {
      throw std::invalid_argument("the blocks of the source map must ascend");
    }
  }
  if (!sources.blocks.empty() && sources.blocks.front().first != 0)
  {
    throw std::invalid_argument("the first block of the source map must begin at 0");
  }
}

/// Divided by its largest component, so that no square overflows; 0 stays 0.
Vec3 scaledToOne(const Vec3& a)
{
  const double largest = std::max({ std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2]) });
  return largest > 0.0 ? Vec3{ a[0] / largest, a[1] / largest, a[2] / largest } : a;
}

} // namespace

PointArray PointArray::from(std::vector<float> xyz)
{
  return take(std::move(xyz));
}

PointArray PointArray::from(std::vector<double> xyz)
{
  return take(std::move(xyz));
}

Surface::Surface(PointArray points, std::vector<Triangle> triangles, SourceMap sources, int threads)
  : Surface(
      std::move(points), std::move(triangles), std::vector<Quadric>{}, std::move(sources), threads)
{
}

Surface::Surface(PointArray points, std::vector<Triangle> triangles, std::vector<Quadric> quadrics,
  SourceMap sources, int threads)
  : Surface(std::move(points), std::move(triangles), std::move(quadrics), std::vector<Implicit>{},
      std::move(sources), threads)
{
}

Surface::Surface(PointArray points, std::vector<Triangle> triangles, std::vector<Quadric> quadrics,
  std::vector<Implicit> implicits, SourceMap sources, int threads)
  : points_(std::move(points))
  , triangles_(std::move(triangles))
  , quadrics_(std::move(quadrics))
  , implicits_(std::move(implicits))
  , sources_(std::move(sources))
{
  if (this->size() >= noPrimitive)
  {
    throw std::invalid_argument(
      "a surface holds at most 2^32 - 2 triangles, quadrics and implicits");
  }
  checkSources(this->sources_, this->size());

  std::vector<Kind> kinds(this->size());
  parallelFor(kinds.size(), 16384, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      const FloatEnvironment environment;
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto id = static_cast<PrimitiveId>(i);
        if (!this->isTriangle(id))
        {
          kinds[i] =
            this->isImplicit(id) ? classify(this->implicit(id)) : classify(this->quadric(id));
          continue;
        }
        const Triangle& t = this->triangles_[i];
        if (std::max({ t[0], t[1], t[2] }) >= this->points_.count)
        {
          throw std::invalid_argument("a triangle names a point that does not exist");
        }
        kinds[i] = classify(this->vertices(id));
      }
    });

  const FloatEnvironment environment;
  this->hittable_.reserve(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    const auto id = static_cast<PrimitiveId>(i);
    switch (kinds[i])
    {
      case Kind::Hittable:
        this->hittable_.push_back(id);
        this->bounds_.extend(this->box(id));
        this->sampled_ += this->isImplicit(id) && !this->implicit(id).function->isBounded() ? 1 : 0;
        break;
      case Kind::NonFinite:
        ++this->nonFinite_;
        break;
      case Kind::ZeroArea:
        ++this->zeroArea_;
        break;
      case Kind::EmptyQuadric:
        ++this->emptyQuadrics_;
        break;
    }
  }
}

Vec3 Surface::normal(PrimitiveId i, const Vec3& point) const
{
  Vec3 n;
  if (this->isImplicit(i))
  {
    n = scaledToOne(this->implicit(i).function->gradient(point));
  }
  else if (this->isQuadric(i))
  {
    n = scaledToOne(gradientAt(this->quadric(i).form, point));
  }
  else
  {
    const auto v = this->vertices(i);
    n = cross(scaledToOne(v[1] - v[0]), scaledToOne(v[2] - v[0]));
  }
  const double norm = length(n);
  return std::isfinite(norm) && norm > 0.0 ? Vec3{ n[0] / norm, n[1] / norm, n[2] / norm }
                                           : Vec3{ 0.0, 0.0, 0.0 };
}

SourceCell Surface::source(PrimitiveId i) const
{
  SourceCell source;
  source.cell =
    this->sources_.cells.empty() ? static_cast<std::int64_t>(i) : this->sources_.cells[i];
  if (!this->sources_.blocks.empty())
  {
    const auto after = std::upper_bound(this->sources_.blocks.begin(), this->sources_.blocks.end(),
      i, [](PrimitiveId id, const SourceBlock& block) { return id < block.first; });
    source.composite = (after - 1)->composite;
  }
  return source;
}

std::size_t Surface::memory() const
{
  const std::size_t scalar =
    this->scalar() == ArrayView::Scalar::Float ? sizeof(float) : sizeof(double);
  return 3 * scalar * this->points_.count + this->triangles_.capacity() * sizeof(Triangle) +
    this->quadrics_.capacity() * sizeof(Quadric) + this->implicits_.capacity() * sizeof(Implicit) +
    this->sources_.cells.capacity() * sizeof(std::int64_t) +
    this->hittable_.capacity() * sizeof(PrimitiveId);
}

void refuseBodies(const Surface& surface, const std::string& reference)
{
  if (surface.bodyCount() > 0)
  {
    throw std::invalid_argument(reference + " knows triangles only, the surface has " +
      (surface.quadricCount() > 0 ? "quadrics: " + std::to_string(surface.quadricCount())
                                  : "implicits: " + std::to_string(surface.implicitCount())));
  }
}

} // namespace lumitree
