// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Kernel_BundlePlan_h
#define Lumitree_Accel_Kernel_BundlePlan_h

#include "Accel/Kernel/RadixOrder.h"
#include "Accel/Ray.h"

#include <cstdint>
#include <vector>

namespace lumitree
{

/// Which rays of a chunk go together: those that start in one point, sorted by direction into
/// square tiles, whatever the order in which they come (the pixels of a camera row by row, the
/// directions of a sensor at random).
class BundlePlan
{
public:
  /// Rays order[first] … order[first + count - 1], of one octant and one dominant axis.
  struct Bundle
  {
    std::uint32_t first;
    std::uint32_t count;
    int axis;
    float spread; ///< width of the range of direction / direction[axis]
  };

  /// Whether it is worth asking: the first rays of the batch start in one point.
  [[nodiscard]] static bool mayPay(const RayBatch& rays);

  /// For rays [begin, end) of the batch.
  void make(const RayBatch& rays, std::size_t begin, std::size_t end);

  [[nodiscard]] const std::vector<Bundle>& bundles() const { return this->bundles_; }
  [[nodiscard]] const std::size_t* members(const Bundle& bundle) const
  {
    return this->order_.data() + bundle.first;
  }

  /// Rays that go alone, those that are not valid among them; a bundle can be sent to join them.
  ///@{
  [[nodiscard]] const std::vector<std::size_t>& alone() const { return this->alone_; }
  void separate(const Bundle& bundle);
  void separate(std::size_t ray) { this->alone_.push_back(ray); }
  ///@}

private:
  /// The direction as a place on the face of a cube.
  struct Place
  {
    float u;
    float v;
    std::uint32_t ray;
    std::uint32_t sector; ///< octant and dominant axis
  };

  void addRun(const RayBatch& rays, std::size_t first, std::size_t last);
  template <class T>
  void place(const T* directions, const RayBatch& rays, std::size_t first, std::size_t last);
  /// By sector, then along a Morton curve over the face; as they came where these are equal.
  void sort();
  void cut();

  std::size_t begin_ = 0;
  float low_ = 0.0f; ///< the range of the places' u and v
  float high_ = 0.0f;
  std::vector<Place> places_;
  std::vector<Place> sorted_;
  std::vector<std::uint32_t> keys_;
  RadixOrder byKey_;
  std::vector<std::size_t> order_;
  std::vector<Bundle> bundles_;
  std::vector<std::size_t> alone_;
};

} // namespace lumitree

#endif
