// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiHalfEdges.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <limits>
#include <stdexcept>

namespace lumitree::filters
{
namespace
{

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// OpenMesh tells std::cerr of every face that it refuses; here that is an answer, not an error.
void beQuiet()
{
  static const bool quiet = (omerr().disable(), true);
  static_cast<void>(quiet);
}

Border walk(const Mesh& mesh, Mesh::HalfedgeHandle first, std::vector<bool>& walked)
{
  Border border;
  Mesh::HalfedgeHandle edge = first;
  do
  {
    walked[static_cast<std::size_t>(edge.idx())] = true;
    border.push_back(static_cast<std::uint32_t>(mesh.from_vertex_handle(edge).idx()));
    edge = mesh.next_halfedge_handle(edge);
  } while (edge != first);
  return border;
}

} // namespace

HalfEdgeReport halfEdges(const std::vector<Face>& faces, std::size_t points)
{
  // OpenMesh counts half-edges in an int.
  if (points > std::numeric_limits<int>::max() ||
    faces.size() > std::numeric_limits<int>::max() / 6)
  {
    throw std::runtime_error("The surface is too large for half-edges.");
  }
  beQuiet();
  Mesh mesh;
  mesh.reserve(points, 3 * faces.size() / 2 + 1, faces.size());
  for (std::size_t i = 0; i < points; ++i)
  {
    mesh.add_vertex(Mesh::Point(0, 0, 0)); // only connectivity is asked for
  }
  HalfEdgeReport report;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto vertex = [&](std::size_t k)
    { return Mesh::VertexHandle(static_cast<int>(faces[i].points[k])); };
    if (!mesh.add_face(vertex(0), vertex(1), vertex(2)).is_valid())
    {
      report.refused.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::vector<bool> walked(mesh.n_halfedges(), false);
  for (const Mesh::HalfedgeHandle edge : mesh.halfedges())
  {
    if (mesh.is_boundary(edge) && !walked[static_cast<std::size_t>(edge.idx())])
    {
      report.borders.push_back(walk(mesh, edge, walked));
    }
  }
  return report;
}

} // namespace lumitree::filters
