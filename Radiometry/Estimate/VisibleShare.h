// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_VisibleShare_h
#define Lumitree_Radiometry_Estimate_VisibleShare_h

#include <array>
#include <cstdint>

namespace lumitree
{

/// The visible share of some light, from weighted rays that come in rounds: the first 64, or 64
/// times a power of two, of a sequence, then as many again, and so on.
///
/// The interval is of the means of eight blocks of the sequence: each block is a net, as even as
/// the whole, and what one leaves out others have, so that the mean of all is better than eight
/// independent ones would be.
class VisibleShare
{
public:
  static constexpr std::uint32_t blockCount = 8;
  static constexpr std::uint32_t leastRays = 8 * blockCount;

  /// The rays of the round: begin … end - 1.
  ///@{
  [[nodiscard]] std::uint32_t begin() const { return this->begin_; }
  [[nodiscard]] std::uint32_t end() const { return this->end_; }
  ///@}

  /// Lets the first round have as many rays as it takes to come below a share of all the light, at
  /// most that many.
  void startWith(double share, std::uint32_t most);

  /// The block of ray begin + i.
  [[nodiscard]] std::uint32_t block(std::uint32_t i) const
  {
    return this->firstBlock_ + i / this->perBlock_;
  }

  void addLight(std::uint32_t block, double light)
  {
    this->blocks_[block].all += light;
    this->all_ += light;
  }
  void addHidden(std::uint32_t block, double light)
  {
    this->blocks_[block].hidden += light;
    this->hidden_ += light;
  }

  /// After a round.
  ///@{
  [[nodiscard]] double all() const { return this->all_; }
  [[nodiscard]] double hiddenShare() const
  {
    return this->all_ > 0.0 ? this->hidden_ / this->all_ : 0.0;
  }
  [[nodiscard]] double halfWidth() const; ///< of the interval around the share
  ///@}

  /// Begins a round of as many rays as there were.
  void goOn();

private:
  /// Sums over the samples of one block.
  struct Sums
  {
    double all = 0.0;    ///< Σ f
    double hidden = 0.0; ///< Σ f (1 − V)
  };

  std::array<Sums, blockCount> blocks_;
  double all_ = 0.0;
  double hidden_ = 0.0;
  std::uint32_t begin_ = 0;
  std::uint32_t end_ = leastRays;
  std::uint32_t firstBlock_ = 0;
  std::uint32_t perBlock_ = leastRays / blockCount;
};

} // namespace lumitree

#endif
