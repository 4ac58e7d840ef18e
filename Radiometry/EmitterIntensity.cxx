// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/EmitterIntensity.h"

#include "Accel/Parallel.h"
#include "Radiometry/Checks.h"
#include "Radiometry/Constants.h"
#include "Radiometry/Estimate/ConePieces.h"
#include "Radiometry/Estimate/Sobol.h"
#include "Radiometry/Frame.h"
#include "Radiometry/ShadowRays.h"
#include "Radiometry/SolidAngle.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

namespace lumitree
{

namespace
{

/// The visible part of triangles in one direction after the other.
class Projector
{
public:
  Projector(const Emitter& emitter, const ShadowRays* clearances)
    : emitter_(emitter)
    , clearances_(clearances)
  {
  }

  [[nodiscard]] std::uint64_t rays() const { return this->rays_; }

  /// Projected visible area, in units squared.
  double area(PrimitiveId id, const Vec3& direction)
  {
    const std::array<Vec3, 3> corners = this->emitter_.surface->vertices(id);
    Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = length(normal);
    double shown = 0.5 * dot(normal, direction);
    if (shown < 0.0 && this->emitter_.twoSided)
    {
      shown = -shown;
      normal = -1.0 * normal;
    }
    if (!(shown > 0.0) || !this->clearances_)
    {
      return std::max(0.0, shown);
    }
    normal = (1.0 / size) * normal;
    double clearance = 0.0;
    for (const Vec3& corner : corners)
    {
      clearance = std::max(clearance, this->clearances_->clearance(corner));
    }
    if (!this->findCones(corners, normal, clearance, direction))
    {
      return shown * this->share(id, corners, normal, clearance, direction);
    }
    if (this->cones_.empty())
    {
      return shown;
    }
    this->subtraction_.run(this->pieces_, this->cones_, 1u << 20, this->cut_);
    const double whole = planeArea(this->pieces_);
    const double left = planeArea(this->cut_.visible) + 0.5 * planeArea(this->cut_.undecided);
    return shown * std::clamp(left / whole, 0.0, 1.0);
  }

private:
  /// Of pieces (x, y, 1).
  static double planeArea(const std::vector<ConePiece>& pieces)
  {
    double sum = 0.0;
    for (const ConePiece& piece : pieces)
    {
      double area = 0.0;
      for (int i = 2; i < piece.count; ++i)
      {
        area +=
          cross(piece.corners[i - 1] - piece.corners[0], piece.corners[i] - piece.corners[0])[2];
      }
      sum += 0.5 * std::fabs(area);
    }
    return sum;
  }

  /// The triangle and what is over it, along the direction, as points (x, y, 1) of a plane across
  /// it: cones of the plane z = 1. False where it is too much.
  bool findCones(
    const std::array<Vec3, 3>& corners, const Vec3& normal, double clearance, const Vec3& direction)
  {
    const double turn = dot(cross(corners[1] - corners[0], corners[2] - corners[0]), direction);
    this->region_.clear();
    for (int k = 0; k < 3; ++k)
    {
      const Vec3 outward =
        (turn > 0.0 ? 1.0 : -1.0) * cross(corners[(k + 1) % 3] - corners[k], direction);
      this->region_.push_back({ outward, dot(outward, corners[k]) });
    }
    this->region_.push_back({ -1.0 * normal, -dot(normal, corners[0]) - clearance });
    this->emitter_.occluders->overlap(this->region_, this->found_, this->emitter_.mostClipped);
    if (this->found_.size() > this->emitter_.mostClipped)
    {
      return false;
    }
    const Frame frame = Frame::around(direction);
    double reach = 0.0;
    for (const Vec3& corner : corners)
    {
      reach = std::max(reach, length(corner - corners[0]));
    }
    const auto project = [&](const Vec3& p) -> Vec3
    {
      const Vec3 way = p - corners[0];
      return { dot(frame.x, way) / reach, dot(frame.y, way) / reach, 1.0 };
    };
    this->cones_.clear();
    const Surface& surface = this->emitter_.occluders->surface();
    for (const PrimitiveId id : this->found_)
    {
      if (!surface.isTriangle(id))
      {
        return false;
      }
      const std::array<Vec3, 3> other = surface.vertices(id);
      Vec3 left[4];
      int count = 0;
      for (int k = 0; k < 3; ++k)
      {
        const Vec3& p = other[k];
        const Vec3& q = other[(k + 1) % 3];
        const double a = dot(normal, p - corners[0]) - clearance;
        const double b = dot(normal, q - corners[0]) - clearance;
        if (a >= 0.0)
        {
          left[count++] = project(p);
        }
        if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0))
        {
          const double t = a / (a - b);
          left[count++] = project((1.0 - t) * p + t * q);
        }
      }
      OccluderCone cone;
      if (count >= 3 && cone.assign(left, count, 0.0))
      {
        this->cones_.push_back(cone);
      }
    }
    this->pieces_.resize(1);
    this->pieces_[0].count = 3;
    for (int k = 0; k < 3; ++k)
    {
      this->pieces_[0].corners[k] = project(corners[k]);
    }
    return true;
  }

