// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Integration_GaussLegendre_h
#define Lumitree_Radiometry_Integration_GaussLegendre_h

#include "Radiometry/Constants.h"

#include <array>
#include <cmath>

namespace lumitree
{

/// Nodes and weights on [−1, 1], exact for polynomials of degree 2N − 1; by Newton's method on the
/// Legendre polynomial from Tricomi's approximation of its roots.
template <int N>
struct GaussLegendre
{
  std::array<double, N> nodes;
  std::array<double, N> weights;

  GaussLegendre()
  {
    for (int i = 0; i < N; ++i)
    {
      double x = std::cos(pi * (N - i - 0.25) / (N + 0.5));
      double slope = 0.0;
      for (int step = 0; step < 8; ++step)
      {
        double before = 1.0;
        double value = x;
        for (int n = 2; n <= N; ++n)
        {
          const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
          before = value;
          value = next;
        }
        slope = N * (x * value - before) / (x * x - 1.0);
        x -= value / slope;
      }
      this->nodes[i] = x;
      this->weights[i] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
  }

  static const GaussLegendre& rule()
  {
    static const GaussLegendre instance;
    return instance;
  }
};

/// ∫ f from a to b
template <int N, class Function>
double integrate(double a, double b, const Function& f)
{
  const GaussLegendre<N>& rule = GaussLegendre<N>::rule();
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  double sum = 0.0;
  for (int i = 0; i < N; ++i)
  {
    sum += rule.weights[i] * f(middle + half * rule.nodes[i]);
  }
  return half * sum;
}

/// The same of a known first estimate, halving the interval where two halves differ from the whole
/// by more than the tolerance, absolute; at most so many times.
template <int N, class Function>
double refine(double a, double b, double whole, double tolerance, const Function& f, int depth)
{
  const double middle = 0.5 * (a + b);
  const double left = integrate<N>(a, middle, f);
  const double right = integrate<N>(middle, b, f);
  if (depth == 0 || std::fabs(left + right - whole) <= tolerance)
  {
    return left + right;
  }
  return refine<N>(a, middle, left, 0.5 * tolerance, f, depth - 1) +
    refine<N>(middle, b, right, 0.5 * tolerance, f, depth - 1);
}

/// ∫ f from a to b to a tolerance, absolute.
template <int N, class Function>
double integrateTo(double tolerance, double a, double b, const Function& f, int depth = 20)
{
  return refine<N>(a, b, integrate<N>(a, b, f), tolerance, f, depth);
}

/// The same to a tolerance relative to the integral, which is of one sign.
template <int N, class Function>
double integrateAdaptively(double a, double b, double tolerance, const Function& f, int depth = 20)
{
  const double whole = integrate<N>(a, b, f);
  return refine<N>(a, b, whole, tolerance * std::fabs(whole), f, depth);
}

} // namespace lumitree

#endif
