// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiHierarchyBlocks.h"

#include "LumiArrays.h"

#include "Accel/Parallel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <string>
#include <vector>

namespace lumitree::filters
{

namespace
{

using NodeIds = std::vector<std::size_t>;

constexpr std::size_t chunk = 1024;
constexpr int pointsPerNode = 8;

/// Corner i of a box has its upper coordinate on axis k where bit k of i is set.
constexpr int edges[12][2] = { { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 }, { 0, 2 }, { 1, 3 }, { 4, 6 },
  { 5, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
/// Counter-clockwise seen from outside.
constexpr int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
  { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

struct ShapeSizes
{
  vtkIdType cells;
  vtkIdType cellSize;
};

ShapeSizes sizesOf(NodeShape shape)
{
  return shape == NodeShape::Outlines ? ShapeSizes{ 12, 2 } : ShapeSizes{ 6, 4 };
}

/// The polyhedron of a node: its corners, and cells over the point ids firstPoint ….
void writeShape(const HierarchyNode& node, NodeShape shape, vtkIdType firstPoint, double* points,
  vtkIdType* connectivity)
{
  for (int corner = 0; corner < pointsPerNode; ++corner)
  {
    for (int k = 0; k < 3; ++k)
    {
      points[3 * corner + k] = (corner >> k & 1) ? node.box.upper[k] : node.box.lower[k];
    }
  }
  const ShapeSizes sizes = sizesOf(shape);
  for (vtkIdType c = 0; c < sizes.cells; ++c)
  {
    for (vtkIdType p = 0; p < sizes.cellSize; ++p)
    {
      const int corner = shape == NodeShape::Outlines ? edges[c][p] : faces[c][p];
      connectivity[sizes.cellSize * c + p] = firstPoint + corner;
    }
  }
}

/// One array per fact about a node, a tuple per cell.
struct NodeArrays
{
  vtkIdType* id;
  vtkIdType* parent;
  int* depth;
  unsigned char* leaf;
  vtkIdType* count;
  double* cost;
  int* axis;
  double* position;
  vtkIdType* visits; ///< null without rays

  NodeArrays(vtkFieldData* data, vtkIdType cells, bool withVisits)
    : id(addArray<vtkIdTypeArray>(data, "NodeId", cells))
    , parent(addArray<vtkIdTypeArray>(data, "ParentId", cells))
    , depth(addArray<vtkIntArray>(data, "Depth", cells))
    , leaf(addArray<vtkUnsignedCharArray>(data, "IsLeaf", cells))
    , count(addArray<vtkIdTypeArray>(data, "PrimitiveCount", cells))
    , cost(addArray<vtkDoubleArray>(data, "SurfaceAreaCost", cells))
    , axis(addArray<vtkIntArray>(data, "SplitAxis", cells))
    , position(addArray<vtkDoubleArray>(data, "SplitPosition", cells))
    , visits(withVisits ? addArray<vtkIdTypeArray>(data, "Visits", cells) : nullptr)
  {
  }

  void set(vtkIdType cell, std::size_t nodeId, const HierarchyNode& node, std::uint64_t visited)
  {
    this->id[cell] = static_cast<vtkIdType>(nodeId);
    this->parent[cell] = static_cast<vtkIdType>(node.parent);
    this->depth[cell] = node.depth;
    this->leaf[cell] = node.leaf ? 1 : 0;
    this->count[cell] = static_cast<vtkIdType>(node.referenceCount);
    this->cost[cell] = node.cost;
    this->axis[cell] = node.splitAxis;
    this->position[cell] =
      node.splitAxis < 0 ? std::numeric_limits<double>::quiet_NaN() : node.splitPosition;
    if (this->visits)
    {
      this->visits[cell] = static_cast<vtkIdType>(visited);
    }
  }
};

/// Of the polyhedron's edges one way, or of its faces, the points.
std::vector<std::vector<std::uint32_t>> cellsOf(const Polyhedron& polyhedron, NodeShape shape)
{
  if (shape == NodeShape::Cells)
  {
    return polyhedron.faces;
  }
  std::vector<std::vector<std::uint32_t>> lines;
  for (const auto& face : polyhedron.faces)
  {
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const std::uint32_t a = face[i];
      const std::uint32_t b = face[(i + 1) % face.size()];
      if (a < b) // the neighbour has it the other way round
      {
        lines.push_back({ a, b });
      }
    }
  }
  return lines;
}

void setCells(vtkPolyData* block, NodeShape shape, vtkCellArray* cells, bool withVisits)
{
  shape == NodeShape::Outlines ? block->SetLines(cells) : block->SetPolys(cells);
  block->GetCellData()->SetActiveScalars(withVisits ? "Visits" : "SurfaceAreaCost");
}

/// Nodes whose cells are not boxes, with as many points and cells as each has.
vtkNew<vtkPolyData> makePolyhedra(const HierarchyView& hierarchy, const std::uint64_t* visits,
  const NodeIds& nodes, const HierarchyOptions& options)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::vector<std::size_t> nodeOfCell;
  for (const std::size_t node : nodes)
  {
    const Polyhedron& polyhedron = hierarchy.polyhedra[node];
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Vec3& p : polyhedron.points)
    {
      points->InsertNextPoint(p.data());
    }
    for (const auto& cell : cellsOf(polyhedron, options.shape))
    {
      cells->InsertNextCell(static_cast<int>(cell.size()));
      for (const std::uint32_t p : cell)
      {
        cells->InsertCellPoint(first + static_cast<vtkIdType>(p));
      }
      nodeOfCell.push_back(node);
    }
  }
  vtkNew<vtkPolyData> block;
  block->SetPoints(points);
  NodeArrays arrays(
    block->GetCellData(), static_cast<vtkIdType>(nodeOfCell.size()), visits != nullptr);
  for (std::size_t c = 0; c < nodeOfCell.size(); ++c)
  {
    const std::size_t node = nodeOfCell[c];
    arrays.set(static_cast<vtkIdType>(c), node, hierarchy.nodes[node], visits ? visits[node] : 0);
  }
  setCells(block, options.shape, cells, visits != nullptr);
  return block;
}

vtkNew<vtkPolyData> makeBlock(const HierarchyView& hierarchy, const std::uint64_t* visits,
  const NodeIds& held, const HierarchyOptions& options)
{
  const NodeIds& nodes = options.drawNothing ? NodeIds() : held;
  if (!hierarchy.polyhedra.empty())
  {
    return makePolyhedra(hierarchy, visits, nodes, options);
  }
  const ShapeSizes sizes = sizesOf(options.shape);
  const auto count = static_cast<vtkIdType>(nodes.size());
  const vtkIdType cells = sizes.cells * count;

  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(pointsPerNode * count);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(cells + 1);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(sizes.cellSize * cells);
  vtkNew<vtkPolyData> block;
  NodeArrays arrays(block->GetCellData(), cells, visits != nullptr);

  double* xyz = coordinates->GetPointer(0);
  vtkIdType* offset = offsets->GetPointer(0);
  vtkIdType* ids = connectivity->GetPointer(0);
  parallelFor(nodes.size(), chunk, options.threads, nullptr,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const HierarchyNode& node = hierarchy.nodes[nodes[i]];
        const vtkIdType firstPoint = pointsPerNode * static_cast<vtkIdType>(i);
        const vtkIdType firstCell = sizes.cells * static_cast<vtkIdType>(i);
        writeShape(
          node, options.shape, firstPoint, xyz + 3 * firstPoint, ids + sizes.cellSize * firstCell);
        for (vtkIdType c = firstCell; c < firstCell + sizes.cells; ++c)
        {
          offset[c] = sizes.cellSize * c;
          arrays.set(c, nodes[i], node, visits ? visits[nodes[i]] : 0);
        }
      }
    });
  offset[cells] = sizes.cellSize * cells;

  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  block->SetPoints(points);
  vtkNew<vtkCellArray> cellArray;
  cellArray->SetData(offsets, connectivity);
  setCells(block, options.shape, cellArray, visits != nullptr);
  return block;
}

