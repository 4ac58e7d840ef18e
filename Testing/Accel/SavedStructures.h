// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Testing_Accel_SavedStructures_h
#define Lumitree_Testing_Accel_SavedStructures_h

#include "TestHelpers.h"

#include "Accel/Save.h"

#include <boost/crc.hpp>

#include <sstream>

/// Saved structures as bytes, and surfaces to save them of.
namespace lumitree::testing
{

inline std::string saved(const Accelerator& accelerator)
{
  std::ostringstream stream;
  save(accelerator, stream);
  return stream.str();
}

inline std::shared_ptr<const Accelerator> loaded(
  const std::string& bytes, const std::shared_ptr<const Surface>& surface)
{
  std::istringstream stream(bytes);
  return load(stream, surface, 1);
}

/// What each leaf holds.
inline std::vector<std::vector<PrimitiveId>> leavesOf(const HierarchyView& view)
{
  std::vector<std::vector<PrimitiveId>> leaves;
  for (const HierarchyNode& node : view.nodes)
  {
    const auto first = view.references.begin() + node.firstReference;
    leaves.emplace_back(first, node.leaf ? first + node.referenceCount : first);
  }
  return leaves;
}

/// What stands between the header and the checksum (Docs/saved-structures.md).
inline std::string bodyOf(const std::string& bytes)
{
  return bytes.substr(24, bytes.size() - 28);
}

/// A body with a header and a checksum that fit.
inline std::string sealed(const std::string& body)
{
  const auto number = [](auto value)
  { return std::string(reinterpret_cast<const char*>(&value), sizeof(value)); };
  const std::string bytes = "LumiTree" + number(std::uint32_t{ 0x01020304 }) +
    number(saveVersion) + number(std::uint64_t{ body.size() }) + body;
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return bytes + number(std::uint32_t{ crc.checksum() });
}

inline std::vector<Quadric> someQuadrics(double shift = 0.0)
{
  std::vector<Quadric> all = {
    Quadric::sphere({ 1 + shift, 0, 0 }, 1), Quadric::disc({ 0, 2, 0 }, { 1, 1, 0 }, 0.5),
    Quadric::ellipsoid({ -2, 0, shift }, { Vec3{ 0.5, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 0.25 } })
  };
  for (const Quadric& q : Quadric::cappedCylinder({ -3, -3, shift }, { -3, 1, 1 }, 0.75))
  {
    all.push_back(q);
  }
  for (int i = 0; i < 12; ++i)
  {
    all.push_back(Quadric::sphere({ 0.5 * i, -2.0 + shift, 0.125 * i }, 0.25));
  }
  all.push_back(Quadric::sphere({ 0, 0, 0 }, -1)); // never hit
  return all;
}

inline std::shared_ptr<const Surface> quadrics()
{
  return std::make_shared<const Surface>(PointArray{}, std::vector<Triangle>{}, someQuadrics());
}

/// A scene's triangles, some that are never hit, and quadrics.
template <class T>
std::shared_ptr<const Surface> mixed()
{
  const auto teapot = surfaceOf<T>(data::teapot(2));
  std::vector<T> points(3 * teapot->pointCount());
  std::memcpy(points.data(), teapot->pointData(), points.size() * sizeof(T));
  std::vector<Triangle> triangles = teapot->triangles();
  triangles[3] = { 0, 0, 1 };
  points[3 * triangles[7][0]] = std::numeric_limits<T>::quiet_NaN();
  return std::make_shared<const Surface>(
    PointArray::from(std::move(points)), std::move(triangles), someQuadrics());
}

} // namespace lumitree::testing

#endif
