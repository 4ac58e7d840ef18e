// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/GeneralSky.h"

#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Frame.h"
#include "Radiometry/Integration/GaussLegendre.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <utility>

namespace lumitree
{

namespace
{

/// Of unit vectors.
double angleBetween(const Vec3& a, const Vec3& b)
{
  const double cosine = dot(a, b);
  constexpr double safe = 0.9; // nearer to ±1 the cosine has lost digits of the angle
  return std::fabs(cosine) < safe ? std::acos(cosine) : std::atan2(length(cross(a, b)), cosine);
}

/// ∫ f over an interval at whose ends f may begin like a square root.
template <class Function>
double integrateRoots(double a, double b, double tolerance, const Function& f)
{
  return integrateTo<10>(
    tolerance, 0.0, 0.5 * pi,
    [&](double t)
    {
      const double sine = std::sin(t);
      return 2.0 * (b - a) * sine * std::cos(t) * f(a + (b - a) * sine * sine);
    },
    6);
}

/// √(1 − cosine of the angle to the sun) up to which its part of the radiance is in a table:
/// beyond, near the point opposite it, the angle is not smooth in that.
constexpr double mostTabled = 1.3;

// Absolute: of sky and of a ring of it, whose relative radiances are of the order of 1.
constexpr double skyTolerance = 5e-11;
constexpr double ringTolerance = 1e-12;

struct Remembered
{
  std::uint64_t sky = 0;
  Vec3 normal = { 0.0, 0.0, 0.0 };
  double value = 0.0;
};

Remembered& remembered(std::uint64_t sky, const Vec3& normal)
{
  thread_local std::array<Remembered, 256> entries;
  std::uint64_t hash = sky;
  for (const double component : normal)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &component, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 29;
  }
  return entries[hash % entries.size()];
}

} // namespace

GeneralSky::GeneralSky(const SkyDistribution& distribution, const Vec3& towardsSun,
  const SkyLevel& level, const Vec3& up, double groundRadiance)
  : SkySource(up, groundRadiance)
  , distribution_(distribution)
  , towardsSun_(checks::unit(towardsSun, "The direction to the sun"))
{
  static std::atomic<std::uint64_t> count{ 0 };
  this->identity_ = ++count;
  const double value = checkedLevel(level);
  if (!distribution.isRound() && dot(this->towardsSun_, this->up()) < -1e-12)
  {
    throw std::invalid_argument("The sun of this sky is below the horizon.");
  }
  const auto all = [&](const Vec3& axis)
  { return this->overSky([&](const Vec3& w) { return dot(w, axis); }, nullptr); };
  const double horizontal = all(this->up());
  const double own =
    level.kind == SkyLevel::Kind::ZenithRadiance ? this->relative(this->up()) : horizontal;
  if (!(own > 0.0))
  {
    throw std::invalid_argument("This distribution makes no sky: it is not positive.");
  }
  this->scale_ = value / own;
  this->makeTables();
  this->scalar_ = this->scale_ * this->overSky([](const Vec3&) { return 1.0; }, nullptr);
  this->vector_ = (this->scale_ * horizontal) * this->up();
  const Vec3 side = cross(this->up(), this->towardsSun_);
  const double size = length(side);
  if (size > 0.0)
  {
    const Vec3 azimuth = (1.0 / size) * cross(side, this->up());
    this->vector_ = this->vector_ + (this->scale_ * all(azimuth)) * azimuth;
  }
}

void GeneralSky::makeTables()
{
  const SkyDistribution& d = this->distribution_;
  if (d.a != 0.0 && d.b > 0.0)
  {
    return; // bent at the horizon
  }
  constexpr std::size_t steps = 512;
  this->gradation_ = HermiteTable(1.0, steps,
    [&](double sine)
    {
      const double slope = sine > 0.0 ? -d.a * d.b / (sine * sine) * std::exp(d.b / sine) : 0.0;
      return std::pair(d.gradation(sine), d.a == 0.0 ? 0.0 : slope);
    });
  // χ = 2 asin(x / √2), of which dχ/dx = 2 / √(2 − x²).
  this->indicatrix_ = HermiteTable(mostTabled, steps,
    [&](double x)
    {
      const double chi = 2.0 * std::asin(x / std::sqrt(2.0));
      const double cosine = 1.0 - x * x;
      const double slope =
        d.c * d.d * std::exp(d.d * chi) * 2.0 / std::sqrt(2.0 - x * x) - 4.0 * d.e * cosine * x;
      return std::pair(d.indicatrix(chi, cosine), slope);
    });
}

