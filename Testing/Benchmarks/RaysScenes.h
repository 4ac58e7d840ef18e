// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_RaysScenes_h
#define Lumitree_Testing_Benchmarks_RaysScenes_h

#include "Accel/Surface.h"
#include "Accel/Vec3.h"

#include <memory>
#include <string>
#include <vector>

/// What RaysVersusEmbree measures on: surfaces of float points, and rays of floats.
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

  [[nodiscard]] std::shared_ptr<const Surface> surface() const;
};

/// A bumpy torus as large as a scanned bunny (70,000 triangles), a city (408,000), a teapot in a
/// stadium (102,000).
[[nodiscard]] std::vector<Scene> builtInScenes();

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

/// One ray per pixel of a square picture, row by row.
[[nodiscard]] Rays cameraRays(const Scene& scene, int width);

/// From what the camera sees: a ray in a random direction (by the cosine) from each point, in
/// random order; and one to a random point of a lamp above the eye, pixel by pixel.
///@{
[[nodiscard]] Rays bounces(
  const Surface& surface, const Rays& camera, const std::vector<Hit>& hits);
[[nodiscard]] Rays occlusion(
  const Scene& scene, const Surface& surface, const Rays& camera, const std::vector<Hit>& hits);
///@}

} // namespace lumitree::benchmarks

#endif
