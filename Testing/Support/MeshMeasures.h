// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshMeasures.h
 * @brief measures of a whole mesh, by VTK's own cells
 */
#ifndef skdtest_MeshMeasures_h
#define skdtest_MeshMeasures_h

#include "Support/MeshBuilder.h"

#include "vtkGenericCell.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

namespace skdtest
{

/// The corners of a cell, an edge or a face of it; those of a pixel around it.
inline std::vector<Point> CornersOf(vtkCell* cell)
{
  std::vector<Point> corners;
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    Point p;
    cell->GetPoints()->GetPoint(i, p.data());
    corners.push_back(p);
  }
  if (cell->GetCellType() == VTK_PIXEL)
  {
    std::swap(corners[2], corners[3]);
  }
  return corners;
}

/// Twice the area of a polygon, across it.
inline Point AreaVector(const std::vector<Point>& p)
{
  Point sum{ 0, 0, 0 };
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
  {
    sum = sum + Cross(p[i] - p[0], p[i + 1] - p[0]);
  }
  return sum;
}

/// A cell's length, area or volume. That of a volume is negative if it is inside out: by its faces,
/// which VTK's cells have outward (a wedge may have either orientation), a fan of triangles each.
inline double Measure(vtkCell* cell)
{
  const std::vector<Point> p = CornersOf(cell);
  if (cell->GetCellDimension() < 3)
  {
    return p.size() == 2 ? Distance(p[0], p[1]) : 0.5 * Length(AreaVector(p));
  }
  double volume = 0.0;
  for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
  {
    const std::vector<Point> f = CornersOf(cell->GetFace(face));
    for (std::size_t i = 1; i + 1 < f.size(); ++i)
    {
      volume += Dot(Cross(f[i] - f[0], f[i + 1] - f[0]), f[0] - p[0]) / 6.0;
    }
  }
  return cell->GetCellType() == VTK_WEDGE ? std::abs(volume) : volume;
}

struct MeshMeasures
{
  double Sum = 0.0; ///< of the measures of cells
  double Least = std::numeric_limits<double>::infinity();
  double SmallestAngle = 180.0; ///< at corners of triangles, degrees
  long Euler = 0;               ///< points in use - edges + faces - volumes
  long OpenFaces = 0;           ///< that one cell has; of surfaces edges
  long FacesOfMany = 0;         ///< that more than two have
  double OpenMeasure = 0.0;     ///< of the open faces together
};

inline std::set<vtkIdType> IdsOf(vtkCell* cell)
{
  return { cell->GetPointIds()->GetPointer(0),
    cell->GetPointIds()->GetPointer(0) + cell->GetNumberOfPoints() };
}

inline double SmallestAngleOf(const std::vector<Point>& p)
{
  double smallest = 180.0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point a = p[(i + 1) % p.size()] - p[i];
    const Point b = p[(i + p.size() - 1) % p.size()] - p[i];
    smallest = std::min(smallest, std::atan2(Length(Cross(a, b)), Dot(a, b)) * 45.0 / std::atan(1));
  }
  return smallest;
}

/// Of a mesh whose cells are all of one dimension, 2 or 3.
inline MeshMeasures MeasuresOf(vtkDataSet* mesh)
{
  MeshMeasures measures;
  std::set<vtkIdType> points;
  std::set<std::set<vtkIdType>> edges;
  std::map<std::set<vtkIdType>, std::pair<long, double>> sides; // how often, and how large
  long volumes = 0;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    mesh->GetCell(id, cell);
    const double measure = Measure(cell);
    measures.Sum += measure;
    measures.Least = std::min(measures.Least, measure);
    const std::set<vtkIdType> ids = IdsOf(cell);
    points.insert(ids.begin(), ids.end());
    const bool isVolume = cell->GetCellDimension() == 3;
    volumes += isVolume;
    if (cell->GetCellType() == VTK_TRIANGLE)
    {
      measures.SmallestAngle = std::min(measures.SmallestAngle, SmallestAngleOf(CornersOf(cell)));
    }
    for (int i = 0; i < cell->GetNumberOfEdges(); ++i)
    {
      edges.insert(IdsOf(cell->GetEdge(i)));
    }
    for (int i = 0; i < (isVolume ? cell->GetNumberOfFaces() : cell->GetNumberOfEdges()); ++i)
    {
      vtkCell* side = isVolume ? cell->GetFace(i) : cell->GetEdge(i);
      auto& entry = sides[IdsOf(side)];
      ++entry.first;
      entry.second = Measure(side);
    }
  }
  for (const auto& [ids, side] : sides)
  {
    measures.OpenFaces += side.first == 1;
    measures.FacesOfMany += side.first > 2;
    measures.OpenMeasure += side.first == 1 ? side.second : 0.0;
  }
  const auto faces = volumes > 0 ? static_cast<long>(sides.size()) : mesh->GetNumberOfCells();
  measures.Euler =
    static_cast<long>(points.size()) - static_cast<long>(edges.size()) + faces - volumes;
  return measures;
}

/// The points that lie on an edge or a face of a cell and are not among its corners, to within
/// `slack`: each point against each cell.
inline std::set<vtkIdType> FindHangingPoints(vtkDataSet* mesh, double slack)
{
  std::set<vtkIdType> hanging;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    mesh->GetCell(id, cell);
    const std::set<vtkIdType> own = IdsOf(cell);
    const int sides =
      cell->GetCellDimension() == 3 ? cell->GetNumberOfFaces() : cell->GetNumberOfEdges();
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      Point x;
      mesh->GetPoint(point, x.data());
      Bounds box;
      cell->GetBounds(box.data());
      if (own.count(point) > 0 || !Contains(Grown(box, slack), x))
      {
        continue;
      }
      for (int i = 0; i < sides; ++i)
      {
        vtkCell* side = cell->GetCellDimension() == 3 ? cell->GetFace(i) : cell->GetEdge(i);
        double closest[3], pcoords[3], dist2, weights[64];
        int subId;
        const int status =
          side->EvaluatePosition(x.data(), closest, subId, pcoords, dist2, weights);
        if (status >= 0 && dist2 <= slack * slack)
        {
          hanging.insert(point);
        }
      }
    }
  }
  return hanging;
}

}

#endif
