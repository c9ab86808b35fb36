// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_LinePacket_h
#define skd_Queries_LinePacket_h

#include "../LeafFilters/QuantizationGrid.h"
#include "../Tree/Node.h"
#include "LocalLine.h"

#include <algorithm>

namespace skd
{

/// Lines that run the same way along each axis, against boxes: all lines at once against many
/// boxes, by the intervals that where they start and how fast they go are in; and each line against
/// one box.
///
/// Along an axis on which lines run forward, one comes to a side at (side - from) * inverse. No
/// line comes to it before the farthest of the starts by the least of the inverses, where that is
/// positive, and where it is not, 0 is a bound; none leaves it later than the other way round.
class LinePacket
{
public:
  static constexpr int Width = 8;

  /// Whether all begin and end near the first of them.
  static bool AreAlike(const Segment<3>* segments, int count, double maxSpread)
  {
    const AxisLanes<3> a(segments[0].A);
    const AxisLanes<3> b(segments[0].B);
    for (int i = 1; i < count; ++i)
    {
      const AxisLanes<3> apart =
        Max(Abs(AxisLanes<3>(segments[i].A) - a), Abs(AxisLanes<3>(segments[i].B) - b));
      if (!AllLessEqual(apart, AxisLanes<3>(maxSpread)))
      {
        return false;
      }
    }
    return count > 1;
  }

  LinePacket()
  {
    std::fill(this->Limits, this->Limits + Width, -1.0f); // less than every key
    for (auto* to : { this->Enter, this->Leave, this->Back })
    {
      std::fill(&to[0][0], &to[0][0] + 3 * Width, 0.0f);
    }
  }

  /// Line i, of at most Width. False: it runs another way than the others.
  bool Add(int i, const LocalLine<3>& line)
  {
    const unsigned backward = line.Along.Signs();
    if (!this->IsAny)
    {
      this->IsAny = true;
      this->Backward = backward;
      this->Along = line.Along;
      this->Least = this->Most = TimesSign(line.From, line.Along);
      this->LeastInverse = this->MostInverse = line.Inverse;
      this->MostRoom = line.Room();
    }
    const AxisLanes<3> room = line.Room();
    const AxisLanes<3> from = TimesSign(line.From, line.Along);
    this->Least = Min(this->Least, from);
    this->Most = Max(this->Most, from);
    this->LeastInverse = Min(this->LeastInverse, line.Inverse);
    this->MostInverse = Max(this->MostInverse, line.Inverse);
    this->MostRoom = Max(this->MostRoom, room);
    const AxisLanes<3> back = -line.Inverse;
    this->Put(i, (from + room) * back, this->Enter);
    this->Put(i, (from - room) * back + AxisLanes<3>(LocalLine<3>::Slack), this->Leave);
    this->Put(i, TimesSign(back, line.Along), this->Back);
    this->Limits[i] = LocalLine<3>::LimitAt(1.0f);
    return this->Backward == backward;
  }

  /// After the last has been added.
  void Start()
  {
    if (!this->IsAny)
    {
      return;
    }
    const AxisLanes<3> slow = -this->LeastInverse;
    const AxisLanes<3> fast = -this->MostInverse;
    SpreadOut((this->Most + this->MostRoom) * slow, this->AllEnter);
    SpreadOut(
      (this->Least - this->MostRoom) * fast + AxisLanes<3>(LocalLine<3>::Slack), this->AllLeave);
    SpreadOut(TimesSign(slow, this->Along), this->BackEnter);
    SpreadOut(TimesSign(fast, this->Along), this->BackLeave);
    this->Sides = &BoxPacket<3, 8>::SidesOf(this->Backward);
    this->TheLimit = LocalLine<3>::LimitAt(1.0f);
  }

  /// Bit i: some of the lines may meet box i, the first of them at the key.
  template <int W>
  unsigned TestBoxes(const BoxPacket<3, W>& boxes, float* keys) const
  {
    Lanes<W> enter(0.0f);
    Lanes<W> leave(this->TheLimit);
    ForEachAxis<3>(
      [&](int axis)
      {
        const Lanes<W> near = boxes.Side(this->Sides->Near[axis]);
        const Lanes<W> far = boxes.Side(this->Sides->Far[axis]);
        enter =
          Max(MinusProduct(Lanes<W>(this->AllEnter[axis]), near, Lanes<W>(this->BackEnter[axis])),
            enter);
        leave =
          Min(MinusProduct(Lanes<W>(this->AllLeave[axis]), far, Lanes<W>(this->BackLeave[axis])),
            leave);
      });
    enter.Store(keys);
    return LessEqual(enter, leave);
  }

  /// Bit i: line i may meet something on the grid.
  unsigned Through(const QuantizationGrid& grid) const
  {
    using L = Lanes<Width>;
    constexpr float rounding = 1.0f / (1 << 23);
    const float half = QuantizationGrid::Largest * grid.Unit + rounding;
    L enter(0.0f);
    L leave = L::Load(this->Limits);
    ForEachAxis<3>(
      [&](int axis)
      {
        const float toNear = (this->Backward >> axis & 1u) != 0 ? half : -half;
        const L back = L::Load(this->Back[axis]);
        const float centre = grid.Centre[axis];
        enter = Max(MinusProduct(L::Load(this->Enter[axis]), L(centre + toNear), back), enter);
        leave = Min(MinusProduct(L::Load(this->Leave[axis]), L(centre - toNear), back), leave);
      });
    return LessEqual(enter, leave);
  }

  /// Of all lines.
  float Limit() const { return this->TheLimit; }

  /// Of line i nothing beyond a parameter of what its clipping left is wanted any more.
  void Lower(int i, double last)
  {
    LocalLine<3>::Lower(this->Limits[i], last);
    this->TheLimit = *std::max_element(this->Limits, this->Limits + Width);
  }

private:
  static void Put(int i, const AxisLanes<3>& values, float (&to)[3][Width])
  {
    float row[AxisLanes<3>::Room];
    values.StorePadded(row);
    ForEachAxis<3>([&](int axis) { to[axis][i] = row[axis]; });
  }
  bool IsAny = false;
  unsigned Backward = 0;
  float TheLimit = -1.0f;
  const BoxPacket<3, 8>::Sides* Sides = nullptr;
  AxisLanes<3> Along; ///< of the first
  ///@{
  /// Of all lines, as if they ran forward along each axis.
  AxisLanes<3> Least;
  AxisLanes<3> Most;
  AxisLanes<3> LeastInverse;
  AxisLanes<3> MostInverse;
  AxisLanes<3> MostRoom;
  ///@}
  ///@{
  /// As those of AlongSegment: of all lines, and of each.
  Spread AllEnter[AxisLanes<3>::Room];
  Spread AllLeave[AxisLanes<3>::Room];
  Spread BackEnter[AxisLanes<3>::Room];
  Spread BackLeave[AxisLanes<3>::Room];
  float Enter[3][Width];
  float Leave[3][Width];
  float Back[3][Width];
  ///@}
  float Limits[Width];
};

}

#endif
