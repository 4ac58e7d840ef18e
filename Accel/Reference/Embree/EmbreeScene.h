// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Reference_Embree_EmbreeScene_h
#define Lumitree_Accel_Reference_Embree_EmbreeScene_h

#include "Accel/Accelerator.h"
#include "Accel/Kernel/RayState.h"

#include <cstddef>
#include <memory>

namespace lumitree
{

/// Embree's tree over the triangles of a surface that can be hit. Any number of threads may query
/// it. The surface must outlive it.
class EmbreeScene
{
public:
  /// Throws std::runtime_error when Embree cannot build,
  /// BuildStopped when it was stopped. It builds with the threads that oneTBB gives.
  EmbreeScene(const Surface& surface, bool robust, JobControl* control);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// The answer for the ray started in the state, whose skipped primitives are left out.
  ///@{
  void closest(RayState& state) const; ///< into state.best
  void any(RayState& state) const;     ///< into state.best
  void all(RayState& state) const;     ///< into state.found, in any order
  ///@}

  /// Bytes that Embree allocated and still holds.
  [[nodiscard]] std::size_t memory() const;

private:
  struct Internals;
  std::unique_ptr<Internals> internals_;
};

} // namespace lumitree

#endif
