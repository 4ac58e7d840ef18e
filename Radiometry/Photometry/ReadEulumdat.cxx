// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PhotometricFile.h"

#include "Radiometry/Photometry/Lines.h"

#include <algorithm>
#include <cmath>

namespace lumitree
{

namespace
{

/// A field a line.
class Fields
{
public:
  explicit Fields(std::string_view text)
    : lines_(text)
  {
  }

  std::string_view text(const char* what)
  {
    std::string_view line;
    if (!this->lines_.next(line))
    {
      throw PhotometricFileError(
        this->lines_.number(), std::string("the file ends before ") + what);
    }
    return trimmed(line);
  }

  double number(const char* what)
  {
    std::string field(this->text(what));
    std::replace(field.begin(), field.end(), ',', '.');
    const std::optional<double> value = parseNumber(field);
    if (!value)
    {
      throw this->error(std::string(what) + " is no number: \"" + field.substr(0, 40) + "\"");
    }
    return *value;
  }

  /// A whole number of at least low, no more than the rest of the text can hold.
  std::size_t count(const char* what, int low)
  {
    const double value = this->number(what);
    if (!(value >= low) || value != std::floor(value))
    {
      throw this->error(std::string(what) + " must be a whole number from " + std::to_string(low));
    }
    if (value > static_cast<double>(this->lines_.left()))
    {
      throw this->error(std::string(what) + " is more than the rest of the file can hold");
    }
    return static_cast<std::size_t>(value);
  }

  void skip(int fields, const char* what)
  {
    for (int i = 0; i < fields; ++i)
    {
      (void)this->text(what);
    }
  }

  [[nodiscard]] PhotometricFileError error(const std::string& reason) const
  {
    return { this->lines_.number(), reason };
  }

