// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_NetGrid_h
#define Lumitree_Radiometry_Estimate_NetGrid_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumitree
{

/// What the points of a net found, one in each of 2^bits cells of the unit square: as many columns
/// as rows, or twice as many.
class NetGrid
{
public:
  /// What is found at a point.
  enum State : std::uint8_t
  {
    Nothing = 0, ///< no light comes from there
    Lit = 1,
    Hidden = 2
  };

  /// All cells Nothing; bits < 0: no cells.
  void reset(int bits);

  [[nodiscard]] bool empty() const { return this->lights_.empty(); }
  [[nodiscard]] int bits() const { return this->columnBits_ + this->rowBits_; }
  [[nodiscard]] std::size_t size() const { return this->lights_.size(); }

  /// The cell of a point; each coordinate in (0, 1).
  [[nodiscard]] std::uint32_t cell(const std::array<double, 2>& point) const
  {
    return static_cast<std::uint32_t>(point[0] * this->columns_) << this->rowBits_ |
      static_cast<std::uint32_t>(point[1] * this->rows_);
  }

  /// Of a cell of this grid: the one of the grid of half as many in which it lies, and the other
  /// one of this grid in there.
  ///@{
  [[nodiscard]] std::uint32_t parent(std::uint32_t cell) const
  {
    const std::uint32_t row = cell & ((1u << this->rowBits_) - 1);
    return this->columnBits_ > this->rowBits_ ? cell >> (this->rowBits_ + 1) << this->rowBits_ | row
                                              : cell >> 1;
  }
  [[nodiscard]] std::uint32_t twin(std::uint32_t cell) const
  {
    return cell ^ (this->columnBits_ > this->rowBits_ ? 1u << this->rowBits_ : 1u);
  }
  ///@}

  void set(std::uint32_t cell, State state, float light)
  {
    this->states_[this->padded(cell)] = state;
    this->lights_[cell] = light;
  }
  [[nodiscard]] State state(std::uint32_t cell) const
  {
    return static_cast<State>(this->states_[this->padded(cell)]);
  }
  [[nodiscard]] float light(std::uint32_t cell) const { return this->lights_[cell]; }

  /// Looks at the neighbours of all cells, for agreed.
  void compareNeighbours();

  /// What the eight neighbours of a cell agree on (fewer at the border); Nothing where they do not.
  [[nodiscard]] State agreed(std::uint32_t cell) const
  {
    const std::uint8_t found = this->around_[this->padded(cell)];
    return found == Lit || found == Hidden ? static_cast<State>(found) : Nothing;
  }

private:
  /// A border of nothing, in bytes, is around the states.
  [[nodiscard]] std::size_t padded(std::uint32_t cell) const
  {
    const std::size_t column = cell >> this->rowBits_;
    const std::size_t row = cell & ((1u << this->rowBits_) - 1);
    return (column + 1) * this->stride_ + row + 1;
  }

  int columnBits_ = 0;
  int rowBits_ = 0;
  double columns_ = 1.0;
  double rows_ = 1.0;
  std::size_t stride_ = 0;
  std::vector<float> lights_;
  std::vector<std::uint8_t> states_; ///< padded
  std::vector<std::uint8_t> threes_; ///< padded: states of a cell and its neighbours in the column
  std::vector<std::uint8_t> around_; ///< padded
};

} // namespace lumitree

#endif
