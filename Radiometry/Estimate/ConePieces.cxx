// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Estimate/ConePieces.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// A plane that passes a corner by less than this [rad] passes through it.
constexpr double touching = 0x1p-48;

/// Occluders that are subtracted one by one; more are split among halves of the piece.
constexpr std::size_t few = 12;

constexpr int deepest = 24;

/// Heights of the corners above a plane, those that touch it 0.
struct Heights
{
  double of[ConePiece::capacity];
  bool above = false;
  bool below = false;

  Heights(const ConePiece& piece, const Vec3& normal)
  {
    for (int i = 0; i < piece.count; ++i)
    {
      const Vec3& c = piece.corners[i];
      const double height = dot(normal, c);
      const double limit = touching * (std::fabs(c[0]) + std::fabs(c[1]) + std::fabs(c[2]));
      this->of[i] = std::fabs(height) <= limit ? 0.0 : height;
      this->above = this->above || height > limit;
      this->below = this->below || height < -limit;
    }
  }
};

void split(const ConePiece& piece, const Heights& heights, ConePiece& above, ConePiece& below)
{
  above.count = 0;
  below.count = 0;
  for (int i = 0; i < piece.count; ++i)
  {
    const int j = i + 1 == piece.count ? 0 : i + 1;
    const double a = heights.of[i];
    const double b = heights.of[j];
    if (a >= 0.0)
    {
      above.corners[above.count++] = piece.corners[i];
    }
    if (a <= 0.0)
    {
      below.corners[below.count++] = piece.corners[i];
    }
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0))
    {
      const double share = a / (a - b);
      const Vec3 between = (1.0 - share) * piece.corners[i] + share * piece.corners[j];
      above.corners[above.count++] = between;
      below.corners[below.count++] = between;
    }
  }
}

/// Two halves of a piece with many corners: cutting adds one each time.
void halveFan(const ConePiece& piece, ConePiece& one, ConePiece& two)
{
  const int middle = piece.count / 2;
  one.count = 0;
  two.count = 0;
  for (int i = 0; i <= middle; ++i)
  {
    one.corners[one.count++] = piece.corners[i];
  }
  for (int i = middle; i < piece.count; ++i)
  {
    two.corners[two.count++] = piece.corners[i];
  }
  two.corners[two.count++] = piece.corners[0];
}

/// Halves across the longest side, as it is seen.
void halve(const ConePiece& piece, ConePiece& one, ConePiece& two)
{
  int longest = 0;
  double least = 2.0;
  Vec3 units[ConePiece::capacity] = {};
  for (int i = 0; i < piece.count; ++i)
  {
    units[i] = (1.0 / length(piece.corners[i])) * piece.corners[i];
  }
  for (int i = 0; i < piece.count; ++i)
  {
    const double cosine = dot(units[i], units[i + 1 == piece.count ? 0 : i + 1]);
    if (cosine < least)
    {
      least = cosine;
      longest = i;
    }
  }
  const Vec3 across = units[longest + 1 == piece.count ? 0 : longest + 1] - units[longest];
  // The plane through the middle of that side and the eye, perpendicular to the side.
  split(piece, Heights(piece, (1.0 / length(across)) * across), one, two);
}

} // namespace

void splitPiece(const ConePiece& piece, const Vec3& normal, ConePiece& above, ConePiece& below)
{
  const Heights heights(piece, normal);
  above.count = 0;
  below.count = 0;
  if (!heights.below)
  {
    above = piece;
  }
  else if (!heights.above)
  {
    below = piece;
  }
  else
  {
    split(piece, heights, above, below);
  }
}

