// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_ReceiverChunk_h
#define Lumitree_Radiometry_Estimate_ReceiverChunk_h

#include "Radiometry/Estimate/EstimateJob.h"
#include "Radiometry/Estimate/SightlineBatch.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumitree
{

/// Some receivers, one part of the light after the other, in it one source after the other.
class ReceiverChunk
{
public:
  ReceiverChunk(EstimateJob& job, EstimateWorkspace& workspace, std::size_t begin, std::size_t end);

  /// Writes the job's outputs for these receivers and adds to its counts.
  void run();

private:
  [[nodiscard]] View view(std::size_t k, ReceiverPart part, std::size_t source) const;

  /// The sum over the sources. main: of the main quantity.
  const std::vector<Estimate>& compute(ReceiverPart part, bool main);

  /// One source that is not extended, for all receivers at once.
  void sightlines(ReceiverPart part, std::size_t source);

  Estimate& of(std::size_t source, std::size_t k)
  {
    return this->perSource_[source * this->size_ + k];
  }

  EstimateJob& job_;
  EstimateWorkspace& workspace_;
  std::size_t begin_;
  std::size_t size_;
  std::vector<std::uint8_t> valid_;
  std::vector<std::uint32_t> rays_;
  std::vector<std::uint8_t> missed_;
  std::vector<Estimate> perSource_;
  std::vector<Estimate> sum_;
  SightlineBatch sightlines_;
};

} // namespace lumitree

#endif
