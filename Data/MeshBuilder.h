// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LUMITREE_DATA_MESH_BUILDER_H
#define LUMITREE_DATA_MESH_BUILDER_H

#include "Data/Scenes.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <unordered_map>
#include <utility>

namespace lumitree::data
{

using Point = std::array<double, 3>;

/// Throws std::invalid_argument unless low <= value <= high (a NaN throws).
void requireRange(const char* name, double value, double low, double high);

/// Puts a Mesh together. Polygons go to the part and reflectance named last.
class MeshBuilder
{
public:
  /// Starts a part; returns its index.
  int beginPart(const std::string& name, double reflectance);
  /// Goes back to a part begun before.
  void usePart(int part, double reflectance);

  /// A new point, never shared with one given before.
  std::int64_t addPoint(const Point& p);
  /// The point with these very coordinates (0 and -0 are one), made if there is none yet.
  std::int64_t weldPoint(const Point& p);

  void addPolygon(std::initializer_list<std::int64_t> ids);
  /// A polygon from which repeated neighbours were removed; nothing if fewer than three are left.
  void addCollapsed(const std::array<std::int64_t, 4>& ids);
  /// The bilinear patch over four corners as divisions x divisions welded quads.
  void addQuadGrid(const std::array<Point, 4>& corners, int divisions);
  /// The six faces of a box, outward; its eight points are its own.
  void addBox(const Point& low, const Point& high);

  [[nodiscard]] Mesh take() { return std::move(this->mesh_); }

private:
  struct PointHash
  {
    std::size_t operator()(const Point& p) const;
  };

  Mesh mesh_;
  std::unordered_map<Point, std::int64_t, PointHash> welded_;
  int part_ = 0;
  double reflectance_ = 0;
};

}

#endif