  /// The visible share, by rays.
  double share(PrimitiveId id, const std::array<Vec3, 3>& corners, const Vec3& normal,
    double clearance, const Vec3& direction)
  {
    const std::uint32_t count = this->emitter_.rays;
    this->origins_.clear();
    this->directions_.clear();
    const Sobol sobol(Sobol::mix(id));
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const auto [u, v] = sobol(i);
      const double root = std::sqrt(u);
      const Vec3 origin = (1.0 - root) * corners[0] + (root * (1.0 - v)) * corners[1] +
        (root * v) * corners[2] + clearance * normal;
      this->origins_.insert(this->origins_.end(), origin.begin(), origin.end());
      this->directions_.insert(this->directions_.end(), direction.begin(), direction.end());
    }
    RayBatch batch;
    batch.size = count;
    batch.origins = this->origins_.data();
    batch.directions = this->directions_.data();
    batch.tMin = clearance;
    QueryOptions query;
    query.precision = this->emitter_.precision;
    query.threads = 1;
    this->hit_.resize(count);
    this->emitter_.occluders->any(batch, this->hit_.data(), query);
    this->rays_ += count;
    const auto hidden = std::count(this->hit_.begin(), this->hit_.end(), 1);
    return 1.0 - static_cast<double>(hidden) / count;
  }

  const Emitter& emitter_;
  const ShadowRays* clearances_;
  std::uint64_t rays_ = 0;
  ConvexRegion region_;
  std::vector<PrimitiveId> found_;
  std::vector<OccluderCone> cones_;
  std::vector<ConePiece> pieces_;
  VisiblePieces cut_;
  ConeSubtraction subtraction_;
  std::vector<double> origins_;
  std::vector<double> directions_;
  std::vector<std::uint8_t> hit_;
};

} // namespace

EmitterReport emitterIntensity(
  const Emitter& emitter, const std::vector<Vec3>& directions, std::vector<double>& intensities)
{
  checks::notNegative(emitter.radiance, "The radiance of an emitter");
  checks::positive(emitter.metresPerUnit, "The number of metres per unit of length");
  if (emitter.rays < 1 || emitter.rays > 1u << 20)
  {
    throw std::invalid_argument("Rays from a triangle must be 1 to 2^20.");
  }
  std::vector<Vec3> units;
  for (const Vec3& direction : directions)
  {
    units.push_back(checks::unit(direction, "The direction of an intensity"));
  }
  std::optional<ShadowRays> clearances;
  if (emitter.occluders && !emitter.occluders->surface().hittable().empty())
  {
    const bool coarse = emitter.surface->scalar() == ArrayView::Scalar::Float ||
      emitter.occluders->surface().scalar() == ArrayView::Scalar::Float;
    clearances.emplace(
      *emitter.occluders, coarse ? ArrayView::Scalar::Float : ArrayView::Scalar::Double);
  }
  std::vector<PrimitiveId> shining;
  double area = 0.0;
  for (const PrimitiveId id : emitter.surface->hittable())
  {
    if (id < emitter.surface->triangleCount())
    {
      const std::array<Vec3, 3> c = emitter.surface->vertices(id);
      area += 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
      shining.push_back(id);
    }
  }
  const double square = emitter.metresPerUnit * emitter.metresPerUnit;
  EmitterReport report;
  report.flux = pi * emitter.radiance * area * square * (emitter.twoSided ? 2.0 : 1.0);
  report.extent =
    emitter.surface->bounds().empty() ? 0.0 : length(emitter.surface->bounds().size());
  intensities.assign(directions.size(), 0.0);
  std::atomic<std::uint64_t> rays{ 0 };
  report.completed = parallelFor(directions.size(), 4, emitter.threads, emitter.control,
    [&](std::size_t begin, std::size_t end)
    {
      Projector projector(emitter, clearances ? &*clearances : nullptr);
      for (std::size_t i = begin; i < end; ++i)
      {
        double sum = 0.0;
        for (const PrimitiveId id : shining)
        {
          sum += projector.area(id, units[i]);
        }
        intensities[i] = sum * emitter.radiance * square;
      }
      rays += projector.rays();
    });
  report.rays = rays;
  return report;
}

bool surfaceSolidAngles(const Surface& surface, const double* positions, std::size_t count,
  double* solidAngles, int threads, JobControl* control)
{
  return parallelFor(count, 64, threads, control,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vec3 from = { positions[3 * i], positions[3 * i + 1], positions[3 * i + 2] };
        double sum = 0.0;
        for (const PrimitiveId id : surface.hittable())
        {
          if (id < surface.triangleCount())
          {
            const std::array<Vec3, 3> c = surface.vertices(id);
            const double omega = solidAngle(from, c[0], c[1], c[2]);
            sum += std::isnan(omega) ? 0.0 : omega;
          }
        }
        solidAngles[i] = isFinite(from) ? sum : std::numeric_limits<double>::quiet_NaN();
      }
    });
}

} // namespace lumitree
