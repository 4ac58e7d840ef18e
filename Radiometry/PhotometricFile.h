// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_PhotometricFile_h
#define Lumitree_Radiometry_PhotometricFile_h

#include "Radiometry/Export.h"
#include "Radiometry/PhotometricWeb.h"

#include <stdexcept>
#include <string>
#include <string_view>

/// Photometric files, in and out. What is malformed is refused with the number of the line and the
/// reason; memory is bounded by the length of the text, whatever its counts say.
namespace lumitree
{

/// Longer files are refused: bytes.
inline constexpr std::size_t photometricFileLimit = 64u << 20;

/// "line 12: ..."; line counts from 1, and is 0 where none is to blame.
class LUMITREE_RADIOMETRY_EXPORT PhotometricFileError : public std::runtime_error
{
public:
  PhotometricFileError(std::size_t line, const std::string& reason);
  [[nodiscard]] std::size_t line() const { return this->line_; }

private:
  std::size_t line_;
};

/// IES LM-63 of 1986 (no tag), 1991, 1995, 2002 and 2019; photometry of type C and B (A is
/// refused); TILT=NONE and TILT=INCLUDE. Intensities are times the candela multiplier and the
/// ballast factor, and in 1986 and 1991 the ballast-lamp photometric factor. Horizontal angles of
/// type C: 0; 0 … 90, 0 … 180, 90 … 270 or 0 … 360; of type B: 0 … 90 or −90 … 90. statedFlux is
/// the lamps' (not that of the luminaire: the format has none). Throws PhotometricFileError.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT PhotometricWeb readIes(std::string_view text);

/// EULUMDAT/1 with all its symmetries (Isym 0 … 4). Intensities are those per 1000 lm times the
/// flux of the first set of lamps and the conversion factor; statedFlux is that flux times the
/// light output ratio. A decimal comma counts as a point. Throws PhotometricFileError.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT PhotometricWeb readEulumdat(std::string_view text);

/// One of both, by what the text looks like: an IES file has a line that begins with TILT=.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT PhotometricWeb readPhotometry(std::string_view text);

/// The same from a file. A file that cannot be read is a PhotometricFileError, too.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT PhotometricWeb readPhotometricFile(
  const std::string& path);

/// As LM-63-2002, absolute photometry (no lamp lumens) where no flux is stated. Numbers are the
/// shortest that read back as the same. Throws std::invalid_argument where the web is none.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT std::string writeIes(const PhotometricWeb& web);

/// As EULUMDAT/1, Isym 1 where it is the same all around, else 0. For lamps of the web's own flux,
/// so that its light output ratio is 100 %. Throws std::invalid_argument for a web of type B, one
/// without flux, and where it is none.
[[nodiscard]] LUMITREE_RADIOMETRY_EXPORT std::string writeEulumdat(const PhotometricWeb& web);

} // namespace lumitree

#endif
