// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiSurfaceCheck.h"

#include "LumiHalfEdges.h"
#include "LumiSurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace lumitree::filters
{
namespace
{

/// The first point with the same coordinates, of each point.
std::vector<std::uint32_t> mergedPoints(const Surface& surface, bool merge)
{
  std::vector<std::uint32_t> same(surface.pointCount());
  std::iota(same.begin(), same.end(), 0u);
  if (!merge)
  {
    return same;
  }
  std::vector<std::uint32_t> order;
  for (const std::uint32_t point : same)
  {
    if (isFinite(surface.point(point))) // NaNs have no order
    {
      order.push_back(point);
    }
  }
  std::sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b)
    {
      const Vec3 p = surface.point(a);
      const Vec3 q = surface.point(b);
      return p < q || (p == q && a < b);
    });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (surface.point(order[i - 1]) == surface.point(order[i]))
    {
      same[order[i]] = same[order[i - 1]];
    }
  }
  return same;
}

class Check
{
public:
  Check(const Surface& surface, bool mergePoints)
    : surface_(surface)
    , same_(mergedPoints(surface, mergePoints))
  {
    this->result_.defects.assign(surface.triangleCount(), Defect::Sound);
    this->result_.components.assign(surface.triangleCount(), -1);
    this->result_.boundary.assign(surface.pointCount(), 0);
    this->result_.nonManifold.assign(surface.pointCount(), 0);
  }

  /// Sorts out what is never hit; the rest, and what has zero area but three points, are faces.
  void collectFaces()
  {
    const std::vector<PrimitiveId>& hittable = this->surface_.hittable();
    std::vector<bool> used(this->surface_.pointCount(), false);
    auto next = hittable.begin();
    for (PrimitiveId i = 0; i < this->surface_.triangleCount(); ++i)
    {
      const Triangle& t = this->surface_.triangle(i);
      const bool isHittable = next != hittable.end() && *next == i;
      next += isHittable ? 1 : 0;
      if (!isHittable)
      {
        this->result_.defects[i] = this->isSeen(i) ? Defect::Degenerate : Defect::NonFinite;
      }
      if (this->result_.defects[i] == Defect::NonFinite)
      {
        continue;
      }
      const Face face{ { this->same_[t[0]], this->same_[t[1]], this->same_[t[2]] }, i };
      // A triangle of two points is an edge there and back: it changes nothing.
      if (face.points[0] != face.points[1] && face.points[1] != face.points[2] &&
        face.points[2] != face.points[0])
      {
        this->faces_.push_back(face);
        for (std::size_t k = 0; k < 3; ++k)
        {
          this->result_.points += used[face.points[k]] ? 0 : 1;
          used[face.points[k]] = true;
          this->result_.mergedPoints += used[t[k]] ? 0 : 1;
          used[t[k]] = true;
        }
      }
    }
    if (this->faces_.size() > std::numeric_limits<std::uint32_t>::max() / 3)
    {
      throw std::runtime_error("The surface is too large for this report.");
    }
  }

  void findDuplicates()
  {
    using Key = std::array<std::uint32_t, 4>; // three points, ascending, and the face
    std::vector<Key> keys;
    keys.reserve(this->faces_.size());
    for (std::uint32_t f = 0; f < this->faces_.size(); ++f)
    {
      const auto& p = this->faces_[f].points;
      keys.push_back({ p[0], p[1], p[2], f });
      std::sort(keys.back().begin(), keys.back().begin() + 3);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1; i < keys.size(); ++i)
    {
      if (std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin()))
      {
        this->mark(keys[i][3], Defect::Duplicate);
      }
    }
  }

  void examineEdges()
  {
    const EdgeTable table(this->faces_);
    const Patches patches(this->faces_, table);
    this->countEdges(table);
    this->result_.orientable = patches.orientable;
    this->result_.componentCount = patches.components;
    for (std::uint32_t f = 0; f < this->faces_.size(); ++f)
    {
      this->result_.components[this->faces_[f].primitive] = patches.component[f];
    }
    std::vector<Face> alike = this->faces_;
    for (std::uint32_t f = 0; f < alike.size(); ++f)
    {
      if (patches.flipped[f])
      {
        std::swap(alike[f].points[1], alike[f].points[2]);
      }
    }
    const HalfEdgeReport halves = halfEdges(alike, this->surface_.pointCount());
    for (const std::uint32_t f : halves.refused)
    {
      this->mark(f, Defect::Refused);
    }
    for (std::uint32_t f = 0; f < this->faces_.size(); ++f)
    {
      if (patches.flipped[f])
      {
        this->mark(f, Defect::Flipped);
      }
    }
    this->drawBoundary(table, halves.borders);
    const std::vector<bool> split = splitPoints(this->faces_, table, this->surface_.pointCount());
    bool oneFan = true;
    for (std::size_t i = 0; i < split.size(); ++i)
    {
      oneFan = oneFan && !split[i];
      this->result_.nonManifold[i] = this->result_.nonManifold[i] || split[i] ? 1 : 0;
      this->result_.nonManifoldPoints += this->result_.nonManifold[i];
    }
    this->result_.manifold = halves.refused.empty() && oneFan;
  }

  SurfaceCheck finish()
  {
    SurfaceCheck& r = this->result_;
    for (const Defect defect : r.defects)
    {
      ++r.counts[static_cast<int>(defect)];
    }
    for (std::size_t i = 0; i < this->same_.size(); ++i)
    {
      r.boundary[i] = r.boundary[this->same_[i]];
      r.nonManifold[i] = r.nonManifold[this->same_[i]];
    }
    const bool some = !this->surface_.hittable().empty() && r.points > 0;
    r.eulerCharacteristic = static_cast<std::int64_t>(r.points) -
      static_cast<std::int64_t>(r.edges) + static_cast<std::int64_t>(this->faces_.size());
    r.closed = some && r.boundaryEdges == 0;
    r.manifold = some && r.manifold;
    r.consistent = some && r.inconsistentEdges == 0;
    r.orientable = some && r.orientable;
    r.even = some && r.even;
    this->measure();
    return std::move(r);
  }

