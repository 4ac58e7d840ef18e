// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SourcesTools.h"

#include "vtkLumiDirectionalLight.h"
#include "vtkLumiPointLight.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"

#include <functional>
#include <limits>

using namespace sources;

namespace
{

void expectCommon(vtkPolyData* light, const std::string& type, const std::string& name, int system)
{
  vtkFieldData* fields = light->GetFieldData();
  auto* schema = vtkIntArray::SafeDownCast(fields->GetArray("LightSchema"));
  auto* types = vtkStringArray::SafeDownCast(fields->GetAbstractArray("LightType"));
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("LightName"));
  auto* systems = vtkIntArray::SafeDownCast(fields->GetArray("LightSystem"));
  ASSERT_TRUE(schema && types && names && systems);
  ASSERT_EQ(schema->GetNumberOfValues(), 1);
  ASSERT_EQ(types->GetNumberOfValues(), 1);
  ASSERT_EQ(names->GetNumberOfValues(), 1);
  ASSERT_EQ(systems->GetNumberOfValues(), 1);
  EXPECT_EQ(schema->GetValue(0), 1);
  EXPECT_EQ(types->GetValue(0), type);
  EXPECT_EQ(names->GetValue(0), name);
  EXPECT_EQ(systems->GetValue(0), system);
}

void expectQuantity(vtkPolyData* light, const char* name, const std::string& unit, double value)
{
  auto* array = vtkDoubleArray::SafeDownCast(light->GetFieldData()->GetArray(name));
  ASSERT_TRUE(array) << name;
  ASSERT_EQ(array->GetNumberOfValues(), 1);
  EXPECT_EQ(array->GetValue(0), value);
  ASSERT_TRUE(array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()));
  EXPECT_EQ(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()), unit);
}

}

TEST(PointLight, IsAPointWithItsFlux)
{
  vtkNew<vtkLumiPointLight> light;
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFlux(40.0);
  light->Update();
  vtkPolyData* output = light->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 1);
  ASSERT_EQ(output->GetNumberOfVerts(), 1);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(point(output, 0), (Vec3{ 1.0, 2.0, 3.0 }));
  expectCommon(output, "point", "point", 0);
  expectQuantity(output, "RadiantFlux [W]", "W", 40.0);
  EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 5);

  light->SetSystem(vtkLumiLight::Photometric);
  light->SetName("Lamp");
  light->Update();
  expectCommon(output, "point", "Lamp", 1);
  expectQuantity(output, "LuminousFlux [lm]", "lm", 40.0);
  EXPECT_FALSE(output->GetFieldData()->GetArray("RadiantFlux [W]"));
}

TEST(DirectionalLight, IsALineWithItsDirection)
{
  vtkNew<vtkLumiDirectionalLight> light;
  light->SetDirection(0.0, 3.0, -4.0);
  light->SetNormalIrradiance(1000.0);
  light->SetAnchor(1.0, 1.0, 1.0);
  light->SetLength(10.0);
  light->SetName("");
  light->Update();
  vtkPolyData* output = light->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 2);
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  expectNear(point(output, 0), { 1.0, -5.0, 9.0 });
  expectNear(point(output, 1), { 1.0, 1.0, 1.0 });
  expectCommon(output, "directional", "directional", 0);
  expectQuantity(output, "NormalIrradiance [W/m^2]", "W/m^2", 1000.0);
  auto* direction =
    vtkDoubleArray::SafeDownCast(output->GetFieldData()->GetArray("LightDirection"));
  ASSERT_TRUE(direction);
  ASSERT_EQ(direction->GetNumberOfComponents(), 3);
  ASSERT_EQ(direction->GetNumberOfTuples(), 1);
  EXPECT_EQ(tuple(direction, 0), (Vec3{ 0.0, 3.0, -4.0 }));

  light->SetSystem(vtkLumiLight::Photometric);
  light->Update();
  expectCommon(output, "directional", "directional", 1);
  expectQuantity(output, "NormalIlluminance [lx]", "lx", 1000.0);
}

TEST(Lights, OnlyPieceZeroHasTheLight)
{
  vtkNew<vtkLumiPointLight> isotropic;
  vtkNew<vtkLumiDirectionalLight> directional;
  for (vtkLumiLight* light :
    { static_cast<vtkLumiLight*>(isotropic), static_cast<vtkLumiLight*>(directional) })
  {
    light->UpdatePiece(1, 2, 0);
    EXPECT_EQ(light->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(light->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
    light->UpdatePiece(0, 2, 0);
    EXPECT_GT(light->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(Lights, BadPropertiesAreOneErrorAndAnEmptyOutput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  using PointBreak = std::function<void(vtkLumiPointLight*)>;
  const PointBreak pointBreaks[] = {
    [=](auto* l) { l->SetPosition(0.0, nan, 0.0); },
    [](auto* l) { l->SetFlux(-1.0); },
    [=](auto* l) { l->SetFlux(nan); },
    [=](auto* l) { l->SetFlux(inf); },
  };
  using DirectionalBreak = std::function<void(vtkLumiDirectionalLight*)>;
  const DirectionalBreak directionalBreaks[] = {
    [](auto* l) { l->SetDirection(0.0, 0.0, 0.0); },
    [=](auto* l) { l->SetDirection(0.0, inf, 0.0); },
    [](auto* l) { l->SetNormalIrradiance(-1.0); },
    [=](auto* l) { l->SetNormalIrradiance(nan); },
    [=](auto* l) { l->SetAnchor(nan, 0.0, 0.0); },
    [](auto* l) { l->SetLength(0.0); },
  };
  const auto check = [](vtkLumiLight* light, const std::function<void()>& spoil)
  {
    vtkNew<Messages> messages;
    messages->watch(light);
    light->Update();
    EXPECT_EQ(messages->errors, 0);
    spoil();
    light->Update();
    EXPECT_EQ(messages->errors, 1) << messages->last;
    EXPECT_EQ(light->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(light->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  };
  for (const PointBreak& spoil : pointBreaks)
  {
    vtkNew<vtkLumiPointLight> light;
    check(light, [&] { spoil(light); });
  }
  for (const DirectionalBreak& spoil : directionalBreaks)
  {
    vtkNew<vtkLumiDirectionalLight> light;
    check(light, [&] { spoil(light); });
  }
}

TEST(Lights, AFluxOfZeroIsALight)
{
  vtkNew<vtkLumiPointLight> light;
  light->SetFlux(0.0);
  light->Update();
  expectQuantity(light->GetOutput(), "RadiantFlux [W]", "W", 0.0);
}
