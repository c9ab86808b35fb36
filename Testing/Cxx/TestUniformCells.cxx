// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that are read and checked in one pass: what is read, and that nothing is where any differs.

#include "Cells/Search/SkdUniformCells.h"
#include "Support/MeshBuilder.h"

#include "vtkAOSDataArrayTemplate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <string>
#include <utility>

using namespace skdtree;
using namespace skdtest;

namespace
{
/// More than one thread reads at once.
constexpr vtkIdType NumberOfCells = 5000;
constexpr vtkIdType NumberOfPoints = 700;

struct Kind
{
  int Type;
  int Size;
};

Mesh RandomMesh(const Kind& kind)
{
  std::mt19937 random(static_cast<unsigned>(kind.Type));
  std::uniform_real_distribution<double> coordinate(-3.0, 2.0);
  Mesh mesh;
  for (vtkIdType i = 0; i < NumberOfPoints; ++i)
  {
    mesh.Add({ coordinate(random), coordinate(random), coordinate(random) });
  }
  mesh.Add({ 1e9, 1e9, 1e9 }); // of no cell
  for (vtkIdType cell = 0; cell < NumberOfCells; ++cell)
  {
    Ids ids(static_cast<std::size_t>(kind.Size));
    for (vtkIdType& id : ids)
    {
      id = static_cast<vtkIdType>(random()) % NumberOfPoints;
    }
    mesh.Add(kind.Type, ids);
  }
  return mesh;
}

void ExpectCells(vtkDataSet* data, const Mesh& mesh, const std::string& what)
{
  const SkdUniformCells uniform = SkdReadUniformCells(data);
  ASSERT_EQ(SkdShapeOfCellType(mesh.Cells[0].Type), uniform.Shape) << what;
  skd::Box3 bounds;
  std::vector<std::uint32_t> ids;
  for (const CellSpec& cell : mesh.Cells)
  {
    for (const vtkIdType id : cell.Points)
    {
      ids.push_back(static_cast<std::uint32_t>(id));
      std::array<double, 3> x;
      data->GetPoint(id, x.data());
      bounds.Add(skd::Vector3{ { x[0], x[1], x[2] } });
    }
  }
  EXPECT_TRUE(std::equal(ids.begin(), ids.end(), uniform.PointIds.begin(), uniform.PointIds.end()))
    << what;
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(bounds.Min[axis], uniform.Bounds.Min[axis]) << what;
    EXPECT_EQ(bounds.Max[axis], uniform.Bounds.Max[axis]) << what;
  }
}

void ExpectNone(vtkDataSet* data, const std::string& what)
{
  const SkdUniformCells uniform = SkdReadUniformCells(data);
  EXPECT_FALSE(uniform.AreThere()) << what;
  EXPECT_TRUE(uniform.PointIds.empty()) << what;
}

/// Cells of the first and the last block, and on either side of where blocks meet.
constexpr std::array<vtkIdType, 6> Somewhere{ 0, 17, 2047, 2048, 4095, NumberOfCells - 1 };

vtkTypeInt64* ConnectivityOf(vtkUnstructuredGrid* grid)
{
  auto* ids =
    vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(grid->GetCells()->GetConnectivityArray());
  return ids->GetPointer(0);
}
}

TEST(UniformCells, GridsOfEachTypeAreRead)
{
  for (const Kind& kind : { Kind{ VTK_VERTEX, 1 }, Kind{ VTK_LINE, 2 }, Kind{ VTK_TRIANGLE, 3 },
         Kind{ VTK_PIXEL, 4 }, Kind{ VTK_QUAD, 4 }, Kind{ VTK_TETRA, 4 }, Kind{ VTK_VOXEL, 8 },
         Kind{ VTK_HEXAHEDRON, 8 }, Kind{ VTK_WEDGE, 6 }, Kind{ VTK_PYRAMID, 5 } })
  {
    const Mesh mesh = RandomMesh(kind);
    for (const int pointType : { VTK_FLOAT, VTK_DOUBLE })
    {
      const auto grid = MakeGrid(mesh, pointType);
      ExpectCells(grid, mesh, "type " + std::to_string(kind.Type));
      grid->GetCells()->ConvertTo32BitStorage();
      ExpectCells(grid, mesh, "32 bits, type " + std::to_string(kind.Type));
    }
  }
}

