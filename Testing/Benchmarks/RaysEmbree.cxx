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

/// Rays of a stream.
constexpr unsigned int streamSize = 256;

/// Many rays, component by component.
struct alignas(64) ComponentRays
{
  std::uint32_t words[12 * streamSize];
};
struct ComponentRayHits
{
  ComponentRays ray;
  std::uint32_t hit[(7 + RTC_MAX_INSTANCE_LEVEL_COUNT) * streamSize];
};

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
  void trace(const int* v, RTCScene s, RTCRayHit4& r) { rtcIntersect4(v, s, &r, &this->nearest); }
  void trace(const int* v, RTCScene s, RTCRayHit8& r) { rtcIntersect8(v, s, &r, &this->nearest); }
  void trace(const int* v, RTCScene s, RTCRayHit16& r) { rtcIntersect16(v, s, &r, &this->nearest); }
  void trace(const int*, RTCScene s, RTCRay& r) { rtcOccluded1(s, &r, &this->any); }
  void trace(const int* v, RTCScene s, RTCRay4& r) { rtcOccluded4(v, s, &r, &this->any); }
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
  void trace(const int* v, RTCScene s, RTCRayHit4& r) { rtcIntersect4(v, s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRayHit8& r) { rtcIntersect8(v, s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRayHit16& r) { rtcIntersect16(v, s, &this->context, &r); }
  void trace(const int*, RTCScene s, RTCRay& r) { rtcOccluded1(s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRay4& r) { rtcOccluded4(v, s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRay8& r) { rtcOccluded8(v, s, &this->context, &r); }
  void trace(const int* v, RTCScene s, RTCRay16& r) { rtcOccluded16(v, s, &this->context, &r); }

  void stream(RTCScene s, RTCRayHit* r, unsigned int n)
  {
    rtcIntersect1M(s, &this->context, r, n, sizeof(RTCRayHit));
  }
  void stream(RTCScene s, RTCRay* r, unsigned int n)
  {
    rtcOccluded1M(s, &this->context, r, n, sizeof(RTCRay));
  }
  void stream(RTCScene s, ComponentRayHits* r, unsigned int)
  {
    rtcIntersectNM(
      s, &this->context, reinterpret_cast<RTCRayHitN*>(r), streamSize, 1, sizeof(ComponentRayHits));
  }
  void stream(RTCScene s, ComponentRays* r, unsigned int)
  {
    rtcOccludedNM(
      s, &this->context, reinterpret_cast<RTCRayN*>(r), streamSize, 1, sizeof(ComponentRays));
  }
};

#endif

/// n rays for one call of a packet interface.
template <class Packet, unsigned int n>
struct PacketBlock
{
  static constexpr unsigned int size = n;
  static constexpr unsigned int lanes = n;
  Packet packet;
  alignas(64) int valid[n];

  Packet* of(unsigned int) { return &this->packet; }
  void trace(Call& call, RTCScene scene, unsigned int used)
  {
    for (unsigned int k = 0; k < n; ++k)
    {
      this->valid[k] = k < used ? -1 : 0;
    }
    call.trace(this->valid, scene, this->packet);
  }
};

/// Rays for one call of a stream interface: one after the other (lanes 1) or by components.
template <class Packet, unsigned int n>
struct StreamBlock
{
  static constexpr unsigned int size = streamSize;
  static constexpr unsigned int lanes = n;
  Packet rays[streamSize / n];

  Packet* of(unsigned int k) { return this->rays + k / n; }
  void trace(Call& call, RTCScene scene, unsigned int used)
  {
    call.stream(scene, this->rays, used);
  }
};

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

/// Traces all rays a block at a time: begin(packet, lane) before, done(packet, lane, ray) after.
template <class Block, class Begin, class Done>
void traceAll(RTCScene scene, const Rays& rays, const EmbreeCall& how, Begin begin, Done done)
{
  Call call(how.coherent);
  Block block;
  const auto rayAt = [&](std::size_t i) { return how.order ? how.order[i] : i; };
  for (std::size_t i = 0; i < rays.size(); i += Block::size)
  {
    const auto used =
      static_cast<unsigned int>(std::min<std::size_t>(Block::size, rays.size() - i));
    // Lanes to spare repeat the last ray: some interfaces have no mask.
    const unsigned int filled = (used + Block::lanes - 1) / Block::lanes * Block::lanes;
    for (unsigned int k = 0; k < filled; ++k)
    {
      load(rays, rayAt(i + std::min(k, used - 1)), block.of(k), Block::lanes, k % Block::lanes);
      begin(block.of(k), k % Block::lanes);
    }
    block.trace(call, scene, used);
    for (unsigned int k = 0; k < used; ++k)
    {
      done(block.of(k), k % Block::lanes, rayAt(i + k));
    }
  }
}

template <class Block>
void closestBy(RTCScene scene, const Rays& rays, const EmbreeCall& how, Hit* hits)
{
  traceAll<Block>(
    scene, rays, how,
    [](auto* packet, unsigned int k)
    {
      RTCHitN_geomID(reinterpret_cast<RTCHitN*>(&packet->hit), Block::lanes, k) =
        RTC_INVALID_GEOMETRY_ID;
    },
    [hits](auto* packet, unsigned int k, std::size_t i)
    {
      auto* found = reinterpret_cast<RTCHitN*>(&packet->hit);
      Hit& hit = hits[i];
      hit = Hit{};
      if (RTCHitN_geomID(found, Block::lanes, k) != RTC_INVALID_GEOMETRY_ID)
      {
        hit.primitive = RTCHitN_primID(found, Block::lanes, k);
        hit.t =
          static_cast<double>(RTCRayN_tfar(reinterpret_cast<RTCRayN*>(packet), Block::lanes, k));
        hit.u = static_cast<double>(RTCHitN_u(found, Block::lanes, k));
        hit.v = static_cast<double>(RTCHitN_v(found, Block::lanes, k));
      }
    });
}

template <class Block>
void anyBy(RTCScene scene, const Rays& rays, const EmbreeCall& how, std::uint8_t* hit)
{
  traceAll<Block>(
    scene, rays, how, [](auto*, unsigned int) {},
    [hit](auto* packet, unsigned int k, std::size_t i)
    { hit[i] = RTCRayN_tfar(reinterpret_cast<RTCRayN*>(packet), Block::lanes, k) < 0.0f ? 1 : 0; });
}

/// An interface of Embree and what calls it.
struct Interface
{
  const char* name;
  void (*closest)(RTCScene, const Rays&, const EmbreeCall&, Hit*);
  void (*any)(RTCScene, const Rays&, const EmbreeCall&, std::uint8_t*);
};

const Interface interfaces[] = {
  { "1", closestBy<PacketBlock<RTCRayHit, 1>>, anyBy<PacketBlock<RTCRay, 1>> },
  { "4", closestBy<PacketBlock<RTCRayHit4, 4>>, anyBy<PacketBlock<RTCRay4, 4>> },
  { "8", closestBy<PacketBlock<RTCRayHit8, 8>>, anyBy<PacketBlock<RTCRay8, 8>> },
  { "16", closestBy<PacketBlock<RTCRayHit16, 16>>, anyBy<PacketBlock<RTCRay16, 16>> },
#if LUMITREE_EMBREE_MAJOR < 4
  { "1M", closestBy<StreamBlock<RTCRayHit, 1>>, anyBy<StreamBlock<RTCRay, 1>> },
  { "NM", closestBy<StreamBlock<ComponentRayHits, streamSize>>,
    anyBy<StreamBlock<ComponentRays, streamSize>> },
#endif
};

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

std::vector<std::string> RawEmbree::interfaces()
{
  std::vector<std::string> names;
  for (const Interface& one : benchmarks::interfaces)
  {
    names.emplace_back(one.name);
  }
  return names;
}

void RawEmbree::closest(const Rays& rays, const EmbreeCall& how, Hit* hits) const
{
  benchmarks::interfaces[how.interface].closest(this->internals_->scene, rays, how, hits);
}

void RawEmbree::any(const Rays& rays, const EmbreeCall& how, std::uint8_t* hit) const
{
  benchmarks::interfaces[how.interface].any(this->internals_->scene, rays, how, hit);
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