private:
  [[nodiscard]] bool isSeen(PrimitiveId i) const
  {
    for (const Vec3& p : this->surface_.vertices(i))
    {
      for (const double x : p)
      {
        if (!(std::abs(x) <= coordinateLimit))
        {
          return false;
        }
      }
    }
    return true;
  }

  void mark(std::uint32_t face, Defect defect)
  {
    Defect& known = this->result_.defects[this->faces_[face].primitive];
    known = known == Defect::Sound ? defect : known;
  }

  void countEdges(const EdgeTable& table)
  {
    SurfaceCheck& r = this->result_;
    r.edges = table.edges.size();
    r.even = true;
    this->balanced_ = true;
    for (const Edge& edge : table.edges)
    {
      r.even = r.even && edge.count % 2 == 0;
      this->balanced_ = this->balanced_ && table.isBalanced(edge);
      if (edge.count == 1)
      {
        ++r.boundaryEdges;
        r.boundary[edge.low] = r.boundary[edge.high] = 1;
      }
      else if (edge.count > 2)
      {
        ++r.nonManifoldEdges;
        r.nonManifold[edge.low] = r.nonManifold[edge.high] = 1;
        r.lines.push_back({ EdgeKind::NonManifold, { edge.low, edge.high }, edge.count });
      }
      else if (table.isInconsistent(edge))
      {
        ++r.inconsistentEdges;
        r.lines.push_back({ EdgeKind::Inconsistent, { edge.low, edge.high }, edge.count });
      }
    }
  }

  /// The borders of the half-edges as far as they are edges of one face (others lie at faces that
  /// were refused), and the edges of one face that the half-edges lack.
  void drawBoundary(const EdgeTable& table, const std::vector<Border>& borders)
  {
    std::vector<bool> drawn(table.edges.size(), false);
    std::vector<EdgeLine> lines;
    for (const Border& border : borders)
    {
      const std::size_t n = border.size();
      std::vector<bool> isBoundary(n);
      for (std::size_t i = 0; i < n; ++i)
      {
        const Edge* edge = table.find(border[i], border[(i + 1) % n]);
        isBoundary[i] = edge && edge->count == 1;
        if (isBoundary[i])
        {
          drawn[static_cast<std::size_t>(edge - table.edges.data())] = true;
        }
      }
      const auto gap = std::find(isBoundary.begin(), isBoundary.end(), false);
      const auto start = gap == isBoundary.end() ? 0 : gap - isBoundary.begin();
      bool open = false;
      for (std::size_t step = 0; step < n; ++step)
      {
        const std::size_t i = (static_cast<std::size_t>(start) + step) % n;
        if (!isBoundary[i])
        {
          open = false;
          continue;
        }
        if (!open)
        {
          lines.push_back({ EdgeKind::Boundary, { border[i] }, 1 });
          open = true;
        }
        lines.back().points.push_back(border[(i + 1) % n]);
      }
    }
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
      if (table.edges[i].count == 1 && !drawn[i])
      {
        lines.push_back({ EdgeKind::Boundary, { table.edges[i].low, table.edges[i].high }, 1 });
      }
    }
    this->result_.boundaryLoops = lines.size();
    this->result_.lines.insert(this->result_.lines.begin(), lines.begin(), lines.end());
  }

  void measure()
  {
    const Box& bounds = this->surface_.bounds();
    const Vec3 middle = bounds.centre();
    double six = 0.0;
    double twice = 0.0;
    for (const PrimitiveId i : this->surface_.hittable())
    {
      if (!this->surface_.isTriangle(i))
      {
        continue;
      }
      const auto v = this->surface_.vertices(i);
      twice += length(cross(v[1] - v[0], v[2] - v[0]));
      six += dot(v[0] - middle, cross(v[1] - middle, v[2] - middle));
    }
    const bool hasVolume = this->result_.closed && this->balanced_;
    this->result_.area = twice / 2;
    this->result_.volume = hasVolume ? six / 6 : std::numeric_limits<double>::quiet_NaN();
  }

  const Surface& surface_;
  std::vector<std::uint32_t> same_;
  std::vector<Face> faces_;
  bool balanced_ = false;
  SurfaceCheck result_;
};

} // namespace

SurfaceCheck checkSurface(
  const Surface& surface, bool mergePoints, const std::function<bool(double)>& progress)
{
  Check check(surface, mergePoints);
  if (!progress(0.3))
  {
    return {};
  }
  check.collectFaces();
  check.findDuplicates();
  if (!progress(0.5))
  {
    return {};
  }
  check.examineEdges();
  return progress(0.9) ? check.finish() : SurfaceCheck{};
}

} // namespace lumitree::filters
