// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Fuzz_FuzzInput_h
#define Lumitree_Testing_Fuzz_FuzzInput_h

#include "Testing/Accel/TestHelpers.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// Surfaces, options and rays out of a fuzzer's bytes.
namespace lumitree::testing
{

/// A finding: libFuzzer keeps the input when the process aborts.
inline void require(bool condition, const char* what, const BuildOptions& options)
{
  if (!condition)
  {
    std::fprintf(stderr, "%s: %s\n", label(options).c_str(), what);
    std::abort();
  }
}

/// Reads bytes one after the other; zeros after the end.
class FuzzInput
{
public:
  FuzzInput(const std::uint8_t* data, std::size_t size)
    : data_(data)
    , size_(size)
  {
  }

  [[nodiscard]] bool empty() const { return this->size_ == 0; }

  std::uint8_t byte()
  {
    if (this->size_ == 0)
    {
      return 0;
    }
    --this->size_;
    return *this->data_++;
  }

  /// A number that matters: a small integer or fraction, a limit of the format, a neighbour of the
  /// last one, or any bits.
  double number()
  {
    static const double special[] = { 0.0, -0.0, 1e300, -1e300, 1e301, std::nan(""), HUGE_VAL,
      -HUGE_VAL, 0x1p-1074, -0x1p-1022, 0x1p-149, 1e-30, 1e20, 0x1p60, 0x1p-60, 0x1.fffffep127, 0.1,
      1.0 / 3.0, 500000.25, 4649776.125 };
    const std::uint8_t kind = this->byte();
    if (kind < 160)
    {
      this->last_ = static_cast<double>(static_cast<std::int8_t>(this->byte()) % 9);
    }
    else if (kind < 190)
    {
      this->last_ = static_cast<double>(static_cast<std::int8_t>(this->byte())) / 16.0;
    }
    else if (kind < 220)
    {
      this->last_ = std::nextafter(this->last_, kind % 2 == 0 ? HUGE_VAL : -HUGE_VAL);
    }
    else if (kind < 245)
    {
      this->last_ = special[this->byte() % (sizeof(special) / sizeof(double))];
    }
    else
    {
      std::uint64_t bits = 0;
      for (int i = 0; i < 8; ++i)
      {
        bits = bits << 8 | this->byte();
      }
      std::memcpy(&this->last_, &bits, sizeof(double));
    }
    return this->last_;
  }

  Vec3 point()
  {
    const double x = this->number();
    const double y = this->number();
    return { x, y, this->number() };
  }

  /// Up to so many triangles over a few points, which they share.
  std::shared_ptr<const Surface> surface(std::size_t limit)
  {
    const bool floats = this->byte() % 2 == 0;
    const std::size_t pointCount = 3 + this->byte() % limit;
    const std::size_t count = this->byte() % (limit + 1);
    std::vector<double> points;
    for (std::size_t i = 0; i < pointCount; ++i)
    {
      const Vec3 p = this->point();
      points.insert(points.end(), p.begin(), p.end());
    }
    std::vector<Triangle> triangles(count);
    for (Triangle& triangle : triangles)
    {
      for (std::uint32_t& corner : triangle)
      {
        corner = static_cast<std::uint32_t>(this->byte() % pointCount);
      }
    }
    if (!floats)
    {
      return std::make_shared<const Surface>(
        PointArray::from(std::move(points)), std::move(triangles));
    }
    std::vector<float> singles;
    for (const double x : points)
    {
      // Converting what floats cannot hold is undefined.
      singles.push_back(std::fabs(x) > std::numeric_limits<float>::max() && std::isfinite(x)
          ? std::numeric_limits<float>::infinity()
          : static_cast<float>(x));
    }
    return std::make_shared<const Surface>(
      PointArray::from(std::move(singles)), std::move(triangles));
  }

  Ray ray()
  {
    Ray r;
    r.origin = this->point();
    r.direction = this->point();
    if (this->byte() % 4 == 0)
    {
      r.tMin = this->number();
      r.tMax = this->number();
    }
    return r;
  }

private:
  const std::uint8_t* data_;
  std::size_t size_;
  double last_ = 1.0;
};

} // namespace lumitree::testing

#endif
