// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Parallel.h"
#include "Accel/Save.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/uuid.hpp>

#include <algorithm>

namespace lumitree
{
namespace
{

constexpr std::size_t chunk = 1 << 18;

/// The fingerprints of pieces of memory, each after the other.
class Pieces
{
public:
  explicit Pieces(int threads)
    : threads_(threads)
  {
  }

  void add(const void* data, std::size_t size)
  {
    const std::size_t first = this->of_.size();
    this->of_.resize(first + (size + chunk - 1) / chunk);
    const auto* const bytes = static_cast<const char*>(data);
    parallelFor(this->of_.size() - first, 1, this->threads_, nullptr,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->of_[first + i] = hash(bytes + i * chunk, std::min(chunk, size - i * chunk));
        }
      });
  }

  [[nodiscard]] Fingerprint all() const
  {
    const boost::uuids::uuid whole =
      hash(this->of_.data(), this->of_.size() * sizeof(boost::uuids::uuid));
    Fingerprint fingerprint;
    std::copy(whole.begin(), whole.end(), fingerprint.begin());
    return fingerprint;
  }

private:
  static boost::uuids::uuid hash(const void* data, std::size_t size)
  {
    return boost::uuids::name_generator_sha1(boost::uuids::nil_uuid())(data, size);
  }

  int threads_;
  std::vector<boost::uuids::uuid> of_;
};

/// All numbers of a quadric: the structure itself may have gaps.
std::array<double, 46> numbersOf(const Quadric& q)
{
  std::array<double, 46> numbers;
  auto out = numbers.begin();
  const auto put = [&](const auto& values) { out = std::copy(values.begin(), values.end(), out); };
  for (const QuadricForm* form : { &q.form, &q.bound })
  {
    put(form->centre);
    put(form->coefficients);
    *out++ = form->residue;
  }
  put(q.clip.lower);
  put(q.clip.upper);
  for (const QuadricCut& cut : q.cuts)
  {
    put(cut.normal);
    put(cut.point);
  }
  return numbers;
}

/// Of the quadrics' trees, and of the implicits.
std::vector<double> numbersOfBodies(const Surface& surface)
{
  std::vector<double> all;
  const auto put = [&](const auto& values) { all.insert(all.end(), values.begin(), values.end()); };
  const ImplicitTree* last = nullptr;
  for (std::size_t i = surface.triangleCount(); i < surface.size(); ++i)
  {
    const auto id = static_cast<PrimitiveId>(i);
    if (surface.isQuadric(id))
    {
      const ImplicitTree* const tree = surface.quadric(id).tree.get();
      if (tree && tree != last)
      {
        all.push_back(static_cast<double>(i));
        put(tree->numbers());
      }
      last = tree;
      continue;
    }
    const Implicit& implicit = surface.implicit(id);
    const std::vector<double> numbers = implicit.function->numbers();
    if (numbers.empty())
    {
      throw SaveError("structures over functions that are only sampled are not saved");
    }
    put(implicit.clip.lower);
    put(implicit.clip.upper);
    all.push_back(implicit.step);
    put(numbers);
  }
  return all;
}

} // namespace

Fingerprint fingerprintOf(const Surface& surface, int threads)
{
  Pieces pieces(threads);
  const std::array<std::uint64_t, 4> counts = { surface.pointCount(), surface.triangleCount(),
    surface.quadricCount(), surface.scalar() == ArrayView::Scalar::Float ? 4u : 8u };
  pieces.add(counts.data(), sizeof(counts));
  pieces.add(surface.pointData(), 3 * counts[0] * counts[3]);
  pieces.add(surface.triangles().data(), surface.triangleCount() * sizeof(Triangle));
  std::vector<std::array<double, 46>> quadrics;
  for (std::size_t i = 0; i < surface.quadricCount(); ++i)
  {
    quadrics.push_back(
      numbersOf(surface.quadric(static_cast<PrimitiveId>(surface.triangleCount() + i))));
  }
  pieces.add(quadrics.data(), quadrics.size() * sizeof(quadrics[0]));
  const std::vector<double> bodies = numbersOfBodies(surface);
  pieces.add(bodies.data(), bodies.size() * sizeof(double));
  return pieces.all();
}

} // namespace lumitree
