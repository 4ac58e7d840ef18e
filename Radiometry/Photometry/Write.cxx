// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/PhotometricFile.h"

#include "Radiometry/Photometry/Lines.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

namespace lumitree
{

namespace
{

std::string number(double value)
{
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return { buffer, result.ptr };
}

/// Numbers in lines of at most 10: below 256 characters, as LM-63 wants.
void writeList(std::string& out, const double* begin, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    out += number(begin[i]);
    out += (i + 1) % 10 == 0 || i + 1 == size ? "\r\n" : " ";
  }
}

std::string oneLine(std::string text, std::size_t longest)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return text.substr(0, longest);
}

} // namespace

PhotometricFileError::PhotometricFileError(std::size_t line, const std::string& reason)
  : std::runtime_error(line > 0 ? "line " + std::to_string(line) + ": " + reason : reason)
  , line_(line)
{
}

PhotometricWeb readPhotometry(std::string_view text)
{
  Lines lines(text);
  for (std::string_view line; lines.next(line);)
  {
    if (trimmed(line).substr(0, 5) == "TILT=")
    {
      return readIes(text);
    }
  }
  if (text.substr(0, 3) == "IES")
  {
    return readIes(text); // which says that there is no TILT
  }
  return readEulumdat(text);
}

PhotometricWeb readPhotometricFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw PhotometricFileError(0, "the file cannot be opened");
  }
  std::string text;
  std::string block(1u << 16, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
  {
    text.append(block, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > photometricFileLimit)
    {
      throw PhotometricFileError(0, "the file is too long");
    }
  }
  if (file.bad())
  {
    throw PhotometricFileError(0, "the file cannot be read");
  }
  return readPhotometry(text);
}

std::string writeIes(const PhotometricWeb& web)
{
  web.check();
  std::string out = "IESNA:LM-63-2002\r\n[TEST] none\r\n[TESTLAB] none\r\n[ISSUEDATE] none\r\n"
                    "[MANUFAC] none\r\n";
  if (!web.name.empty())
  {
    out += "[LUMINAIRE] " + oneLine(web.name, 200) + "\r\n";
  }
  if (web.tiltAngles.empty())
  {
    out += "TILT=NONE\r\n";
  }
  else
  {
    out += "TILT=INCLUDE\r\n1\r\n" + std::to_string(web.tiltAngles.size()) + "\r\n";
    writeList(out, web.tiltAngles.data(), web.tiltAngles.size());
    writeList(out, web.tiltFactors.data(), web.tiltFactors.size());
  }
  out += "1 " + number(web.statedFlux.value_or(-1.0)) + " 1 " +
    std::to_string(web.verticals.size()) + " " + std::to_string(web.horizontals.size()) +
    (web.type == PhotometricWeb::Type::C ? " 1 2 " : " 2 2 ") + number(web.width) + " " +
    number(web.length) + " " + number(web.height) + "\r\n1 1 " + number(web.watts) + "\r\n";
  writeList(out, web.verticals.data(), web.verticals.size());
  writeList(out, web.horizontals.data(), web.horizontals.size());
  for (std::size_t h = 0; h < web.horizontals.size(); ++h)
  {
    writeList(out, web.intensities.data() + h * web.verticals.size(), web.verticals.size());
  }
  return out;
}

std::string writeEulumdat(const PhotometricWeb& web)
{
  web.check();
  if (web.type != PhotometricWeb::Type::C)
  {
    throw std::invalid_argument("EULUMDAT has photometry of type C only.");
  }
  const double flux = web.flux();
  if (!(flux > 0.0))
  {
    throw std::invalid_argument("EULUMDAT needs a luminaire that emits something.");
  }
  const bool round = web.horizontals.size() == 1;
  const std::size_t planes = round ? 1 : web.horizontals.size() - 1;
  std::string out;
  const auto field = [&](const std::string& text) { out += text + "\r\n"; };
  field("none");
  field(round ? "1" : "3");
  field(round ? "1" : "0");
  field(std::to_string(planes));
  field("0");
  field(std::to_string(web.verticals.size()));
  field("0");
  field("");
  field(oneLine(web.name, 78));
  field("");
  field("");
  field("");
  for (int repeat = 0; repeat < 2; ++repeat)
  {
    field(number(1e3 * std::max(0.0, web.length)));
    field(number(1e3 * std::max(0.0, web.width)));
    if (repeat == 0)
    {
      field(number(1e3 * std::max(0.0, web.height)));
    }
  }
  for (int side = 0; side < 4; ++side)
  {
    field(number(1e3 * std::max(0.0, web.height)));
  }
  field("0");   // downward flux fraction: not stated
  field("100"); // light output ratio
  field("1");
  field("0");
  field("1");
  field("1");
  field("");
  field(number(flux));
  field("");
  field("");
  field(number(web.watts));
  for (int ratio = 0; ratio < 10; ++ratio)
  {
    field("0");
  }
  for (std::size_t c = 0; c < planes; ++c)
  {
    field(number(web.horizontals[c]));
  }
  for (const double gamma : web.verticals)
  {
    field(number(gamma));
  }
  for (std::size_t i = 0; i < planes * web.verticals.size(); ++i)
  {
    field(number(1000.0 * web.intensities[i] / flux));
  }
  return out;
}

} // namespace lumitree
