// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_TrianglePacket_h
#define skd_LeafFilters_TrianglePacket_h

#include "../Tree/Node.h"
#include "../Tree/Tolerances.h"
#include "QuantizationGrid.h"

namespace skd
{

/// Corners of up to eight cells of a leaf on its grid: those of triangles, or of boxes the least
/// and the greatest.
template <int Number>
struct QuantizedCorners
{
  static constexpr int Width = 8;

  QuantizationGrid Grid{};
  std::int16_t Corners[Number][3][Width] = {}; ///< by corner, axis, lane

  /// `position` in the tree's frame.
  void Set(int corner, int lane, const Vector3& position)
  {
    const Vector3 rounded = this->Grid.Of(position);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Corners[corner][axis][lane] = QuantizationGrid::Round(rounded[axis]);
    }
  }

  /// In the frame, what is within `margin` of the boxes of the exact corners, and at most
  /// WideningOf() more on each side.
  SKD_FLATTEN void GetBoxes(float margin, BoxPacket<3, Width>& boxes) const
  {
    using L = Lanes<NativeWidth>;
    const float aside = margin + AsideOf(this->Grid.Unit);
    const L back(-this->Grid.Unit);
    for (int axis = 0; axis < 3; ++axis)
    {
      const L low(this->Grid.Centre[axis] - aside);
      const L high(this->Grid.Centre[axis] + aside);
      for (int first = 0; first < Width; first += NativeWidth)
      {
        L least = L::LoadShorts(this->Corners[0][axis] + first);
        L most = L::LoadShorts(this->Corners[1][axis] + first);
        if constexpr (Number == 3)
        {
          const L other = L::LoadShorts(this->Corners[2][axis] + first);
          const L less = Min(least, most);
          most = Max(Max(least, most), other);
          least = Min(less, other);
        }
        MinusProduct(low, least, back).Store(boxes.Min[axis] + first);
        MinusProduct(high, most, back).Store(boxes.Max[axis] + first);
      }
    }
  }
  static double WideningOf(float unit) { return 2.0 * AsideOf(unit); }

private:
  /// Above the errors of corners and what rounding does to coordinates and to the margin.
  static float AsideOf(float unit)
  {
    constexpr float cornerError = 0.53f;
    static_assert(cornerError > QuantizationGrid::CornerError);
    return cornerError * unit + tolerances::QuantizedBox;
  }
};

/// Up to eight triangles on their grid, and the indices of their exact corners: three cache lines.
struct alignas(64) TrianglePacket : QuantizedCorners<3>
{
  std::uint32_t FirstPoint = 0;        ///< of those that the triangles share (TrianglePackets)
  std::uint8_t PointOf[Width][3] = {}; ///< how much farther that of each corner is

  template <int W>
  Lanes<W> Load(int corner, int axis, int first) const
  {
    return Lanes<W>::LoadShorts(this->Corners[corner][axis] + first);
  }

  /// The coordinates of all corners along one axis, which is not known when this is compiled: its
  /// address is computed once.
  class Row
  {
  public:
    Row(const TrianglePacket& packet, int axis)
      : First(packet.Corners[0][axis])
    {
    }

    template <int W>
    Lanes<W> Load(int corner, int first) const
    {
      constexpr int perCorner = 3 * Width;
      return Lanes<W>::LoadShorts(this->First + (corner * perCorner + first));
    }

  private:
    const std::int16_t* First;
  };
};

/// Three coordinates, each for some lanes.
template <int W>
struct LanePoint
{
  Lanes<W> X;
  Lanes<W> Y;
  Lanes<W> Z;

  friend LanePoint operator-(const LanePoint& a, const LanePoint& b)
  {
    return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
  }
  friend LanePoint operator*(const Lanes<W>& factor, const LanePoint& a)
  {
    return { factor * a.X, factor * a.Y, factor * a.Z };
  }
  friend Lanes<W> Dot(const LanePoint& a, const LanePoint& b)
  {
    return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
  }
};

template <int W>
LanePoint<W> CornersOf(const TrianglePacket& packet, int corner, int first)
{
  return { packet.Load<W>(corner, 0, first), packet.Load<W>(corner, 1, first),
    packet.Load<W>(corner, 2, first) };
}

}

#endif
