// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_Trees_h
#define Lumitree_Testing_Accel_Trees_h

#include "Accel/Quadric.h"

/// Implicit trees written as expressions.
namespace lumitree::testing
{

inline ImplicitTree leaf(const QuadricForm& form)
{
  ImplicitTree tree;
  tree.forms = { form };
  tree.steps = { { ImplicitTree::Operation::Form, 0 } };
  return tree;
}

inline ImplicitTree leaf(const Superquadric& superquadric)
{
  ImplicitTree tree;
  tree.superquadrics = { superquadric };
  tree.steps = { { ImplicitTree::Operation::Superquadric, 0 } };
  return tree;
}

inline ImplicitTree ball(const Vec3& centre, double radius)
{
  return leaf(Quadric::sphere(centre, radius).form);
}

inline ImplicitTree then(ImplicitTree tree, ImplicitTree::Operation operation)
{
  tree.steps.push_back({ operation, 0 });
  return tree;
}

inline ImplicitTree joined(
  ImplicitTree tree, const ImplicitTree& other, ImplicitTree::Operation operation)
{
  for (ImplicitTree::Step step : other.steps)
  {
    step.index += static_cast<std::int32_t>(step.operation == ImplicitTree::Operation::Form
        ? tree.forms.size()
        : (step.operation == ImplicitTree::Operation::Superquadric ? tree.superquadrics.size()
                                                                   : 0));
    tree.steps.push_back(step);
  }
  tree.forms.insert(tree.forms.end(), other.forms.begin(), other.forms.end());
  tree.superquadrics.insert(
    tree.superquadrics.end(), other.superquadrics.begin(), other.superquadrics.end());
  return then(std::move(tree), operation);
}

inline ImplicitTree operator|(const ImplicitTree& a, const ImplicitTree& b)
{
  return joined(a, b, ImplicitTree::Operation::Minimum);
}

inline ImplicitTree operator&(const ImplicitTree& a, const ImplicitTree& b)
{
  return joined(a, b, ImplicitTree::Operation::Maximum);
}

inline ImplicitTree operator-(const ImplicitTree& a)
{
  return then(a, ImplicitTree::Operation::Negation);
}

inline ImplicitTree operator-(const ImplicitTree& a, const ImplicitTree& b)
{
  return a & -b;
}

inline ImplicitTree halfSpace(const Vec3& point, const Vec3& normal)
{
  return leaf(Quadric::plane(point, normal, Box{}).form);
}

inline ImplicitTree brick(const Vec3& lower, const Vec3& upper)
{
  return (halfSpace(lower, { -1, 0, 0 }) & halfSpace(upper, { 1, 0, 0 })) &
    (halfSpace(lower, { 0, -1, 0 }) & halfSpace(upper, { 0, 1, 0 })) &
    (halfSpace(lower, { 0, 0, -1 }) & halfSpace(upper, { 0, 0, 1 }));
}

inline Box boxOf(double lower, double upper)
{
  return { { lower, lower, lower }, { upper, upper, upper } };
}

inline std::vector<Quadric> zerosOf(const ImplicitTree& tree, const Box& box)
{
  return Quadric::zerosOf(std::make_shared<const ImplicitTree>(tree), box);
}

} // namespace lumitree::testing

#endif
