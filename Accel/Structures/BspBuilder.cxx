// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BspBuilder.h"

#include "Accel/Hierarchy.h"
#include "Accel/Structures/BspDivide.h"

#include <algorithm>
#include <optional>

namespace lumitree
{
namespace
{

/// What a plane costs that leaves one side empty.
constexpr double emptyBonus = 0.8;
/// Of the cell's area, what both sides of a plane certainly have together.
constexpr double leastShare = 0.999;
constexpr std::size_t trianglesTried = 16;
constexpr std::size_t mostForPlanes = 4096;

/// A cell and what reaches into it, to become the node `node`.
struct Task : BspPart
{
  std::size_t allowance = 0; ///< references that the leaves below may hold together
  std::uint32_t node = 0;
  int depth = 0;
};

/// A plane that a cell may be divided by.
struct Offer
{
  BspPlane plane;
  double cost = 0.0;
};

/// Those worth something, and the least that any costs.
struct Offers
{
  double whole = 0.0; ///< area of the cell
  double least = 0.0;
  std::vector<Offer> list;
};

class Builder
{
public:
  Builder(const Surface& surface, LeafBlocks& blocks, BuildProgress& progress)
    : surface_(surface)
    , blocks_(blocks)
    , progress_(progress)
    , frame_(bspFrameOf(surface.bounds()))
  {
  }

  BspNodes build(int maxDepth)
  {
    const std::size_t count = this->surface_.hittable().size();
    this->tree_.nodes.emplace_back();
    this->tree_.cell = this->surface_.bounds();
    const int depthLimit = std::min(maxDepth,
      static_cast<int>(
        8.0 + 1.3 * std::log2(static_cast<double>(std::max<std::size_t>(1, count)))));
    std::vector<Task> tasks(1);
    this->makeRoot(tasks.front());
    this->progress_.stage(0.99, tasks.front().allowance);
    while (!tasks.empty())
    {
      Task task = std::move(tasks.back());
      tasks.pop_back();
      this->progress_.advance(0);
      if (task.depth >= depthLimit || !this->split(task, tasks))
      {
        this->makeLeaf(task);
        this->progress_.advance(task.allowance);
      }
    }
    return std::move(this->tree_);
  }

private:
  void makeRoot(Task& root)
  {
    root.cell = this->tree_.cell;
    root.node = 0;
    root.depth = 0;
    for (const PrimitiveId id : this->surface_.hittable())
    {
      root.references.push_back({ this->surface_.box(id), id });
    }
    root.allowance = bspReferencesPerTriangle * root.references.size();
    if (!root.cell.empty())
    {
      root.polyhedron = framedRoot(this->frame_, root.cell);
    }
  }

  [[nodiscard]] Vec3 framed(const Vec3& x) const { return framedPoint(this->frame_, x); }

  bool split(Task& task, std::vector<Task>& tasks)
  {
    if (task.references.size() < 2)
    {
      return false;
    }
    Offers offers;
    offers.whole = areaOf(task.polyhedron);
    offers.least = leafCost(task.references.size());
    const KdSplit across = this->axisPlanes_.best(task.cell, task.references);
    if (across.axis >= 0)
    {
      BspPlane plane;
      plane.axis = across.axis;
      plane.normal[static_cast<std::size_t>(across.axis)] = 1.0;
      plane.offset = across.position;
      plane.inPlaneBelow = across.inPlaneBelow;
      this->offer(task, plane, offers);
    }
    if (task.references.size() <= mostForPlanes)
    {
      const std::size_t step = (task.references.size() + trianglesTried - 1) / trianglesTried;
      for (std::size_t i = 0; i < task.references.size(); i += step)
      {
        for (const bool below : { true, false })
        {
          if (const auto plane = this->planeBeside(task.references[i].id, below))
          {
            this->offer(task, *plane, offers);
          }
        }
      }
    }
    // The cheapest that can be cut; where several cost the same, the first.
    std::stable_sort(offers.list.begin(), offers.list.end(),
      [](const Offer& a, const Offer& b) { return a.cost < b.cost; });
    for (const Offer& offer : offers.list)
    {
      auto parts = cutPolyhedron(task.polyhedron, offer.plane.normal,
        framedOffset(this->frame_, offer.plane.normal, offer.plane.offset));
      if (parts)
      {
        return this->divide(task, offer.plane, std::move(*parts), tasks);
      }
    }
    return false;
  }