TEST(UniformCells, PolygonsOfThreeOrFourAreReadWithOrWithoutTableOfTypes)
{
  for (const Kind& kind : { Kind{ VTK_TRIANGLE, 3 }, Kind{ VTK_QUAD, 4 } })
  {
    const Mesh mesh = RandomMesh(kind);
    for (const bool ids32 : { false, true })
    {
      const auto surface = MakePolyData(mesh, VTK_DOUBLE, ids32);
      surface->DeleteCells();
      ASSERT_TRUE(surface->NeedToBuildCells());
      ExpectCells(surface, mesh, "no table");
      surface->BuildCells();
      ExpectCells(surface, mesh, "table");
    }
  }
}

TEST(UniformCells, NoneWhereOneIdIsOutOfRange)
{
  const Mesh mesh = RandomMesh({ VTK_TETRA, 4 });
  const auto grid = MakeGrid(mesh);
  for (const vtkIdType cell : Somewhere)
  {
    for (const vtkTypeInt64 bad :
      { vtkTypeInt64(-1), vtkTypeInt64(NumberOfPoints + 1), vtkTypeInt64(1) << 32,
        std::numeric_limits<vtkTypeInt64>::min(), std::numeric_limits<vtkTypeInt64>::max() })
    {
      vtkTypeInt64& id = ConnectivityOf(grid)[4 * cell + 3];
      const vtkTypeInt64 good = std::exchange(id, bad);
      ExpectNone(grid, "cell " + std::to_string(cell) + ", id " + std::to_string(bad));
      id = good;
    }
  }
  ExpectCells(grid, mesh, "as it was");
}

TEST(UniformCells, NoneWhereOneOffsetIsWrong)
{
  const Mesh mesh = RandomMesh({ VTK_TRIANGLE, 3 });
  const auto surface = MakePolyData(mesh);
  auto* offsets =
    vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(surface->GetPolys()->GetOffsetsArray());
  for (const vtkIdType cell : Somewhere)
  {
    for (const vtkTypeInt64 bad : { -3, 1, 1 << 30 })
    {
      vtkTypeInt64& offset = offsets->GetPointer(0)[cell];
      const vtkTypeInt64 good = std::exchange(offset, offset + bad);
      ExpectNone(surface, "cell " + std::to_string(cell));
      offset = good;
    }
  }
  ExpectCells(surface, mesh, "as it was");
}

TEST(UniformCells, NoneWhereCellsDifferAreDeletedOrGhosts)
{
  for (const vtkIdType cell : Somewhere)
  {
    Mesh mixed = RandomMesh({ VTK_TETRA, 4 });
    mixed.Cells[static_cast<std::size_t>(cell)].Type = VTK_QUAD;
    ExpectNone(MakeGrid(mixed), "other type of cell " + std::to_string(cell));
    const auto surface = MakePolyData(RandomMesh({ VTK_TRIANGLE, 3 }));
    surface->BuildCells();
    surface->DeleteCell(cell);
    ExpectNone(surface, "deleted cell " + std::to_string(cell));
  }
  const auto grid = MakeGrid(RandomMesh({ VTK_HEXAHEDRON, 8 }));
  grid->AllocateCellGhostArray();
  ExpectNone(grid, "ghosts");
  Mesh both = RandomMesh({ VTK_TRIANGLE, 3 });
  both.Add(VTK_LINE, { 0, 1 });
  ExpectNone(MakePolyData(both), "lines beside triangles");
  ExpectNone(MakeGrid(RandomMesh({ VTK_QUADRATIC_EDGE, 3 })), "curved cells");
}

TEST(UniformCells, NoneOfNothing)
{
  ExpectNone(nullptr, "no mesh");
  ExpectNone(vtkNew<vtkPolyData>(), "empty polydata");
  ExpectNone(vtkNew<vtkUnstructuredGrid>(), "empty grid");
  vtkNew<vtkPolyData> pointless;
  pointless->SetPolys(MakePolyData(RandomMesh({ VTK_TRIANGLE, 3 }))->GetPolys());
  ExpectNone(pointless, "no points");
  Mesh unused = RandomMesh({ VTK_TETRA, 4 });
  unused.Cells.clear();
  ExpectNone(MakeGrid(unused), "points alone");
}
