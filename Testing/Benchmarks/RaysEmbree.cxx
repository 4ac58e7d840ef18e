// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RaysEmbree.h"

#include "Accel/Reference/Embree/EmbreeVersions.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <stdexcept>

namespace lumitree::benchmarks
{
namespace
{

/// The calls of Embree 3 and 4, by one name for every width.
#if LUMITREE_EMBREE_MAJOR >= 4

struct Call
{
  RTCIntersectArguments nearest;
  RTCOccludedArguments any;

  explicit Call(bool coherent)
  {
    rtcInitIntersectArguments(&this->nearest);
    rtcInitOccludedArguments(&this->any);
    this->nearest.flags = this->any.flags =
      coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    this->nearest.feature_mask = this->any.feature_mask = RTC_FEATURE_FLAG_TRIANGLE;
  }
  void trace(const int*, RTCScene s, RTCRayHit& r) { rtcIntersect1(s, &r, &this->nearest); }
  void trace(const int* v, RTCScene s, RTCRayHit8& r) { rtcIntersect8(v, s, &r, &this->nearest); }
  void trace(const int* v, RTCScene s, RTCRayHit16& r) { rtcIntersect16(v, s, &r, &this->nearest); }
  void trace(const int*, RTCScene s, RTCRay& r) { rtcOccluded1(s, &r, &this->any); }
  void trace(const int* v, RTCScene s, RTCRay8& r) { rtcOccluded8(v, s, &r, &this->any); }
  void trace(const int* v, RTCScene s, RTCRay16& r) { rtcOccluded16(v, s, &r, &this->any); }
};

#else

struct Call
{
  RTCIntersectContext context;

