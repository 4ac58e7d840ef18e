// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/RayStream.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace lumitree
{
namespace
{

/// Calls ask(batch, answers, options) and take for each block.
template <class Answer, class Ask, class Take>
QueryReport inBlocks(
  const RayStream& stream, const QueryOptions& options, const Ask& ask, const Take& take)
{
  if (stream.block == 0)
  {
    throw std::invalid_argument("a stream of rays needs blocks of at least one");
  }
  std::vector<Answer> answers(std::min(stream.block, stream.size));
  QueryReport total;
  for (std::size_t first = 0; first < stream.size && total.completed; first += stream.block)
  {
    const std::size_t count = std::min(stream.block, stream.size - first);
    const RayBatch batch = stream.rays(first, count);
    if (batch.size != count)
    {
      throw std::invalid_argument("a stream of rays gave a batch of another size");
    }
    // The job sees one progress, from 0 to 1.
    JobControl job;
    job.onProgress = [&](double done)
    {
      JobControl& whole = *options.control;
      const double rays = static_cast<double>(first) + done * static_cast<double>(count);
      if (whole.onProgress && !whole.onProgress(rays / static_cast<double>(stream.size)))
      {
        whole.stop = true;
      }
      return !whole.stop;
    };
    QueryOptions own = options;
    own.control = options.control ? &job : nullptr;
    own.perRay = options.perRay ? options.perRay + first : nullptr;
    job.stop = options.control && options.control->stop;
    const QueryReport report = ask(batch, answers.data(), own);
    total.invalidRays += report.invalidRays;
    total.exactTests += report.exactTests;
    total.exactParameters += report.exactParameters;
    total.completed = report.completed;
    take(first, count, answers.data());
  }
  return total;
}

} // namespace

QueryReport streamClosest(const Accelerator& accelerator, const RayStream& stream,
  const std::function<void(std::size_t, std::size_t, const Hit*)>& take,
  const QueryOptions& options)
{
  return inBlocks<Hit>(
    stream, options,
    [&](const RayBatch& rays, Hit* hits, const QueryOptions& own)
    { return accelerator.closest(rays, hits, own); },
    take);
}

QueryReport streamAny(const Accelerator& accelerator, const RayStream& stream,
  const std::function<void(std::size_t, std::size_t, const std::uint8_t*)>& take,
  const QueryOptions& options)
{
  return inBlocks<std::uint8_t>(
    stream, options,
    [&](const RayBatch& rays, std::uint8_t* hit, const QueryOptions& own)
    { return accelerator.any(rays, hit, own); },
    take);
}

} // namespace lumitree
