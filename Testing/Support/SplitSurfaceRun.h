// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SplitSurfaceRun.h
 * @brief What vtkSkdTreeSurfaceIntersection's split surfaces must be like, whatever they are of
 */
#ifndef skdtest_SplitSurfaceRun_h
#define skdtest_SplitSurfaceRun_h

#include "Support/SurfaceIntersectionRun.h"

#include <cstdlib>
#include <map>
#include <set>

namespace skdtest
{

/// A split surface by value.
struct SplitSurface
{
  std::vector<Point> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;
  std::vector<vtkIdType> Cells;
  std::vector<vtkIdType> Regions;

  explicit SplitSurface(vtkPolyData* output)
    : Points(output->GetNumberOfPoints())
    , Triangles(output->GetNumberOfPolys())
  {
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      output->GetPoint(static_cast<vtkIdType>(i), this->Points[i].data());
    }
    vtkNew<vtkIdList> ids;
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      const auto cell = static_cast<vtkIdType>(i);
      output->GetPolys()->GetCellAtId(cell, ids);
      std::copy_n(ids->GetPointer(0), 3, this->Triangles[i].begin());
      this->Cells.push_back(
        static_cast<vtkIdType>(output->GetCellData()->GetArray("SkdCellId")->GetTuple1(cell)));
      this->Regions.push_back(
        static_cast<vtkIdType>(output->GetCellData()->GetArray("SkdRegionId")->GetTuple1(cell)));
    }
  }

  Point TwiceAreaOf(std::size_t triangle) const
  {
    const auto& ids = this->Triangles[triangle];
    return Cross(
      this->Points[ids[1]] - this->Points[ids[0]], this->Points[ids[2]] - this->Points[ids[0]]);
  }

  /// The sums of the vector areas of the pieces, by cell.
  std::map<vtkIdType, Point> AreasOfCells() const
  {
    std::map<vtkIdType, Point> areas;
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      Point& sum = areas.emplace(this->Cells[i], Point{ 0, 0, 0 }).first->second;
      sum = sum + 0.5 * this->TwiceAreaOf(i);
    }
    return areas;
  }

  double Area() const
  {
    double area = 0.0;
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      area += 0.5 * Length(this->TwiceAreaOf(i));
    }
    return area;
  }

  vtkIdType CountRegions() const
  {
    return this->Regions.empty()
      ? 0
      : *std::max_element(this->Regions.begin(), this->Regions.end()) + 1;
  }

  using Edge = std::pair<vtkIdType, vtkIdType>;

  /// How often each edge is used, one way less the other: all 0 of what is closed and oriented.
  std::map<Edge, int> Borders() const
  {
    std::map<Edge, int> edges;
    for (const auto& ids : this->Triangles)
    {
      for (int i = 0; i < 3; ++i)
      {
        const vtkIdType a = ids[i];
        const vtkIdType b = ids[(i + 1) % 3];
        edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
      }
    }
    return edges;
  }

  std::size_t CountBorderEdges() const
  {
    std::size_t count = 0;
    for (const auto& [edge, balance] : this->Borders())
    {
      count += balance != 0;
    }
    return count;
  }

  double BorderLength() const
  {
    double length = 0.0;
    for (const auto& [edge, balance] : this->Borders())
    {
      length += std::abs(balance) * Distance(this->Points[edge.first], this->Points[edge.second]);
    }
    return length;
  }

  /// All edges, by the places of their ends.
  std::set<std::pair<Point, Point>> Edges() const
  {
    std::set<std::pair<Point, Point>> edges;
    for (const auto& [edge, balance] : this->Borders())
    {
      const Point& a = this->Points[edge.first];
      const Point& b = this->Points[edge.second];
      edges.insert({ std::min(a, b), std::max(a, b) });
    }
    return edges;
  }
};

}

#endif