  explicit Call(bool coherent)
  {
    rtcInitIntersectContext(&this->context);
    this->context.flags =
      coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
  void trace(const int*, RTCScene s, RTCRayHit& r) { rtcIntersect1(s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRayHit8& r) { rtcIntersect8(v, s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRayHit16& r) { rtcIntersect16(v, s, &this->context, &r); }
  void trace(const int*, RTCScene s, RTCRay& r) { rtcOccluded1(s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRay8& r) { rtcOccluded8(v, s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRay16& r) { rtcOccluded16(v, s, &this->context, &r); }
};

#endif

/// Ray i of the batch into lane k of n.
void load(const Rays& rays, std::size_t i, void* packet, unsigned int n, unsigned int k)
{
  auto* ray = static_cast<RTCRayN*>(packet);
  RTCRayN_org_x(ray, n, k) = rays.origins[3 * i];
  RTCRayN_org_y(ray, n, k) = rays.origins[3 * i + 1];
  RTCRayN_org_z(ray, n, k) = rays.origins[3 * i + 2];
  RTCRayN_dir_x(ray, n, k) = rays.directions[3 * i];
  RTCRayN_dir_y(ray, n, k) = rays.directions[3 * i + 1];
  RTCRayN_dir_z(ray, n, k) = rays.directions[3 * i + 2];
  RTCRayN_tnear(ray, n, k) = 0.0f;
  RTCRayN_tfar(ray, n, k) = rays.tMax;
  RTCRayN_time(ray, n, k) = 0.0f;
  RTCRayN_mask(ray, n, k) = ~0u;
  RTCRayN_flags(ray, n, k) = 0;
}

template <class Packet, unsigned int n>
void closestOf(RTCScene scene, const Rays& rays, Hit* hits)
{
  Call call(rays.coherent);
  Packet packet;
  alignas(64) int valid[n];
  auto* found = reinterpret_cast<RTCHitN*>(&packet.hit);
  for (std::size_t i = 0; i < rays.size(); i += n)
  {
    const auto used = static_cast<unsigned int>(std::min<std::size_t>(n, rays.size() - i));
    for (unsigned int k = 0; k < n; ++k)
    {
      valid[k] = k < used ? -1 : 0;
      load(rays, i + std::min(k, used - 1), &packet.ray, n, k);
      RTCHitN_geomID(found, n, k) = RTC_INVALID_GEOMETRY_ID;
    }
    call.trace(valid, scene, packet);
    for (unsigned int k = 0; k < used; ++k)
    {
      Hit& hit = hits[i + k];
      hit = Hit{};
      if (RTCHitN_geomID(found, n, k) != RTC_INVALID_GEOMETRY_ID)
      {
        hit.primitive = RTCHitN_primID(found, n, k);
        hit.t = RTCRayN_tfar(reinterpret_cast<RTCRayN*>(&packet.ray), n, k);
        hit.u = RTCHitN_u(found, n, k);
        hit.v = RTCHitN_v(found, n, k);
      }
    }
  }
}

template <class Packet, unsigned int n>
void anyOf(RTCScene scene, const Rays& rays, std::uint8_t* hit)
{
  Call call(rays.coherent);
  Packet packet;
  alignas(64) int valid[n];
  for (std::size_t i = 0; i < rays.size(); i += n)
  {
    const auto used = static_cast<unsigned int>(std::min<std::size_t>(n, rays.size() - i));
    for (unsigned int k = 0; k < n; ++k)
    {
      valid[k] = k < used ? -1 : 0;
      load(rays, i + std::min(k, used - 1), &packet, n, k);
    }
    call.trace(valid, scene, packet);
    for (unsigned int k = 0; k < used; ++k)
    {
      hit[i + k] = RTCRayN_tfar(reinterpret_cast<RTCRayN*>(&packet), n, k) < 0.0f ? 1 : 0;
    }
  }
}

} // namespace

struct RawEmbree::Internals
{
  std::atomic<std::ptrdiff_t> bytes{ 0 };
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = nullptr;
  double commitSeconds = 0.0;
};

RawEmbree::RawEmbree(const Scene& scene, bool robust)
  : internals_(std::make_unique<Internals>())
{
  const RTCDevice device = this->internals_->device;
  rtcSetDeviceMemoryMonitorFunction(
    device,
    [](void* internals, ssize_t change, bool)
    {
      static_cast<Internals*>(internals)->bytes += change;
      return true;
    },
    this->internals_.get());
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
    RTC_FORMAT_FLOAT3, 3 * sizeof(float), scene.points.size() / 3));
  auto* triangles = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry,
    RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), scene.triangles.size()));
  std::copy(scene.points.begin(), scene.points.end(), points);
  for (const Triangle& triangle : scene.triangles)
  {
    triangles = std::copy(triangle.begin(), triangle.end(), triangles);
  }
  rtcCommitGeometry(geometry);
  this->internals_->scene = rtcNewScene(device);
  rtcSetSceneFlags(this->internals_->scene, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  rtcAttachGeometry(this->internals_->scene, geometry);
  rtcReleaseGeometry(geometry);
  const bool serial =
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1;
  const auto now = [serial]
  {
    timespec time{};
    clock_gettime(serial ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  rtcCommitScene(this->internals_->scene);
  this->internals_->commitSeconds = now() - start;
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
  {
    throw std::runtime_error("Embree cannot build its tree");
  }
}

RawEmbree::~RawEmbree()
{
  rtcReleaseScene(this->internals_->scene);
  rtcReleaseDevice(this->internals_->device);
}

void RawEmbree::closest(const Rays& rays, unsigned int packet, Hit* hits) const
{
  const RTCScene scene = this->internals_->scene;
  packet == 16    ? closestOf<RTCRayHit16, 16>(scene, rays, hits)
    : packet == 8 ? closestOf<RTCRayHit8, 8>(scene, rays, hits)
                  : closestOf<RTCRayHit, 1>(scene, rays, hits);
}

void RawEmbree::any(const Rays& rays, unsigned int packet, std::uint8_t* hit) const
{
  const RTCScene scene = this->internals_->scene;
  packet == 16    ? anyOf<RTCRay16, 16>(scene, rays, hit)
    : packet == 8 ? anyOf<RTCRay8, 8>(scene, rays, hit)
                  : anyOf<RTCRay, 1>(scene, rays, hit);
}

std::size_t RawEmbree::memory() const
{
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(this->internals_->bytes, 0));
}

double RawEmbree::commitSeconds() const
{
  return this->internals_->commitSeconds;
}

std::string RawEmbree::version() const
{
  const auto part = [&](RTCDeviceProperty which)
  { return std::to_string(rtcGetDeviceProperty(this->internals_->device, which)); };
  return part(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." + part(RTC_DEVICE_PROPERTY_VERSION_MINOR) +
    "." + part(RTC_DEVICE_PROPERTY_VERSION_PATCH);
}

} // namespace lumitree::benchmarks
