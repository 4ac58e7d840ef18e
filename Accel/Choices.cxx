// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Choices.h"

#include <array>

namespace lumitree
{
namespace
{

constexpr std::array<std::string_view, structureCount> structureNames = { "auto", "brute_force",
  "bvh", "wide_bvh", "grid", "octree", "kd_tree", "bsp_tree", "embree", "cgal", "cgal_epick",
  "cgal_cartesian" };
constexpr std::array<std::string_view, precisionCount> precisionNames = { "fast", "watertight",
  "exact" };
constexpr std::array<std::string_view, bvhBuildCount> bvhBuildNames = { "longest_axis_median",
  "binned_sah", "sweep_sah", "spatial_splits", "morton" };
constexpr std::array<std::string_view, kdBuildCount> kdBuildNames = { "spatial_median", "sah" };
constexpr std::array<std::string_view, queryKindCount> queryNames = { "closest", "any", "all",
  "count", "crossings", "ties" };

template <std::size_t N>
std::string_view nameOf(const std::array<std::string_view, N>& names, int value)
{
  return value >= 0 && static_cast<std::size_t>(value) < N ? names[value] : "unknown";
}

template <class Choice, std::size_t N>
std::optional<Choice> fromName(const std::array<std::string_view, N>& names, std::string_view text)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    if (names[i] == text)
    {
      return static_cast<Choice>(i);
    }
  }
  return std::nullopt;
}

} // namespace

std::string_view name(Structure value)
{
  return nameOf(structureNames, static_cast<int>(value));
}

std::string_view name(Precision value)
{
  return nameOf(precisionNames, static_cast<int>(value));
}

std::string_view name(BvhBuild value)
{
  return nameOf(bvhBuildNames, static_cast<int>(value));
}

std::string_view name(KdBuild value)
{
  return nameOf(kdBuildNames, static_cast<int>(value));
}

std::string_view name(QueryKind value)
{
  return nameOf(queryNames, static_cast<int>(value));
}

std::optional<Structure> structureFromName(std::string_view text)
{
  return fromName<Structure>(structureNames, text);
}

std::optional<Precision> precisionFromName(std::string_view text)
{
  return fromName<Precision>(precisionNames, text);
}

} // namespace lumitree