bool OccluderCone::assign(const Vec3* corners, int cornerCount, double clearance)
{
  Vec3 area = { 0.0, 0.0, 0.0 };
  for (int i = 2; i < cornerCount; ++i)
  {
    area = area + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  const double areaSize = length(area);
  const double volume = dot(area, corners[0]);
  if (!(std::fabs(volume) > clearance * areaSize))
  {
    return false;
  }
  const double sign = volume > 0.0 ? 1.0 : -1.0;
  this->count = 0;
  for (int i = 0; i < cornerCount; ++i)
  {
    const Vec3 normal = cross(corners[i], corners[i + 1 == cornerCount ? 0 : i + 1]);
    const double squared = dot(normal, normal);
    if (squared > 0.0)
    {
      this->planes[this->count++] = (sign / std::sqrt(squared)) * normal;
    }
  }
  const double distance = dot(corners[0], corners[0]);
  this->size = std::fabs(volume) / (distance * std::sqrt(distance));
  return this->count >= 3;
}

ConeSubtraction::Meeting ConeSubtraction::meets(const OccluderCone& cone, const ConePiece& piece)
{
  ++this->spent_;
  bool covers = true;
  for (int k = 0; k < cone.count; ++k)
  {
    const Heights heights(piece, cone.planes[k]);
    if (!heights.above)
    {
      return Meeting::Outside;
    }
    covers = covers && !heights.below;
  }
  return covers ? Meeting::Covers : Meeting::Crosses;
}

/// From every part.
void ConeSubtraction::subtract(const OccluderCone& cone)
{
  for (std::size_t p = 0; p < this->parts_.size();)
  {
    if (this->parts_[p].count + cone.count > ConePiece::capacity)
    {
      ConePiece one, two;
      halveFan(this->parts_[p], one, two);
      this->parts_[p] = one;
      this->parts_.push_back(two);
    }
    // What is outside of one plane after the other is kept; what is left in the end is hidden.
    ++this->spent_;
    this->fragments_.clear();
    ConePiece inside = this->parts_[p];
    bool outside = false;
    for (int k = 0; k < cone.count; ++k)
    {
      const Heights heights(inside, cone.planes[k]);
      if (!heights.above)
      {
        outside = true; // as a whole: it was cut for nothing
        break;
      }
      if (heights.below)
      {
        ConePiece in, out;
        split(inside, heights, in, out);
        this->fragments_.push_back(out);
        inside = in;
      }
    }
    if (outside)
    {
      ++p;
      continue;
    }
    this->parts_[p] = this->parts_.back();
    this->parts_.pop_back();
    // Fragments need not meet this cone again: they go to the front, what was swapped in stays.
    for (const ConePiece& fragment : this->fragments_)
    {
      this->parts_.push_back(fragment);
      std::swap(this->parts_[p], this->parts_.back());
      ++p;
    }
  }
}

void ConeSubtraction::refine(const ConePiece& piece, std::size_t first, std::size_t last, int depth,
  const std::vector<OccluderCone>& occluders, VisiblePieces& result)
{
  const std::size_t base = this->stack_.size();
  for (std::size_t i = first; i < last; ++i)
  {
    const std::uint32_t id = this->stack_[i];
    const Meeting meeting = this->meets(occluders[id], piece);
    if (meeting == Meeting::Covers)
    {
      this->stack_.resize(base);
      return;
    }
    if (meeting == Meeting::Crosses)
    {
      this->stack_.push_back(id);
    }
  }
  const std::size_t crossing = this->stack_.size() - base;
  if (crossing == 0)
  {
    result.visible.push_back(piece);
  }
  else if (this->spent_ > this->budget_)
  {
    result.undecided.push_back(piece);
  }
  else if (crossing <= few || depth >= deepest)
  {
    this->parts_.assign(1, piece);
    for (std::size_t i = base; i < base + crossing && !this->parts_.empty(); ++i)
    {
      this->subtract(occluders[this->stack_[i]]);
    }
    result.visible.insert(result.visible.end(), this->parts_.begin(), this->parts_.end());
  }
  else
  {
    ConePiece one, two;
    if (piece.count + 2 > ConePiece::capacity)
    {
      halveFan(piece, one, two);
    }
    else
    {
      halve(piece, one, two);
    }
    for (const ConePiece* half : { &one, &two })
    {
      if (half->count >= 3)
      {
        this->refine(*half, base, base + crossing, depth + 1, occluders, result);
      }
    }
  }
  this->stack_.resize(base);
}

void ConeSubtraction::run(const std::vector<ConePiece>& pieces,
  const std::vector<OccluderCone>& occluders, std::size_t budget, VisiblePieces& result)
{
  result.visible.clear();
  result.undecided.clear();
  this->budget_ = budget;
  this->spent_ = 0;
  this->stack_.resize(occluders.size());
  for (std::size_t i = 0; i < occluders.size(); ++i)
  {
    this->stack_[i] = static_cast<std::uint32_t>(i);
  }
  for (const ConePiece& piece : pieces)
  {
    this->refine(piece, 0, occluders.size(), 0, occluders, result);
  }
}

} // namespace lumitree
