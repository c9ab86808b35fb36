// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdInnerFaces.h"

#include "Pipeline/SkdVolumeCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// From here on not every whole number is a double.
constexpr double endOfWholeNumbers = 9007199254740992.0; // 2^53

/// Of numbers that can be told from their neighbours.
bool IsWhole(double x)
{
  return std::abs(x) < endOfWholeNumbers && x == std::round(x);
}

/// Of points on one line along an axis only the last differs.
std::array<double, 3> AlongLast(const Vector3& x, int axis)
{
  return { x[(axis + 1) % 3], x[(axis + 2) % 3], x[axis] };
}

/// The axis that a side runs along, -1 if it runs along none.
int AxisOf(const Vector3& side)
{
  int found = -1;
  int along = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    found = side[axis] != 0.0 ? axis : found;
    along += side[axis] != 0.0 ? 1 : 0;
  }
  return along == 1 ? found : -1;
}

/// A rectangle in a plane of a lattice, and on which side of it its cell is.
struct Rectangle
{
  int Axis; // across
  bool IsCellBelow;
  std::int64_t Plane;
  std::array<std::int64_t, 2> First;
  std::array<std::int64_t, 2> Size;

  /// Exact if it is less than endOfWholeNumbers, as is then each sum of areas that is less.
  double Area() const
  {
    return static_cast<double>(this->Size[0]) * static_cast<double>(this->Size[1]);
  }

  std::array<std::int64_t, 7> Key() const
  {
    return { this->Axis, this->IsCellBelow, this->Plane, this->Size[0], this->Size[1],
      this->First[0], this->First[1] };
  }
};

std::int64_t Remainder(std::int64_t a, std::int64_t n)
{
  return (a % n + n) % n;
}

/// The larger rectangles that others lie on, seen from the other side.
class Cover
{
public:
  void Add(std::size_t face, const Rectangle& rectangle)
  {
    this->Rectangles.push_back(rectangle);
    this->Faces.push_back(face);
    this->Order.emplace_back(rectangle.Key(), this->Order.size());
    const auto& first = rectangle.First;
    const auto& size = rectangle.Size;
    this->Kinds.insert({ rectangle.Axis, rectangle.IsCellBelow, size[0], size[1],
      Remainder(first[0], size[0]), Remainder(first[1], size[1]) });
  }

  /// Marks the rectangles that smaller ones cover wholly, and these.
  void Mark(std::vector<unsigned char>& isMarked)
  {
    std::sort(this->Order.begin(), this->Order.end());
    std::vector<double> covered(this->Rectangles.size(), 0.0);
    std::vector<std::pair<std::size_t, std::size_t>> pairs; // small, large
    for (std::size_t small = 0; small < this->Rectangles.size(); ++small)
    {
      for (const std::array<std::int64_t, 6>& kind : this->Kinds)
      {
        const std::size_t large = this->FindOf(kind, this->Rectangles[small]);
        if (large < covered.size())
        {
          covered[large] += this->Rectangles[small].Area();
          pairs.emplace_back(small, large);
        }
      }
    }
    for (const auto& [small, large] : pairs)
    {
      if (covered[large] == this->Rectangles[large].Area())
      {
        isMarked[this->Faces[small]] = isMarked[this->Faces[large]] = 1;
      }
    }
  }

private:
  /// The rectangle of a kind that a smaller one lies on; if there is none, how many there are.
  std::size_t FindOf(const std::array<std::int64_t, 6>& kind, const Rectangle& small) const
  {
    Rectangle large = small;
    large.IsCellBelow = !small.IsCellBelow;
    large.Size = { kind[2], kind[3] };
    bool isWithin = kind[0] == small.Axis && kind[1] == (large.IsCellBelow ? 1 : 0) &&
      large.Area() > small.Area();
    for (std::size_t i = 0; isWithin && i < 2; ++i)
    {
      const std::int64_t beyond = Remainder(small.First[i] - kind[4 + i], large.Size[i]);
      large.First[i] = small.First[i] - beyond;
      isWithin = beyond + small.Size[i] <= large.Size[i];
    }
    const auto found = std::lower_bound(
      this->Order.begin(), this->Order.end(), std::make_pair(large.Key(), std::size_t(0)));
    return isWithin && found != this->Order.end() && found->first == large.Key()
      ? found->second
      : this->Rectangles.size();
  }

