// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_RaysEmbree_h
#define Lumitree_Testing_Benchmarks_RaysEmbree_h

#include "RaysScenes.h"

#include <memory>

namespace lumitree::benchmarks
{

/// Embree by its own interface, without ours around it: rays come from the same arrays, and hits go
/// to the same.
class RawEmbree
{
public:
  RawEmbree(const Scene& scene, bool robust);
  ~RawEmbree();
  RawEmbree(const RawEmbree&) = delete;
  RawEmbree& operator=(const RawEmbree&) = delete;

  /// One by one, or in packets of 8 or 16.
  ///@{
  void closest(const Rays& rays, unsigned int packet, Hit* hits) const;
  void any(const Rays& rays, unsigned int packet, std::uint8_t* hit) const;
  ///@}

  [[nodiscard]] std::size_t memory() const;
  [[nodiscard]] double commitSeconds()
    const; ///< processor time of rtcCommitScene with one thread, else the clock's
  [[nodiscard]] std::string version() const;

private:
  struct Internals;
  std::unique_ptr<Internals> internals_;
};

} // namespace lumitree::benchmarks

#endif
