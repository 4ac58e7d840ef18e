// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MeshBuilder.h"

#include "Data/Random.h"

#include <cstring>
#include <sstream>
#include <stdexcept>

namespace lumitree::data
{

void requireRange(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
  {
    std::ostringstream message;
    message << name << " must lie in [" << low << ", " << high << "], got " << value;
    throw std::invalid_argument(message.str());
  }
}

std::size_t MeshBuilder::PointHash::operator()(const Point& p) const
{
  std::uint64_t hash = 0;
  for (const double x : p)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    hash = mixBits(hash ^ bits);
  }
  return static_cast<std::size_t>(hash);
}

int MeshBuilder::beginPart(const std::string& name, double reflectance)
{
  this->mesh_.partNames.push_back(name);
  const int part = static_cast<int>(this->mesh_.partNames.size()) - 1;
  this->usePart(part, reflectance);
  return part;
}

void MeshBuilder::usePart(int part, double reflectance)
{
  this->part_ = part;
  this->reflectance_ = reflectance;
}

std::int64_t MeshBuilder::addPoint(const Point& p)
{
  this->mesh_.points.insert(this->mesh_.points.end(), p.begin(), p.end());
  return this->mesh_.numberOfPoints() - 1;
}

std::int64_t MeshBuilder::weldPoint(const Point& p)
{
  // Adding 0 turns -0 into 0, whose bits differ.
  const Point key{ p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 };
  const auto [entry, isNew] = this->welded_.try_emplace(key, this->mesh_.numberOfPoints());
  if (isNew)
  {
    this->addPoint(key);
  }
  return entry->second;
}

void MeshBuilder::addPolygon(std::initializer_list<std::int64_t> ids)
{
  this->mesh_.connectivity.insert(this->mesh_.connectivity.end(), ids);
  this->mesh_.offsets.push_back(static_cast<std::int64_t>(this->mesh_.connectivity.size()));
  this->mesh_.part.push_back(this->part_);
  this->mesh_.reflectance.push_back(this->reflectance_);
}

void MeshBuilder::addCollapsed(const std::array<std::int64_t, 4>& ids)
{
  std::array<std::int64_t, 4> kept{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    if (ids[i] != ids[(i + 1) % 4])
    {
      kept[count++] = ids[i];
    }
  }
  if (count == 4)
  {
    this->addPolygon({ kept[0], kept[1], kept[2], kept[3] });
  }
  else if (count == 3)
  {
    this->addPolygon({ kept[0], kept[1], kept[2] });
  }
}

void MeshBuilder::addQuadGrid(const std::array<Point, 4>& corners, int divisions)
{
  const int n = divisions;
  std::vector<std::int64_t> ids;
  ids.reserve(static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1));
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      // Whole-number weights: along an edge two of them vanish, and the sum of the other two has
      // the same bits from either face. A corner is itself.
      const double w[4] = { double(n - i) * (n - j), double(i) * (n - j), double(i) * j,
        double(n - i) * j };
      Point p;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const bool same = corners[0][k] == corners[1][k] && corners[1][k] == corners[2][k] &&
          corners[2][k] == corners[3][k];
        p[k] = same ? corners[0][k]
                    : ((w[0] * corners[0][k] + w[1] * corners[1][k]) +
                        (w[2] * corners[2][k] + w[3] * corners[3][k])) /
            (double(n) * n);
      }
      ids.push_back(this->weldPoint(p));
    }
  }
  const std::size_t row = static_cast<std::size_t>(n) + 1;
  for (std::size_t j = 0; j + 1 < row; ++j)
  {
    for (std::size_t i = 0; i + 1 < row; ++i)
    {
      const std::size_t at = j * row + i;
      this->addPolygon({ ids[at], ids[at + 1], ids[at + row + 1], ids[at + row] });
    }
  }
}

void MeshBuilder::addBox(const Point& low, const Point& high)
{
  const std::int64_t first = this->mesh_.numberOfPoints();
  for (int corner = 0; corner < 8; ++corner)
  {
    this->addPoint({ corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
      corner & 4 ? high[2] : low[2] });
  }
  constexpr int faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& face : faces)
  {
    this->addPolygon({ first + face[0], first + face[1], first + face[2], first + face[3] });
  }
}

}