  std::vector<Rectangle> Rectangles;
  std::vector<std::size_t> Faces;
  std::vector<std::pair<std::array<std::int64_t, 7>, std::size_t>> Order;
  std::set<std::array<std::int64_t, 6>> Kinds; // axis, side, sizes, where they begin
};

/// Of a face with the corners of a rectangle of the lattice. Returns whether it is one whose area
/// is exact.
bool FindRectangle(const std::vector<Vector3>& corners, const Vector3& within, Rectangle& rectangle)
{
  Vector3 low = corners.front();
  Vector3 high = low;
  bool isWhole = corners.size() == 4;
  for (const Vector3& corner : corners)
  {
    low = skd::Least(low, corner);
    high = skd::Greatest(high, corner);
    isWhole = isWhole && IsWhole(corner[0]) && IsWhole(corner[1]) && IsWhole(corner[2]);
  }
  int flat = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    rectangle.Axis = low[axis] == high[axis] ? axis : rectangle.Axis;
    flat += low[axis] == high[axis] ? 1 : 0;
  }
  if (!isWhole || flat != 1)
  {
    return false;
  }
  rectangle.Plane = static_cast<std::int64_t>(low[rectangle.Axis]);
  rectangle.IsCellBelow = within[rectangle.Axis] < low[rectangle.Axis];
  for (int i = 0; i < 2; ++i)
  {
    const int axis = (rectangle.Axis + 1 + i) % 3;
    rectangle.First[i] = static_cast<std::int64_t>(low[axis]);
    rectangle.Size[i] = static_cast<std::int64_t>(high[axis] - low[axis]);
  }
  return rectangle.Area() < endOfWholeNumbers;
}
}

//------------------------------------------------------------------------------
SkdInnerFaces::SkdInnerFaces(const std::vector<vtkDataSet*>& pieces)
{
  std::optional<SkdVoxelLattice> all;
  for (vtkDataSet* piece : pieces)
  {
    const std::optional<SkdVoxelLattice> lattice = SkdVoxelLatticeOf(piece);
    if (!lattice)
    {
      return;
    }
    all = all ? all->With(*lattice) : lattice;
  }
  if (all)
  {
    this->IsLattice = true;
    this->Origin = all->Origin;
    this->Spacing = all->Least;
  }
}

//------------------------------------------------------------------------------
// Where a point is on the lattice, in its steps, or in space.
Vector3 SkdInnerFaces::KeyOf(const Vector3& x) const
{
  constexpr double rounding = 1e-4; // more than any
  Vector3 key = x;
  for (int axis = 0; axis < 3 && this->IsLattice; ++axis)
  {
    key[axis] = (x[axis] - this->Origin[axis]) / this->Spacing[axis];
    const double nearest = std::round(key[axis]);
    key[axis] = std::abs(key[axis] - nearest) < rounding ? nearest : key[axis];
  }
  return key;
}

//------------------------------------------------------------------------------
void SkdInnerFaces::Add(const std::vector<Vector3>& corners, const Vector3& within)
{
  std::vector<vtkIdType> ids;
  for (const Vector3& corner : corners)
  {
    ids.push_back(this->Weld.GetId(this->KeyOf(corner).X));
    if (static_cast<std::size_t>(ids.back()) == this->Points.size())
    {
      this->Points.push_back(corner);
    }
  }
  this->Corners.Add(ids.begin(), ids.end());
  this->Within.push_back(within);
}

//------------------------------------------------------------------------------
std::vector<unsigned char> SkdInnerFaces::Find()
{
  std::vector<unsigned char> isInner(this->Within.size(), 0);
  this->FindEqual(isInner);
  if (this->IsLattice)
  {
    this->FindCovered(isInner);
    this->SortCorners();
  }
  return isInner;
}

