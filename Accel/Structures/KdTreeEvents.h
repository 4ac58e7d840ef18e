// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_KdTreeEvents_h
#define Lumitree_Accel_Structures_KdTreeEvents_h

#include "Accel/BuildProgress.h"
#include "Accel/Hit.h"
#include "Accel/Structures/KdTreeNodes.h"

#include <array>
#include <vector>

namespace lumitree
{

/// A triangle in a cell while a KD-tree is built.
struct KdReference
{
  Box bounds; ///< of its part inside the cell, rounded outward
  PrimitiveId id = noPrimitive;
};

/// Where, on one axis, the bounds of a reference begin, end, or lie in one plane.
struct KdEvent
{
  enum Kind : std::uint32_t
  {
    End = 0, ///< kinds at one position come in this order
    Flat = 1,
    Begin = 2
  };

  double position = 0.0;
  std::uint32_t code = 0; ///< the reference's index, then two bits for the kind

  [[nodiscard]] Kind kind() const { return static_cast<Kind>(this->code & 3u); }
  [[nodiscard]] std::uint32_t reference() const { return this->code >> 2; }

  friend bool operator<(const KdEvent& a, const KdEvent& b)
  {
    return a.position < b.position || (a.position == b.position && a.kind() < b.kind());
  }
};

/// What an index in a KdEvent can say.
inline constexpr std::size_t mostKdReferences = std::size_t{ 1 } << 30;

inline void appendEvents(
  const Box& bounds, int axis, std::uint32_t reference, std::vector<KdEvent>& events)
{
  const double lower = bounds.lower[axis];
  const double upper = bounds.upper[axis];
  if (lower == upper)
  {
    events.push_back({ lower, reference << 2 | KdEvent::Flat });
    return;
  }
  events.push_back({ lower, reference << 2 | KdEvent::Begin });
  events.push_back({ upper, reference << 2 | KdEvent::End });
}

/// The events of all references on all axes, sorted, in parallel. The only sort of whole lists: who
/// divides a cell keeps the order (Wald and Havran 2006, section 4.3). Advances the stage by
/// kdSortWork per reference.
[[nodiscard]] std::array<std::vector<KdEvent>, 3> sortedEvents(
  const std::vector<KdReference>& references, BuildProgress& progress);
inline constexpr std::size_t kdSortWork = 6;

/// Where the references of a cell go when it is divided, by the index they have in it: to one of
/// two sides whole, or not as they are.
class KdSideMap
{
public:
  static constexpr std::uint32_t neither = 2; ///< it has parts with events of their own, or none

  void reset(std::size_t references)
  {
    this->codes_.resize(references);
    this->whole_ = {};
  }
  void set(std::size_t reference, std::uint32_t side, std::size_t index)
  {
    this->codes_[reference] = static_cast<std::uint32_t>(index) << 2 | side;
    ++this->whole_[side];
  }
  /// How many go to a side as they are.
  [[nodiscard]] std::size_t whole(std::uint32_t side) const { return this->whole_[side]; }
  [[nodiscard]] std::uint32_t side(std::uint32_t reference) const
  {
    return this->codes_[reference] & 3u;
  }
  /// On its side.
  [[nodiscard]] std::uint32_t index(std::uint32_t reference) const
  {
    return this->codes_[reference] >> 2;
  }

private:
  std::vector<std::uint32_t> codes_;
  std::array<std::size_t, 3> whole_{};
};

/// The events of one side in order: those of the references that go there whole, and the new ones
/// of parts, which are sorted and left empty. `side` is overwritten.
void takeEvents(const std::vector<KdEvent>& all, const KdSideMap& sides, std::uint32_t which,
  std::vector<KdEvent>& fresh, std::vector<KdEvent>& side);

} // namespace lumitree

#endif
