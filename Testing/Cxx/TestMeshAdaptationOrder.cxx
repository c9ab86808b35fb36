// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeMeshAdaptation: in which order Input and Source have their points and cells, and how
// often Source has what its pieces share, does not matter: of several processes this may be any.

#include "Support/FilterRun.h"
#include "Support/Reported.h"
#include "Support/SurfaceMeshes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeMeshAdaptation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

using namespace skdtest;

namespace
{
/// n x n quads of the unit square.
PolyDataPointer MakeTiles(int n)
{
  return MakePolyData(Transformed(Sheet(n, VTK_QUAD), 1.0 / n, { 0, 0, 0 }));
}

/// A fine square with a ring.
PolyDataPointer MakeRing()
{
  PolyDataPointer tiles = MakeTiles(60);
  const auto ring = [&](vtkIdType i)
  {
    Point p;
    tiles->GetPoint(i, p.data());
    const double gap = std::hypot(p[0] - 0.4, p[1] - 0.45) - 0.3;
    return std::exp(-100.0 * gap * gap);
  };
  tiles->GetPointData()->Initialize();
  tiles->GetPointData()->AddArray(MakeArray("Ring", tiles->GetNumberOfPoints(), ring));
  return tiles;
}

std::vector<vtkIdType> RandomOrder(vtkIdType size, unsigned int seed)
{
  std::vector<vtkIdType> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  return order;
}

/// The same mesh with its points and cells in another order: which has each point's old id.
PolyDataPointer Shuffled(vtkPolyData* mesh, const std::vector<vtkIdType>& which)
{
  std::vector<vtkIdType> now(which.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const vtkIdType id : which)
  {
    now[static_cast<std::size_t>(id)] = points->InsertNextPoint(mesh->GetPoint(id));
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : RandomOrder(mesh->GetNumberOfCells(), 7))
  {
    mesh->GetCellPoints(cell, ids);
    std::transform(ids->begin(), ids->end(), ids->begin(),
      [&now](vtkIdType id) { return now[static_cast<std::size_t>(id)]; });
    cells->InsertNextCell(ids);
  }
  auto shuffled = PolyDataPointer::New();
  shuffled->SetPoints(points);
  shuffled->SetPolys(cells);
  return shuffled;
}

/// The same mesh from pieces that its cells are dealt to, put together in the given order: points
/// where pieces meet are there once a piece. A last piece repeats cells of the others.
PolyDataPointer FromPieces(vtkPolyData* mesh, const std::vector<int>& order)
{
  const auto count = static_cast<int>(order.size());
  std::mt19937 random(11);
  std::vector<int> pieceOf;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    pieceOf.push_back(static_cast<int>(random() % static_cast<unsigned int>(count)));
  }
  vtkNew<vtkAppendPolyData> append;
  for (const int piece : order)
  {
    vtkNew<vtkIdList> cells;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      if (pieceOf[static_cast<std::size_t>(cell)] == piece || cell % 10 == piece)
      {
        cells->InsertNextId(cell);
      }
    }
    vtkNew<vtkPolyData> part;
    part->SetPoints(vtkNew<vtkPoints>());
    part->GetPoints()->SetDataTypeToDouble();
    part->AllocateEstimate(cells->GetNumberOfIds(), 4);
    part->GetPointData()->CopyAllocate(mesh->GetPointData());
    part->GetCellData()->CopyAllocate(mesh->GetCellData());
    part->CopyCells(mesh, cells);
    append->AddInputData(part);
  }
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  return append->GetOutput();
}

/// The measures that a run reports, to the last bit, and where points are.
std::vector<double> FindingsOf(vtkPolyData* adapted)
{
  std::vector<double> findings;
  for (const char* name :
    { "EquidistributionBefore", "EquidistributionAfter", "EquidistributionOfField", "Samples" })
  {
    findings.push_back(Reported(adapted, name));
  }
  for (vtkIdType i = 0; i < adapted->GetNumberOfPoints(); ++i)
  {
    Point p;
    adapted->GetPoint(i, p.data());
    findings.insert(findings.end(), p.begin(), p.end());
  }
  return findings;
}

vtkSmartPointer<vtkPolyData> Adapted(
  vtkPolyData* input, vtkPolyData* source, const char* field = "Ring")
{
  vtkNew<vtkSkdTreeMeshAdaptation> filter;
  filter->SetFieldArray(field);
  filter->SetMonitor(vtkSkdTreeMeshAdaptation::VALUE);
  filter->SetInputDataObject(0, input);
  filter->SetSourceData(source);
  filter->SetMaximumIterations(5);
  filter->Update();
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

TEST(MeshAdaptation, TheOrderOfPointsAndCellsDoesNotMatter)
{
  const PolyDataPointer ring = MakeRing();
  const PolyDataPointer tiles = MakeTiles(12);
  const std::vector<vtkIdType> which = RandomOrder(tiles->GetNumberOfPoints(), 5);
  const auto expected = Adapted(tiles, ring);
  const auto found = Adapted(Shuffled(tiles, which), ring);
  double largestMove = 0.0;
  for (std::size_t i = 0; i < which.size(); ++i)
  {
    Point first;
    Point second;
    Point old;
    expected->GetPoint(which[i], first.data());
    found->GetPoint(static_cast<vtkIdType>(i), second.data());
    tiles->GetPoint(which[i], old.data());
    EXPECT_EQ(first, second) << i;
    largestMove = std::max(largestMove, std::hypot(first[0] - old[0], first[1] - old[1]));
  }
  EXPECT_GT(largestMove, 0.01);
}

TEST(MeshAdaptation, HowOftenAndInWhichOrderPiecesHaveValuesDoesNotMatter)
{
  const PolyDataPointer ring = MakeRing();
  const auto inCell = [](vtkIdType i) { return 1.0 + static_cast<double>(i * i % 17); };
  ring->GetCellData()->AddArray(MakeArray("InCells", ring->GetNumberOfCells(), inCell));
  const PolyDataPointer tiles = MakeTiles(12);
  for (const char* field : { "Ring", "InCells" })
  {
    SCOPED_TRACE(field);
    const std::vector<double> expected = FindingsOf(Adapted(tiles, ring, field));
    EXPECT_EQ(expected, FindingsOf(Adapted(tiles, FromPieces(ring, { 0, 1, 2, 3, 4 }), field)));
    EXPECT_EQ(expected, FindingsOf(Adapted(tiles, FromPieces(ring, { 3, 1, 4, 0, 2 }), field)));
  }
}
}
