// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every light from its VTK source through its field data to the core: the irradiance at a receiver
// is the closed form's.
#include "SourcesTools.h"

#include "vtkLumiAreaLight.h"
#include "vtkLumiDirectionalLight.h"
#include "vtkLumiIrradiance.h"
#include "vtkLumiPhotometricLight.h"
#include "vtkLumiPointLight.h"
#include "vtkLumiShapeLight.h"
#include "vtkLumiSky.h"
#include "vtkLumiSpotLight.h"
#include "vtkLumiSun.h"

#include "Radiometry/Constants.h"
#include "Radiometry/PhotometricFile.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

using namespace sources;

namespace
{

/// Irradiance of a small horizontal receiver in the origin that looks up; NaN where there is none.
double irradianceOf(const std::vector<vtkAlgorithm*>& lights, int lengthUnit = 0,
  std::string* problem = nullptr, const char* name = "Irradiance [W/m^2]")
{
  const double h = 1e-7;
  vtkNew<vtkPlaneSource> receiver;
  receiver->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  receiver->SetOrigin(-h, -h, 0.0);
  receiver->SetPoint1(h, -h, 0.0);
  receiver->SetPoint2(-h, h, 0.0);
  vtkNew<vtkLumiIrradiance> filter;
  vtkNew<Messages> messages;
  messages->watch(filter);
  filter->SetInputConnection(receiver->GetOutputPort());
  for (vtkAlgorithm* light : lights)
  {
    filter->AddLightsConnection(light->GetOutputPort());
  }
  filter->SetShadows(false);
  filter->SetLengthUnit(lengthUnit);
  filter->Update();
  if (problem)
  {
    *problem = messages->last;
  }
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* values = output->GetCellData()->GetArray(name);
  return values && values->GetNumberOfTuples() > 0 ? values->GetComponent(0, 0)
                                                   : std::numeric_limits<double>::quiet_NaN();
}

double field(vtkAlgorithm* light, const char* name)
{
  light->Update();
  vtkDataArray* array = light->GetOutputDataObject(0)->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::numeric_limits<double>::quiet_NaN();
}

void expectRelative(double value, double reference, double tolerance = 1e-9)
{
  EXPECT_NEAR(value, reference, tolerance * std::fabs(reference));
}

/// 1000 cosγ cd every 10°.
std::string cosineFile()
{
  lumitree::PhotometricWeb web;
  web.horizontals = { 0.0 };
  web.name = "Cosine";
  web.statedFlux = 1000.0 * pi;
  for (int i = 0; i <= 9; ++i)
  {
    web.verticals.push_back(10.0 * i);
    web.intensities.push_back(i == 9 ? 0.0 : 1000.0 * std::cos(i * pi / 18.0));
  }
  std::string path = ::testing::TempDir() + "lumitree_cosine.ies";
  std::ofstream(path) << lumitree::writeIes(web);
  return path;
}

}

