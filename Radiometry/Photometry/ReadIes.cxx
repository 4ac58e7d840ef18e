// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PhotometricFile.h"

#include "Radiometry/Photometry/Lines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lumitree
{

namespace
{

constexpr double metresPerFoot = 0.3048;

/// Numbers between blanks and commas, over as many lines as they take.
class Numbers
{
public:
  explicit Numbers(Lines& lines)
    : lines_(lines)
  {
  }

  double next(const char* what)
  {
    constexpr std::string_view separators = " \t,\f\v";
    std::size_t begin = this->line_.find_first_not_of(separators);
    while (begin == std::string_view::npos)
    {
      if (!this->lines_.next(this->line_))
      {
        throw PhotometricFileError(
          this->lines_.number(), std::string("the file ends before ") + what);
      }
      begin = this->line_.find_first_not_of(separators);
    }
    const std::size_t end =
      std::min(this->line_.find_first_of(separators, begin), this->line_.size());
    const std::string_view word = this->line_.substr(begin, end - begin);
    const std::optional<double> value = parseNumber(word);
    if (!value)
    {
      throw PhotometricFileError(this->lines_.number(),
        std::string(what) + " is no number: \"" + std::string(word.substr(0, 40)) + "\"");
    }
    this->line_.remove_prefix(end);
    return *value;
  }

  /// A whole number from low on, of which so many times each other numbers must fit in the rest of
  /// the text.
  std::size_t count(const char* what, int low, std::size_t each = 1)
  {
    const double value = this->next(what);
    if (!(value >= low) || value != std::floor(value))
    {
      throw PhotometricFileError(this->lines_.number(),
        std::string(what) + " must be a whole number from " + std::to_string(low));
    }
    const auto room = static_cast<double>(this->lines_.left() + this->line_.size());
    if (value * static_cast<double>(each) > room)
    {
      throw PhotometricFileError(
        this->lines_.number(), std::string(what) + " is more than the rest of the file can hold");
    }
    return static_cast<std::size_t>(value);
  }

  double atLeastZero(const char* what)
  {
    const double value = this->next(what);
    if (value < 0.0)
    {
      throw PhotometricFileError(
        this->lines_.number(), std::string(what) + " must not be negative");
    }
    return value;
  }

  std::vector<double> list(const char* what, std::size_t size)
  {
    std::vector<double> values;
    values.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      values.push_back(this->next(what));
    }
    return values;
  }

  std::vector<double> growing(const char* what, std::size_t size, double low, double high)
  {
    std::vector<double> values;
    values.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      const double value = this->next(what);
      if (!(value >= low && value <= high) || (i > 0 && !(value > values.back())))
      {
        throw PhotometricFileError(this->lines_.number(),
          std::string(what) + " must grow from " + std::to_string(static_cast<int>(low)) + " to " +
            std::to_string(static_cast<int>(high)) + " degrees");
      }
      values.push_back(value);
    }
    return values;
  }

  [[nodiscard]] std::size_t line() const { return this->lines_.number(); }

private:
  Lines& lines_;
  std::string_view line_;
};

bool beginsWith(std::string_view text, std::string_view beginning)
{
  return text.substr(0, beginning.size()) == beginning;
}

int editionOf(std::string_view firstLine)
{
  struct Tag
  {
    std::string_view text;
    int year;
  };
  constexpr std::array<Tag, 5> tags = { { { "IESNA:LM-63-1986", 1986 }, { "IESNA91", 1991 },
    { "IESNA:LM-63-1995", 1995 }, { "IESNA:LM-63-2002", 2002 }, { "IES:LM-63-2019", 2019 } } };
  for (const Tag& tag : tags)
  {
    if (beginsWith(firstLine, tag.text))
    {
      return tag.year;
    }
  }
  return beginsWith(firstLine, "IES") && firstLine.find("LM-63") != std::string_view::npos ? 0
                                                                                           : 1986;
}

/// Appends rows of intensities in that order.
void takeRows(
  PhotometricWeb& web, const std::vector<double>& rows, const std::vector<std::size_t>& order)
{
  const std::size_t size = web.verticals.size();
  for (const std::size_t row : order)
  {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(row * size);
    web.intensities.insert(web.intensities.end(), begin, begin + static_cast<std::ptrdiff_t>(size));
  }
}

