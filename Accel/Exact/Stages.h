// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Exact_Stages_h
#define Lumitree_Accel_Exact_Stages_h

#include "Accel/Exact/Dyadic.h"
#include "Accel/Exact/Formulas.h"
#include "Accel/Exact/Lattice.h"

#include <optional>

/// Kinds of numbers, from the fastest, which takes nearly all inputs, to the one that takes every
/// input. Each is exact, so the first that takes an input answers.
namespace lumitree::exact
{

/// The line of a ray and the triangles of a question.
template <std::size_t K>
struct Question
{
  const Ray& ray;
  std::array<const std::array<Vec3, 3>*, K> triangles;
};

#if defined(LUMITREE_HAS_FIXED_INTEGERS)
template <class Integer, std::size_t K>
using LatticeScene = Scene<typename Lattice<Integer>::Number, typename Lattice<Integer>::Point, K>;

/// Whether points and direction are integers on a lattice each; these go to scene.
template <class Integer, std::size_t K>
bool place(const Question<K>& q, LatticeScene<Integer, K>& scene)
{
  double size = largest(q.ray.origin);
  for (const auto* triangle : q.triangles)
  {
    size = std::max(size, largest(*triangle));
  }
  const Lattice<Integer> points(size);
  const Lattice<Integer> directions(largest(q.ray.direction));
  scene.tExponent = directions.exponent() - points.exponent();
  bool exact =
    points.place(q.ray.origin, scene.origin) && directions.place(q.ray.direction, scene.direction);
  for (std::size_t i = 0; i < K; ++i)
  {
    exact = exact && points.place(*q.triangles[i], scene.triangles[i]);
  }
  return exact;
}
#endif

template <std::size_t K>
Scene<Dyadic, Vec3, K> asStored(const Question<K>& q)
{
  Scene<Dyadic, Vec3, K> scene;
  scene.origin = q.ray.origin;
  scene.direction = q.ray.direction;
  for (std::size_t i = 0; i < K; ++i)
  {
    scene.triangles[i] = *q.triangles[i];
  }
  return scene;
}

/// What answer(scene) says at the first stage that takes the question and does not leave it open.
template <std::size_t K, class Answer>
auto answerInStages(const Question<K>& q, Answer answer)
{
#if defined(LUMITREE_HAS_FIXED_INTEGERS)
  {
    LatticeScene<std::int64_t, K> scene;
    if (place<std::int64_t>(q, scene))
    {
      if (const auto a = answer(scene))
      {
        return *a;
      }
    }
  }
  {
    LatticeScene<Int128, K> scene;
    if (place<Int128>(q, scene))
    {
      if (const auto a = answer(scene))
      {
        return *a;
      }
    }
  }
#endif
  return *answer(asStored(q));
}

} // namespace lumitree::exact

#endif
