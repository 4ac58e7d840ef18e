// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Radiometry/Photometry/Lines.h"

#include <charconv>
#include <cmath>

namespace lumitree
{

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t\f\v\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos
    ? std::string_view()
    : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::optional<double> parseNumber(std::string_view text)
{
  if (!text.empty() && text.front() == '+')
  {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-')
    {
      return std::nullopt;
    }
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() ||
    !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
}

bool Lines::next(std::string_view& line)
{
  if (this->rest_.empty())
  {
    return false;
  }
  ++this->number_;
  const std::size_t end = this->rest_.find_first_of("\r\n");
  if (end == std::string_view::npos)
  {
    line = this->rest_;
    this->rest_ = {};
    return true;
  }
  line = this->rest_.substr(0, end);
  const bool both =
    this->rest_[end] == '\r' && end + 1 < this->rest_.size() && this->rest_[end + 1] == '\n';
  this->rest_.remove_prefix(end + (both ? 2 : 1));
  return true;
}

} // namespace lumitree
