// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitPoints.h"

#include "Core/Geometry/Predicates/LongPoint.h"
#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace skdtree
{
namespace
{
/// What a slot has, or make() for it if it has nothing. Of two threads that make one the first
/// keeps its own.
template <class T, class Make>
const T& MadeOnce(std::atomic<const T*>& slot, const Make& make)
{
  const T* known = slot.load();
  if (!known)
  {
    auto made = std::make_unique<const T>(make());
    known = slot.compare_exchange_strong(known, made.get()) ? made.release() : known;
  }
  return *known;
}

double LargestCoordinateOf(const SkdTriangleSet::PointList& points)
{
  double extent = 0.0;
  for (const skd::Vector3& x : points)
  {
    extent = std::max({ extent, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  }
  return extent;
}
}

/// An exact position, and that to two hundred bits once that is worth while: it takes as long to
/// make as some exact signs.
struct SkdSplitPoints::ExactPosition
{
  static constexpr int Few = 2; // signs

  explicit ExactPosition(skd::ExactPoint exact)
    : Exact(std::move(exact))
  {
  }
  ~ExactPosition() { delete this->Long.load(); }
  ExactPosition(const ExactPosition&) = delete;
  ExactPosition& operator=(const ExactPosition&) = delete;

  bool IsAskedOften() const { return this->NumberAsked.load(std::memory_order_relaxed) > Few; }
  const skd::LongPoint& GetLong() const
  {
    return MadeOnce(this->Long, [&] { return skd::LongPoint(this->Exact); });
  }

  const skd::ExactPoint Exact;
  mutable std::atomic<const skd::LongPoint*> Long{ nullptr };
  mutable std::atomic<int> NumberAsked{ 0 }; // for signs
};

std::optional<int> SkdOrientByCoordinates(
  const SkdSplitPosition& a, const SkdSplitPosition& b, const SkdSplitPosition& c, int axis)
{
  const unsigned axes = a.ExactAxes & b.ExactAxes & c.ExactAxes;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const auto isExact = [axes](int along) { return (axes >> along & 1u) != 0; };
  const auto areSame = [&](int along)
  { return isExact(along) && a.X[along] == b.X[along] && b.X[along] == c.X[along]; };
  if (areSame(u) || areSame(v))
  {
    return 0;
  }
  return isExact(u) && isExact(v) ? std::make_optional(skd::Orient2D(a.X, b.X, c.X, axis))
                                  : std::nullopt;
}

SkdSplitPoints::SkdSplitPoints(const SkdContactPoints& contacts, const SkdPlacement& placement)
  : Contacts(contacts)
  , Positions(contacts.GetNumberOfPoints())
  , ExactAxes(contacts.GetNumberOfPoints())
  , Exact(contacts.GetNumberOfPoints())
  , Close(contacts.GetNumberOfPoints())
  , Same(contacts.GetNumberOfPoints())
{
  const double extent = std::max(LargestCoordinateOf(placement.First.GetPoints()),
    LargestCoordinateOf(placement.GetSecond().GetPoints()));
  this->Error = ErrorOf(extent);
  for (std::uint32_t point = 0; point < contacts.GetNumberOfPoints(); ++point)
  {
    const skd::Vector3 position = placement.Scale * contacts.GetPosition(point);
    this->Positions[point] = position;
    this->ExactAxes[point] = static_cast<unsigned char>(contacts.FindExactAxes(point, position));
  }
}

SkdSplitPoints::~SkdSplitPoints()
{
  this->ForgetExact();
  for (const std::atomic<const skd::ClosePoint*>& close : this->Close)
  {
    delete close.load();
  }
}

void SkdSplitPoints::ForgetExact() const
{
  for (std::atomic<const ExactPosition*>& exact : this->Exact)
  {
    delete exact.exchange(nullptr);
  }
}

std::uint32_t SkdSplitPoints::AddCrossing(const std::array<std::uint32_t, 4>& ends, int axis)
{
  const std::uint32_t point = this->GetNumberOfPoints();
  this->Crossings.push_back({ ends, axis });
  this->Exact.emplace_back(nullptr);
  this->Positions.push_back(this->MakeExact(point).Rounded()); // few are asked for again
  this->ExactAxes.push_back(this->FindExactAxes(ends, this->Positions.back()));
  this->Same.Add();
  return point;
}

/// Of a crossing of segments one of which is normal to an axis.
unsigned char SkdSplitPoints::FindExactAxes(
  const std::array<std::uint32_t, 4>& ends, const skd::Vector3& position) const
{
  unsigned axes = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto isAt = [&](int end)
    {
      const SkdSplitPosition at = this->GetSplitPosition(ends[static_cast<std::size_t>(end)]);
      return (at.ExactAxes >> axis & 1u) != 0 && at.X[axis] == position[axis];
    };
    axes |= static_cast<unsigned>((isAt(0) && isAt(1)) || (isAt(2) && isAt(3))) << axis;
  }
  return static_cast<unsigned char>(axes);
}

bool SkdSplitPoints::Unite(std::uint32_t a, std::uint32_t b)
{
  return this->Same.Unite(a, b);
}

std::uint32_t SkdSplitPoints::Find(std::uint32_t point) const
{
  return this->Same.Find(point);
}

const skd::ExactPoint& SkdSplitPoints::GetExact(std::uint32_t point) const
{
  return MadeOnce(this->Exact[point], [&] { return this->MakeExact(point); }).Exact;
}

/// For a sign.
auto SkdSplitPoints::AskExact(std::uint32_t point) const -> const ExactPosition&
{
  const ExactPosition& position =
    MadeOnce(this->Exact[point], [&] { return this->MakeExact(point); });
  position.NumberAsked.fetch_add(1, std::memory_order_relaxed);
  return position;
}

const skd::ClosePoint& SkdSplitPoints::GetClose(std::uint32_t point) const
{
  return MadeOnce(this->Close[point], [&] { return this->Contacts.GetClose(point); });
}

skd::ExactPoint SkdSplitPoints::MakeExact(std::uint32_t point) const
{
  const std::uint32_t before = this->Contacts.GetNumberOfPoints();
  if (point < before)
  {
    return this->Contacts.GetExact(point);
  }
  const Crossing& crossing = this->Crossings[point - before];
  const auto end = [&](int i) -> const skd::ExactPoint&
  { return this->GetExact(crossing.Ends[i]); };
  return skd::ExactCrossing(end(0), end(1), end(2), end(3), crossing.Axis);
}

int SkdSplitPoints::Orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const
{
  const int sign = skd::FilteredOrient2D(
    this->Positions[a], this->Positions[b], this->Positions[c], axis, this->Error);
  return sign != 0 ? sign : this->OrientExactly(a, b, c, axis);
}

int SkdSplitPoints::OrientExactly(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const
{
  const std::optional<int> known = SkdOrientByCoordinates(
    this->GetSplitPosition(a), this->GetSplitPosition(b), this->GetSplitPosition(c), axis);
  if (known)
  {
    return *known;
  }
  const bool areContacts = std::max({ a, b, c }) < this->Contacts.GetNumberOfPoints();
  if (areContacts && this->Contacts.AreOnOneEdge(a, b, c))
  {
    return 0;
  }
  const int close = areContacts
    ? skd::CloseOrient2D(this->GetClose(a), this->GetClose(b), this->GetClose(c), axis)
    : 0;
  if (close != 0)
  {
    return close;
  }
  const ExactPosition& x = this->AskExact(a);
  const ExactPosition& y = this->AskExact(b);
  const ExactPosition& z = this->AskExact(c);
  const bool areAskedOften = x.IsAskedOften() && y.IsAskedOften() && z.IsAskedOften();
  const int sign =
    areAskedOften ? skd::LongOrient2D(x.GetLong(), y.GetLong(), z.GetLong(), axis) : 0;
  return sign != 0 ? sign : skd::ExactArea(x.Exact, y.Exact, z.Exact, axis).Sign();
}

int SkdSplitPoints::Compare(std::uint32_t a, std::uint32_t b, int axis) const
{
  const double difference = this->Positions[a][axis] - this->Positions[b][axis];
  if (std::abs(difference) > 4.0 * this->Error)
  {
    return difference > 0.0 ? 1 : -1;
  }
  if (a == b || (this->ExactAxes[a] & this->ExactAxes[b] & 1u << axis) != 0)
  {
    return (difference > 0.0) - (difference < 0.0);
  }
  return skd::ExactCompare(this->GetExact(a), this->GetExact(b), axis);
}

int SkdSplitPoints::FindAxis(std::uint32_t a, std::uint32_t b) const
{
  const skd::Vector3 difference = this->Positions[a] - this->Positions[b];
  int first = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    first = std::abs(difference[axis]) > std::abs(difference[first]) ? axis : first;
  }
  for (const int axis : { first, (first + 1) % 3, (first + 2) % 3 })
  {
    if (this->Compare(a, b, axis) != 0)
    {
      return axis;
    }
  }
  return -1;
}
}
