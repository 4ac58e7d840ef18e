// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_VisibleShare_h
#define Lumitree_Radiometry_Estimate_VisibleShare_h

#include "Radiometry/Estimate/NetGrid.h"

#include <array>
#include <cstdint>

namespace lumitree
{

/// The visible share of some light, from weighted samples that come in rounds: the first 64, or 64
/// times a power of two, points of a sequence of nets in the unit square, then as many again, and
/// so on. Rays are cast where they are needed.
///
/// Points lie in pairs in cells of the square: how often two of a pair differ says how certain the
/// whole is. (Where an outline goes through a cell, that is more than the error by a fifth, as each
/// is in its own half of it; where what hides is finer than the cells it is the error.)
///
/// The first n = 2^m points lie one in each of n cells of the square, and so do the next n. Where
/// all neighbours of a cell agree, the next point there takes over what the one before has found,
/// and no ray is cast: rays go to the outlines of what hides. Points of a net keep off each other,
/// and so one differs from neighbours that agree about twice as often as by chance: what is taken
/// over is a little wrong on average, by half of what is found alone. So all rays are cast where
/// that is more than a tenth of what is sought; what is left counts as uncertain, and the gap
/// between rays is that of the last net that was cast whole.
class VisibleShare
{
public:
  static constexpr std::uint32_t leastRays = 64;

  /// The points of the round: begin … end - 1.
  ///@{
  [[nodiscard]] std::uint32_t begin() const { return this->begin_; }
  [[nodiscard]] std::uint32_t end() const { return this->end_; }
  ///@}

  /// Lets the first round have as many rays as it takes for gaps between them to come below a share
  /// of all the light; at most that many.
  void startWith(double share, std::uint32_t most);

  /// Whether a point of the round needs no ray; then it is taken account of. slot: for the other
  /// functions.
  bool takeOver(const std::array<double, 2>& point, std::uint32_t& slot);

  /// The sample at a point brings that light, of the order of 1, if it is seen.
  void addLight(std::uint32_t slot, double light);

  /// It is not.
  void hide(std::uint32_t slot, double light);

  /// After a round.
  ///@{
  [[nodiscard]] double all() const { return this->all_; }
  [[nodiscard]] double hiddenShare() const
  {
    return this->all_ > 0.0 ? this->hidden_ / this->all_ : 0.0;
  }
  [[nodiscard]] double halfWidth(); ///< of the interval around the share
  [[nodiscard]] std::uint32_t cast() const { return this->cast_; } ///< points not taken over
  ///@}

  /// Begins a round of as many points as there were. sought: half the interval that is to be
  /// reached; rays are only left out where that does not suffer.
  void goOn(double sought);

private:
  /// Looks at what there is after a round.
  void judge();

  /// Whether rays can be left out in the next round, for what is sought.
  [[nodiscard]] bool canSpare(double sought) const;

  double all_ = 0.0;        ///< Σ f
  double hidden_ = 0.0;     ///< Σ f (1 − V)
  double alone_ = 0.0;      ///< Σ f of points that found what no neighbour did
  double takenAlone_ = 0.0; ///< Σ (2 f)² of those that took it over from such a point
  double perPoint_ = 0.0; ///< variance of Σ f (1 − V − share) over the points, of the last grid
  std::uint32_t begin_ = 0;
  std::uint32_t end_ = leastRays;
  std::uint32_t cast_ = 0;
  std::uint32_t full_ = leastRays; ///< points of the last net whose rays were all cast
  bool sparing_ = false;           ///< rays are left out in this round
  NetGrid before_;                 ///< of the points before the round
  NetGrid now_;                    ///< with those of the round; empty where it would be too large
};

} // namespace lumitree

#endif
