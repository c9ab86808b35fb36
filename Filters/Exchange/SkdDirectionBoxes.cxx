// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdDirectionBoxes.h"

#include "Cells/Read/SkdCellReader.h"
#include "Pipeline/SkdLonLat.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// In degrees of longitude. The edges of a cell that spans as much, along parallels, may be
/// anywhere.
constexpr double HalfTurn = 180.0;
/// No two directions are farther apart.
constexpr double Anywhere = 2.0;
/// Of directions.
constexpr double Rounding = 1e-12;

/// Not finite if there is none.
skd::Vector3 DirectionOf(const skd::Vector3& x, bool inDegrees)
{
  return inDegrees ? SkdDirectionOfLonLat(x) : (1.0 / Norm(x)) * x;
}

skd::Vector3 PointOf(vtkDataSet* mesh, vtkIdType id)
{
  skd::Vector3 x;
  mesh->GetPoint(id, x.X);
  return x;
}
}

std::vector<skd::Box3> SkdDirectionBoxesOfPoints(vtkDataSet* mesh, bool inDegrees)
{
  std::vector<skd::Box3> boxes(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t id = 0; id < boxes.size(); ++id)
  {
    const skd::Vector3 direction =
      DirectionOf(PointOf(mesh, static_cast<vtkIdType>(id)), inDegrees);
    if (IsFinite(direction))
    {
      boxes[id] = { direction, direction };
    }
  }
  return boxes;
}

// What is between corners is no farther from their box than it is large.
std::vector<skd::Box3> SkdDirectionBoxesOfCells(vtkDataSet* mesh, bool inDegrees)
{
  const std::vector<skd::Box3> points = SkdDirectionBoxesOfPoints(mesh, inDegrees);
  const SkdCellReader reader(mesh);
  std::vector<skd::Box3> boxes(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  vtkNew<vtkIdList> list;
  for (std::size_t cell = 0; cell < boxes.size(); ++cell)
  {
    double west = std::numeric_limits<double>::max();
    double east = std::numeric_limits<double>::lowest();
    reader.VisitPoints(static_cast<vtkIdType>(cell), list,
      [&](const auto* ids, std::size_t size)
      {
        for (std::size_t i = 0; i < size; ++i)
        {
          boxes[cell].Add(points[static_cast<std::size_t>(ids[i])]);
          const double longitude = PointOf(mesh, static_cast<vtkIdType>(ids[i]))[0];
          west = std::min(west, longitude);
          east = std::max(east, longitude);
        }
      });
    const double diagonal = boxes[cell].Diagonal() + Rounding;
    const bool isWide = diagonal > 1.0 || (inDegrees && east - west >= HalfTurn);
    boxes[cell] = boxes[cell].Inflated(isWide ? Anywhere : diagonal);
  }
  return boxes;
}
}
