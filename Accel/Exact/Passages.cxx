// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Exact/Passages.h"

#include "Accel/Exact/Moved.h"
#include "Accel/Exact/QuadraticFormulas.h"

#include <vector>

namespace lumitree::exact
{
namespace
{

using Along = BasicQuadratic<Moved>;
using Root = BasicRoot<Moved>;

/// A form on both sides of a root.
struct Sides
{
  int before;
  int after;
};

bool changesTree(const Ray& ray, const Quadric& quadric, const Root& root)
{
  const ImplicitTree& tree = *quadric.tree;
  std::vector<Sides> sides;
  bool first = true; // no form before has been 0
  for (const QuadricForm& form : tree.forms)
  {
    const Along along = Along::along(ray, form);
    const int sign = signAt(along, root);
    if (sign != 0)
    {
      sides.push_back({ sign, sign });
      continue;
    }
    if (first && !(form == quadric.form))
    {
      return false;
    }
    first = false;
    const int slope = signAt(along.derivative(), root);
    const int curve = along.a.sign();
    sides.push_back(slope != 0 ? Sides{ -slope, slope } : Sides{ curve, curve });
  }
  const int before = signOf(tree, [&](std::size_t i) { return sides[i].before; });
  const int after = signOf(tree, [&](std::size_t i) { return sides[i].after; });
  return before * after < 0;
}

} // namespace

std::array<bool, 2> movedPassages(const Ray& ray, const Quadric& quadric)
{
  std::array<bool, 2> passes = { false, false };
  Root root{ Along::along(ray, quadric.form), 0 };
  const bool linear = root.of.a.sign() == 0;
  const int count = root.of.roots();
  // A double root, whatever the move, changes no sign.
  for (; count == (linear ? 1 : 2) && root.index < count; ++root.index)
  {
    passes[static_cast<std::size_t>(root.index)] = compare(root, ray.tMin) > 0 &&
      compare(root, ray.tMax) <= 0 && isWithinBounds(ray, quadric, root) &&
      (!quadric.tree || changesTree(ray, quadric, root));
  }
  return passes;
}

} // namespace lumitree::exact