//------------------------------------------------------------------------------
// Of as many faces from either side none is left.
void SkdInnerFaces::FindEqual(std::vector<unsigned char>& isInner) const
{
  skd::Rows<vtkIdType> names; // corners ascending
  std::vector<vtkIdType> name;
  for (std::size_t face = 0; face < isInner.size(); ++face)
  {
    const auto corners = this->Corners[face];
    name.assign(corners.begin(), corners.end());
    std::sort(name.begin(), name.end());
    names.Add(name.begin(), name.end());
  }
  std::vector<std::size_t> order(isInner.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto isBefore = [&names](std::size_t a, std::size_t b)
  {
    return std::lexicographical_compare(
      names[a].begin(), names[a].end(), names[b].begin(), names[b].end());
  };
  std::stable_sort(order.begin(), order.end(), isBefore);
  for (auto begin = order.begin(); begin != order.end();)
  {
    const auto end =
      std::find_if(begin, order.end(), [&](std::size_t face) { return isBefore(*begin, face); });
    const auto opposite = std::count_if(
      begin, end, [&](std::size_t face) { return this->AreOnOppositeSides(*begin, face); });
    for (auto at = begin; 2 * opposite == end - begin && at != end; ++at)
    {
      isInner[*at] = 1;
    }
    begin = end;
  }
}

//------------------------------------------------------------------------------
// The cells of two faces with the same corners, in whatever order these are.
bool SkdInnerFaces::AreOnOppositeSides(std::size_t first, std::size_t second) const
{
  const auto corners = this->Corners[first];
  const Vector3& from = this->GetPoint(corners[0]);
  Vector3 normal{};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const Vector3 area =
      skd::Cross(this->GetPoint(corners[i]) - from, this->GetPoint(corners[i + 1]) - from);
    normal = skd::Norm2(area) > skd::Norm2(normal) ? area : normal;
  }
  return skd::Dot(normal, this->Within[first] - from) > 0.0 !=
    skd::Dot(normal, this->Within[second] - from) > 0.0;
}

//------------------------------------------------------------------------------
void SkdInnerFaces::FindCovered(std::vector<unsigned char>& isInner) const
{
  Cover cover;
  std::vector<Vector3> corners;
  for (std::size_t face = 0; face < isInner.size(); ++face)
  {
    corners.clear();
    for (const vtkIdType corner : this->Corners[face])
    {
      corners.push_back(this->GetKey(corner));
    }
    Rectangle rectangle{};
    if (isInner[face] == 0 && FindRectangle(corners, this->KeyOf(this->Within[face]), rectangle))
    {
      cover.Add(face, rectangle);
    }
  }
  cover.Mark(isInner);
}

//------------------------------------------------------------------------------
void SkdInnerFaces::SortCorners()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<vtkIdType>& order = this->OnLines[axis];
    order.resize(this->Points.size());
    std::iota(order.begin(), order.end(), vtkIdType(0));
    std::sort(order.begin(), order.end(),
      [&](vtkIdType a, vtkIdType b)
      { return AlongLast(this->GetKey(a), axis) < AlongLast(this->GetKey(b), axis); });
  }
}

//------------------------------------------------------------------------------
void SkdInnerFaces::FindAllCorners(
  std::size_t face, const std::vector<unsigned char>& counts, std::vector<vtkIdType>& corners) const
{
  const auto given = this->Corners[face];
  corners.clear();
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    corners.push_back(given[i]);
    const std::size_t first = corners.size();
    this->AddCornersBetween(given[i], given[(i + 1) % given.size()], corners);
    corners.erase(
      std::remove_if(corners.begin() + static_cast<std::ptrdiff_t>(first), corners.end(),
        [&](vtkIdType corner) { return counts[static_cast<std::size_t>(corner)] == 0; }),
      corners.end());
  }
}

//------------------------------------------------------------------------------
// In their order from one to the other.
void SkdInnerFaces::AddCornersBetween(
  vtkIdType from, vtkIdType to, std::vector<vtkIdType>& corners) const
{
  const int axis = AxisOf(this->GetKey(to) - this->GetKey(from));
  if (!this->IsLattice || axis < 0)
  {
    return;
  }
  const auto positionOf = [&](vtkIdType corner) { return AlongLast(this->GetKey(corner), axis); };
  std::array<double, 3> least = positionOf(from);
  std::array<double, 3> most = positionOf(to);
  const bool isBackward = most < least;
  if (isBackward)
  {
    std::swap(least, most);
  }
  const std::vector<vtkIdType>& order = this->OnLines[axis];
  const auto begin = std::upper_bound(order.begin(), order.end(), least,
    [&](const auto& position, vtkIdType corner) { return position < positionOf(corner); });
  const auto end = std::lower_bound(begin, order.end(), most,
    [&](vtkIdType corner, const auto& position) { return positionOf(corner) < position; });
  const auto first = static_cast<std::ptrdiff_t>(corners.size());
  corners.insert(corners.end(), begin, end);
  if (isBackward)
  {
    std::reverse(corners.begin() + first, corners.end());
  }
}
}
