// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Benchmarks_RaysEmbree_h
#define Lumitree_Testing_Benchmarks_RaysEmbree_h

#include "RaysScenes.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lumitree::benchmarks
{

/// How Embree is asked.
struct EmbreeCall
{
  std::size_t interface = 0;            ///< one of RawEmbree::interfaces()
  bool coherent = false;                ///< its flag
  const std::uint32_t* order = nullptr; ///< of the rays; null: as they come
};

/// Embree by its own interface, without ours around it: rays come from the same arrays, and hits go
/// to the same.
class RawEmbree
{
public:
  RawEmbree(const Scene& scene, bool robust);
  ~RawEmbree();
  RawEmbree(const RawEmbree&) = delete;
  RawEmbree& operator=(const RawEmbree&) = delete;

  /// What rtcIntersect… and rtcOccluded… are followed by: 1, 4, 8, 16; of Embree 3 also 1M and NM.
  [[nodiscard]] static std::vector<std::string> interfaces();

  void closest(const Rays& rays, const EmbreeCall& how, Hit* hits) const;
  void any(const Rays& rays, const EmbreeCall& how, std::uint8_t* hit) const;

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
