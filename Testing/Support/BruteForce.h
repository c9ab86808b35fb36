// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BruteForce.h
 * @brief every question answered by a look at every cell
 */
#ifndef skdtest_BruteForce_h
#define skdtest_BruteForce_h

#include "Support/MeshBuilder.h"
#include "Support/PrimitiveDistance.h"

#include "vtkGenericCell.h"
#include "vtkMath.h"

namespace skdtest
{

/// A data set's cells by value. Distances to linear cells do not go through VTK.
class BruteForce
{
public:
  struct Nearest
  {
    double Distance = std::numeric_limits<double>::infinity();
    vtkIdType Cell = -1;
  };

  struct Hit
  {
    double T;
    vtkIdType Cell;
    bool operator<(const Hit& o) const
    {
      return this->T < o.T || (this->T == o.T && this->Cell < o.Cell);
    }
  };

  explicit BruteForce(
    vtkDataSet* data, const std::function<bool(vtkIdType)>& keep = [](vtkIdType) { return true; })
    : Data(data)
    , Whole(EmptyBounds())
  {
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      this->Shapes.emplace_back(this->ShapeOf(cell));
      const bool has = keep(cell) && this->Shapes.back().Type != VTK_EMPTY_CELL;
      if (has)
      {
        this->Cells.push_back(cell);
        Extend(this->Whole, { this->Box(cell)[0], this->Box(cell)[2], this->Box(cell)[4] });
        Extend(this->Whole, { this->Box(cell)[1], this->Box(cell)[3], this->Box(cell)[5] });
      }
    }
  }

  const Ids& GetCells() const { return this->Cells; }
  const Bounds& GetBounds() const { return this->Whole; }
  const Bounds& Box(vtkIdType cell) const { return this->Shapes[cell].Box; }

  /// Rounding errors of distances are within this.
  double Tolerance() const { return 1e-12 * Scale(this->Whole); }

  /// The nearest of all cells, of equally near ones the lowest id.
  Nearest FindNearest(const Point& x)
  {
    Nearest nearest;
    for (vtkIdType cell : this->Cells)
    {
      if (Distance(this->Box(cell), x) <= nearest.Distance)
      {
        const double distance = this->DistanceTo(cell, x);
        nearest = distance < nearest.Distance ? Nearest{ distance, cell } : nearest;
      }
    }
    return nearest;
  }

  double DistanceTo(vtkIdType cell, const Point& x)
  {
    const Shape& shape = this->Shapes[cell];
    if (shape.ByVtk)
    {
      return this->DistanceByVtk(cell, x);
    }
    double best = std::numeric_limits<double>::infinity();
    for (const Point& p : shape.Vertices)
    {
      best = std::min(best, Distance(x, p));
    }
    for (const auto& s : shape.Segments)
    {
      best = std::min(best, SegmentDistance(x, s[0], s[1]));
    }
    for (const auto& t : shape.Triangles)
    {
      best = std::min(best, TriangleDistance(x, t[0], t[1], t[2]));
    }
    for (const Patch& p : shape.Patches)
    {
      best = std::min(best, PatchDistance(x, p));
    }
    return shape.Solid && this->IsInside(cell, x) ? 0.0 : best;
  }

  /// As vtkCell::EvaluatePosition sees it; infinite where that fails.
  double DistanceByVtk(vtkIdType cell, const Point& x)
  {
    double closest[3], pcoords[3], dist2 = 0.0;
    return this->Evaluate(cell, x, closest, pcoords, dist2) >= 0
      ? std::sqrt(dist2)
      : std::numeric_limits<double>::infinity();
  }

  bool IsInside(vtkIdType cell, const Point& x)
  {
    double closest[3], pcoords[3], dist2 = 0.0;
    return Contains(this->Box(cell), x) &&
      this->Evaluate(cell, x, closest, pcoords, dist2) == 1 && dist2 == 0.0;
  }

  /// All cells of volume that hold x, ascending.
  Ids FindContaining(const Point& x)
  {
    Ids found;
    for (vtkIdType cell : this->Cells)
    {
      if (this->IsInside(cell, x))
      {
        found.push_back(cell);
      }
    }
    return found;
  }

  Ids FindWithinBounds(const Bounds& box) const
  {
    Ids found;
    for (vtkIdType cell : this->Cells)
    {
      if (Overlap(this->Box(cell), box))
      {
        found.push_back(cell);
      }
    }
    return found;
  }

