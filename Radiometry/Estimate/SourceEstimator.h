// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Estimate_SourceEstimator_h
#define Lumitree_Radiometry_Estimate_SourceEstimator_h

#include "Radiometry/Estimate/Amounts.h"
#include "Radiometry/Estimate/ConePieces.h"
#include "Radiometry/Estimate/Estimate.h"
#include "Radiometry/Estimate/PieceLight.h"
#include "Radiometry/Estimate/RaySampler.h"
#include "Radiometry/Estimate/Skyline.h"
#include "Radiometry/LightEstimate.h"
#include "Radiometry/ShadowRays.h"

#include <memory>
#include <optional>

namespace lumitree
{

/// Memory that estimates on one thread use again.
struct EstimateWorkspace
{
  ConvexRegion region;
  std::vector<PrimitiveId> found;
  std::vector<OccluderCone> cones;
  std::vector<ConePiece> pieces;
  VisiblePieces cut;
  ConeSubtraction subtraction;
  Skyline::Scratch skyline;
  RaySampler sampler;         ///< where rays are queued
  Estimate* result = nullptr; ///< of the view being estimated: what rays find is added to it
};

/// What estimates of all receivers share.
struct EstimateScene
{
  const EstimateOptions& options;
  const Accelerator* occluders; ///< null: nothing hides
  const ShadowRays* shadowRays; ///< null where occluders is
  std::size_t triangles;        ///< primitives from there on are not triangles

  /// How many occluders are worth being cut out. absolute: the tolerance beside the relative one,
  /// of a light that is `unoccluded` with nothing in the way.
  [[nodiscard]] std::size_t mostClipped(double absolute, double unoccluded) const;

  [[nodiscard]] RaySamplerOptions sampling() const;
};

/// The flat front of a light, behind which nothing hides it, as what hides it is looked for.
struct LightFront
{
  const Vec3* hull = nullptr; ///< convex; of an endless light, the eye and directions from it
  std::size_t count = 0;
  double side = 1.0; ///< 1 where corners a, b, c relative to the eye have a · (b × c) > 0, else −1
  bool endless = false;
  Vec3 towards = { 0.0, 0.0, 1.0 }; ///< unit normal of the hull, to the side of the eye
  double height = 0.0;              ///< of the eye above the hull
  double clearance = 0.0;           ///< what is nearer to the hull than that is the light
  std::size_t mostClipped = 0;      ///< see EstimateScene

  /// A light that is a ball: what lies in it does not hide it.
  const Vec3* ballCentre = nullptr;
  double ballRadius = 0.0;
};

/// Estimates the light of one extended source.
class SourceEstimator
{
public:
  virtual ~SourceEstimator() = default;

  /// tolerance: absolute, of value.main, beside the relative one. Where rays are needed they are
  /// queued in the workspace, and what is returned is all but what they will find.
  [[nodiscard]] virtual Estimate estimate(
    const View& view, double tolerance, EstimateWorkspace& workspace) const = 0;
};

/// The one that suits the source.
[[nodiscard]] std::unique_ptr<const SourceEstimator> makeEstimator(
  const Source& source, const EstimateScene& scene);

/// For PolygonEstimator, SkyEstimator and those of other sources.
class SourceEstimatorBase : public SourceEstimator
{
protected:
  SourceEstimatorBase(const Source& source, const EstimateScene& scene)
    : source_(source)
    , scene_(scene)
  {
  }

  /// Primitives that may meet workspace.region, without those that the view skips. False where
  /// there are more than the limit, or one is not a triangle.
  bool find(const View& view, std::size_t limit, EstimateWorkspace& workspace) const;

  /// Finds what is in the shaft between the eye and a light, and makes it cones; false where that
  /// is too much to be cut out, or reaches into a ball.
  bool findCones(const LightFront& front, const View& view, EstimateWorkspace& workspace) const;

  /// The closed form: nothing hides.
  [[nodiscard]] Estimate unoccluded(const View& view, EstimateWorkspace& workspace) const;

  /// Queues rays to the whole source, given its closed form; in directions that the source draws,
  /// or in those given.
  ///@{
  [[nodiscard]] Estimate sampleAll(
    const View& view, const Estimate& full, double tolerance, EstimateWorkspace& workspace) const;
  [[nodiscard]] Estimate sampleAll(const View& view, const Estimate& full, double tolerance,
    std::shared_ptr<const LightSamples> samples, EstimateWorkspace& workspace) const;
  ///@}

  /// Queues rays to what is open, beside the light that is certain; sets the result to the latter.
  static void sample(const View& view, const Amounts& certain, const Amounts& open,
    double tolerance, std::shared_ptr<const LightSamples> samples, EstimateWorkspace& workspace,
    Estimate& result);

  const Source& source_;
  const EstimateScene& scene_;
};

} // namespace lumitree

#endif
