// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Save_h
#define Lumitree_Accel_Save_h

#include "Accel/Accelerator.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <stdexcept>
#include <string>

namespace lumitree
{

/// What is saved of a structure are the builder's decisions: its options, which nodes there are,
/// planes, and in hierarchies of boxes which primitives lie in which leaf. All that a wrong hit
/// could come from (boxes, and what else lies in which leaf) is computed from the surface again, so
/// no file, however it came about, makes a structure that answers wrongly. The format is described
/// in Docs/saved-structures.md.

/// A file or stream that is no saved structure, is damaged, or is of another surface or version;
/// or one that cannot be read or written.
class LUMITREE_ACCEL_EXPORT SaveError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A structure that was saved of another surface.
class LUMITREE_ACCEL_EXPORT WrongSurface : public SaveError
{
public:
  using SaveError::SaveError;
};

/// The version that is written. Only this one is read.
inline constexpr std::uint32_t saveVersion = 2;

/// SHA-1 over points, triangles, quadrics and implicits as they are stored, cut to 16 bytes. The map
/// to cells is not part of it. Throws SaveError where an implicit's function has no numbers (those
/// that are sampled).
using Fingerprint = std::array<std::uint8_t, 16>;
[[nodiscard]] LUMITREE_ACCEL_EXPORT Fingerprint fingerprintOf(
  const Surface& surface, int threads = 0);

/// Writes the structure. Throws SaveError for references (Embree, CGAL), which keep their trees to
/// themselves, and where the stream fails.
LUMITREE_ACCEL_EXPORT void save(const Accelerator& accelerator, std::ostream& stream);

/// The same to a file, which is there whole or as it was before: it is written under another name
/// beside it first.
LUMITREE_ACCEL_EXPORT void saveFile(const Accelerator& accelerator, const std::string& path);

/// Reads a structure saved over a surface with the same fingerprint; never null. Statistics say
/// Origin::Loaded and how long loading took. Throws SaveError and BuildStopped. The stream must end
/// with the structure. threads: 0: as many as oneTBB gives.
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::shared_ptr<const Accelerator> load(std::istream& stream,
  std::shared_ptr<const Surface> surface, int threads = 0, JobControl* control = nullptr);

/// The same from a file.
[[nodiscard]] LUMITREE_ACCEL_EXPORT std::shared_ptr<const Accelerator> loadFile(
  const std::string& path, std::shared_ptr<const Surface> surface, int threads = 0,
  JobControl* control = nullptr);

/// Whether a file begins as a saved structure does; false also where it cannot be read.
[[nodiscard]] LUMITREE_ACCEL_EXPORT bool isSavedStructure(const std::string& path);

} // namespace lumitree

#endif
