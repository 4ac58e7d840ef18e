// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SourceChecks.h"

#include "Radiometry/Constants.h"
#include "Radiometry/PhotometricFile.h"
#include "Radiometry/PhotometricSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace lumitree;
using sourcechecks::expectRelative;

const Vec3 origin = { 0.0, 0.0, 0.0 };
const Vec3 down = { 0.0, 0.0, -1.0 };
const Vec3 east = { 1.0, 0.0, 0.0 };

/// 1000 cosγ every 10°, the same all around.
PhotometricWeb cosine()
{
  PhotometricWeb web;
  for (int i = 0; i <= 9; ++i)
  {
    web.verticals.push_back(10.0 * i);
    web.intensities.push_back(i == 9 ? 0.0 : 1000.0 * std::cos(10.0 * i * pi / 180.0));
  }
  web.horizontals = { 0.0 };
  return web;
}

/// A different value for each pair of angles.
PhotometricWeb uneven()
{
  PhotometricWeb web;
  web.name = "Uneven";
  web.verticals = { 0.0, 30.0, 75.0, 120.0, 180.0 };
  web.horizontals = { 0.0, 45.0, 100.0, 180.0, 290.0, 360.0 };
  for (std::size_t h = 0; h < web.horizontals.size(); ++h)
  {
    for (std::size_t v = 0; v < web.verticals.size(); ++v)
    {
      const bool pole = v == 0 || v + 1 == web.verticals.size();
      const std::size_t plane = h + 1 == web.horizontals.size() ? 0 : h;
      web.intensities.push_back(pole ? 100.0 : 100.0 + 37.0 * static_cast<double>(plane * 5 + v));
    }
  }
  return web;
}

