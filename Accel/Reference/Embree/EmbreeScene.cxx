// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Reference/Embree/EmbreeScene.h"

#include "Accel/Reference/Embree/EmbreeFrame.h"
#include "Accel/Reference/Embree/EmbreeVersions.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

namespace lumitree
{
namespace
{

/// One ray on its way through Embree; filter functions get it back as their context.
struct Query : embree::Context
{
  RayState* state = nullptr;
  EmbreeSegment segment;
};

Query& queryOf(const RTCFilterFunctionNArguments* arguments)
{
  return *const_cast<Query*>(static_cast<const Query*>(arguments->context));
}

/// What Embree found, if it is within the ray's limits and not skipped. Rays come one by one, so N
/// is 1.
bool admit(const RTCFilterFunctionNArguments* arguments, const Query& query, Candidate& candidate)
{
  const RayState& state = *query.state;
  const unsigned int index = RTCHitN_primID(arguments->hit, arguments->N, 0);
  candidate.primitive = state.surface.hittable()[index];
  candidate.t = query.segment.t(RTCRayN_tfar(arguments->ray, arguments->N, 0));
  candidate.key = candidate.tLow = candidate.tHigh = candidate.t;
  candidate.u = static_cast<double>(RTCHitN_u(arguments->hit, arguments->N, 0));
  candidate.v = static_cast<double>(RTCHitN_v(arguments->hit, arguments->N, 0));
  return candidate.t >= state.ray.tMin && candidate.t <= state.ray.tMax &&
    std::isfinite(candidate.t) && !state.skips(candidate.primitive);
}

/// Embree offers what is not beyond the hit it holds: of equal ones the lowest primitive is kept.
void keepNearest(const RTCFilterFunctionNArguments* arguments)
{
  Query& query = queryOf(arguments);
  Candidate candidate;
  if (!admit(arguments, query, candidate) ||
    (candidate.t == query.state->best.t && candidate.primitive > query.state->best.primitive))
  {
    arguments->valid[0] = 0;
    return;
  }
  query.state->best = candidate;
}

void keepFirst(const RTCFilterFunctionNArguments* arguments)
{
  Query& query = queryOf(arguments);
  Candidate candidate;
  if (!admit(arguments, query, candidate))
  {
    arguments->valid[0] = 0;
    return;
  }
  query.state->best = candidate;
}

/// Refuses every hit, so that Embree goes on to the next.
void collect(const RTCFilterFunctionNArguments* arguments)
{
  Query& query = queryOf(arguments);
  Candidate candidate;
  if (admit(arguments, query, candidate))
  {
    query.state->found.push_back(candidate);
  }
  arguments->valid[0] = 0;
}

/// Embree asks from any of its threads whether to go on.
class Monitor
{
public:
  explicit Monitor(JobControl* control)
    : control_(control)
  {
  }

  static bool ask(void* self, double fraction)
  {
    auto& monitor = *static_cast<Monitor*>(self);
    JobControl* const control = monitor.control_;
    if (control && control->onProgress && std::this_thread::get_id() == monitor.caller_ &&
      fraction > monitor.reported_)
    {
      monitor.reported_ = fraction;
      if (!control->onProgress(std::min(fraction, 1.0)))
      {
        control->stop.store(true);
      }
    }
    return !monitor.stopped();
  }

  [[nodiscard]] bool stopped() const { return this->control_ && this->control_->stop.load(); }

private:
  JobControl* control_;
  double reported_ = -1.0;
  std::thread::id caller_ = std::this_thread::get_id();
};

void set(const EmbreeSegment& segment, RTCRay& ray)
{
  ray = RTCRay{};
  ray.org_x = segment.origin[0];
  ray.org_y = segment.origin[1];
  ray.org_z = segment.origin[2];
  ray.dir_x = segment.direction[0];
  ray.dir_y = segment.direction[1];
  ray.dir_z = segment.direction[2];
  ray.tfar = segment.tFar;
  ray.mask = ~0u;
}

} // namespace

struct EmbreeScene::Internals
{
  explicit Internals(const Surface& surface)
    : frame(surface.bounds())
    // Not "threads=1": that bounds oneTBB in the whole process for as long as the device lives.
    , device(rtcNewDevice(nullptr))
  {
    if (!this->device)
    {
      throw std::runtime_error("Embree cannot start");
    }
    rtcSetDeviceMemoryMonitorFunction(
      this->device,
      [](void* internals, ssize_t change, bool)
      {
        static_cast<Internals*>(internals)->bytes += change;
        return true;
      },
      this);
    this->scene = rtcNewScene(this->device);
  }

  ~Internals()
  {
    rtcReleaseScene(this->scene);
    rtcReleaseDevice(this->device);
  }

  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  void add(const Surface& surface)
  {
    const RTCGeometry geometry = rtcNewGeometry(this->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), surface.pointCount()));
    auto* triangles =
      static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
        RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), surface.hittable().size()));
    if (points && triangles)
    {
      // Points that no triangle here uses stay 0: they need not even be finite.
      std::fill_n(points, 3 * surface.pointCount(), 0.0f);
      for (const PrimitiveId id : surface.hittable())
      {
        for (const std::uint32_t corner : surface.triangle(id))
        {
          const std::array<float, 3> p = this->frame.point(surface.point(corner));
          std::copy(p.begin(), p.end(), points + 3 * std::size_t{ corner });
          *triangles++ = corner;
        }
      }
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(this->scene, geometry);
    }
    rtcReleaseGeometry(geometry);
  }

  EmbreeFrame frame;
  std::atomic<std::ptrdiff_t> bytes{ 0 };
  RTCDevice device;
  RTCScene scene = nullptr;
};

EmbreeScene::EmbreeScene(const Surface& surface, bool robust, JobControl* control)
  : internals_(std::make_unique<Internals>(surface))
{
  const RTCScene scene = this->internals_->scene;
  rtcSetSceneFlags(scene,
    static_cast<RTCSceneFlags>(
      embree::filterPerQuery | (robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE)));
  if (!surface.hittable().empty())
  {
    this->internals_->add(surface);
  }
  Monitor monitor(control);
  rtcSetSceneProgressMonitorFunction(scene, &Monitor::ask, &monitor);
  rtcCommitScene(scene);
  rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  if (monitor.stopped())
  {
    throw BuildStopped("the build was stopped");
  }
  const RTCError error = rtcGetDeviceError(this->internals_->device);
  if (error != RTC_ERROR_NONE)
  {
    throw std::runtime_error(
      "Embree cannot build its tree (its error " + std::to_string(error) + ")");
  }
}

EmbreeScene::~EmbreeScene() = default;

void EmbreeScene::closest(RayState& state) const
{
  Query query;
  query.state = &state;
  if (this->internals_->frame.cut(state.ray, query.segment))
  {
    RTCRayHit ray;
    set(query.segment, ray.ray);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(this->internals_->scene, query, keepNearest, ray);
  }
}

void EmbreeScene::any(RayState& state) const
{
  Query query;
  query.state = &state;
  if (this->internals_->frame.cut(state.ray, query.segment))
  {
    RTCRay ray;
    set(query.segment, ray);
    embree::occluded(this->internals_->scene, query, keepFirst, ray);
  }
}

void EmbreeScene::all(RayState& state) const
{
  Query query;
  query.state = &state;
  if (this->internals_->frame.cut(state.ray, query.segment))
  {
    RTCRayHit ray;
    set(query.segment, ray.ray);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(this->internals_->scene, query, collect, ray);
  }
}

std::size_t EmbreeScene::memory() const
{
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(this->internals_->bytes, 0));
}

} // namespace lumitree
