// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Predicates.h"

#include "Accel/Exact/Limits.h"
#include "Accel/Exact/Stages.h"

namespace lumitree::exact
{

bool lineMeetsTriangle(const Ray& ray, const std::array<Vec3, 3>& t)
{
  return answerInStages(
    Question<1>{ ray, { &t } }, [](const auto& scene) { return std::optional(meets(scene)); });
}

bool movedLineMeetsTriangle(const Ray& ray, const std::array<Vec3, 3>& t)
{
  return answerInStages(
    Question<1>{ ray, { &t } }, [](const auto& scene) { return std::optional(meetsMoved(scene)); });
}

int compareCrossing(const Ray& ray, const std::array<Vec3, 3>& t, double limit)
{
  if (std::isinf(limit))
  {
    return limit > 0.0 ? -1 : 1;
  }
  return answerInStages(
    Question<1>{ ray, { &t } }, [&](const auto& scene) { return compareToLimit(scene, limit); });
}

int compareMovedCrossing(const Ray& ray, const std::array<Vec3, 3>& t, double limit)
{
  if (const int sign = compareCrossing(ray, t, limit); sign != 0)
  {
    return sign;
  }
  return answerInStages(
    Question<1>{ ray, { &t } }, [](const auto& scene) { return std::optional(signOfMove(scene)); });
}

int compareCrossings(const Ray& ray, const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b)
{
  return answerInStages(Question<2>{ ray, { &a, &b } },
    [](const auto& scene) { return std::optional(compare(scene)); });
}

double crossingParameter(const Ray& ray, const std::array<Vec3, 3>& t)
{
  return answerInStages(Question<1>{ ray, { &t } },
    [](const auto& scene)
    {
      const auto x = parameter(scene, 0);
      return std::optional(
        Dyadic::quotient(Dyadic::from(x.over, scene.tExponent), Dyadic::from(x.under, 0)));
    });
}

bool isZeroArea(const std::array<Vec3, 3>& t)
{
  // Each component of the normal is off by less than 5 u times the sum of its products' magnitudes;
  // one that is certainly not 0 decides. Products that underflow decide nothing.
  const Vec3 a = t[1] - t[0];
  const Vec3 b = t[2] - t[0];
  for (int k = 0; k < 3; ++k)
  {
    const double first = a[(k + 1) % 3] * b[(k + 2) % 3];
    const double second = a[(k + 2) % 3] * b[(k + 1) % 3];
    if (std::fabs(first - second) > 0x1p-50 * (std::fabs(first) + std::fabs(second)) + 0x1p-1000)
    {
      return false;
    }
  }
  return collinear<Dyadic>(t);
}

} // namespace lumitree::exact
