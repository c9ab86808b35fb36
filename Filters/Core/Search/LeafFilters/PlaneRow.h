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

/// A direction for each of eight cells, on the grid, and what limits need that cells have along it.
/// Directions are whole numbers, and no error: with each go the limits that it needs.
struct NormalRow
{
  static constexpr int Width = 8;
  static constexpr double OffsetUnit = 4.0 * QuantizationGrid::Largest; ///< no product is greater
  /// A margin, in units, above what rounding does to corners, to a point and in MayHold().
  static constexpr double Rounding = 0.25;

  std::int16_t Normal[3][Width] = {};

protected:
  /// How far x, which is within the grid's extent, is along the directions.
  template <class L>
  L HeightOf(const float* x, int first) const
  {
    const auto normal = [&](int axis) { return L::LoadShorts(this->Normal[axis] + first); };
    return normal(0) * L(x[0]) + normal(1) * L(x[1]) + normal(2) * L(x[2]);
  }

  template <class L>
  static L Limit(const std::int16_t* offsets, int first)
  {
    return L::LoadShorts(offsets + first) * L(float(OffsetUnit));
  }

  /// A direction across one face of cells of a shape.
  template <class Shape>
  static void AcrossFace(
    int face, const CornerLanes<Shape>& corners, int first, DoubleVector* across)
  {
    const int* ids = Shape::Faces[face];
    const int last = ids[3] < 0 ? ids[0] : ids[3];
    DoubleVector a[3], b[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      a[axis] = corners.Load(ids[2], axis, first) - corners.Load(ids[0], axis, first);
      b[axis] = corners.Load(last, axis, first) - corners.Load(ids[1], axis, first);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const int next = (axis + 1) % 3, other = (axis + 2) % 3;
      across[axis] = a[next] * b[other] - a[other] * b[next];
    }
  }

  template <class Number, class Point>
  static Number Along(const Number* normal, const Point& x)
  {
    return normal[0] * x(0) + normal[1] * x(1) + normal[2] * x(2);
  }

  /// How far corners extend along a direction, and how long that is.
  template <class Number>
  struct Extent
  {
    Number Least;
    Number Most;
    Number Length;

    /// `height`: of a point between them.
    template <class Corner>
    Extent(const Number* normal, const Number& height, const Corner& corner, int count)
      : Least(height)
      , Most(height)
      , Length(SquareRoot(Along(normal, [&](int axis) { return normal[axis]; })))
    {
      for (int i = 0; i < count; ++i)
      {
        const Number other = Along(normal, [&](int axis) { return corner(i, axis); });
        this->Least = other < this->Least ? other : this->Least;
        this->Most = other > this->Most ? other : this->Most;
      }
    }
  };

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
};

/// A plane for each of eight cells that has the whole cell on one side: Normal . x is at most
/// Offset * OffsetUnit there.
struct alignas(64) PlaneRow : NormalRow
{
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
    for (int first = 0; first < Width; first += NativeDoubles)
    {
      const auto corner = [&](int i, int axis) { return corners.Load(i, axis, first); };
      DoubleVector onFace[3], across[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        onFace[axis] = corner(Shape::Faces[face][0], axis);
      }
      AcrossFace(face, corners, first, across);
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
      held |= LessEqual(this->HeightOf<L>(x, first), Limit<L>(this->Offset, first)) << first;
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
    const Number height = Along(plane.Normal, [&](int axis) { return onFace[axis]; });
    const Extent<Number> extent(plane.Normal, height, corner, count);
    const auto isFlipped = extent.Most - height > height - extent.Least;
    const Number most = isFlipped ? -extent.Least : extent.Most;
    plane.Offset = LeastWholeAbove((most + extent.Length * margin) / OffsetUnit);
    for (Number& component : plane.Normal)
    {
      component = isFlipped ? -component : component;
    }
    return plane;
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

/// Two parallel planes for each of eight cells that have the whole cell between them: there
/// Normal . x, in units of OffsetUnit, is at least Least and at most Most.
struct SlabRow : NormalRow
{
  std::int16_t Least[Width] = {};
  std::int16_t Most[Width] = {};

  /// Across a face of cells of a shape and the next, which is opposite, both with a direction
  /// outward or both inward. Of the lanes whose bits are set.
  template <class Shape>
  void SetBetweenFaces(unsigned lanes, int face, const CornerLanes<Shape>& corners, double margin)
  {
    for (int first = 0; first < Width; first += NativeDoubles)
    {
      const auto corner = [&](int i, int axis) { return corners.Load(i, axis, first); };
      DoubleVector across[3], opposite[3], normal[3];
      AcrossFace(face, corners, first, across);
      AcrossFace(face + 1, corners, first, opposite);
      for (int axis = 0; axis < 3; ++axis)
      {
        across[axis] = across[axis] - opposite[axis];
      }
      SetDirection(across, normal);
      const DoubleVector height = Along(normal, [&](int axis) { return corner(0, axis); });
      const Extent<DoubleVector> extent(normal, height, corner, Shape::Size);
      const DoubleVector aside = extent.Length * margin;
      const DoubleVector most = LeastWholeAbove((extent.Most + aside) / OffsetUnit);
      const DoubleVector least = -LeastWholeAbove((aside - extent.Least) / OffsetUnit);
      for (int i = 0; i < NativeDoubles; ++i)
      {
        const int lane = first + i;
        for (int axis = 0; axis < 3 && (lanes >> lane & 1u) != 0; ++axis)
        {
          this->Normal[axis][lane] = static_cast<std::int16_t>(LaneOf(normal[axis], i));
          this->Least[lane] = static_cast<std::int16_t>(LaneOf(least, i));
          this->Most[lane] = static_cast<std::int16_t>(LaneOf(most, i));
        }
      }
    }
  }

  /// How far x is beyond the planes, as Normal has it: not at all, which is 0 or less, where it may
  /// be in the cell.
  template <class L>
  L Beyond(const float* x, int first) const
  {
    const L height = this->HeightOf<L>(x, first);
    return Max(Limit<L>(this->Least, first) - height, height - Limit<L>(this->Most, first));
  }
};

/// What eight hexahedra are in: the slabs between their opposite faces.
struct SlabPacket
{
  static constexpr int Number = 3;

  SlabRow Slabs[Number];

  /// As that of PlaneRow.
  SKD_FLATTEN unsigned MayHold(const float* x) const
  {
    unsigned held = 0;
    for (int first = 0; first < SlabRow::Width; first += NativeWidth)
    {
      using L = Lanes<NativeWidth>;
      const auto beyond = [&](int i) { return this->Slabs[i].Beyond<L>(x, first); };
      held |= LessEqual(Max(Max(beyond(0), beyond(1)), beyond(2)), L(0.0f)) << first;
    }
    return held;
  }
};

}

#endif
