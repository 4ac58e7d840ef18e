// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_RaysContenders_h
#define Lumitree_Testing_Benchmarks_RaysContenders_h

#include "RaysScenes.h"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace lumitree::benchmarks
{

/// A scene with its rays, which are made when they are first asked for: camera 0, incoherent 1,
/// occlusion 2. Makes sure that they are what they are meant to be.
class Course
{
public:
  explicit Course(Scene ofScene)
    : scene(std::move(ofScene))
  {
  }

  /// Throws std::runtime_error when the shares of rays that hit are not those of the scene; of a
  /// file, when fewer than 5 % of the camera's do.
  const Rays& rays(std::size_t kind);

  /// Which part of the rays of a kind hits, by the exact answer.
  double hitShare(std::size_t kind);

  const std::shared_ptr<const Surface>& surface();

  const Scene scene;

private:
  std::shared_ptr<const Surface> surface_;
  std::vector<Rays> rays_;
  std::vector<double> hitShares_;
};

/// What a build took and weighs.
struct BuildCost
{
  double seconds = 0.0;
  std::size_t bytes = 0;
};

/// One who traces rays: what is timed is closest or any, after prepare.
struct Contender
{
  std::string name;
  std::size_t limit = 0; ///< how many rays of a kind it is given, the slow ones fewer
  std::size_t mostTriangles =
    std::numeric_limits<std::size_t>::max(); ///< larger scenes it is spared
  bool misses = false;                       ///< known to: its hits are told, not required
  std::function<void(Course&)> prepare;
  std::function<void(const Rays&, Hit*)> closest;
  std::function<void(const Rays&, std::uint8_t*)> any;
  std::vector<std::size_t> kinds = { 0, 1, 2 };
};

/// One who builds.
struct Builder
{
  std::string name;
  std::function<BuildCost(Course&)> build;
};

/// For one scene, new at each call; structures are shared among those of one call and built when
/// they are first needed, on one thread.
///@{
[[nodiscard]] std::vector<Contender> contenders();
[[nodiscard]] std::vector<Builder> builders();
///@}

/// The version of Embree that is measured; empty without.
[[nodiscard]] std::string embreeVersion();

} // namespace lumitree::benchmarks

#endif