TEST(LightTypes, SpotAndLobe)
{
  vtkNew<vtkLumiSpotLight> spot;
  spot->SetPosition(0.0, 0.0, 2.0);
  spot->SetEmissionKind(vtkLumiSpotLight::AxialIntensity);
  spot->SetEmission(40.0);
  expectRelative(irradianceOf({ spot }), 10.0);
  spot->SetFalloff(vtkLumiSpotLight::CosineLobe);
  spot->SetExponent(20.0);
  spot->SetEmissionKind(vtkLumiSpotLight::Flux);
  spot->SetEmission(1000.0);
  expectRelative(irradianceOf({ spot }), 3342.253804929802 / 4.0);
  EXPECT_GT(spot->GetOutput()->GetNumberOfPolys(), 0);
  spot->SetLength(0.0);
  spot->Update();
  EXPECT_EQ(spot->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_EQ(spot->GetOutput()->GetNumberOfPolys(), 0);
}

TEST(LightTypes, Shapes)
{
  vtkNew<vtkLumiShapeLight> light;
  light->SetEmission(100.0);
  light->SetOrigin(0.0, 0.0, 3.0);
  light->SetRadius(1.0);
  expectRelative(irradianceOf({ light }), 100.0 * pi / 9.0); // sphere
  // The same by its exitance, and by its flux 4π² R² L in millimetres.
  light->SetEmissionQuantity(vtkLumiShapeLight::Exitance);
  light->SetEmission(100.0 * pi);
  expectRelative(irradianceOf({ light }), 100.0 * pi / 9.0);
  light->SetEmissionQuantity(vtkLumiShapeLight::Flux);
  light->SetEmission(4.0 * pi * pi * 1e-6 * 100.0);
  expectRelative(irradianceOf({ light }, 1), 100.0 * pi / 9.0, 1e-6);

  light->SetShape(vtkLumiShapeLight::Disk);
  light->SetEmissionQuantity(vtkLumiShapeLight::Radiance);
  light->SetEmission(100.0);
  light->SetOrigin(0.0, 0.0, 2.0);
  expectRelative(irradianceOf({ light }), 62.83185307179586);

  light->SetShape(vtkLumiShapeLight::Rectangle);
  light->SetOrigin(-0.5, -0.5, 1.0);
  light->SetPoint1(-0.5, 0.5, 1.0);
  light->SetPoint2(0.5, -0.5, 1.0);
  expectRelative(irradianceOf({ light }), 75.22746884541075);
  light->SetEmissionQuantity(vtkLumiShapeLight::Flux);
  light->SetEmission(100.0 * pi);
  expectRelative(irradianceOf({ light }), 75.22746884541075);

  light->SetShape(vtkLumiShapeLight::Tube);
  light->SetEmissionQuantity(vtkLumiShapeLight::Radiance);
  light->SetEmission(100.0);
  light->SetRadius(0.25);
  light->SetOrigin(0.0, 0.0, 2.0);
  light->SetPoint1(1.2, 0.0, 2.0);
  expectRelative(irradianceOf({ light }), 13.12872732613554);

  light->SetShape(vtkLumiShapeLight::Line);
  expectRelative(irradianceOf({ light }), 24.53989927147049);
  light->SetLineDistribution(vtkLumiShapeLight::Isotropic);
  expectRelative(irradianceOf({ light }), 25.72478777137633);
  light->SetEmissionQuantity(vtkLumiShapeLight::Flux);
  light->SetEmission(4.0 * pi * 100.0 * 1.2);
  expectRelative(irradianceOf({ light }), 25.72478777137633);
}

TEST(LightTypes, AreaOfADataset)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetResolution(2, 2);
  plane->SetOrigin(-0.5, -0.5, 1.0);
  plane->SetPoint1(-0.5, 0.5, 1.0);
  plane->SetPoint2(0.5, -0.5, 1.0);
  vtkNew<vtkLumiAreaLight> light;
  light->SetInputConnection(plane->GetOutputPort());
  light->SetEmission(100.0);
  expectRelative(irradianceOf({ light }), 75.22746884541075);
  light->SetEmissionQuantity(vtkLumiAreaLight::Flux);
  light->SetTwoSided(true);
  light->SetEmission(200.0 * pi);
  expectRelative(irradianceOf({ light }), 75.22746884541075);

  // Each cell has its own: half of them nothing.
  plane->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(plane->GetOutput());
  vtkNew<vtkDoubleArray> array;
  array->SetName("Bright");
  for (const double value : { 100.0, 0.0, 100.0, 0.0 })
  {
    array->InsertNextValue(value);
  }
  data->GetCellData()->AddArray(array);
  light->SetInputDataObject(data);
  light->SetTwoSided(false);
  light->SetEmissionQuantity(vtkLumiAreaLight::Radiance);
  light->SetEmissionArray("Bright");
  expectRelative(irradianceOf({ light }), 0.5 * 75.22746884541075);
  EXPECT_TRUE(light->GetOutput()->GetCellData()->GetArray("Radiance [W/(m^2 sr)]"));
}

TEST(LightTypes, ASphereOfTrianglesIsLikeASphere)
{
  vtkNew<vtkSphereSource> mesh;
  mesh->SetCenter(0.0, 0.0, 3.0);
  mesh->SetRadius(1.0);
  mesh->SetThetaResolution(64);
  mesh->SetPhiResolution(64);
  vtkNew<vtkLumiAreaLight> light;
  light->SetInputConnection(mesh->GetOutputPort());
  light->SetEmission(100.0);
  expectRelative(irradianceOf({ light }), 100.0 * pi / 9.0, 1e-2);
}

