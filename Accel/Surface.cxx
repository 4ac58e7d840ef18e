// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Surface.h"

#include "Accel/Exact/Predicates.h"
#include "Accel/FloatEnvironment.h"
#include "Accel/Parallel.h"

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
  ZeroArea
};

Kind classify(const std::array<Vec3, 3>& vertices)
{
  for (const Vec3& p : vertices)
  {
    for (const double x : p)
    {
      if (!(std::fabs(x) <= coordinateLimit))
      {
        return Kind::NonFinite;
      }
    }
  }
  return exact::isZeroArea(vertices) ? Kind::ZeroArea : Kind::Hittable;
}

void checkSources(const SourceMap& sources, std::size_t triangles)
{
  if (!sources.cells.empty() && sources.cells.size() != triangles)
  {
    throw std::invalid_argument("the source map needs one cell per triangle");
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
  : points_(std::move(points))
  , triangles_(std::move(triangles))
  , sources_(std::move(sources))
{
  if (this->triangles_.size() >= noPrimitive)
  {
    throw std::invalid_argument("a surface holds at most 2^32 - 2 triangles");
  }
  checkSources(this->sources_, this->triangles_.size());

  std::vector<Kind> kinds(this->triangles_.size());
  parallelFor(this->triangles_.size(), 16384, threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Triangle& t = this->triangles_[i];
        if (std::max({ t[0], t[1], t[2] }) >= this->points_.count)
        {
          throw std::invalid_argument("a triangle names a point that does not exist");
        }
        kinds[i] = classify(this->vertices(static_cast<PrimitiveId>(i)));
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
        break;
      case Kind::NonFinite:
        ++this->nonFinite_;
        break;
      case Kind::ZeroArea:
        ++this->zeroArea_;
        break;
    }
  }
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
    this->sources_.cells.capacity() * sizeof(std::int64_t) +
    this->hittable_.capacity() * sizeof(PrimitiveId);
}

} // namespace lumitree
