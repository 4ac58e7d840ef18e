// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_EstimateJob_h
#define Lumitree_Radiometry_Estimate_EstimateJob_h

#include "Radiometry/Estimate/SourceEstimator.h"
#include "Radiometry/LightEstimate.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace lumitree
{

/// Of the light at a receiver: on the side of its normal, on the other, in free space.
enum class ReceiverPart
{
  Front,
  Back,
  Free
};

/// All that the chunks of one computation share.
struct EstimateJob
{
  const Receivers& receivers;
  const std::vector<const Source*>& sources;
  const EstimateOutputs& outputs;
  const EstimateOptions& options;
  EstimateScene scene;
  std::vector<std::unique_ptr<const SourceEstimator>> estimators; ///< null: one sightline
  std::atomic<std::uint64_t> invalid{ 0 };
  std::atomic<std::uint64_t> missed{ 0 };
  std::atomic<std::uint64_t> rays{ 0 };
  std::mutex mutex;
  std::vector<std::unique_ptr<EstimateWorkspace>> workspaces; ///< not in use

  [[nodiscard]] bool sided() const { return static_cast<bool>(this->receivers.normals); }
  [[nodiscard]] bool wantsFree() const
  {
    return this->outputs.scalar || this->outputs.vector || this->outputs.cylindrical ||
      this->outputs.hemispherical || !this->sided();
  }
};

/// A workspace for one chunk, given back afterwards.
class BorrowedWorkspace
{
public:
  explicit BorrowedWorkspace(EstimateJob& job)
    : job_(job)
  {
    const std::lock_guard<std::mutex> lock(job.mutex);
    if (job.workspaces.empty())
    {
      this->workspace_ = std::make_unique<EstimateWorkspace>();
    }
    else
    {
      this->workspace_ = std::move(job.workspaces.back());
      job.workspaces.pop_back();
    }
  }
  ~BorrowedWorkspace()
  {
    const std::lock_guard<std::mutex> lock(this->job_.mutex);
    this->job_.workspaces.push_back(std::move(this->workspace_));
  }
  BorrowedWorkspace(const BorrowedWorkspace&) = delete;
  BorrowedWorkspace& operator=(const BorrowedWorkspace&) = delete;

  EstimateWorkspace& operator*() { return *this->workspace_; }

private:
  EstimateJob& job_;
  std::unique_ptr<EstimateWorkspace> workspace_;
};

} // namespace lumitree

#endif
