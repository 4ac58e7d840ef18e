// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Registry_h
#define Lumitree_Accel_Registry_h

#include "Accel/Accelerator.h"

#include <functional>
#include <string>
#include <vector>

namespace lumitree
{

class SaveReader;

/// A structure that no back end of this process offers. The message says which are there.
class LUMITREE_ACCEL_EXPORT UnknownStructure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// One way to build one structure.
struct Backend
{
  Structure structure = Structure::Auto;
  std::string description; ///< one line for people
  /// The control may be null. Throws BuildStopped when it was told to stop.
  std::function<std::shared_ptr<const Accelerator>(
    std::shared_ptr<const Surface>, const BuildOptions&, JobControl*)>
    build;
  /// From what the accelerator saved (Save.h); empty where it saves nothing.
  std::function<std::shared_ptr<const Accelerator>(
    std::shared_ptr<const Surface>, const BuildOptions&, SaveReader&, JobControl*)>
    load = nullptr;
};

/// The back ends of this process. It lives in this shared library, so that there is one; other
/// libraries (CGAL, under its own licence) add theirs when they are loaded. Thread-safe.
class LUMITREE_ACCEL_EXPORT Registry
{
public:
  [[nodiscard]] static Registry& instance();

  /// Adds a back end, or replaces the one of the same structure.
  void add(Backend backend);

  [[nodiscard]] bool has(Structure structure) const;
  [[nodiscard]] std::vector<Structure> structures() const; ///< ascending

  /// The back end of that structure; throws UnknownStructure.
  [[nodiscard]] Backend find(Structure structure) const;

private:
  Registry();
  ~Registry();
  struct Internals;
  std::unique_ptr<Internals> internals_;
};

} // namespace lumitree

#endif
