// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_PlaneRow_h
#define skd_LeafFilters_PlaneRow_h

#include "../Tree/Lanes.h"
#include "QuantizationGrid.h"

namespace skd
{

/// The corners of eight cells of one shape, on the grid: by corner, axis and cell. Those that are
/// not set are in the middle.
template <class Shape>
class CornerLanes
{
public:
  void Set(int lane, int corner, const Vector3& position)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->At[corner][axis][lane] = position[axis];
    }
  }

  /// Of the cells from `first` on, as many as are computed with at once.
  DoubleVector Load(int corner, int axis, int first) const
  {
    return LoadDoubles(this->At[corner][axis] + first);
  }

private:
  double At[Shape::Size][3][8] = {};
};

/// A plane for each of eight cells that has the whole cell on one side: Normal . x is at most
/// Offset * OffsetUnit there, on the grid. Normals are whole numbers, and no error: with each
/// goes the offset that it needs.
struct alignas(64) PlaneRow
{
  static constexpr int Width = 8;
  static constexpr double OffsetUnit = 4.0 * QuantizationGrid::Largest; ///< no product is greater
  /// A margin, in units, above what rounding does to corners, to a point and in MayHold().
  static constexpr double Rounding = 0.25;

  std::int16_t Normal[3][Width] = {};
  std::int16_t Offset[Width] = {}; // 0 . x <= 0: until it is set, a plane excludes nothing

  /// The plane along a face of what the points (on the grid) span, beside them all and `margin`
  /// away from them, given a direction across it, either way, and a point of it: outward is where
  /// the points extend less far from there. A direction without length excludes nothing.
  void SetAlongFace(int lane, const Vector3& across, const Vector3& onFace, const Vector3* points,
    int count, double margin)
  {
    const auto corner = [&](int i, int axis) { return points[i][axis]; };
    this->Put(lane, AlongFace(across.X, onFace.X, corner, count, margin));
  }

  /// The same along one face of cells of a shape: those of the lanes whose bits are set.
  template <class Shape>
  void SetAlongFaces(unsigned lanes, int face, const CornerLanes<Shape>& corners, double margin)
  {
    const int* ids = Shape::Faces[face];
    const int last = ids[3] < 0 ? ids[0] : ids[3];
    for (int first = 0; first < Width; first += NativeDoubles)
    {
      const auto corner = [&](int i, int axis) { return corners.Load(i, axis, first); };
      DoubleVector onFace[3], across[3], a[3], b[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        onFace[axis] = corner(ids[0], axis);
        a[axis] = corner(ids[2], axis) - onFace[axis];
        b[axis] = corner(last, axis) - corner(ids[1], axis);
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        const int next = (axis + 1) % 3, other = (axis + 2) % 3;
        across[axis] = a[next] * b[other] - a[other] * b[next];
      }
      this->PutSeveral(lanes, first, AlongFace(across, onFace, corner, Shape::Size, margin));
    }
  }

  /// Bit i: x, which is within the grid's extent, may be in the cell of lane i.
  SKD_FLATTEN unsigned MayHold(const float* x) const
  {
    unsigned held = 0;
    for (int first = 0; first < Width; first += NativeWidth)
    {
      using L = Lanes<NativeWidth>;
      const auto normal = [&](int axis) { return L::LoadShorts(this->Normal[axis] + first); };
      const L height = normal(0) * L(x[0]) + normal(1) * L(x[1]) + normal(2) * L(x[2]);
      const L offset = L::LoadShorts(this->Offset + first) * L(float(OffsetUnit));
      held |= LessEqual(height, offset) << first;
    }
    return held;
  }

private:
  /// Of a cell, or of several: Number is double, or as many of them as are computed with at once.
  /// Whole numbers of 16 bits.
  template <class Number>
  struct Plane
  {
    Number Normal[3];
    Number Offset;
  };

  template <class Number, class Corner>
  static Plane<Number> AlongFace(
    const Number* across, const Number* onFace, const Corner& corner, int count, double margin)
  {
    Plane<Number> plane;
    SetDirection(across, plane.Normal);
    const auto heightOf = [&](const auto& x)
    { return plane.Normal[0] * x(0) + plane.Normal[1] * x(1) + plane.Normal[2] * x(2); };
    const Number height = heightOf([&](int axis) { return onFace[axis]; });
    Number least = height;
    Number most = height;
    for (int i = 0; i < count; ++i)
    {
      const Number other = heightOf([&](int axis) { return corner(i, axis); });
      least = other < least ? other : least;
      most = other > most ? other : most;
    }
    const auto isFlipped = most - height > height - least;
    const Number length = SquareRoot(heightOf([&](int axis) { return plane.Normal[axis]; }));
    const Number extent = isFlipped ? -least : most;
    plane.Offset = LeastWholeAbove((extent + length * margin) / OffsetUnit);
    for (Number& component : plane.Normal)
    {
      component = isFlipped ? -component : component;
    }
    return plane;
  }

  /// To zero if `across` has no length, or none that is finite.
  template <class Number>
  static void SetDirection(const Number* across, Number* normal)
  {
    const Number none = {};
    Number largest = none;
    Number sum = none;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Number size = across[axis] < none ? -across[axis] : across[axis];
      largest = size > largest ? size : largest;
      sum = sum + size;
    }
    const Number most = none + std::numeric_limits<double>::max();
    const auto isDirection = (largest > none) & (sum <= most);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Number whole = NearestWhole(across[axis] / largest * double(QuantizationGrid::Largest));
      normal[axis] = isDirection ? whole : none;
    }
  }

  /// What std::nearbyint() gives: doubles as large as this have no fractions.
  template <class Number>
  static Number NearestWhole(const Number& value)
  {
    constexpr double large = 6755399441055744.0; // 1.5 * 2^52
    return (value + large) - large;
  }

  /// Within the grid's extent.
  template <class Number>
  static Number LeastWholeAbove(const Number& value)
  {
    const Number most = Number{} + double(QuantizationGrid::Largest);
    const Number above = value > -most ? value : -most;
    const Number within = above < most ? above : most;
    const Number nearest = NearestWhole(within);
    return nearest < within ? nearest + 1.0 : nearest;
  }

  void PutSeveral(unsigned lanes, int first, const Plane<DoubleVector>& planes)
  {
    for (int i = 0; i < NativeDoubles; ++i)
    {
      if ((lanes >> (first + i) & 1u) != 0)
      {
        this->Put(first + i,
          { { LaneOf(planes.Normal[0], i), LaneOf(planes.Normal[1], i),
              LaneOf(planes.Normal[2], i) },
            LaneOf(planes.Offset, i) });
      }
    }
  }

  void Put(int lane, const Plane<double>& plane)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Normal[axis][lane] = static_cast<std::int16_t>(plane.Normal[axis]);
    }
    this->Offset[lane] = static_cast<std::int16_t>(plane.Offset);
  }
};

}

#endif
