// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiLightReader.h"

#include "LumiAreaLightReader.h"
#include "LumiLightFields.h"

#include "Radiometry/Constants.h"
#include "Radiometry/CosineLobeSource.h"
#include "Radiometry/DirectionalSource.h"
#include "Radiometry/DiskSource.h"
#include "Radiometry/GeneralSky.h"
#include "Radiometry/IsotropicPointSource.h"
#include "Radiometry/LineSource.h"
#include "Radiometry/PhotometricSource.h"
#include "Radiometry/SphereSource.h"
#include "Radiometry/SpotSource.h"
#include "Radiometry/SunDiskSource.h"
#include "Radiometry/TubeSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace lumitree::filters
{

namespace
{

using Made = std::unique_ptr<const Source>;

constexpr double degree = pi / 180.0;

Made pointSource(const LightFields& fields)
{
  const double flux = fields.amount(Quantity::Flux);
  if (fields.data()->GetNumberOfPoints() != 1)
  {
    throw std::runtime_error("a point light has one point, but it has " +
      std::to_string(fields.data()->GetNumberOfPoints()));
  }
  return std::make_unique<IsotropicPointSource>(flux, fields.position(), fields.metresPerUnit());
}

Made directionalSource(const LightFields& fields)
{
  return std::make_unique<DirectionalSource>(
    fields.amount(Quantity::NormalIrradiance), fields.direction("LightDirection"));
}

Made sunSource(const LightFields& fields)
{
  return std::make_unique<SunDiskSource>(fields.amount(Quantity::NormalIrradiance),
    fields.direction("LightDirection"), fields.number("AngularDiameter [deg]") * degree);
}

Made lobeSource(const LightFields& fields)
{
  const double exponent = fields.number("LobeExponent");
  const double axial = fields.has(Quantity::Flux)
    ? CosineLobeSource::axialIntensityOf(fields.amount(Quantity::Flux), exponent)
    : fields.amount(Quantity::Intensity);
  return std::make_unique<CosineLobeSource>(
    axial, exponent, fields.position(), fields.direction("LightAxis"), fields.metresPerUnit());
}

Made spotSource(const LightFields& fields)
{
  const double cone = fields.number("ConeAngle [deg]") * degree;
  const double cutoff = fields.number("CutoffAngle [deg]") * degree;
  // The angles are checked before a flux is divided by what they make of it.
  (void)SpotSource(0.0, cone, cutoff, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  const double axial = fields.has(Quantity::Flux)
    ? SpotSource::axialIntensityOf(fields.amount(Quantity::Flux), cone, cutoff)
    : fields.amount(Quantity::Intensity);
  return std::make_unique<SpotSource>(
    axial, cone, cutoff, fields.position(), fields.direction("LightAxis"), fields.metresPerUnit());
}

Made sphereSource(const LightFields& fields)
{
  const double radius = fields.number("LightRadius");
  const double metres = radius * fields.metresPerUnit();
  return std::make_unique<SphereSource>(fields.radiance(4.0 * pi * metres * metres),
    fields.vector("LightCentre"), radius, fields.metresPerUnit());
}

Made diskSource(const LightFields& fields)
{
  const double radius = fields.number("LightRadius");
  const double metres = radius * fields.metresPerUnit();
  const bool twoSided = fields.flag("LightTwoSided");
  return std::make_unique<DiskSource>(
    fields.radiance((twoSided ? 2.0 : 1.0) * pi * metres * metres), fields.vector("LightCentre"),
    fields.direction("LightNormal"), radius, twoSided, fields.metresPerUnit());
}

double distanceInMetres(const LightFields& fields, const Vec3& begin, const Vec3& end)
{
  const Vec3 way = end - begin;
  return std::hypot(way[0], way[1], way[2]) * fields.metresPerUnit();
}

Made lineSource(const LightFields& fields)
{
  const Vec3 begin = fields.vector("LightBegin");
  const Vec3 end = fields.vector("LightEnd");
  const std::string name = fields.text("LineDistribution");
  if (name != "lambertian" && name != "isotropic")
  {
    throw std::runtime_error(
      "its \"LineDistribution\" is \"" + name + "\", but must be lambertian or isotropic");
  }
  const bool lambertian = name == "lambertian";
  const double length = distanceInMetres(fields, begin, end);
  const double perMetre = fields.has(Quantity::Flux)
    ? fields.amount(Quantity::Flux) / ((lambertian ? pi * pi : 4.0 * pi) * length)
    : fields.amount(intensityPerMetreName(fields.system()));
  return std::make_unique<LineSource>(perMetre, begin, end,
    lambertian ? LineSource::Distribution::Lambertian : LineSource::Distribution::Isotropic,
    fields.metresPerUnit());
}

Made tubeSource(const LightFields& fields)
{
  const Vec3 begin = fields.vector("LightBegin");
  const Vec3 end = fields.vector("LightEnd");
  const double radius = fields.number("LightRadius");
  const double area =
    2.0 * pi * radius * fields.metresPerUnit() * distanceInMetres(fields, begin, end);
  return std::make_unique<TubeSource>(
    fields.radiance(area), begin, end, radius, fields.metresPerUnit());
}

Made skySource(const LightFields& fields)
{
  SkyLevel level;
  const std::string diffuse = diffuseIrradianceName(fields.system());
  if (fields.has(diffuse))
  {
    level = { SkyLevel::Kind::HorizontalIrradiance, fields.amount(diffuse) };
  }
  else
  {
    level = { SkyLevel::Kind::ZenithRadiance, fields.amount(zenithRadianceName(fields.system())) };
  }
  const std::string groundName = groundRadianceName(fields.system());
  const double ground = fields.has(groundName) ? fields.amount(groundName) : 0.0;
  const Vec3 up = fields.direction("SkyUp");
  const std::string model = fields.text("SkyModel");
  if (model == "uniform")
  {
    return std::make_unique<UniformSky>(uniformRadiance(level), up, ground);
  }
  if (model == "overcast")
  {
    return std::make_unique<OvercastSky>(level, up, ground);
  }
  if (model != "general")
  {
    throw std::runtime_error(
      "its \"SkyModel\" is \"" + model + "\", but must be uniform, overcast or general");
  }
  const std::vector<double> p = fields.numbers("SkyDistribution");
  if (p.size() != 6 || !std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
  {
    throw std::runtime_error("its \"SkyDistribution\" must be 6 finite numbers");
  }
  return std::make_unique<GeneralSky>(SkyDistribution{ p[0], p[1], p[2], p[3], p[4], p[5] },
    fields.direction("SkyTowardsSun"), level, up, ground);
}

Made photometricSource(const LightFields& fields, double factor)
{
  auto web = std::make_shared<PhotometricWeb>();
  const std::string type = fields.text("PhotometricType");
  if (type != "C" && type != "B")
  {
    throw std::runtime_error("its \"PhotometricType\" is \"" + type + "\", but must be C or B");
  }
  web->type = type == "C" ? PhotometricWeb::Type::C : PhotometricWeb::Type::B;
  web->verticals = fields.numbers("PhotometricVerticals [deg]");
  web->horizontals = fields.numbers("PhotometricHorizontals [deg]");
  web->intensities =
    fields.numbers("Photometric" + arrayName(Quantity::Intensity, fields.system()));
  return std::make_unique<PhotometricSource>(web, fields.position(), fields.direction("LightAxis"),
    fields.direction("LightReference"), factor * fields.number("PhotometricScale"),
    fields.metresPerUnit());
}

Made makeSource(const std::string& type, const LightFields& fields, double factor)
{
  using Maker = std::function<Made(const LightFields&)>;
  const std::map<std::string, Maker> makers = {
    { "point", pointSource },
    { "directional", directionalSource },
    { "sun", sunSource },
    { "lobe", lobeSource },
    { "spot", spotSource },
    { "sphere", sphereSource },
    { "disk", diskSource },
    { "line", lineSource },
    { "tube", tubeSource },
    { "sky", skySource },
    { "area", [&](const LightFields& f) { return readAreaLight(f, factor); } },
    { "photometric", [&](const LightFields& f) { return photometricSource(f, factor); } },
  };
  const auto found = makers.find(type);
  if (found == makers.end())
  {
    std::string known;
    for (const auto& [name, maker] : makers)
    {
      known += (known.empty() ? "" : ", ") + name;
    }
    throw std::runtime_error(
      "this build does not know its type \"" + type + "\" (it knows " + known + ")");
  }
  return found->second(fields);
}

} // namespace

bool mayBeLight(vtkPolyData* data)
{
  vtkFieldData* fields = data->GetFieldData();
  return data->GetNumberOfPoints() > 0 || data->GetNumberOfCells() > 0 ||
    fields->GetAbstractArray("LightType") || fields->GetAbstractArray("LightSchema");
}

LightSystem readLightSystem(vtkPolyData* data)
{
  const double schema = LightFields::number(data, "LightSchema");
  if (schema != lightSchemaVersion)
  {
    std::ostringstream message;
    message << "its schema is version " << schema << ", but this build reads version "
            << lightSchemaVersion;
    throw std::runtime_error(message.str());
  }
  const double system = LightFields::number(data, "LightSystem");
  if (system != 0.0 && system != 1.0)
  {
    std::ostringstream message;
    message << "its \"LightSystem\" is " << system
            << ", but must be 0 (radiometric) or 1 (photometric)";
    throw std::runtime_error(message.str());
  }
  return static_cast<LightSystem>(static_cast<int>(system));
}

std::optional<double> readLuminousEfficacy(vtkPolyData* data)
{
  if (!data->GetFieldData()->GetAbstractArray("LuminousEfficacy [lm/W]"))
  {
    return std::nullopt;
  }
  const double value = LightFields::number(data, "LuminousEfficacy [lm/W]");
  if (!(value > 0.0) || !std::isfinite(value))
  {
    throw std::runtime_error("its \"LuminousEfficacy [lm/W]\" must be finite and above 0");
  }
  return value;
}

Light readLight(vtkPolyData* data, double metresPerUnit, std::optional<LightSystem> wanted)
{
  const LightSystem own = readLightSystem(data);
  const std::string type = LightFields::text(data, "LightType");
  Light light;
  light.name = LightFields::text(data, "LightName");
  light.system = wanted.value_or(own);
  double factor = 1.0;
  if (light.system != own)
  {
    const std::optional<double> efficacy = readLuminousEfficacy(data);
    if (!efficacy)
    {
      throw std::runtime_error("it has no \"LuminousEfficacy [lm/W]\" to convert it by");
    }
    factor = own == LightSystem::Radiometric ? *efficacy : 1.0 / *efficacy;
  }
  std::string problem;
  try
  {
    light.source = makeSource(type, LightFields(data, own, metresPerUnit, factor), factor);
  }
  catch (const std::invalid_argument& error)
  {
    // What the cores refuse is a sentence of its own.
    problem = error.what();
  }
  if (!problem.empty())
  {
    problem.erase(problem.find_last_not_of('.') + 1);
    throw std::runtime_error(problem);
  }
  return light;
}

} // namespace lumitree::filters
