// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenes.h
 * Test and demonstration scenes, generated from their description alone: no file is read.
 *
 * Lengths are in metres, z is up, and polygons wind counter-clockwise seen from the side that
 * light and rays meet: outward for solid things, inward for rooms. Points that touch are shared
 * (welded bit for bit), except between separate objects.
 *
 * The same arguments give the same bits on every platform: random numbers come from SplitMix64,
 * and nothing but + - * / and sqrt is used on doubles (no libm, no fused multiply-add).
 *
 * Every generator throws std::invalid_argument, naming the argument, when one is out of its range.
 * Data/README.md says where each scene comes from.
 */
#ifndef LUMITREE_DATA_SCENES_H
#define LUMITREE_DATA_SCENES_H

#include "Data/Export.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lumitree::data
{

/// Polygons of any size. Cell c uses the points connectivity[offsets[c] .. offsets[c + 1]).
struct Mesh
{
  std::vector<double> points;             ///< x y z of each point [m]
  std::vector<std::int64_t> offsets{ 0 }; ///< one more than there are cells; the first is 0
  std::vector<std::int64_t> connectivity; ///< point ids
  std::vector<int> part;                  ///< per cell, an index into partNames
  std::vector<std::string> partNames;     ///< such as "floor" or "light"
  std::vector<double> reflectance;        ///< per cell, diffuse, in [0, 1]

  [[nodiscard]] std::int64_t numberOfPoints() const
  {
    return static_cast<std::int64_t>(this->points.size() / 3);
  }
  [[nodiscard]] std::int64_t numberOfCells() const
  {
    return static_cast<std::int64_t>(this->offsets.size()) - 1;
  }
  /// Triangles when each polygon of k points is cut into k - 2.
  [[nodiscard]] std::int64_t numberOfTriangles() const
  {
    return static_cast<std::int64_t>(this->connectivity.size()) - 2 * this->numberOfCells();
  }
};

/**
 * A unit room facing inward, two blocks turned about z, and a 0.3 x 0.3 light (part "light")
 * 5 mm below the ceiling, facing down. Reflectance 0.7, the light 0.
 * Each of the 17 faces becomes divisions x divisions quads. Range [1, 1000].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh cornellBox(int divisions = 1);

/**
 * Newell's teapot with its bottom, one unit of his data taken as a metre: x in [-3, 3.434]
 * (handle to spout), y in [-2, 2], z in [0, 3.15]. Parts: body, handle, spout, lid, bottom.
 * Each of the 32 patches becomes divisions x divisions quads, triangles at the two poles.
 * As Newell left it, the lid rests loose in the rim, and the spout and the handle pierce the body.
 * Range [2, 1000]: one division would flatten handle and spout.
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh teapot(int divisions = 10);

/**
 * plots x plots towers, 30 m apart, centred on the origin, on one ground quad. A tower is
 * 5 + 60 u^3 metres high (u uniform) and carries 18 roof boxes; 40 thin poles stand round it.
 * Boxes are closed and sunk into what they stand on, so that no two faces coincide.
 * 24 plots are 407,810 triangles. Parts: ground, tower, roof, pole. Range of plots [1, 200].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh city(int plots = 24, std::uint64_t seed = 1);

/**
 * The teapot, 0.32 m long, on the floor in the middle of a closed hall that is ratio times as
 * wide and as deep, and 0.3 ratio times as high. Parts: those of the teapot, then hall.
 * 40 divisions are 102,092 triangles. Ranges: divisions [2, 1000], ratio [4, 1e6].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh teapotInStadium(int divisions = 40, double ratio = 300);

/**
 * Unconnected triangles of random direction, their centres uniform in the unit cube. Corners lie
 * on a circle of radius size * u^sizePower (u uniform in (0, 1]): sizePower 0 makes all sizes
 * equal; larger ones follow a power law, many small and few large.
 * Ranges: count [0, 1e8], size (0, 1e3], sizePower [0, 16].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh randomCloud(
  std::int64_t count = 10000, std::uint64_t seed = 1, double size = 0.02, int sizePower = 0);

/**
 * A closed sphere of radius 1: an icosahedron with every edge cut into frequency pieces,
 * 20 frequency^2 triangles. Range [1, 1000].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh sphere(int frequency = 16);

/**
 * A closed torus about z of radii 1 and 0.4, of around x across quads. A bump b varies the tube's
 * radius between 0.4 (1 - b) and 0.4 (1 + b), in waves, so that quads are no longer flat.
 * Ranges: around and across [3, 10000], bump [0, 0.9].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh torus(int around = 128, int across = 64, double bump = 0);

/**
 * The unit square as divisions x divisions quads facing up, its heights in [0, height] from six
 * octaves of smoothed noise. Height 0 is a flat grid. Ranges: divisions [1, 5000], height [0, 10].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh terrain(
  int divisions = 256, std::uint64_t seed = 1, double height = 0.2);

/**
 * Thin triangles in a closed solid: a double cone along z on a ring of radius 1 of count points.
 * Each tip is aspect ring edges away from the centre, so that a triangle is at least aspect times
 * as long as it is wide. Ranges: count [3, 1e6], aspect [1, 1e12].
 */
[[nodiscard]] LUMITREE_DATA_EXPORT Mesh slivers(int count = 100, double aspect = 1e4);

}

#endif