/// The cells of a grid as an image, empty ones included.
vtkSmartPointer<vtkImageData> makeOccupancy(
  const HierarchyView& hierarchy, const std::uint64_t* visits, const HierarchyOptions& options)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  if (options.drawNothing)
  {
    return image;
  }
  const Box& box = hierarchy.nodes.front().box;
  const std::array<int, 3>& cells = hierarchy.gridResolution;
  Vec3 spacing;
  for (int k = 0; k < 3; ++k)
  {
    spacing[k] = (box.upper[k] - box.lower[k]) / cells[k];
    spacing[k] = spacing[k] > 0 ? spacing[k] : 1.0; // VTK wants cells with an extent
  }
  image->SetOrigin(box.lower.data());
  image->SetSpacing(spacing.data());
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  const vtkIdType count = image->GetNumberOfCells();
  auto* const held = addArray<vtkIdTypeArray>(image->GetCellData(), "PrimitiveCount", count);
  auto* const entered =
    visits ? addArray<vtkIdTypeArray>(image->GetCellData(), "Visits", count) : nullptr;
  std::fill_n(held, count, 0);
  std::fill_n(entered, entered ? count : 0, 0);
  for (std::size_t i = 1; i < hierarchy.nodes.size(); ++i)
  {
    const Vec3 middle = hierarchy.nodes[i].box.centre();
    vtkIdType cell = 0;
    for (int k = 2; k >= 0; --k)
    {
      const auto slab = static_cast<int>((middle[k] - box.lower[k]) / spacing[k]);
      cell = cell * cells[k] + std::min(std::max(slab, 0), cells[k] - 1);
    }
    held[cell] = hierarchy.nodes[i].referenceCount;
    if (entered)
    {
      entered[cell] = static_cast<vtkIdType>(visits[i]);
    }
  }
  image->GetCellData()->SetActiveScalars("PrimitiveCount");
  return image;
}

} // namespace