/// Unfolds what the file leaves to symmetry.
void unfold(PhotometricWeb& web, const std::vector<double>& angles, const std::vector<double>& rows,
  std::size_t line)
{
  std::vector<std::size_t> order;
  const auto mirror = [&](double across)
  {
    // Planes beyond the last one are those before it, seen in a mirror.
    const std::size_t size = web.horizontals.size();
    for (std::size_t i = size - 1; i-- > 0;)
    {
      web.horizontals.push_back(2.0 * across - web.horizontals[i]);
      order.push_back(order[i]);
    }
  };
  web.horizontals = angles;
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    order.push_back(i);
  }
  const double first = angles.front();
  const double last = angles.back();
  if (web.type == PhotometricWeb::Type::B)
  {
    if (first == 0.0 && last == 90.0)
    {
      std::reverse(web.horizontals.begin(), web.horizontals.end());
      std::reverse(order.begin(), order.end());
      for (double& angle : web.horizontals)
      {
        angle = -angle;
      }
      web.horizontals.back() = 0.0;
      mirror(0.0);
    }
    else if (!(first < 0.0 && last > 0.0) && angles.size() > 1)
    {
      throw PhotometricFileError(
        line, "horizontal angles of type B must go from -90 to 90 or from 0 to 90 degrees");
    }
  }
  else if (angles.size() > 1)
  {
    if (first == 90.0 && last == 270.0)
    {
      // The same on both sides of the plane C 90 – C 270: 270 … 450, then in order from 0.
      mirror(270.0);
      std::vector<std::pair<double, std::size_t>> planes;
      for (std::size_t i = 0; i < order.size(); ++i)
      {
        const double turned =
          web.horizontals[i] >= 360.0 ? web.horizontals[i] - 360.0 : web.horizontals[i];
        planes.emplace_back(turned, order[i]);
      }
      std::sort(planes.begin(), planes.end());
      planes.erase(std::unique(planes.begin(), planes.end(),
                     [](const auto& a, const auto& b) { return a.first == b.first; }),
        planes.end());
      if (planes.front().first != 0.0)
      {
        throw PhotometricFileError(line, "horizontal angles from 90 to 270 must have 180 degrees");
      }
      planes.emplace_back(360.0, planes.front().second);
      web.horizontals.clear();
      order.clear();
      for (const auto& [angle, row] : planes)
      {
        web.horizontals.push_back(angle);
        order.push_back(row);
      }
    }
    else if (first != 0.0 || (last != 90.0 && last != 180.0 && last != 360.0))
    {
      throw PhotometricFileError(line,
        "horizontal angles of type C must be 0, or go from 0 to 90, 180 or 360, or from 90 to 270 "
        "degrees");
    }
    else
    {
      if (last == 90.0)
      {
        mirror(90.0);
      }
      if (last != 360.0)
      {
        mirror(180.0);
      }
    }
  }
  takeRows(web, rows, order);
}

} // namespace

PhotometricWeb readIes(std::string_view text)
{
  if (text.size() > photometricFileLimit)
  {
    throw PhotometricFileError(0, "the file is too long");
  }
  Lines lines(text);
  std::string_view line;
  PhotometricWeb web;
  int edition = 1986;
  std::string_view tilt;
  for (bool found = false; !found;)
  {
    if (!lines.next(line))
    {
      throw PhotometricFileError(lines.number(), "there is no line that begins with TILT=");
    }
    const std::string_view content = trimmed(line);
    if (lines.number() == 1)
    {
      edition = editionOf(content);
      if (edition == 0)
      {
        throw PhotometricFileError(
          1, "this edition of LM-63 is not known: \"" + std::string(content.substr(0, 40)) + "\"");
      }
    }
    if (beginsWith(content, "[LUMINAIRE]"))
    {
      web.name = std::string(trimmed(content.substr(11)));
    }
    found = beginsWith(content, "TILT=");
    tilt = found ? trimmed(content.substr(5)) : tilt;
  }
  web.format = "IES LM-63-" + std::to_string(edition);

  Numbers numbers(lines);
  if (tilt == "INCLUDE")
  {
    (void)numbers.next("the lamp-to-luminaire geometry");
    const std::size_t count = numbers.count("the number of tilt angles", 1, 2);
    web.tiltAngles = numbers.growing("tilt angles", count, 0.0, 180.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      web.tiltFactors.push_back(numbers.atLeastZero("a tilt factor"));
    }
  }
  else if (tilt != "NONE")
  {
    throw PhotometricFileError(lines.number(),
      "TILT must be NONE or INCLUDE; a file of its own (\"" + std::string(tilt.substr(0, 40)) +
        "\") is not read");
  }

  const double lamps = numbers.next("the number of lamps");
  const double lumens = numbers.next("the lumens per lamp");
  const double multiplier = numbers.atLeastZero("the candela multiplier");
  const std::size_t verticals = numbers.count("the number of vertical angles", 1);
  const std::size_t horizontals = numbers.count("the number of horizontal angles", 1, verticals);
  const double type = numbers.next("the photometric type");
  if (type == 3.0)
  {
    throw PhotometricFileError(numbers.line(), "photometry of type A is not read (C and B are)");
  }
  if (type != 1.0 && type != 2.0)
  {
    throw PhotometricFileError(
      numbers.line(), "the photometric type must be 1 (C), 2 (B) or 3 (A)");
  }
  web.type = type == 1.0 ? PhotometricWeb::Type::C : PhotometricWeb::Type::B;
  const double units = numbers.next("the unit of lengths");
  if (units != 1.0 && units != 2.0)
  {
    throw PhotometricFileError(
      numbers.line(), "the unit of lengths must be 1 (feet) or 2 (metres)");
  }
  const double metres = units == 1.0 ? metresPerFoot : 1.0;
  web.width = metres * numbers.next("the width");
  web.length = metres * numbers.next("the length");
  web.height = metres * numbers.next("the height");
  const double ballast = numbers.atLeastZero("the ballast factor");
  const double ballastLamp = numbers.next("the ballast-lamp photometric factor");
  web.watts = numbers.next("the input watts");
  if (lumens > 0.0 && lamps > 0.0)
  {
    web.statedFlux = lamps * lumens;
  }

  const bool polar = web.type == PhotometricWeb::Type::C;
  web.verticals =
    numbers.growing("vertical angles", verticals, polar ? 0.0 : -90.0, polar ? 180.0 : 90.0);
  const std::vector<double> angles =
    numbers.growing("horizontal angles", horizontals, polar ? 0.0 : -90.0, polar ? 360.0 : 90.0);
  const std::size_t angleLine = numbers.line();
  const double factor = multiplier * ballast * (edition <= 1991 ? ballastLamp : 1.0);
  std::vector<double> rows;
  rows.reserve(verticals * horizontals);
  for (std::size_t i = 0; i < verticals * horizontals; ++i)
  {
    const double value = factor * numbers.next("an intensity");
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      throw PhotometricFileError(
        numbers.line(), "an intensity is negative or, with its factors, not finite");
    }
    rows.push_back(value);
  }
  unfold(web, angles, rows, angleLine);
  return web;
}

} // namespace lumitree
