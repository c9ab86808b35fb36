// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_PlaneRow_h
#define skd_LeafFilters_PlaneRow_h

#include "../Tree/ShortLanes.h"
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

/// A point on the grid in whole numbers, as rows take it: within the grid's extent the nearest.
class WholePoint
{
public:
  explicit WholePoint(const Vector3& onGrid)
    : XY{ NearestTo(onGrid[0]), NearestTo(onGrid[1]) }
    , ZAndUnit{ NearestTo(onGrid[2]), std::numeric_limits<std::int16_t>::min() }
  {
  }

private:
  friend struct NormalRow;

  /// Without a conversion, which is slower: the last bits of a sum with 1.5 * 2^52.
  static std::int16_t NearestTo(double coordinate)
  {
    const double large = coordinate + 6755399441055744.0;
    std::uint64_t bits;
    std::memcpy(&bits, &large, sizeof(bits));
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
  }

  ShortPair XY;
  ShortPair ZAndUnit; ///< with the unit of offsets, negative
};

/// A plane for each of eight cells, on the grid, that has the whole cell on one side: there
/// Normal . x is at least Least * OffsetUnit. Normals and limits are whole numbers: a normal has no
/// error, since it goes with the limit that it needs.
struct NormalRow
{
  static constexpr int Width = 8;
  static constexpr double Longest = 8191.0;     ///< of a normal along an axis
  static constexpr double OffsetUnit = 32768.0; ///< with Longest, no sum is beyond 32 bits
  /// A margin, in units, above what rounding does to corners and to a point.
  static constexpr double Rounding = 0.25 + 0.875;

  ///@{
  /// Until it is set, a plane excludes nothing: 0 . x >= 0.
  ShortPair XY[Width] = {};
  ShortPair ZAndLeast[Width] = {};
  ///@}

  /// How far above the plane, in the normal's length.
  EightIntegers HeightOf(const WholePoint& x) const
  {
    return EightIntegers::SumsOfProducts(this->XY, x.XY) +
      EightIntegers::SumsOfProducts(this->ZAndLeast, x.ZAndUnit);
  }

protected:
  void Put(int lane, const double* normal, double least)
  {
    const auto whole = [](double value) { return static_cast<std::int16_t>(value); };
    this->XY[lane] = { whole(normal[0]), whole(normal[1]) };
    this->ZAndLeast[lane] = { whole(normal[2]), whole(least) };
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
      const Number whole = NearestWhole(across[axis] / largest * Longest);
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

  /// Of 16 bits, and so is its negative.
  template <class Number>
  static Number GreatestWholeBelow(const Number& value)
  {
    const Number most = Number{} + double(QuantizationGrid::Largest);
    const Number above = value > -most ? value : -most;
    const Number within = above < most ? above : most;
    const Number nearest = NearestWhole(within);
    return nearest > within ? nearest - 1.0 : nearest;
  }
};

/// Planes of which nothing else is known.
struct alignas(64) PlaneRow : NormalRow
{
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

  /// Negative in the lanes of cells that do not hold x, which is within the grid's extent.
  EightIntegers Inside(const WholePoint& x) const { return this->HeightOf(x); }

private:
  /// Of a cell, or of several: Number is double, or as many of them as are computed with at once.
  /// Whole numbers of 16 bits.
  template <class Number>
  struct Plane
  {
    Number Normal[3];
    Number Least;
  };

  template <class Number, class Corner>
  static Plane<Number> AlongFace(
    const Number* across, const Number* onFace, const Corner& corner, int count, double margin)
  {
    Plane<Number> plane;
    SetDirection(across, plane.Normal);
    const Number height = Along(plane.Normal, [&](int axis) { return onFace[axis]; });
    const Extent<Number> extent(plane.Normal, height, corner, count);
    const auto isInward = extent.Most - height > height - extent.Least;
    const Number least = isInward ? extent.Least : -extent.Most;
    plane.Least = GreatestWholeBelow((least - extent.Length * margin) / OffsetUnit);
    for (Number& component : plane.Normal)
    {
      component = isInward ? component : -component;
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
            LaneOf(planes.Least, i) });
      }
    }
  }

  void Put(int lane, const Plane<double>& plane)
  {
    this->NormalRow::Put(lane, plane.Normal, plane.Least);
  }
};

/// A second plane for each cell, parallel to the first and Thickness * OffsetUnit away from it, so
/// that the whole cell is between them.
struct SlabRow : NormalRow
{
  std::uint16_t Thickness[Width] = {};

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
      const DoubleVector most = -GreatestWholeBelow(-(extent.Most + aside) / OffsetUnit);
      const DoubleVector least = GreatestWholeBelow((extent.Least - aside) / OffsetUnit);
      for (int i = 0; i < NativeDoubles; ++i)
      {
        if ((lanes >> (first + i) & 1u) != 0)
        {
          const double one[3] = { LaneOf(normal[0], i), LaneOf(normal[1], i),
            LaneOf(normal[2], i) };
          this->Put(first + i, one, LaneOf(least, i));
          this->Thickness[first + i] = static_cast<std::uint16_t>(LaneOf(most - least, i));
        }
      }
    }
  }

  /// As that of PlaneRow.
  EightIntegers Inside(const WholePoint& x) const
  {
    const EightIntegers height = this->HeightOf(x);
    return height | (EightIntegers::Shifted15(this->Thickness) - height);
  }
};

/// What eight hexahedra are in: the slabs between their opposite faces.
struct SlabPacket
{
  static constexpr int Number = 3;

  SlabRow Slabs[Number];

  /// As that of PlaneRow.
  EightIntegers Inside(const WholePoint& x) const
  {
    return this->Slabs[0].Inside(x) | this->Slabs[1].Inside(x) | this->Slabs[2].Inside(x);
  }
};

}

#endif
