// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdOwnCells.h"

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdSubset.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>

namespace
{
/// A point whose coordinates in the whole mesh are others than in this piece.
struct MovedPoint
{
  vtkIdType Point;
  skd::Vector3 Place;
};

skd::Vector3 PlaceOf(vtkDataSet* mesh, vtkIdType point)
{
  skd::Vector3 place;
  mesh->GetPoint(point, place.X);
  return place;
}

/// Points of other pieces are asked for where they are there.
std::vector<MovedPoint> FindMoved(
  SkdTransport& transport, vtkDataSet* piece, const SkdPieceNumbers& numbers)
{
  const auto processes = static_cast<std::size_t>(transport.GetNumber());
  SkdRowsByProcess<vtkIdType> asked(processes);
  SkdRowsByProcess<vtkIdType> points(processes);
  for (std::size_t point = 0; point < numbers.PointOrigins.size(); ++point)
  {
    const SkdPointOrigin& origin = numbers.PointOrigins[point];
    if (origin.Process >= 0 && origin.Process != transport.GetRank())
    {
      asked[static_cast<std::size_t>(origin.Process)].push_back(origin.Point);
      points[static_cast<std::size_t>(origin.Process)].push_back(static_cast<vtkIdType>(point));
    }
  }
  const SkdRowsByProcess<skd::Vector3> places = SkdAsk<skd::Vector3>(transport, asked,
    [&](const SkdRowsByProcess<vtkIdType>& wanted)
    {
      SkdRowsByProcess<skd::Vector3> found(wanted.size());
      for (std::size_t process = 0; process < wanted.size(); ++process)
      {
        std::transform(wanted[process].begin(), wanted[process].end(),
          std::back_inserter(found[process]),
          [&](vtkIdType point) { return PlaceOf(piece, point); });
      }
      return found;
    });
  std::vector<MovedPoint> moved;
  for (std::size_t process = 0; process < processes; ++process)
  {
    for (std::size_t i = 0; i < places[process].size(); ++i)
    {
      if (!(PlaceOf(piece, points[process][i]) == places[process][i]))
      {
        moved.push_back({ points[process][i], places[process][i] });
      }
    }
  }
  return moved;
}

/// The piece with the points where they are in the whole mesh.
vtkSmartPointer<vtkDataSet> WithMovedPoints(vtkDataSet* piece, const std::vector<MovedPoint>& moved)
{
  auto* set = vtkPointSet::SafeDownCast(piece);
  if (moved.empty() || !set)
  {
    return piece;
  }
  vtkNew<vtkPoints> points;
  points->DeepCopy(set->GetPoints());
  for (const MovedPoint& point : moved)
  {
    points->SetPoint(point.Point, point.Place.X);
  }
  auto copy = vtkSmartPointer<vtkPointSet>::Take(set->NewInstance());
  copy->ShallowCopy(set);
  copy->SetPoints(points);
  return copy;
}
}

SkdOwnCells SkdTakeOwnCells(
  SkdTransport& transport, vtkDataSet* piece, const SkdPieceNumbers& numbers)
{
  SkdOwnCells own;
  own.Mesh = WithMovedPoints(piece, FindMoved(transport, piece, numbers));
  std::vector<vtkIdType> cells;
  for (std::size_t cell = 0; cell < numbers.CellIds.size(); ++cell)
  {
    if (numbers.CellIds[cell] >= 0)
    {
      cells.push_back(static_cast<vtkIdType>(cell));
    }
  }
  const auto idOf = [&](vtkIdType cell) { return numbers.CellIds[static_cast<std::size_t>(cell)]; };
  const auto isBefore = [&](vtkIdType a, vtkIdType b) { return idOf(a) < idOf(b); };
  const bool isAll =
    cells.size() == numbers.CellIds.size() && std::is_sorted(cells.begin(), cells.end(), isBefore);
  if (!isAll)
  {
    std::sort(cells.begin(), cells.end(), isBefore);
    SkdSubset subset(own.Mesh);
    subset.SetCells(cells);
    subset.CopyShaping();
    subset.CopyData(); // marks of blanked cells are among them
    own.Mesh = subset.Get();
  }
  own.Ids.resize(cells.size());
  std::transform(cells.begin(), cells.end(), own.Ids.begin(), idOf);
  return own;
}
