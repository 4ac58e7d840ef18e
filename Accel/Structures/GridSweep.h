// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_GridSweep_h
#define Lumitree_Accel_Structures_GridSweep_h

#include "Accel/Kernel/RayBox.h"
#include "Accel/Structures/GridLattice.h"

namespace lumitree
{

/// A ray's way through a lattice: a three-dimensional digital differential analyser (Amanatides &
/// Woo 1987) that keeps intervals in place of numbers.
///
/// Along an axis the ray crosses plane p at t = (p - origin) / direction, always computed from the
/// plane itself. The true t lies within RayBox's pad of the computed one, so the ray is inside a
/// slab for no longer than from the padded t of its near plane to the padded t of its far plane. At
/// any t the slabs of an axis that the ray may be in are therefore one range, nearly always one
/// slab and two close to a crossing. A cell is touched by the closed segment only if its three
/// slabs' intervals have a t in common, and then it is found, once, when the last of the three
/// begins: through a corner all eight cells are. Cells come in ascending order of that t, which is
/// their certified tEnter. An axis with direction ±0 has the slabs that hold the origin, both of
/// them on a plane.
class GridSweep
{
public:
  GridSweep(const GridLattice& lattice, const RayBox& ray);

  /// Goes to the first cells within the closed segment; false where there are none before tStop.
  bool start(double tStop)
  {
    if (!(this->t_ <= this->end_ && this->t_ <= tStop))
    {
      return false;
    }
    this->fresh_ = -1;
    return true;
  }

  /// Goes to the next cells; false where there are none before tStop. inEmptyBlock: the last of the
  /// cells gone to is one of a block (gridBlock) that holds nothing. Then the rest of the block is
  /// left out: the next cells are those at the earliest t at which the ray may leave the block.
  bool advance(double tStop, bool inEmptyBlock = false)
  {
    const int xy = this->axes_[1].begin < this->axes_[0].begin ? 1 : 0;
    const int k = this->axes_[2].begin < this->axes_[xy].begin ? 2 : xy;
    const double t = this->axes_[k].begin;
    if (!(t <= this->end_ && t <= tStop))
    {
      return false;
    }
    this->t_ = t;
    this->fresh_ = k;
    for (Axis& axis : this->axes_)
    {
      while (axis.finish < t)
      {
        ++axis.first;
        axis.finish = later(this->crossing(axis, axis.first + 1));
      }
    }
    if (inEmptyBlock && this->leap())
    {
      return this->t_ <= this->end_ && this->t_ <= tStop;
    }
    Axis& moved = this->axes_[k];
    ++moved.last;
    moved.begin = this->beginAfter(moved);
    return true;
  }

  /// A certified lower bound of t in the cells gone to, never before the segment.
  [[nodiscard]] double tEnter() const { return this->t_; }

  /// Calls visit(cell) for each cell gone to that was not gone to before.
  template <class Visit>
  void forEachCell(const Visit& visit) const
  {
    std::array<int, 3> first;
    for (int k = 0; k < 3; ++k)
    {
      first[k] = k == this->fresh_ ? this->axes_[k].last : this->axes_[k].first;
    }
    for (int z = first[2]; z <= this->axes_[2].last; ++z)
    {
      for (int y = first[1]; y <= this->axes_[1].last; ++y)
      {
        for (int x = first[0]; x <= this->axes_[0].last; ++x)
        {
          visit(this->axes_[0].offset(x) + this->axes_[1].offset(y) + this->axes_[2].offset(z));
        }
      }
    }
  }

private:
  /// Slabs are numbered in the ray's direction here.
  struct Axis
  {
    const double* plane = nullptr; ///< plane 0, the first in the ray's direction
    std::ptrdiff_t step = 1;       ///< to the next plane
    std::ptrdiff_t cell = 0;       ///< of slab 0
    std::ptrdiff_t stride = 1;     ///< to the next slab's cell
    double origin = 0.0;
    double reciprocal = 0.0;
    double direction = 0.0; ///< 1 / reciprocal, roughly
    int count = 1;
    int first = 0; ///< slabs first … last may hold the ray at t
    int last = 0;
    double begin = 0.0;  ///< when the ray may enter slab last + 1
    double finish = 0.0; ///< when the ray has surely left slab first

    [[nodiscard]] std::ptrdiff_t offset(int slab) const { return this->cell + slab * this->stride; }
  };

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double greatest = std::numeric_limits<double>::max();

  static double pad(double t) { return std::fabs(t) * RayBox::relativePad + RayBox::absolutePad; }
  static double earlier(double t) { return t - pad(t); }
  static double later(double t) { return t + pad(t); }

  /// Finite, so that the pad of a t beyond the doubles still has a lower end.
  static double crossing(const Axis& axis, int plane)
  {
    const double t = (axis.plane[plane * axis.step] - axis.origin) * axis.reciprocal;
    return t > greatest ? greatest : (t < -greatest ? -greatest : t);
  }

  static double beginAfter(const Axis& axis)
  {
    return axis.last + 1 < axis.count ? earlier(crossing(axis, axis.last + 1)) : infinity;
  }

  /// The plane, in the ray's direction, at which it leaves the block of its last slab.
  static int blockEnd(const Axis& axis)
  {
    if (axis.step > 0)
    {
      return std::min((axis.last / gridBlock + 1) * gridBlock, axis.count);
    }
    return axis.count - (axis.count - 1 - axis.last) / gridBlock * gridBlock;
  }

  /// Goes to the end of an empty block; false where the ray may be in more cells than one of it,
  /// and where the next step leads as far.
  bool leap();

  /// The slab of an axis that the ray is near at t, in the ray's direction.
  [[nodiscard]] int slabAt(int k) const;

  void placeStill(Axis& axis, bool unknown);
  void placeMoving(Axis& axis, int guess);

  const GridLattice& lattice_;
  std::array<Axis, 3> axes_;
  double t_;
  double end_;
  int fresh_ = -1; ///< the axis whose last slab is new, -1 at the start
};

} // namespace lumitree

#endif
