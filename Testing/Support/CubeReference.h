// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CubeReference.h
 * @brief spatial relations of an axis-aligned cube to boxes, spheres, planes, lines and points, by
 * intervals
 */
#ifndef skdtest_CubeReference_h
#define skdtest_CubeReference_h

#include "Support/SpatialQueryRun.h"

namespace skdtest
{

/// A query shape, a cube being a box.
struct CubeQuery
{
  int Shape = SpatialQuery::BOX;
  Bounds Box{};                       // also of a point and of a cell
  Point Center{}, Normal{}, A{}, B{}; // of a sphere, plane, line
  double Radius = 0.0;
};

inline bool IsFlat(const Bounds& box, int axis)
{
  return box[2 * axis] == box[2 * axis + 1];
}

inline Point CornerOf(const Bounds& box, int corner)
{
  return { box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2 & 1)] };
}

inline double HighestOf(const Bounds& box, const std::function<double(const Point&)>& value)
{
  double highest = -std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner)
  {
    highest = std::max(highest, value(CornerOf(box, corner)));
  }
  return highest;
}

/// The parameters at which a segment is in a box, its boundary left out or not: first and last.
inline std::array<double, 2> ParametersIn(const CubeQuery& line, const Bounds& box, bool isOpen)
{
  std::array<double, 2> inside = { 0.0, 1.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double from = line.A[axis];
    const double along = line.B[axis] - from;
    const double low = box[2 * axis];
    const double high = box[2 * axis + 1];
    if (along == 0.0)
    {
      const bool isIn = isOpen ? low < from && from < high : low <= from && from <= high;
      inside[1] = isIn ? inside[1] : -1.0;
      continue;
    }
    inside[0] = std::max(inside[0], (along > 0.0 ? low - from : high - from) / along);
    inside[1] = std::min(inside[1], (along > 0.0 ? high - from : low - from) / along);
  }
  return inside;
}

/// The relation of a cube and a query, by intervals.
class CubeReference
{
public:
  CubeReference(const Bounds& cube, const CubeQuery& query)
    : Cube(cube)
    , Query(query)
  {
  }

  double Min() const
  {
    switch (this->Query.Shape)
    {
      case SpatialQuery::SPHERE:
        return std::max(0.0, Distance(this->Cube, this->Query.Center) - this->Query.Radius);
      case SpatialQuery::PLANE:
        return std::max({ 0.0, -this->Above(), -this->Below() });
      case SpatialQuery::LINE:
        return this->MinToLine();
      default:
      {
        Point gap;
        for (int axis = 0; axis < 3; ++axis)
        {
          gap[axis] = std::max({ 0.0, this->Cube[2 * axis] - this->Query.Box[2 * axis + 1],
            this->Query.Box[2 * axis] - this->Cube[2 * axis + 1] });
        }
        return Length(gap);
      }
    }
  }

  double Max() const
  {
    const auto farthest = [&](const Point& x)
    { return HighestOf(this->Cube, [&](const Point& corner) { return Distance(corner, x); }); };
    switch (this->Query.Shape)
    {
      case SpatialQuery::SPHERE:
        return farthest(this->Query.Center) + this->Query.Radius;
      case SpatialQuery::PLANE:
        return std::max(this->Above(), this->Below());
      case SpatialQuery::LINE:
        return std::max(farthest(this->Query.A), farthest(this->Query.B));
      default:
        return HighestOf(this->Query.Box, farthest);
    }
  }

  bool Is(int relation) const
  {
    switch (relation)
    {
      case SpatialQuery::EXACT_MATCH:
        return this->Contains() && this->Encloses();
      case SpatialQuery::OVERLAP:
        return this->Min() < 1e-7;
      case SpatialQuery::ENCLOSURE:
        return this->Encloses();
      case SpatialQuery::CONTAINMENT:
        return this->Contains();
      default:
        return this->Min() < 1e-7 && !this->MeetInside();
    }
  }

private:
  double Height(const Point& x) const
  {
    return Dot(x - this->Query.Center, (1.0 / Length(this->Query.Normal)) * this->Query.Normal);
  }
  double Above() const
  {
    return HighestOf(this->Cube, [&](const Point& x) { return this->Height(x); });
  }
  double Below() const
  {
    return HighestOf(this->Cube, [&](const Point& x) { return -this->Height(x); });
  }

  /// The distance along a line is convex: by thirds.
  double MinToLine() const
  {
    const std::array<double, 2> in = ParametersIn(this->Query, this->Cube, false);
    if (in[0] <= in[1] + 1e-12)
    {
      return 0.0;
    }
    const auto at = [&](double t)
    { return Distance(this->Cube, Lerp(this->Query.A, this->Query.B, t)); };
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 200; ++i)
    {
      const double third = (high - low) / 3.0;
      const bool isBefore = at(low + third) < at(high - third);
      (isBefore ? high : low) += isBefore ? -third : third;
    }
    return at(low);
  }

  bool Encloses() const
  {
    switch (this->Query.Shape)
    {
      case SpatialQuery::SPHERE:
      {
        const double r = this->Query.Radius;
        const Point& c = this->Query.Center;
        return skdtest::Contains(
          this->Cube, Bounds{ c[0] - r, c[0] + r, c[1] - r, c[1] + r, c[2] - r, c[2] + r });
      }
      case SpatialQuery::PLANE:
        return false;
      case SpatialQuery::LINE:
        return skdtest::Contains(this->Cube, this->Query.A) &&
          skdtest::Contains(this->Cube, this->Query.B);
      default:
        return skdtest::Contains(this->Cube, this->Query.Box);
    }
  }

  bool Contains() const
  {
    switch (this->Query.Shape)
    {
      case SpatialQuery::SPHERE:
        return HighestOf(this->Cube,
                 [&](const Point& x)
                 { return Distance(x, this->Query.Center); }) <= this->Query.Radius + 1e-12;
      case SpatialQuery::PLANE:
      case SpatialQuery::LINE:
        return false;
      default:
        return skdtest::Contains(this->Query.Box, this->Cube);
    }
  }

  bool MeetInside() const
  {
    switch (this->Query.Shape)
    {
      case SpatialQuery::SPHERE:
        return this->Query.Radius == 0.0
          ? skdtest::Contains(Grown(this->Cube, -1e-7), this->Query.Center)
          : Distance(this->Cube, this->Query.Center) < this->Query.Radius - 1e-7;
      case SpatialQuery::PLANE:
        return this->Above() > 1e-7 && this->Below() > 1e-7;
      case SpatialQuery::LINE:
      {
        const std::array<double, 2> in = ParametersIn(this->Query, this->Cube, true);
        const bool isPoint = this->Query.A == this->Query.B;
        return isPoint ? in[1] > 0.0 : in[0] + 1e-12 < in[1];
      }
      default:
        break;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = std::max(this->Cube[2 * axis], this->Query.Box[2 * axis]);
      const double high = std::min(this->Cube[2 * axis + 1], this->Query.Box[2 * axis + 1]);
      const double at = this->Query.Box[2 * axis];
      const bool meet = IsFlat(this->Query.Box, axis)
        ? this->Cube[2 * axis] < at && at < this->Cube[2 * axis + 1]
        : low < high;
      if (!meet)
      {
        return false;
      }
    }
    return true;
  }

  Bounds Cube;
  CubeQuery Query;
};

}

#endif
