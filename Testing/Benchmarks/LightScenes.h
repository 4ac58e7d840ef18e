// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_LightScenes_h
#define Lumitree_Testing_Benchmarks_LightScenes_h

#include "Accel/Accelerator.h"
#include "Radiometry/EmittingPolygon.h"
#include "Radiometry/SkyDistribution.h"
#include "Radiometry/Source.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lumitree::benchmarks
{

/// Places on the ground, which look up.
struct Sensors
{
  std::vector<double> positions;
  std::vector<double> normals;

  void add(double x, double y);
  [[nodiscard]] std::size_t size() const { return this->positions.size() / 3; }
};

/// One light, what casts shadows, and where light is asked for. Lengths in metres, z up.
struct LightScene
{
  std::string key;  ///< one word
  std::string name; ///< of a table
  std::shared_ptr<const Accelerator> occluders;
  std::unique_ptr<const Source> light;
  Sensors sensors;

  /// What the light is, for other programs: a polygon, or else a sky with the sun in that
  /// direction, whose radiance at the zenith is 1.
  ///@{
  std::optional<EmittingPolygon> polygon;
  SkyDistribution sky;
  Vec3 towardsSun = { 0.0, 0.0, 1.0 };
  ///@}
};

/// The Cornell box: two blocks under a square light; sensors where no block stands.
[[nodiscard]] LightScene box();

/// Sixteen houses of 12 by 12 metres, 6 to 28 high, and streets of 8 between them, under a uniform
/// or an overcast (Moon and Spencer) sky; sensors in the streets around the four in the middle.
[[nodiscard]] LightScene streets(bool overcast);

/// A ball of 20 frequency² triangles over the floor, right under the light.
[[nodiscard]] LightScene ball(int frequency);

/// What a scanner would give: a lump with dents and knobs, of 69,620 triangles, over the floor
/// under a square light. Neither convex nor coarse: clipping has nothing to gain.
[[nodiscard]] LightScene scan();

/// What has no skyline: balconies, a bridge, arcades and tree crowns around a yard, under the CIE's
/// clear sky (type 12) with the sun 45 degrees high.
[[nodiscard]] LightScene yard();

} // namespace lumitree::benchmarks

#endif
