// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_RaysScenes_h
#define Lumitree_Testing_Benchmarks_RaysScenes_h

#include "Accel/Surface.h"
#include "Accel/Vec3.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

/// What the benchmarks of rays measure on: surfaces of float points, and rays of floats.
namespace lumitree::benchmarks
{

struct Scene
{
  std::string name;
  std::vector<float> points;
  std::vector<Triangle> triangles;
  Vec3 eye;
  Vec3 target;
  double view = 0.5; ///< half the width of the picture at distance 1
  /// Which part of the camera's rays and of the bounces hit the surface; 0 where it is not known.
  std::array<double, 2> hitShares = { 0.0, 0.0 };

  [[nodiscard]] std::shared_ptr<const Surface> surface() const;
};

/// A bumpy torus as large as a scanned bunny (70,000 triangles), or what the Wavefront file holds;
/// a city (408,000); the first one subdivided twice; a teapot in a stadium (102,000).
[[nodiscard]] std::vector<Scene> builtInScenes(const std::string& surface = {});

/// Each triangle in four, new points in the middle of edges and up to 5 % of their length beside it
/// along each axis.
[[nodiscard]] Scene subdivided(const Scene& scene);

/// The vertices and faces of a Wavefront file, seen from outside. Throws std::runtime_error.
[[nodiscard]] Scene readObj(const std::string& file);

struct Rays
{
  std::string kind;
  bool any = false; ///< asks only whether there is a hit before tMax
  bool coherent = false;
  float tMax = std::numeric_limits<float>::infinity();
  std::vector<float> origins;
  std::vector<float> directions;

  void add(const Vec3& origin, const Vec3& direction);
  [[nodiscard]] std::size_t size() const { return this->origins.size() / 3; }
  [[nodiscard]] RayBatch batch() const;
};

/// One ray per pixel of a picture of 4 : 3, row by row from above.
[[nodiscard]] Rays cameraRays(const Scene& scene, int width = 640);

/// From random points of what the camera sees in random directions (by the cosine).
[[nodiscard]] Rays bounces(const Surface& surface, const Rays& camera, const std::vector<Hit>& hits,
  std::size_t count = 300000);

/// n of the rays, evenly spread among them.
[[nodiscard]] Rays sampled(const Rays& rays, std::size_t n);

/// The same rays, asked whether they hit anything.
[[nodiscard]] Rays occlusion(Rays rays);

} // namespace lumitree::benchmarks

#endif
