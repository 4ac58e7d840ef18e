// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Structures/KdTreeEvents.h"

#include <algorithm>

namespace lumitree
{
namespace
{

/// Events sorted at once; longer lists are merged from such.
constexpr std::size_t run = std::size_t{ 1 } << 16;
constexpr std::size_t mergeWork = 2;

} // namespace

std::array<std::vector<KdEvent>, 3> sortedEvents(
  const std::vector<KdReference>& references, BuildProgress& progress)
{
  std::array<std::vector<KdEvent>, 3> events;
  progress.forEach(
    3, 1,
    [&](std::size_t begin, std::size_t)
    {
      events[begin].reserve(2 * references.size());
      std::uint32_t index = 0;
      for (const KdReference& r : references)
      {
        appendEvents(r.bounds, static_cast<int>(begin), index++, events[begin]);
      }
    },
    [&](std::size_t, std::size_t) { return references.size() / 3; });

  struct Run
  {
    std::size_t axis, begin, middle, end;
  };
  std::vector<Run> runs;
  std::size_t longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t size = events[axis].size();
    longest = std::max(longest, size);
    for (std::size_t begin = 0; begin < size; begin += run)
    {
      runs.push_back({ axis, begin, 0, std::min(begin + run, size) });
    }
  }
  progress.forEach(
    runs.size(), 1,
    [&](std::size_t begin, std::size_t)
    {
      std::vector<KdEvent>& list = events[runs[begin].axis];
      std::sort(list.data() + runs[begin].begin, list.data() + runs[begin].end);
    },
    [&](std::size_t begin, std::size_t) { return (runs[begin].end - runs[begin].begin) / 2; });

  // The rest of the work is shared out evenly among rounds of merging.
  std::size_t rounds = 0;
  for (std::size_t length = run; length < longest; length *= 2)
  {
    ++rounds;
  }
  std::array<std::vector<KdEvent>, 3> merged;
  for (std::size_t length = run; length < longest; length *= 2)
  {
    runs.clear();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t size = events[axis].size();
      merged[axis].resize(size);
      for (std::size_t begin = 0; begin < size; begin += 2 * length)
      {
        runs.push_back(
          { axis, begin, std::min(begin + length, size), std::min(begin + 2 * length, size) });
      }
    }
    progress.forEach(
      runs.size(), 1,
      [&](std::size_t begin, std::size_t)
      {
        const Run& r = runs[begin];
        const KdEvent* const from = events[r.axis].data();
        std::merge(from + r.begin, from + r.middle, from + r.middle, from + r.end,
          merged[r.axis].data() + r.begin);
      },
      [&](std::size_t begin, std::size_t)
      { return mergeWork * (runs[begin].end - runs[begin].begin) / (6 * rounds); });
    events.swap(merged);
  }
  return events;
}

void takeEvents(const std::vector<KdEvent>& all, const KdSideMap& sides, std::uint32_t which,
  std::vector<KdEvent>& fresh, std::vector<KdEvent>& side)
{
  // Two events of each reference at most, and a place to write what is not kept.
  side.resize(std::min(all.size(), 2 * sides.whole(which)) + fresh.size() + 1);
  KdEvent* out = side.data();
  for (const KdEvent& event : all)
  {
    // Written in any case, so that there is nothing to guess.
    *out = { event.position, sides.index(event.reference()) << 2 | event.kind() };
    out += sides.side(event.reference()) == which ? 1 : 0;
  }
  const auto kept = static_cast<std::size_t>(out - side.data());
  std::size_t write = kept + fresh.size();
  side.resize(write);
  std::sort(fresh.begin(), fresh.end());
  // From the end on, until no new ones are left.
  std::size_t read = kept;
  while (!fresh.empty())
  {
    if (read > 0 && fresh.back() < side[read - 1])
    {
      side[--write] = side[--read];
    }
    else
    {
      side[--write] = fresh.back();
      fresh.pop_back();
    }
  }
}

} // namespace lumitree
