// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshChecks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

namespace lumitree::data::testing
{
namespace
{

using Vector = std::array<double, 3>;

Vector pointAt(const Mesh& mesh, std::int64_t id)
{
  const double* p = &mesh.points[3 * static_cast<std::size_t>(id)];
  return { p[0], p[1], p[2] };
}

Vector minus(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Visitor>
void forEachTriangle(const Mesh& mesh, Visitor visit)
{
  for (std::size_t cell = 0; cell + 1 < mesh.offsets.size(); ++cell)
  {
    const std::int64_t* ids = &mesh.connectivity[static_cast<std::size_t>(mesh.offsets[cell])];
    const std::int64_t size = mesh.offsets[cell + 1] - mesh.offsets[cell];
    for (std::int64_t i = 1; i + 1 < size; ++i)
    {
      visit(pointAt(mesh, ids[0]), pointAt(mesh, ids[i]), pointAt(mesh, ids[i + 1]));
    }
  }
}

}

EdgeCounts countEdges(const Mesh& mesh)
{
  // Per edge: how often it is run upward and downward.
  std::map<std::pair<std::int64_t, std::int64_t>, std::pair<int, int>> edges;
  for (std::size_t cell = 0; cell + 1 < mesh.offsets.size(); ++cell)
  {
    const std::int64_t* ids = &mesh.connectivity[static_cast<std::size_t>(mesh.offsets[cell])];
    const std::int64_t size = mesh.offsets[cell + 1] - mesh.offsets[cell];
    for (std::int64_t i = 0; i < size; ++i)
    {
      const std::int64_t a = ids[i];
      const std::int64_t b = ids[(i + 1) % size];
      auto& counts = edges[std::minmax(a, b)];
      ++(a < b ? counts.first : counts.second);
    }
  }
  EdgeCounts result;
  for (const auto& [edge, counts] : edges)
  {
    result.open += counts.first + counts.second == 1;
    result.wrong += counts.first > 1 || counts.second > 1 || edge.first == edge.second;
  }
  return result;
}

double signedVolume(const Mesh& mesh)
{
  double volume = 0;
  forEachTriangle(mesh,
    [&](const Vector& a, const Vector& b, const Vector& c) { volume += dot(a, cross(b, c)) / 6; });
  return volume;
}

double area(const Mesh& mesh)
{
  double sum = 0;
  forEachTriangle(mesh,
    [&](const Vector& a, const Vector& b, const Vector& c)
    {
      const Vector normal = cross(minus(b, a), minus(c, a));
      sum += 0.5 * std::sqrt(dot(normal, normal));
    });
  return sum;
}

bool isConsistent(const Mesh& mesh)
{
  const auto cells = static_cast<std::size_t>(mesh.numberOfCells());
  const auto inRange = [](const auto& values, auto low, auto high)
  {
    return std::all_of(
      values.begin(), values.end(), [=](auto value) { return value >= low && value <= high; });
  };
  return mesh.points.size() % 3 == 0 && mesh.part.size() == cells &&
    mesh.reflectance.size() == cells && mesh.offsets.front() == 0 &&
    mesh.offsets.back() == static_cast<std::int64_t>(mesh.connectivity.size()) &&
    std::is_sorted(mesh.offsets.begin(), mesh.offsets.end()) &&
    inRange(mesh.connectivity, std::int64_t(0), mesh.numberOfPoints() - 1) &&
    inRange(mesh.part, 0, static_cast<int>(mesh.partNames.size()) - 1) &&
    inRange(mesh.reflectance, 0.0, 1.0);
}

std::uint64_t fingerprint(const Mesh& mesh)
{
  std::uint64_t hash = 0xcbf29ce484222325ull;
  const auto add = [&](std::uint64_t word)
  {
    for (int shift = 0; shift < 64; shift += 8)
    {
      hash = (hash ^ ((word >> shift) & 0xff)) * 0x100000001b3ull;
    }
  };
  for (const double x : mesh.points)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    add(bits);
  }
  for (const std::int64_t id : mesh.connectivity)
  {
    add(static_cast<std::uint64_t>(id));
  }
  return hash;
}

Mesh partOf(const Mesh& mesh, const std::string& name)
{
  Mesh result;
  result.points = mesh.points;
  result.partNames = mesh.partNames;
  for (std::size_t cell = 0; cell + 1 < mesh.offsets.size(); ++cell)
  {
    if (mesh.partNames[static_cast<std::size_t>(mesh.part[cell])] == name)
    {
      result.connectivity.insert(result.connectivity.end(),
        mesh.connectivity.begin() + mesh.offsets[cell],
        mesh.connectivity.begin() + mesh.offsets[cell + 1]);
      result.offsets.push_back(static_cast<std::int64_t>(result.connectivity.size()));
      result.part.push_back(mesh.part[cell]);
      result.reflectance.push_back(mesh.reflectance[cell]);
    }
  }
  return result;
}

Bounds bounds(const Mesh& mesh)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds result{ { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
  for (const std::int64_t id : mesh.connectivity)
  {
    const Vector p = pointAt(mesh, id);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      result.low[axis] = std::min(result.low[axis], p[axis]);
      result.high[axis] = std::max(result.high[axis], p[axis]);
    }
  }
  return result;
}

}