TEST(LightTypes, SunAndSkies)
{
  vtkNew<vtkLumiDirectionalLight> disk;
  disk->SetDirection(0.0, 3.0, -4.0);
  disk->SetNormalIrradiance(1000.0);
  disk->SetAngularDiameter(0.533);
  expectRelative(irradianceOf({ disk }), 800.0);

  vtkNew<vtkLumiSky> sky;
  sky->SetGroundRadiance(7.0); // which the receiver does not see
  expectRelative(irradianceOf({ sky }), pi);
  sky->SetModel(vtkLumiSky::CieOvercast);
  expectRelative(irradianceOf({ sky }), 2.443460952792061);
  sky->SetModel(vtkLumiSky::CieGeneral);
  expectRelative(irradianceOf({ sky }), 4.848524088837507);
  sky->SetSunAzimuth(77.0);
  expectRelative(irradianceOf({ sky }), 4.848524088837507);
  sky->SetLevelQuantity(vtkLumiSky::HorizontalIrradiance);
  sky->SetLevel(123.0);
  expectRelative(irradianceOf({ sky }), 123.0);
  sky->SetModel(vtkLumiSky::AllWeather);
  expectRelative(irradianceOf({ sky }), 100.0);
  EXPECT_GT(sky->GetOutput()->GetNumberOfPolys(), 0);
  sky->SetSystem(vtkLumiLight::Photometric);
  sky->SetModel(vtkLumiSky::CieOvercast);
  expectRelative(irradianceOf({ sky }, 0, nullptr, "Illuminance [lx]"), 123.0);
}

TEST(LightTypes, TheSunHasTime)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkNew<vtkLumiSun> sun;
  sun->SetLatitude(39.742476);
  sun->SetLongitude(-105.1786);
  sun->SetDate(2003, 10, 17);
  sun->SetUTCOffset(-7.0);
  sun->SetHour(12.5 + 30.0 / 3600.0);
  EXPECT_NEAR(field(sun, "SunZenith [deg]"), 50.11, 0.01);
  EXPECT_NEAR(field(sun, "SunAzimuth [deg]"), 194.34, 0.01);
  expectRelative(
    irradianceOf({ sun }), 1000.0 * std::cos(field(sun, "SunZenith [deg]") * pi / 180.0));
  sun->SetTimeSteps(25);
  sun->UpdateInformation();
  vtkInformation* information = sun->GetOutputInformation(0);
  ASSERT_EQ(information->Length(Pipeline::TIME_STEPS()), 25);
  EXPECT_EQ(information->Get(Pipeline::TIME_STEPS(), 24), 24.0);
  sun->UpdateTimeStep(0.0);
  EXPECT_EQ(
    sun->GetOutput()->GetFieldData()->GetArray("NormalIrradiance [W/m^2]")->GetComponent(0, 0),
    0.0);
  sun->UpdateTimeStep(12.0);
  EXPECT_EQ(
    sun->GetOutput()->GetFieldData()->GetArray("NormalIrradiance [W/m^2]")->GetComponent(0, 0),
    1000.0);
  EXPECT_EQ(sun->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 12.0);

  // A sky around it has the same time.
  vtkNew<vtkLumiSky> sky;
  sky->SetModel(vtkLumiSky::AllWeather);
  sky->SetInputConnection(sun->GetOutputPort());
  sky->UpdateInformation();
  EXPECT_EQ(sky->GetOutputInformation(0)->Length(Pipeline::TIME_STEPS()), 25);
  const auto of = [](vtkAlgorithm* light, const char* name, double time, int component)
  {
    light->UpdateTimeStep(time);
    return vtkDataObject::SafeDownCast(light->GetOutputDataObject(0))
      ->GetFieldData()
      ->GetArray(name)
      ->GetComponent(0, component);
  };
  for (const double time : { 9.0, 15.0 })
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(of(sky, "SkyTowardsSun", time, k), -of(sun, "LightDirection", time, k), 1e-12);
    }
  }
  EXPECT_EQ(of(sky, "DiffuseHorizontalIrradiance [W/m^2]", 15.0, 0), 100.0);
  EXPECT_EQ(of(sky, "DiffuseHorizontalIrradiance [W/m^2]", 0.0, 0), 0.0);
}