double GeneralSky::radianceOfSample(const Vec3& direction) const
{
  const double sine = dot(direction, this->up());
  const double x = std::sqrt(std::max(0.0, 1.0 - dot(direction, this->towardsSun_)));
  if (this->gradation_.empty() || !(sine >= 0.0) || !(x <= mostTabled))
  {
    return this->radianceFrom(direction);
  }
  return this->scale_ * std::max(0.0, this->gradation_(std::min(1.0, sine)) * this->indicatrix_(x));
}

double GeneralSky::relative(const Vec3& direction) const
{
  const double toZenith = std::clamp(dot(direction, this->up()), 0.0, 1.0);
  const double cosine = std::clamp(dot(direction, this->towardsSun_), -1.0, 1.0);
  return std::max(0.0,
    this->distribution_.gradation(toZenith) *
      this->distribution_.indicatrix(angleBetween(direction, this->towardsSun_), cosine));
}

double GeneralSky::skyRadiance(const Vec3& direction) const
{
  return this->scale_ * this->relative(direction);
}

template <class Kernel>
double GeneralSky::overSky(const Kernel& kernel, const Vec3* normal) const
{
  // Rings around the sun, where the corona has its tip; of a round sky, around the zenith.
  const Vec3 pole = this->distribution_.isRound() ? this->up() : this->towardsSun_;
  const Frame frame = Frame::around(pole);

  // The arcs of a ring that are above both planes, and where rings begin to be cut or to be whole:
  // where they touch a plane, and where both planes meet.
  std::array<const Vec3*, 2> planes = { &this->up(), normal };
  const int planeCount = normal ? 2 : 1;
  std::array<double, 18> marks = { 0.0, pi }; // 8 at most
  std::size_t markCount = 2;
  for (int i = 0; i < planeCount; ++i)
  {
    const double touch = std::fabs(0.5 * pi - angleBetween(pole, *planes[i]));
    marks[markCount++] = touch;
    marks[markCount++] = pi - touch;
  }
  if (normal)
  {
    const Vec3 edge = cross(*normal, this->up());
    const double size = length(edge);
    if (size > 1e-12)
    {
      const double meet = angleBetween(pole, (1.0 / size) * edge);
      marks[markCount++] = meet;
      marks[markCount++] = pi - meet;
    }
  }
  std::sort(marks.begin(), marks.begin() + static_cast<std::ptrdiff_t>(markCount));

  const auto ring = [&](double chi)
  {
    const double sine = std::sin(chi);
    const double cosine = std::cos(chi);
    std::array<double, 18> cuts = { -pi, pi }; // 6 at most; smaller ones confuse gcc 12
    std::size_t cutCount = 2;
    for (int i = 0; i < planeCount; ++i)
    {
      const Vec3 local = frame.toLocal(*planes[i]);
      const double amplitude = sine * std::hypot(local[0], local[1]);
      const double sought = -cosine * local[2];
      if (std::fabs(sought) < amplitude)
      {
        const double middle = std::atan2(local[1], local[0]);
        const double half = std::acos(sought / amplitude);
        for (const double cut : { middle - half, middle + half })
        {
          cuts[cutCount++] = std::remainder(cut, 2.0 * pi);
        }
      }
    }
    std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(cutCount));
    const auto at = [&](double psi) {
      return frame.toWorld({ sine * std::cos(psi), sine * std::sin(psi), cosine });
    };
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < cutCount; ++i)
    {
      const Vec3 middle = at(0.5 * (cuts[i] + cuts[i + 1]));
      if (cuts[i] < cuts[i + 1] && dot(middle, this->up()) > 0.0 &&
        (!normal || dot(middle, *normal) > 0.0))
      {
        sum += integrateTo<8>(
          ringTolerance, cuts[i], cuts[i + 1],
          [&](double psi)
          {
            const Vec3 w = at(psi);
            return this->distribution_.gradation(dot(w, this->up())) * kernel(w);
          },
          8);
      }
    }
    return sum == 0.0 ? 0.0
                      : sum * sine * std::max(0.0, this->distribution_.indicatrix(chi, cosine));
  };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < markCount; ++i)
  {
    if (marks[i + 1] - marks[i] > 1e-14)
    {
      sum += integrateRoots(marks[i], marks[i + 1], skyTolerance, ring);
    }
  }
  return sum;
}

double GeneralSky::skyIrradiance(const Vec3& normal) const
{
  Remembered& entry = remembered(this->identity_, normal);
  if (entry.sky != this->identity_ || entry.normal != normal)
  {
    entry.sky = this->identity_;
    entry.normal = normal;
    entry.value = std::max(
      0.0, this->scale_ * this->overSky([&](const Vec3& w) { return dot(w, normal); }, &normal));
  }
  return entry.value;
}

} // namespace lumitree
