// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/BvhParts.h"

#include "Accel/Structures/BodyBoxOverlap.h"
#include "Accel/Structures/KdTreeClip.h"

namespace lumitree
{
namespace
{

constexpr std::size_t chunk = 256;
constexpr int mostSteps = 512;

/// A box around what a primitive has inside a closed box, empty where that is nothing.
Box partOf(const Surface& surface, PrimitiveId primitive, const Box& inside)
{
  if (surface.isTriangle(primitive))
  {
    return clippedBounds(surface.vertices(primitive), inside);
  }
  const Box box = commonBox(surface.box(primitive), inside);
  return box.empty() || mayMeet(surface, primitive, box) ? box : Box{};
}

bool isWithin(const Box& a, const Box& b)
{
  bool within = true;
  for (int k = 0; k < 3; ++k)
  {
    within = within && a.lower[k] >= b.lower[k] && a.upper[k] <= b.upper[k];
  }
  return within;
}

/// Cuts a box in two by a side of another that passes through its inside, if one does.
bool cutBySide(const Box& box, const Box& by, Box& first, Box& second)
{
  for (int k = 0; k < 3; ++k)
  {
    for (const double plane : { by.lower[k], by.upper[k] })
    {
      if (box.lower[k] < plane && plane < box.upper[k])
      {
        first = second = box;
        first.upper[k] = second.lower[k] = plane;
        return true;
      }
    }
  }
  return false;
}

/// Of each primitive the references to it: those of primitive p stand from first[p] on.
struct ReferencesOf
{
  std::vector<std::size_t> first;
  std::vector<std::size_t> references;

  ReferencesOf(const Surface& surface, const std::vector<PrimitiveId>& ids)
    : first(surface.size() + 1, 0)
    , references(ids.size())
  {
    for (const PrimitiveId id : ids)
    {
      ++this->first[id + 1];
    }
    for (std::size_t p = 0; p < surface.size(); ++p)
    {
      this->first[p + 1] += this->first[p];
    }
    std::vector<std::size_t> next(this->first.begin(), this->first.end() - 1);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      this->references[next[ids[i]]++] = i;
    }
  }
};

} // namespace

bool cover(const Surface& surface, PrimitiveId primitive, const std::vector<Box>& boxes)
{
  std::vector<Box> open = { surface.box(primitive) };
  for (int step = 0; step < mostSteps; ++step)
  {
    if (open.empty())
    {
      return true;
    }
    const Box inside = open.back();
    open.pop_back();
    const Box part = partOf(surface, primitive, inside);
    if (part.empty() ||
      std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return isWithin(part, b); }))
    {
      continue;
    }
    Box first;
    Box second;
    const bool cut = std::any_of(boxes.begin(), boxes.end(),
      [&](const Box& b)
      { return !commonBox(part, b).empty() && cutBySide(part, b, first, second); });
    if (!cut)
    {
      return false;
    }
    open.push_back(first);
    open.push_back(second);
  }
  return false;
}

std::vector<Box> boxesOfParts(const Surface& surface, const BvhLeaves& leaves,
  const std::vector<std::size_t>& firsts, BuildProgress& progress)
{
  std::vector<std::size_t> leafOf(leaves.references.size());
  for (std::size_t leaf = 0; leaf < leaves.sizes.size(); ++leaf)
  {
    std::fill(leafOf.begin() + static_cast<std::ptrdiff_t>(firsts[leaf]),
      leafOf.begin() + static_cast<std::ptrdiff_t>(firsts[leaf + 1]), leaf);
  }
  const ReferencesOf of(surface, leaves.references);
  std::vector<Box> parts(leaves.references.size());
  progress.forEach(surface.size(), chunk,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Box> boxes;
      for (std::size_t p = begin; p < end; ++p)
      {
        const auto id = static_cast<PrimitiveId>(p);
        boxes.clear();
        for (std::size_t i = of.first[p]; i < of.first[p + 1]; ++i)
        {
          boxes.push_back(leaves.boxes[leafOf[of.references[i]]]);
        }
        const bool split = boxes.size() > 1 && cover(surface, id, boxes);
        for (std::size_t i = of.first[p]; i < of.first[p + 1]; ++i)
        {
          parts[of.references[i]] =
            split ? partOf(surface, id, boxes[i - of.first[p]]) : surface.box(id);
        }
      }
    });
  return parts;
}

} // namespace lumitree