  [[nodiscard]] std::size_t left() const { return this->lines_.left(); }

private:
  Lines lines_;
};

std::vector<double> growing(
  Fields& fields, const char* what, std::size_t size, double low, double high)
{
  std::vector<double> values;
  values.reserve(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const double value = fields.number(what);
    if (!(value >= low && value <= high) || (i > 0 && !(value > values.back())))
    {
      throw fields.error(std::string(what) + " must grow from " +
        std::to_string(static_cast<int>(low)) + " to " + std::to_string(static_cast<int>(high)) +
        " degrees");
    }
    values.push_back(value);
  }
  return values;
}

/// The plane of the file in which plane c of all is found, by symmetry.
std::size_t storedPlane(std::size_t c, std::size_t all, int symmetry)
{
  const std::size_t mirrored = (all - c) % all; // about C 0 – C 180
  switch (symmetry)
  {
    case 1:
      return 0;
    case 2:
      return std::min(c, mirrored);
    case 3:
    {
      // Planes 3/4 … 5/4 of the turn are there; about C 90 – C 270 plane c is the one at half a
      // turn less c.
      const std::size_t start = 3 * all / 4;
      const std::size_t ahead = (c + all - start) % all;
      const std::size_t other = (all + all / 2 - c) % all;
      return ahead <= all / 2 ? ahead : (other + all - start) % all;
    }
    case 4:
    {
      const std::size_t half = std::min(c, mirrored);
      return std::min(half, all / 2 - half);
    }
    default:
      return c;
  }
}

std::size_t storedCount(std::size_t all, int symmetry)
{
  switch (symmetry)
  {
    case 1:
      return 1;
    case 2:
    case 3:
      return all / 2 + 1;
    case 4:
      return all / 4 + 1;
    default:
      return all;
  }
}

} // namespace

PhotometricWeb readEulumdat(std::string_view text)
{
  if (text.size() > photometricFileLimit)
  {
    throw PhotometricFileError(0, "the file is too long");
  }
  Fields fields(text);
  PhotometricWeb web;
  web.format = "EULUMDAT";
  fields.skip(1, "the company");
  (void)fields.number("the type of light source");
  const double symmetryField = fields.number("the symmetry");
  if (!(symmetryField >= 0.0 && symmetryField <= 4.0) || symmetryField != std::floor(symmetryField))
  {
    throw fields.error("the symmetry must be 0, 1, 2, 3 or 4");
  }
  const int symmetry = static_cast<int>(symmetryField);
  const std::size_t planes = fields.count("the number of C planes", 1);
  const std::size_t unit = symmetry == 4 || symmetry == 3 ? 4 : (symmetry == 2 ? 2 : 1);
  if (planes % unit != 0)
  {
    throw fields.error(
      "with this symmetry the number of C planes must be a multiple of " + std::to_string(unit));
  }
  (void)fields.number("the distance of C planes");
  const std::size_t gammas = fields.count("the number of intensities in a C plane", 1);
  const std::size_t stored = storedCount(planes, symmetry);
  if (static_cast<double>(stored) * static_cast<double>(gammas) >
    static_cast<double>(fields.left()))
  {
    throw fields.error("there are more intensities than the rest of the file can hold");
  }
  (void)fields.number("the distance of intensities");
  fields.skip(1, "the measurement report");
  web.name = std::string(fields.text("the name of the luminaire"));
  fields.skip(3, "the date");
  for (const char* what :
    { "the length of the luminaire", "the width of the luminaire", "the height of the luminaire" })
  {
    (void)fields.number(what);
  }
  web.length = 1e-3 * fields.number("the length of the luminous area");
  web.width = 1e-3 * fields.number("the width of the luminous area");
  for (const char* what :
    { "the height of the luminous area in C 0", "… in C 90", "… in C 180", "… in C 270" })
  {
    web.height = std::max(web.height, 1e-3 * fields.number(what));
  }
  (void)fields.number("the downward flux fraction");
  const double outputRatio = fields.number("the light output ratio");
  const double conversion = fields.number("the conversion factor");
  (void)fields.number("the tilt of the luminaire");
  const std::size_t sets = fields.count("the number of sets of lamps", 1);
  double lampFlux = 0.0;
  for (std::size_t set = 0; set < sets; ++set)
  {
    (void)fields.number("the number of lamps");
    fields.skip(1, "the type of lamps");
    const double flux = fields.number("the flux of the lamps");
    fields.skip(2, "the colour of the lamps");
    const double watts = fields.number("the watts of the lamps");
    if (set == 0)
    {
      lampFlux = flux;
      web.watts = watts;
    }
  }
  for (int i = 0; i < 10; ++i)
  {
    (void)fields.number("a direct ratio");
  }
  if (!(lampFlux >= 0.0) || !(outputRatio >= 0.0) || !(conversion >= 0.0))
  {
    throw fields.error(
      "the flux of the lamps, the light output ratio and the conversion factor must not be "
      "negative");
  }
  web.statedFlux = lampFlux * outputRatio / 100.0;

  const std::vector<double> angles = growing(fields, "C angles", planes, 0.0, 360.0);
  if (angles.back() == 360.0 || angles.front() != 0.0)
  {
    throw fields.error("C angles must begin with 0 and end below 360 degrees");
  }
  if (symmetry > 1)
  {
    const double step = 360.0 / static_cast<double>(planes);
    for (std::size_t i = 0; i < planes; ++i)
    {
      // A plane and its mirror image must both be there for the one to stand for the other.
      const double image = symmetry == 3 ? 180.0 - angles[i] : -angles[i];
      const double turned = image - 360.0 * std::floor(image / 360.0);
      const std::size_t partner =
        symmetry == 3 ? (planes + planes / 2 - i) % planes : (planes - i) % planes;
      if (std::fabs(angles[partner] - turned) > 0.01 * step &&
        std::fabs(angles[partner] + 360.0 - turned) > 0.01 * step)
      {
        throw fields.error("the C angles do not have the symmetry of the file");
      }
    }
  }
  web.verticals = growing(fields, "gamma angles", gammas, 0.0, 180.0);
  const double factor = conversion * lampFlux / 1000.0;
  std::vector<double> rows;
  rows.reserve(stored * gammas);
  for (std::size_t i = 0; i < stored * gammas; ++i)
  {
    const double value = factor * fields.number("an intensity");
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      throw fields.error("an intensity is negative or, with its factors, not finite");
    }
    rows.push_back(value);
  }
  const auto take = [&](double angle, std::size_t plane)
  {
    web.horizontals.push_back(angle);
    const auto begin =
      rows.begin() + static_cast<std::ptrdiff_t>(storedPlane(plane, planes, symmetry) * gammas);
    web.intensities.insert(
      web.intensities.end(), begin, begin + static_cast<std::ptrdiff_t>(gammas));
  };
  if (symmetry == 1 || planes == 1)
  {
    take(0.0, 0);
  }
  else
  {
    // Unfolded planes are bounded by what the file lists: their angles are all in it.
    for (std::size_t c = 0; c < planes; ++c)
    {
      take(angles[c], c);
    }
    take(360.0, 0);
  }
  return web;
}

} // namespace lumitree
