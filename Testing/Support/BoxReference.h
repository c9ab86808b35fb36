// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxReference.h
 * @brief whether a linear cell and a box meet, by clipping; and the octree that follows from it
 *
 * Not for boxes that only touch, where rounding decides.
 */
#ifndef skdtest_BoxReference_h
#define skdtest_BoxReference_h

#include "Support/CellShape.h"
#include "Support/ClippedWhere.h"

#include "vtkGenericCell.h"

#include <functional>

namespace skdtest
{

/// The part of a convex polygon in the box; a segment is one of two corners.
inline std::vector<Point> ClippedBy(const Bounds& box, std::vector<Point> polygon)
{
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2;
    const auto height = [&](const Point& p)
    { return side % 2 ? box[side] - p[axis] : p[axis] - box[side]; };
    polygon = ClippedWhere(polygon, height,
      [&](const Point& p, const Point& q, double t)
      {
        Point crossing = Lerp(p, q, t);
        crossing[axis] = box[side];
        return crossing;
      });
  }
  return polygon;
}

inline bool MeetsBox(const CellShape& shape, const Bounds& box)
{
  bool meets = false;
  for (const Point& p : shape.Vertices)
  {
    meets = meets || Contains(box, p);
  }
  for (const auto& s : shape.Segments)
  {
    meets = meets || !ClippedBy(box, { s[0], s[1] }).empty();
  }
  for (const auto& t : SeenTriangles(shape))
  {
    meets = meets || !ClippedBy(box, { t[0], t[1], t[2] }).empty();
  }
  const Point corner = { box[0], box[2], box[4] };
  return meets || (shape.IsSolid && Contains(shape.Box, box) && IsInsideByParity(shape, corner));
}

/// The shapes of all cells of a data set.
inline std::vector<CellShape> ShapesOf(vtkDataSet* data)
{
  std::vector<CellShape> shapes;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    data->GetCell(id, cell);
    shapes.push_back(MakeShape(cell->GetRepresentativeCell()));
  }
  return shapes;
}

/// The octree around some shapes by plain recursion: each box is tested with all shapes.
class ReferenceOctree
{
public:
  using Met = std::vector<const CellShape*>;

  /// Refines boxes that meet a shape, where `isWanted(level, shapes met)` if that is given.
  ReferenceOctree(const std::vector<CellShape>& shapes, int levels,
    std::function<bool(int, const Met&)> isWanted = nullptr)
    : Cut(levels + 1, 0)
    , Leaves(levels + 1, 0)
    , Shapes(shapes)
    , IsWanted(std::move(isWanted))
  {
  }

  void Refine(const Bounds& box, int level)
  {
    Met all;
    for (const CellShape& shape : this->Shapes)
    {
      all.push_back(&shape);
    }
    this->Refine(box, level, all);
  }

  std::vector<double> Cut;    // a value a level
  std::vector<double> Leaves; // likewise

private:
  void Refine(const Bounds& box, int level, const Met& above)
  {
    Met met;
    for (const CellShape* shape : above)
    {
      if (Overlap(shape->Box, box) && MeetsBox(*shape, box))
      {
        met.push_back(shape);
      }
    }
    this->Cut[level] += !met.empty();
    if (met.empty() || level + 1 == static_cast<int>(this->Cut.size()) ||
      (this->IsWanted && !this->IsWanted(level, met)))
    {
      ++this->Leaves[level];
      return;
    }
    const Point middle = Center(box);
    for (int child = 0; child < 8; ++child)
    {
      Bounds part = box;
      for (int axis = 0; axis < 3; ++axis)
      {
        part[2 * axis + (child >> axis & 1 ? 0 : 1)] = middle[axis];
      }
      this->Refine(part, level + 1, met);
    }
  }

  const std::vector<CellShape>& Shapes;
  std::function<bool(int, const Met&)> IsWanted;
};

}

#endif
