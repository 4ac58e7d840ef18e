// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Filters_Rays_LumiCast_h
#define Lumitree_Filters_Rays_LumiCast_h

#include "LumiMemory.h"
#include "LumitreeFiltersRaysModule.h"

#include "Accel/Accelerator.h"

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <vector>

namespace lumitree::filters
{

/// Memory for n values that are all written before any is read: unlike a vector it is not touched
/// when made, so that the threads that fill it are the first to.
template <class T>
class Buffer
{
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
  explicit Buffer(std::size_t n)
    : values_(n > 0 ? static_cast<T*>(allocate(n * sizeof(T))) : nullptr)
  {
  }
  ~Buffer() { std::free(this->values_); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  [[nodiscard]] T* data() const { return this->values_; }
  T& operator[](std::size_t i) const { return this->values_[i]; }

private:
  T* values_;
};

/// What a batch of rays met, in one form for all queries.
class LUMITREEFILTERSRAYS_EXPORT Cast
{
public:
  /// Asks the accelerator; throws what it throws.
  Cast(QueryKind query, const Accelerator& accelerator, const RayBatch& rays,
    const QueryOptions& options);

  [[nodiscard]] QueryKind query() const { return this->query_; }
  [[nodiscard]] std::size_t size() const { return this->size_; }
  [[nodiscard]] const QueryReport& report() const { return this->report_; }

  /// Whether the hits themselves are known: of Closest, All and Ties.
  [[nodiscard]] bool givesHits() const
  {
    return this->query_ == QueryKind::Closest || this->query_ == QueryKind::All ||
      this->query_ == QueryKind::Ties;
  }

  /// How many hits that ray has; of Closest and Any 0 or 1; of Crossings, how many passages.
  [[nodiscard]] vtkIdType count(std::size_t ray) const;

  /// Calls work with a function that does what count does. Its type differs from query to query, so
  /// that a loop over rays asks for the query once and not for each ray.
  template <class Work>
  void withCounts(Work&& work) const
  {
    switch (this->query_)
    {
      case QueryKind::Closest:
        work([hits = this->nearest_.data()](std::size_t ray) -> vtkIdType
          { return hits[ray].primitive == noPrimitive ? 0 : 1; });
        break;
      case QueryKind::Any:
        work([hit = this->any_.data()](std::size_t ray) -> vtkIdType { return hit[ray]; });
        break;
      case QueryKind::Count:
      case QueryKind::Crossings:
        work([counts = this->counts_.data()](std::size_t ray) -> vtkIdType { return counts[ray]; });
        break;
      case QueryKind::All:
      case QueryKind::Ties:
        work([offsets = this->all_.offsets.data()](std::size_t ray)
          { return static_cast<vtkIdType>(offsets[ray + 1] - offsets[ray]); });
        break;
    }
  }

  /// The hits of that ray, nearest first, count(ray) of them. Only when givesHits().
  [[nodiscard]] const Hit* hits(std::size_t ray) const
  {
    return this->query_ == QueryKind::Closest ? &this->nearest_[ray]
                                              : this->all_.hits.data() + this->all_.offsets[ray];
  }

private:
  QueryKind query_;
  std::size_t size_;
  QueryReport report_;
  Buffer<Hit> nearest_;
  Buffer<std::uint8_t> any_;
  Buffer<std::uint32_t> counts_;
  AllHits all_;
};

} // namespace lumitree::filters

#endif