TEST(LightTypes, PhotometricFile)
{
  const std::string path = cosineFile();
  vtkNew<vtkLumiPhotometricLight> light;
  light->SetFileName(path.c_str());
  light->SetPosition(0.0, 0.0, 2.0);
  light->SetScale(0.5);
  expectRelative(irradianceOf({ light }, 0, nullptr, "Illuminance [lx]"), 125.0);
  expectRelative(field(light, "LuminousFlux [lm]"), 0.5 * 3133.593420246322);
  expectRelative(field(light, "StatedLuminousFlux [lm]"), 1000.0 * pi);
  std::ofstream(path) << "IESNA91\nTILT=NONE\n1 -1 1 1 1 3\n";
  vtkNew<Messages> messages;
  messages->watch(light);
  light->Modified();
  light->Update();
  EXPECT_EQ(messages->errors, 1);
  EXPECT_NE(messages->last.find("line 3"), std::string::npos) << messages->last;
  EXPECT_NE(messages->last.find("type A"), std::string::npos) << messages->last;
  EXPECT_EQ(light->GetOutput()->GetNumberOfPoints(), 0);
  std::remove(path.c_str());
}

TEST(LightTypes, SystemsAreMixedByAnEfficacyOnly)
{
  vtkNew<vtkLumiPointLight> watts;
  watts->SetPosition(0.0, 0.0, 2.0);
  watts->SetFlux(4.0 * pi * 4.0); // 4 W/m² × 4 m² / 4 m²
  vtkNew<vtkLumiPointLight> lumens;
  lumens->SetPosition(0.0, 0.0, 2.0);
  lumens->SetSystem(vtkLumiLight::Photometric);
  lumens->SetFlux(4.0 * pi * 4.0 * 200.0); // 200 times as much
  std::string problem;
  EXPECT_TRUE(std::isnan(irradianceOf({ watts, lumens }, 0, &problem)));
  EXPECT_NE(problem.find("luminous efficacy"), std::string::npos) << problem;
  lumens->SetLuminousEfficacy(100.0);

  expectRelative(irradianceOf({ lumens, watts }),
    irradianceOf({ watts }) + irradianceOf({ lumens }, 0, nullptr, "Illuminance [lx]") / 100.0);
  lumens->SetLuminousEfficacy(0.0);
  watts->SetLuminousEfficacy(100.0);
  expectRelative(irradianceOf({ watts, lumens }, 0, nullptr, "Illuminance [lx]"),
    100.0 * irradianceOf({ watts }) + irradianceOf({ lumens }, 0, nullptr, "Illuminance [lx]"));
  // Both have one: the first light's system.
  lumens->SetLuminousEfficacy(100.0);
  EXPECT_FALSE(std::isnan(irradianceOf({ watts, lumens })));
}