  /// A plane so little beside a triangle that the triangle is certainly on the side asked for.
  [[nodiscard]] std::optional<BspPlane> planeBeside(PrimitiveId id, bool triangleBelow) const
  {
    const auto v = this->surface_.vertices(id);
    const Vec3 a = this->framed(v[0]);
    BspPlane plane;
    plane.normal = cross(this->framed(v[1]) - a, this->framed(v[2]) - a);
    double largest = 0.0;
    for (const double n : plane.normal)
    {
      largest = std::max(largest, std::fabs(n));
    }
    if (!(largest > 0x1p-200))
    {
      return std::nullopt;
    }
    for (double& n : plane.normal)
    {
      n /= largest;
    }
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double margin = 0.0;
    for (const Vec3& p : v)
    {
      const PlaneDistance distance(plane.normal, 0.0, p);
      low = std::min(low, distance.value);
      high = std::max(high, distance.value);
      margin = std::max(margin, distance.margin);
    }
    // The offset adds its own magnitude to the margin: four margins are certainly enough.
    plane.offset = triangleBelow ? high + 4.0 * margin : low - 4.0 * margin;
    return plane;
  }

  void offer(const Task& task, const BspPlane& plane, Offers& offers)
  {
    std::size_t below = 0;
    std::size_t above = 0;
    for (const KdReference& r : task.references)
    {
      const BspSide side = sideOf(this->surface_, r, plane);
      below += side != BspSide::Above ? 1 : 0;
      above += side != BspSide::Below ? 1 : 0;
    }
    const std::size_t count = task.references.size();
    if (below == count && above == count)
    {
      return;
    }
    const double step = plane.axis >= 0 ? bspAxisStepCost : bspPlaneStepCost;
    const double bonus = below == 0 || above == 0 ? emptyBonus : 1.0;
    // The least that this plane can cost: both areas together are the cell's and twice that of the
    // cut, and neither is larger than the cell's (but for rounding). Most planes are not worth
    // cutting the polyhedron.
    if (bonus * (step + leastShare * std::min(leafCost(below), leafCost(above))) >= offers.least)
    {
      return;
    }
    const auto areas = this->cutAreas_(
      task.polyhedron, plane.normal, framedOffset(this->frame_, plane.normal, plane.offset));
    if (!areas || !(offers.whole > 0.0))
    {
      return;
    }
    const double cost = bonus *
      (step + areas->first / offers.whole * leafCost(below) +
        areas->second / offers.whole * leafCost(above));
    if (cost < offers.least)
    {
      offers.least = cost;
      offers.list.push_back({ plane, cost });
    }
  }

  /// False where the sides would hold more than is allowed.
  bool divide(const Task& task, const BspPlane& plane,
    std::pair<Polyhedron, Polyhedron>&& polyhedra, std::vector<Task>& tasks)
  {
    auto parts = divideReferences(this->surface_, this->frame_, task, plane, std::move(polyhedra));
    Task below{ std::move(parts.first), 0, 0, task.depth + 1 };
    Task above{ std::move(parts.second), 0, 0, task.depth + 1 };
    const std::size_t held = below.references.size() + above.references.size();
    if (held > task.allowance)
    {
      return false;
    }
    const std::size_t spare = task.allowance - held;
    const auto spareBelow = held > 0
      ? static_cast<std::size_t>(static_cast<double>(spare) *
          static_cast<double>(below.references.size()) / static_cast<double>(held))
      : 0;
    below.allowance = below.references.size() + std::min(spareBelow, spare);
    above.allowance = task.allowance - below.allowance;

    const auto first = static_cast<std::uint32_t>(this->tree_.nodes.size());
    BspNode& node = this->tree_.nodes[task.node];
    node.leaf = false;
    node.normal = plane.normal;
    node.offset = plane.offset;
    node.axis = plane.axis;
    node.first = first;
    this->tree_.nodes.resize(first + 2);
    below.node = first;
    above.node = first + 1;
    tasks.push_back(std::move(above));
    tasks.push_back(std::move(below));
    return true;
  }

  void makeLeaf(const Task& task)
  {
    std::vector<PrimitiveId> ids;
    for (const KdReference& r : task.references)
    {
      ids.push_back(r.id);
    }
    BspNode& leaf = this->tree_.nodes[task.node];
    leaf.count = static_cast<std::uint32_t>(ids.size());
    std::visit([&](auto& store)
      { leaf.first = store.append(this->surface_, ids.data(), ids.size()); },
      this->blocks_);
  }

  const Surface& surface_;
  LeafBlocks& blocks_;
  BuildProgress& progress_;
  WideBvhFrame frame_;
  KdPlaneSearch axisPlanes_;
  CutAreas cutAreas_;
  BspNodes tree_;
};

} // namespace

BspNodes buildBspNodes(
  const Surface& surface, const BuildOptions& options, LeafBlocks& blocks, BuildProgress& progress)
{
  return Builder(surface, blocks, progress).build(options.maxDepth);
}

} // namespace lumitree
