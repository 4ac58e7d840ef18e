// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Reference_Embree_EmbreeVersions_h
#define Lumitree_Accel_Reference_Embree_EmbreeVersions_h

/// What differs between Embree 3 and 4. LUMITREE_EMBREE_MAJOR says which one the build found.
#if LUMITREE_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace lumitree::embree
{

#if LUMITREE_EMBREE_MAJOR >= 4

using Context = RTCRayQueryContext;
inline constexpr RTCSceneFlags filterPerQuery = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

/// The filter gets &context back.
///@{
inline void intersect(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRayHit& ray)
{
  RTCIntersectArguments arguments;
  rtcInitRayQueryContext(&context);
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  arguments.feature_mask = static_cast<RTCFeatureFlags>(
    RTC_FEATURE_FLAG_TRIANGLE | RTC_FEATURE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS);
  arguments.context = &context;
  arguments.filter = filter;
  rtcIntersect1(scene, &ray, &arguments);
}

inline void occluded(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay& ray)
{
  RTCOccludedArguments arguments;
  rtcInitRayQueryContext(&context);
  rtcInitOccludedArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  arguments.feature_mask = static_cast<RTCFeatureFlags>(
    RTC_FEATURE_FLAG_TRIANGLE | RTC_FEATURE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS);
  arguments.context = &context;
  arguments.filter = filter;
  rtcOccluded1(scene, &ray, &arguments);
}
///@}

#else

using Context = RTCIntersectContext;
inline constexpr RTCSceneFlags filterPerQuery = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void intersect(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRayHit& ray)
{
  rtcInitIntersectContext(&context);
  context.filter = filter;
  rtcIntersect1(scene, &context, &ray);
}

inline void occluded(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay& ray)
{
  rtcInitIntersectContext(&context);
  context.filter = filter;
  rtcOccluded1(scene, &context, &ray);
}

#endif

} // namespace lumitree::embree

#endif