TEST(LightTypes, BadPropertiesAreOneErrorAndAnEmptyOutput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto check = [](vtkLumiLight* light, const std::function<void()>& spoil)
  {
    vtkNew<Messages> messages;
    messages->watch(light);
    spoil();
    light->Update();
    EXPECT_EQ(messages->errors, 1) << light->GetClassName() << " " << messages->last;
    EXPECT_EQ(light->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(light->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  };
  using Spot = std::function<void(vtkLumiSpotLight*)>;
  for (const Spot& spoil :
    { Spot([](auto* l) { l->SetDirection(0.0, 0.0, 0.0); }),
      Spot([=](auto* l) { l->SetPosition(nan, 0.0, 0.0); }),
      Spot([](auto* l) { l->SetConeAngle(40.0); }), Spot([](auto* l) { l->SetCutoffAngle(181.0); }),
      Spot([](auto* l) { l->SetExponent(-1.0); }), Spot([](auto* l) { l->SetEmission(-1.0); }),
      Spot([](auto* l) { l->SetLuminousEfficacy(684.0); }) })
  {
    vtkNew<vtkLumiSpotLight> light;
    check(light, [&] { spoil(light); });
  }
  using Shape = std::function<void(vtkLumiShapeLight*)>;
  for (const Shape& spoil :
    { Shape([](auto* l) { l->SetRadius(0.0); }), Shape([=](auto* l) { l->SetEmission(nan); }),
      Shape([](auto* l) { l->SetShape(1), l->SetNormal(0.0, 0.0, 0.0); }),
      Shape([](auto* l) { l->SetShape(2), l->SetPoint2(2.0, 0.0, 0.0); }),
      Shape([](auto* l) { l->SetShape(3), l->SetPoint1(0.0, 0.0, 0.0); }),
      Shape([](auto* l) { l->SetShape(4), l->SetEmissionQuantity(1); }) })
  {
    vtkNew<vtkLumiShapeLight> light;
    check(light, [&] { spoil(light); });
  }
  using Sky = std::function<void(vtkLumiSky*)>;
  for (const Sky& spoil :
    { Sky([](auto* l) { l->SetLevel(-1.0); }), Sky([](auto* l) { l->SetSunZenith(91.0); }),
      Sky([](auto* l) { l->SetNorth(0.0, 0.0, 1.0); }),
      Sky([=](auto* l) { l->SetGroundRadiance(nan); }),
      Sky([](auto* l) { l->SetModel(3), l->SetSystem(1); }),
      Sky([](auto* l) { l->SetModel(3), l->SetDiffuseHorizontal(0.0); }) })
  {
    vtkNew<vtkLumiSky> light;
    check(light, [&] { spoil(light); });
  }
  using Sun = std::function<void(vtkLumiSun*)>;
  for (const Sun& spoil :
    { Sun([](auto* l) { l->SetLatitude(91.0); }), Sun([](auto* l) { l->SetDate(2024, 13, 1); }),
      Sun([=](auto* l) { l->SetHour(nan); }), Sun([](auto* l) { l->SetUp(0.0, 0.0, 0.0); }),
      Sun([](auto* l) { l->SetAngularDiameter(-1.0); }) })
  {
    vtkNew<vtkLumiSun> light;
    check(light, [&] { spoil(light); });
  }
  vtkNew<vtkLumiPhotometricLight> photometric;
  check(photometric, [] {});
  photometric->SetFileName("/nowhere/at/all.ies");
  check(photometric, [] {});
  vtkNew<vtkLumiAreaLight> area;
  vtkNew<vtkPolyData> empty;
  area->SetInputData(empty);
  check(area, [] {});
  vtkNew<vtkPlaneSource> plane;
  area->SetInputConnection(plane->GetOutputPort());
  check(area, [&] { area->SetEmissionArray("not there"); });
}

TEST(LightTypes, OnlyPieceZeroHasTheLight)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkLumiAreaLight> area;
  area->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkLumiSpotLight> spot;
  vtkNew<vtkLumiShapeLight> shape;
  vtkNew<vtkLumiSun> sun;
  vtkNew<vtkLumiSky> sky;
  for (vtkLumiLight* light : { static_cast<vtkLumiLight*>(area), static_cast<vtkLumiLight*>(spot),
         static_cast<vtkLumiLight*>(shape), static_cast<vtkLumiLight*>(sun),
         static_cast<vtkLumiLight*>(sky) })
  {
    light->UpdatePiece(1, 2, 0);
    EXPECT_EQ(light->GetOutput()->GetNumberOfPoints(), 0) << light->GetClassName();
    EXPECT_EQ(light->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
    light->UpdatePiece(0, 2, 0);
    EXPECT_GT(light->GetOutput()->GetNumberOfPoints(), 0) << light->GetClassName();
  }
}

TEST(LightTypes, BadDataNameTheLight)
{
  vtkNew<vtkLumiShapeLight> source;
  source->SetName("Lamp");
  source->Update();
  const auto problemOf = [&](const std::function<void(vtkPolyData*)>& spoil)
  {
    vtkNew<vtkPolyData> data;
    data->DeepCopy(source->GetOutput());
    spoil(data);
    vtkNew<vtkPlaneSource> receiver;
    vtkNew<vtkLumiIrradiance> filter;
    vtkNew<Messages> messages;
    messages->watch(filter);
    filter->SetInputConnection(receiver->GetOutputPort());
    filter->AddLightsData(data);
    filter->Update();
    EXPECT_EQ(messages->errors, 1);
    EXPECT_NE(messages->last.find("Lamp"), std::string::npos) << messages->last;
    return messages->last;
  };
  EXPECT_NE(
    problemOf([](auto* d) { d->GetFieldData()->RemoveArray("LightRadius"); }).find("LightRadius"),
    std::string::npos);
  EXPECT_NE(problemOf([](auto* d) { d->GetFieldData()->RemoveArray("Radiance [W/(m^2 sr)]"); })
              .find("Radiance"),
    std::string::npos);
  EXPECT_NE(problemOf(
              [](auto* d)
              {
                vtkStringArray::SafeDownCast(d->GetFieldData()->GetAbstractArray("LightType"))
                  ->SetValue(0, "laser");
              })
              .find("laser"),
    std::string::npos);
  EXPECT_NE(
    problemOf([](auto* d) { d->GetFieldData()->GetArray("LightRadius")->SetComponent(0, 0, -1.0); })
      .find("radius"),
    std::string::npos);
}