  /// vtkCell::IntersectWithLine of every cell, sorted.
  std::vector<Hit> Intersect(const Point& p1, const Point& p2, double tolerance)
  {
    std::vector<Hit> hits;
    double t, x[3], pcoords[3];
    int subId;
    for (vtkIdType cell : this->Cells)
    {
      this->Data->GetCell(cell, this->Cell);
      if (this->Cell->IntersectWithLine(p1.data(), p2.data(), tolerance, t, x, pcoords, subId))
      {
        hits.push_back({ t, cell });
      }
    }
    std::sort(hits.begin(), hits.end());
    return hits;
  }

private:
  struct Shape
  {
    int Type = VTK_EMPTY_CELL;
    bool ByVtk = false;
    bool Solid = false;
    Bounds Box = EmptyBounds();
    std::vector<Point> Vertices;
    std::vector<std::array<Point, 2>> Segments;
    std::vector<std::array<Point, 3>> Triangles;
    std::vector<Patch> Patches;
  };

  int Evaluate(vtkIdType cell, const Point& x, double closest[3], double pcoords[3], double& dist2)
  {
    int subId = 0;
    this->Data->GetCell(cell, this->Cell);
    this->Weights.resize(this->Cell->GetNumberOfPoints() + 1);
    return this->Cell->EvaluatePosition(
      x.data(), closest, subId, pcoords, dist2, this->Weights.data());
  }

  Shape ShapeOf(vtkIdType cell)
  {
    Shape shape;
    this->Data->GetCell(cell, this->Cell);
    std::vector<Point> p(this->Cell->GetNumberOfPoints());
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      this->Cell->Points->GetPoint(static_cast<vtkIdType>(i), p[i].data());
      Extend(shape.Box, p[i]);
    }
    shape.Type = p.empty() ? static_cast<int>(VTK_EMPTY_CELL) : this->Cell->GetCellType();
    shape.Solid = this->Cell->GetCellDimension() == 3;
    shape.ByVtk = !AddPrimitives(shape, p);
    return shape;
  }

  static void AddPatch(Shape& s, const std::vector<Point>& p, int a, int b, int c, int d)
  {
    s.Patches.push_back({ p[a], p[b], p[c], p[d] });
  }

  static void AddTriangle(Shape& s, const std::vector<Point>& p, int a, int b, int c)
  {
    s.Triangles.push_back({ p[a], p[b], p[c] });
  }

  /// False where the cell is left to VTK.
  static bool AddPrimitives(Shape& s, const std::vector<Point>& p)
  {
    const int n = static_cast<int>(p.size());
    switch (s.Type)
    {
      case VTK_EMPTY_CELL:
        return true;
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        s.Vertices = p;
        return true;
      case VTK_LINE:
      case VTK_POLY_LINE:
        for (int i = 0; i + 1 < n; ++i)
        {
          s.Segments.push_back({ p[i], p[i + 1] });
        }
        return true;
      case VTK_TRIANGLE:
      case VTK_TRIANGLE_STRIP:
        for (int i = 0; i + 2 < n; ++i)
        {
          AddTriangle(s, p, i, i + 1, i + 2);
        }
        return true;
      case VTK_QUAD:
        AddPatch(s, p, 0, 1, 2, 3);
        return true;
      case VTK_PIXEL:
        AddPatch(s, p, 0, 1, 3, 2);
        return true;
      default:
        return AddFaces(s, p);
    }
  }

  static bool AddFaces(Shape& s, const std::vector<Point>& p)
  {
    switch (s.Type)
    {
      case VTK_TETRA:
        AddTriangle(s, p, 0, 1, 2);
        AddTriangle(s, p, 0, 1, 3);
        AddTriangle(s, p, 0, 2, 3);
        AddTriangle(s, p, 1, 2, 3);
        return true;
      case VTK_HEXAHEDRON:
      case VTK_VOXEL:
      {
        const int two = s.Type == VTK_VOXEL ? 3 : 2;
        const int top = s.Type == VTK_VOXEL ? 7 : 6;
        AddPatch(s, p, 0, 1, two, 5 - two);
        AddPatch(s, p, 4, 5, top, 13 - top);
        AddPatch(s, p, 0, 1, 5, 4);
        AddPatch(s, p, 1, two, top, 5);
        AddPatch(s, p, two, 5 - two, 13 - top, top);
        AddPatch(s, p, 5 - two, 0, 4, 13 - top);
        return true;
      }
      case VTK_WEDGE:
        AddTriangle(s, p, 0, 1, 2);
        AddTriangle(s, p, 3, 4, 5);
        AddPatch(s, p, 0, 1, 4, 3);
        AddPatch(s, p, 1, 2, 5, 4);
        AddPatch(s, p, 2, 0, 3, 5);
        return true;
      case VTK_PYRAMID:
        AddPatch(s, p, 0, 1, 2, 3);
        AddTriangle(s, p, 0, 1, 4);
        AddTriangle(s, p, 1, 2, 4);
        AddTriangle(s, p, 2, 3, 4);
        AddTriangle(s, p, 3, 0, 4);
        return true;
      default:
        return false;
    }
  }

  vtkSmartPointer<vtkDataSet> Data;
  Bounds Whole;
  std::vector<Shape> Shapes;
  Ids Cells;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Weights;
};

}

#endif
