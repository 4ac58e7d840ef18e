// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Photometry_Lines_h
#define Lumitree_Radiometry_Photometry_Lines_h

#include <cstddef>
#include <optional>
#include <string_view>

namespace lumitree
{

/// Text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// A finite number in the C locale, and nothing else; a leading + is allowed.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// The lines of a text, which end in \n, \r\n or \r.
class Lines
{
public:
  explicit Lines(std::string_view text)
    : rest_(text)
  {
  }

  /// False at the end of the text.
  bool next(std::string_view& line);

  /// Of the line that came last, from 1.
  [[nodiscard]] std::size_t number() const { return this->number_; }

  /// Bytes that are left: no more numbers than that can follow.
  [[nodiscard]] std::size_t left() const { return this->rest_.size(); }

private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

} // namespace lumitree

#endif
