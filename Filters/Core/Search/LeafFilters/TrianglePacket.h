// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_TrianglePacket_h
#define skd_LeafFilters_TrianglePacket_h

#include "../Tree/Lanes.h"
#include "QuantizationGrid.h"

namespace skd
{

/// Up to eight triangles on their grid, and the indices of their exact corners: three cache lines.
struct alignas(64) TrianglePacket
{
  static constexpr int Width = 8;

  QuantizationGrid Grid{};
  std::int16_t Corners[3][3][Width] = {}; ///< by corner, axis, lane
  std::uint32_t FirstPoint = 0;           ///< of those that the triangles share (TrianglePackets)
  std::uint8_t PointOf[Width][3] = {};    ///< how much farther that of each corner is

  /// `position` in the tree's frame.
  void Set(int corner, int lane, const Vector3& position)
  {
    const Vector3 rounded = this->Grid.Of(position);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Corners[corner][axis][lane] = QuantizationGrid::Round(rounded[axis]);
    }
  }

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