HierarchyReport makeHierarchyBlocks(const HierarchyView& hierarchy, const std::uint64_t* visits,
  const HierarchyOptions& options, vtkMultiBlockDataSet* blocks)
{
  std::vector<NodeIds> levels;
  NodeIds leaves;
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i)
  {
    const HierarchyNode& node = hierarchy.nodes[i];
    if (node.box.empty())
    {
      continue; // nothing to draw: the root of an empty surface
    }
    if (levels.size() <= static_cast<std::size_t>(node.depth))
    {
      levels.resize(static_cast<std::size_t>(node.depth) + 1);
    }
    levels[static_cast<std::size_t>(node.depth)].push_back(i);
    if (node.leaf)
    {
      leaves.push_back(i);
    }
  }

  HierarchyReport report;
  unsigned int block = 0;
  const auto append = [&](vtkDataObject* data, const std::string& name)
  {
    blocks->SetBlock(block, data);
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
    ++block;
  };
  std::int64_t total = 0;
  for (int level = 0; level < static_cast<int>(levels.size()) && level <= options.maximumLevel;
       ++level)
  {
    const NodeIds& nodes = levels[static_cast<std::size_t>(level)];
    const std::string name = "Level " + std::to_string(level);
    if (level < options.minimumLevel)
    {
      append(nullptr, name);
      continue;
    }
    total += static_cast<std::int64_t>(nodes.size());
    if (total > options.maximumNodes)
    {
      report.firstLevelLeftOut = level;
      break;
    }
    append(makeBlock(hierarchy, visits, nodes, options), name);
  }
  if (options.leaves)
  {
    report.leavesLeftOut = static_cast<std::int64_t>(leaves.size()) > options.maximumNodes;
    if (!report.leavesLeftOut)
    {
      append(makeBlock(hierarchy, visits, leaves, options), "Leaves");
    }
  }
  if (options.occupancy && hierarchy.gridResolution[0] > 0)
  {
    append(makeOccupancy(hierarchy, visits, options), "Occupancy");
  }
  return report;
}

} // namespace lumitree::filters
