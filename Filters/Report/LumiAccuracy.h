// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LumiAccuracy_h
#define LumiAccuracy_h

#include "Accel/Surface.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lumitree::filters
{

struct AccuracyOptions
{
  std::size_t rays = 2000; ///< of each kind
  unsigned int seed = 1;
  int repeats = 2;                    ///< of which the fastest counts
  std::size_t bruteForceLimit = 2000; ///< triangles beyond which brute force is left out
};

/// One back end on one kind of rays, compared with the exact answer.
struct AccuracyRow
{
  std::string backEnd;
  std::string setting; ///< how it was built or called, where there is a choice
  std::string precision;
  std::string rayKind;
  std::size_t rays = 0;
  std::size_t leaks = 0;           ///< hits nothing where there is a hit
  std::size_t phantoms = 0;        ///< hits something where there is none
  std::size_t otherPrimitives = 0; ///< none of those at the least t
  std::size_t farPrimitives = 0;   ///< and t off by more than 1e-4 of it
  double medianTError = 0.0;       ///< relative, of the right primitives
  double maxTError = 0.0;
  double nanosecondsPerRay = 0.0; ///< one thread, processor time
};

/// Measures every back end of the registry, and vtkStaticCellLocator, with one kind of rays after
/// the other. goOn is told the fraction done and returns false to stop; no rows then. Throws what
/// building throws.
[[nodiscard]] std::vector<AccuracyRow> measureAccuracy(std::shared_ptr<const Surface> surface,
  const AccuracyOptions& options, const std::function<bool(double)>& goOn);

} // namespace lumitree::filters

#endif