const std::string ies = "IESNA:LM-63-2002\n"
                        "[TEST] none\n"
                        "[LUMINAIRE] A lamp, for tests\n"
                        "TILT=NONE\n"
                        "2 1000 2.0 3 2 1 2 0.1 0.2 0.0\n"
                        "0.5 1 40\n"
                        "0 45 90\n"
                        "0 90\n"
                        "100 80 0\n"
                        "100,60, 10\n";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expectError(const std::string& text, std::size_t line, const std::string& reason)
{
  try
  {
    (void)readPhotometry(text);
    ADD_FAILURE() << "read: " << reason;
  }
  catch (const PhotometricFileError& error)
  {
    EXPECT_EQ(error.line(), line) << error.what();
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST(PhotometricWeb, FluxOfTheInterpolant)
{
  // Not 1000 π: linear between the angles.
  expectRelative(cosine().flux(), 3133.593420246322);
  PhotometricWeb even;
  even.verticals = { 0.0, 180.0 };
  even.horizontals = { 0.0 };
  even.intensities = { 10.0, 10.0 };
  expectRelative(even.flux(), 40.0 * pi);
  even.type = PhotometricWeb::Type::B;
  even.verticals = { -90.0, 90.0 };
  even.horizontals = { -90.0, 0.0, 90.0 };
  even.intensities = { 10.0, 10.0, 10.0, 10.0, 10.0, 10.0 };
  expectRelative(even.flux(), 20.0 * pi);
}

TEST(PhotometricWeb, Interpolates)
{
  const PhotometricWeb web = uneven();
  EXPECT_EQ(web.intensity(45.0, 30.0), web.intensities[6]);
  expectRelative(web.intensity(22.5, 30.0), 0.5 * (web.intensities[1] + web.intensities[6]));
  expectRelative(web.intensity(45.0, 52.5), 0.5 * (web.intensities[6] + web.intensities[7]));
  expectRelative(
    web.intensity(325.0 - 720.0, 75.0), 0.5 * (web.intensities[22] + web.intensities[2]));
  EXPECT_EQ(web.intensity(10.0, -1.0), 0.0);
  EXPECT_EQ(cosine().intensity(77.0, 91.0), 0.0);
  EXPECT_EQ(cosine().intensity(std::nan(""), 10.0), cosine().intensity(0.0, 10.0));
  EXPECT_EQ(web.intensity(std::nan(""), 30.0), 0.0);
}

TEST(PhotometricSource, OrientationAndFlux)
{
  auto web = std::make_shared<PhotometricWeb>(uneven());
  const PhotometricSource source(web, origin, down, east, 2.0);
  EXPECT_EQ(*source.intensity(down), 200.0);
  const double g = 75.0 * pi / 180.0;
  expectRelative(*source.intensity({ std::sin(g), 0.0, -std::cos(g) }), 2.0 * web->intensities[2]);
  // C 180, and C between 45 and 100 counterclockwise from above.
  expectRelative(
    *source.intensity({ -std::sin(g), 0.0, -std::cos(g) }), 2.0 * web->intensities[17]);
  expectRelative(
    *source.intensity({ 0.0, std::sin(g), -std::cos(g) }), 2.0 * web->intensity(90.0, 75.0));
  expectRelative(*source.flux(), 2.0 * web->flux());
  sourcechecks::expectFluxThroughSphere(source, origin, 2.0, 1e-3);
  // Turned: the axis along x, C 0 up.
  const PhotometricSource turned(web, origin, east, { 0.3, 0.0, 1.0 });
  expectRelative(*turned.intensity({ std::cos(g), 0.0, std::sin(g) }), web->intensities[2]);
}

TEST(PhotometricSource, TypeBLooksAlongItsAxis)
{
  auto web = std::make_shared<PhotometricWeb>();
  web->type = PhotometricWeb::Type::B;
  web->verticals = { -90.0, 0.0, 90.0 };
  web->horizontals = { -90.0, 0.0, 90.0 };
  web->intensities = { 1.0, 1.0, 1.0, 2.0, 5.0, 4.0, 3.0, 3.0, 3.0 };
  // Ahead is north; right is east; so V > 0 is up.
  const PhotometricSource source(web, origin, { 0.0, 1.0, 0.0 }, east);
  EXPECT_EQ(*source.intensity({ 0.0, 1.0, 0.0 }), 5.0);
  expectRelative(*source.intensity({ 1.0, 1.0, 0.0 }), 4.0);
  expectRelative(*source.intensity({ 0.0, 1.0, 1.0 }), 4.5);
  expectRelative(*source.intensity({ 0.0, 1.0, -1.0 }), 3.5);
  EXPECT_EQ(*source.intensity({ 0.0, -1.0, 0.1 }), 0.0);
  sourcechecks::expectFluxThroughSphere(source, origin, 2.0, 1e-3);
}

TEST(PhotometricSource, RefusesWhatIsNoSource)
{
  const auto good = std::make_shared<PhotometricWeb>(uneven());
  EXPECT_THROW(PhotometricSource(nullptr, origin, down, east), std::invalid_argument);
  EXPECT_THROW(PhotometricSource(good, origin, down, down), std::invalid_argument);
  EXPECT_THROW(PhotometricSource(good, origin, origin, east), std::invalid_argument);
  EXPECT_THROW(PhotometricSource(good, origin, down, east, -1.0), std::invalid_argument);
  for (const int fault : { 0, 1, 2, 3, 4 })
  {
    auto bad = std::make_shared<PhotometricWeb>(uneven());
    switch (fault)
    {
      case 0:
        bad->intensities.pop_back();
        break;
      case 1:
        bad->intensities[3] = -1.0;
        break;
      case 2:
        bad->verticals[2] = 10.0;
        break;
      case 3:
        bad->horizontals.back() = 350.0;
        break;
      default:
        bad->verticals.back() = 181.0;
    }
    EXPECT_THROW(PhotometricSource(bad, origin, down, east), std::invalid_argument) << fault;
  }
}

TEST(IesFile, ReadsAndUnfoldsAQuarter)
{
  const PhotometricWeb web = readPhotometry(ies);
  EXPECT_EQ(web.format, "IES LM-63-2002");
  EXPECT_EQ(web.name, "A lamp, for tests");
  EXPECT_EQ(web.statedFlux, 2000.0);
  EXPECT_EQ(web.watts, 40.0);
  EXPECT_EQ(web.length, 0.2);
  EXPECT_EQ(web.horizontals, (std::vector<double>{ 0.0, 90.0, 180.0, 270.0, 360.0 }));
  for (const double plane : { 0.0, 180.0, 360.0 })
  {
    EXPECT_EQ(web.intensity(plane, 45.0), 80.0);
  }
  for (const double plane : { 90.0, 270.0 })
  {
    EXPECT_EQ(web.intensity(plane, 45.0), 60.0);
  }
  web.check();
}

TEST(IesFile, EditionsAndTheirFactors)
{
  const std::string body = replaced(ies, "0.5 1 40", "0.5 0.8 40");
  const auto at = [](const std::string& text) { return readIes(text).intensity(0.0, 0.0); };
  EXPECT_EQ(at(body), 100.0);
  EXPECT_EQ(at(replaced(body, "IESNA:LM-63-2002", "IESNA:LM-63-1995")), 100.0);
  EXPECT_EQ(at(replaced(body, "IESNA:LM-63-2002", "IES:LM-63-2019")), 100.0);
  EXPECT_EQ(at(replaced(body, "IESNA:LM-63-2002", "IESNA91")), 80.0);
  const PhotometricWeb old = readIes(replaced(body, "IESNA:LM-63-2002\n", ""));
  EXPECT_EQ(old.format, "IES LM-63-1986");
  EXPECT_EQ(old.intensity(0.0, 0.0), 80.0);
  expectError(replaced(body, "IESNA:LM-63-2002", "IES:LM-63-2050"), 1, "edition");
  EXPECT_NEAR(readIes(replaced(ies, "1 2 0.1", "1 1 0.1")).width, 0.03048, 1e-15); // feet
  EXPECT_FALSE(readIes(replaced(ies, "2 1000 ", "1 -1 ")).statedFlux);             // absolute
}

TEST(IesFile, Symmetries)
{
  const auto planes = [](const std::string& angles) {
    return readIes("IESNA91\nTILT=NONE\n1 -1 1 1 3 1 2 0 0 0 1 1 0\n0\n" + angles + "\n1\n2\n3\n");
  };
  const PhotometricWeb half = planes("0 40 180");
  EXPECT_EQ(half.horizontals, (std::vector<double>{ 0.0, 40.0, 180.0, 320.0, 360.0 }));
  EXPECT_EQ(half.intensities, (std::vector<double>{ 1.0, 2.0, 3.0, 2.0, 1.0 }));
  const PhotometricWeb other = planes("90 180 270");
  EXPECT_EQ(other.horizontals, (std::vector<double>{ 0.0, 90.0, 180.0, 270.0, 360.0 }));
  EXPECT_EQ(other.intensities, (std::vector<double>{ 2.0, 1.0, 2.0, 3.0, 2.0 }));
  EXPECT_EQ(planes("0 100 360").intensities, (std::vector<double>{ 1.0, 2.0, 3.0 }));
  const PhotometricWeb flood =
    readIes("IESNA91\nTILT=NONE\n1 -1 1 1 3 2 2 0 0 0 1 1 0\n0\n0 30 90\n1\n2\n3\n");
  EXPECT_EQ(flood.horizontals, (std::vector<double>{ -90.0, -30.0, 0.0, 30.0, 90.0 }));
  EXPECT_EQ(flood.intensities, (std::vector<double>{ 3.0, 2.0, 1.0, 2.0, 3.0 }));
  EXPECT_EQ(flood.type, PhotometricWeb::Type::B);
}

TEST(IesFile, Tilt)
{
  const PhotometricWeb web =
    readIes(replaced(ies, "TILT=NONE", "TILT=INCLUDE\n1\n3\n0 45 90\n1.0 0.9 0.7"));
  EXPECT_EQ(web.tiltFactor(0.0), 1.0);
  expectRelative(web.tiltFactor(67.5), 0.8);
  EXPECT_EQ(web.tiltFactor(120.0), 0.7);
  EXPECT_EQ(readIes(ies).tiltFactor(45.0), 1.0);
  expectError(replaced(ies, "TILT=NONE", "TILT=lamp.tlt"), 4, "lamp.tlt");
}

TEST(IesFile, MalformedFilesNameTheirLine)
{
  expectError(replaced(ies, "3 2 1 2", "3 2 3 2"), 5, "type A");
  expectError(replaced(ies, "3 2 1 2", "3 2 7 2"), 5, "photometric type");
  expectError(replaced(ies, "3 2 1 2", "3 2 1 4"), 5, "unit of lengths");
  expectError(replaced(ies, "3 2 1 2", "0 2 1 2"), 5, "vertical angles");
  expectError(replaced(ies, "3 2 1 2", "3.5 2 1 2"), 5, "vertical angles");
  expectError(replaced(ies, "3 2 1 2", "3 999999999 1 2"), 5, "can hold");
  expectError(replaced(ies, "3 2 1 2", "1e300 2 1 2"), 5, "can hold");
  expectError(replaced(ies, "0 45 90", "0 95 90"), 7, "vertical angles");
  expectError(replaced(ies, "0 90\n", "0 91\n"), 8, "horizontal angles");
  expectError(replaced(ies, "100 80 0", "100 eighty 0"), 9, "eighty");
  expectError(replaced(ies, "100 80 0", "100 -80 0"), 9, "negative");
  expectError(replaced(ies, "100 80 0", "100 nan 0"), 9, "nan");
  expectError(replaced(ies, "60, 10", "60"), 10, "ends before");
  expectError(replaced(ies, "TILT=NONE\n", ""), 9, "TILT");
  expectError("", 0, "company");
}

const std::string& eulumdat()
{
  static const std::string text = writeEulumdat(uneven());
  return text;
}

/// Planes 0, 90, 180, 270 with intensities 1, 2, … in the planes that are stored.
PhotometricWeb symmetric(int isym, int planes, int stored)
{
  std::string text = "x\n3\n" + std::to_string(isym) + "\n" + std::to_string(planes) +
    "\n0\n1\n0\n\nname\n\n\n\n100\n100\n0\n50\n50\n0\n0\n0\n0\n100\n80\n1\n0\n1\n1\nlamp\n1000\n\n"
    "\n36\n";
  for (int i = 0; i < 10; ++i)
  {
    text += "0\n";
  }
  for (int c = 0; c < planes; ++c)
  {
    text += std::to_string(c * 360 / planes) + "\n";
  }
  text += "0\n";
  for (int i = 0; i < stored; ++i)
  {
    text += std::to_string(i + 1) + ",5\n";
  }
  return readPhotometry(text);
}

TEST(EulumdatFile, Symmetries)
{
  using Values = std::vector<double>;
  EXPECT_EQ(symmetric(0, 4, 4).intensities, (Values{ 1.5, 2.5, 3.5, 4.5, 1.5 }));
  EXPECT_EQ(symmetric(1, 4, 1).intensities, (Values{ 1.5 }));
  EXPECT_EQ(symmetric(2, 4, 3).intensities, (Values{ 1.5, 2.5, 3.5, 2.5, 1.5 }));
  // Stored are C 270, 0, 90; C 180 is the image of C 0.
  EXPECT_EQ(symmetric(3, 4, 3).intensities, (Values{ 2.5, 3.5, 2.5, 1.5, 2.5 }));
  EXPECT_EQ(symmetric(4, 4, 2).intensities, (Values{ 1.5, 2.5, 1.5, 2.5, 1.5 }));
  EXPECT_EQ(
    symmetric(3, 8, 5).intensities, (Values{ 3.5, 4.5, 5.5, 4.5, 3.5, 2.5, 1.5, 2.5, 3.5 }));
  EXPECT_EQ(
    symmetric(4, 8, 3).intensities, (Values{ 1.5, 2.5, 3.5, 2.5, 1.5, 2.5, 3.5, 2.5, 1.5 }));
  const PhotometricWeb web = symmetric(0, 4, 4);
  EXPECT_EQ(web.statedFlux, 800.0);
  EXPECT_EQ(web.watts, 36.0);
  EXPECT_EQ(web.name, "name");
  EXPECT_EQ(web.format, "EULUMDAT");
}

TEST(EulumdatFile, MalformedFilesNameTheirLine)
{
  expectError(replaced(eulumdat(), "\r\n3\r\n0\r\n", "\r\n3\r\n9\r\n"), 3, "symmetry");
  expectError(replaced(eulumdat(), "\r\n0\r\n5\r\n", "\r\n0\r\n999999999\r\n"), 4, "can hold");
  expectError(replaced(eulumdat(), "Uneven\r\n", ""), 27, "number of lamps"); // a line too few
}

TEST(PhotometricFiles, ComeBackAsTheyWere)
{
  for (const PhotometricWeb& web : { cosine(), uneven() })
  {
    const PhotometricWeb a = readPhotometry(writeIes(web));
    EXPECT_EQ(a.verticals, web.verticals);
    EXPECT_EQ(a.horizontals, web.horizontals);
    EXPECT_EQ(a.intensities, web.intensities);
    EXPECT_EQ(a.name, web.name);
    EXPECT_FALSE(a.statedFlux);
    const PhotometricWeb b = readPhotometry(writeEulumdat(web));
    EXPECT_EQ(b.verticals, web.verticals);
    EXPECT_EQ(b.horizontals, web.horizontals);
    expectRelative(b.flux(), web.flux(), 1e-14);
    expectRelative(*b.statedFlux, web.flux(), 1e-14);
  }
  PhotometricWeb tilted = cosine();
  tilted.tiltAngles = { 0.0, 90.0 };
  tilted.tiltFactors = { 1.0, 0.5 };
  EXPECT_EQ(readIes(writeIes(tilted)).tiltFactor(45.0), 0.75);
  tilted.type = PhotometricWeb::Type::B;
  EXPECT_THROW((void)writeEulumdat(tilted), std::invalid_argument);
  tilted.intensities.clear();
  EXPECT_THROW((void)writeIes(tilted), std::invalid_argument);
}

TEST(PhotometricFiles, TruncatedAndSpoiledOnesAreRefusedOrRead)
{
  for (const std::string& text : { ies, eulumdat() })
  {
    for (std::size_t size = 0; size < text.size(); ++size)
    {
      try
      {
        readPhotometry(text.substr(0, size)).check();
      }
      catch (const PhotometricFileError&)
      {
      }
    }
    for (std::size_t at = 0; at < text.size(); ++at)
    {
      for (const char spoiled : { '9', '-', 'x', '\n', '\0', '\xff' })
      {
        std::string copy = text;
        copy[at] = spoiled;
        try
        {
          readPhotometry(copy).check();
        }
        catch (const PhotometricFileError&)
        {
        }
      }
    }
  }
  EXPECT_THROW((void)readPhotometricFile("/nowhere/at/all.ies"), PhotometricFileError);
  EXPECT_THROW((void)readPhotometricFile("/"), PhotometricFileError);
}

} // namespace
