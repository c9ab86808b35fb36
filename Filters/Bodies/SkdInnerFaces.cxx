// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdInnerFaces.h"

#include "Bodies/SkdWeld.h"
#include "Core/Search/Tree/PackedRTree.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace skdtree
{
using skd::Vector3;

/// A face of a voxel, by the ranks of its corners.
struct SkdInnerFaces::Rectangle
{
  std::size_t Face;
  int Axis; // across
  bool IsCellBelow;
  int Plane;
  std::array<int, 2> First; // along the two axes that follow
  std::array<int, 2> Last;
  double Area;

  /// Whether the other one is seen from the other side, and is a part of it.
  bool HasWithin(const Rectangle& other) const
  {
    return this->Axis == other.Axis && this->Plane == other.Plane &&
      this->IsCellBelow != other.IsCellBelow && this->First[0] <= other.First[0] &&
      this->First[1] <= other.First[1] && other.Last[0] <= this->Last[0] &&
      other.Last[1] <= this->Last[1] && (this->First != other.First || this->Last != other.Last);
  }

  /// Ascending.
  std::array<std::array<int, 2>, 4> GetCorners() const
  {
    return { { this->First, { this->First[0], this->Last[1] }, { this->Last[0], this->First[1] },
      this->Last } };
  }

  skd::Box3 GetBox() const
  {
    Vector3 low;
    Vector3 high;
    low[this->Axis] = high[this->Axis] = this->Plane;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const int axis = (this->Axis + 1 + static_cast<int>(i)) % 3;
      low[axis] = this->First[i];
      high[axis] = this->Last[i];
    }
    return { low, high };
  }

  /// Whether parts of it are all of it and do not overlap. The number of parts at each of its
  /// points is odd if the corners of an odd number of parts are its own; it is 1 if their areas are
  /// no more than its own.
  bool IsTiledBy(const std::vector<const Rectangle*>& parts) const
  {
    double area = 0.0;
    double least = this->Area;
    std::vector<std::array<int, 2>> corners;
    for (const Rectangle* part : parts)
    {
      area += part->Area;
      least = std::min(least, part->Area);
      const auto some = part->GetCorners();
      corners.insert(corners.end(), some.begin(), some.end());
    }
    std::sort(corners.begin(), corners.end());
    std::vector<std::array<int, 2>> odd;
    for (auto begin = corners.begin(); begin != corners.end();)
    {
      const auto end = std::upper_bound(begin, corners.end(), *begin);
      odd.insert(odd.end(), static_cast<std::size_t>(end - begin) % 2, *begin);
      begin = end;
    }
    const auto own = this->GetCorners();
    return area < this->Area + least && std::equal(odd.begin(), odd.end(), own.begin(), own.end());
  }
};

//------------------------------------------------------------------------------
SkdInnerFaces::SkdInnerFaces(const std::vector<vtkDataSet*>& pieces)
{
  for (vtkDataSet* piece : pieces)
  {
    const std::optional<SkdVoxelLattice> voxels = SkdVoxelLatticeOf(piece);
    const auto known = std::find_if(this->Lattices.begin(), this->Lattices.end(),
      [&](const SkdVoxelLattice& lattice) { return voxels && lattice.HasSameAxes(*voxels); });
    this->LatticeOfPiece.push_back(voxels ? static_cast<int>(known - this->Lattices.begin()) : -1);
    this->SizeOfPiece.push_back(voxels ? voxels->Least : Vector3{});
    if (voxels && known == this->Lattices.end())
    {
      this->Lattices.push_back(*voxels);
    }
    else if (voxels)
    {
      *known = known->With(*voxels);
    }
  }
}

//------------------------------------------------------------------------------
void SkdInnerFaces::Add(
  std::size_t piece, const std::vector<Vector3>& corners, const Vector3& within)
{
  this->Given.insert(this->Given.end(), corners.begin(), corners.end());
  this->FirstGiven.push_back(this->Given.size());
  this->PieceOf.push_back(piece);
  this->Within.push_back(within);
}

//------------------------------------------------------------------------------
std::vector<unsigned char> SkdInnerFaces::Find()
{
  this->NumberCorners();
  std::vector<unsigned char> isInner(this->Within.size(), 0);
  this->FindEqual(isInner);
  for (std::size_t lattice = 0; lattice < this->Lattices.size(); ++lattice)
  {
    if (this->Lattices[lattice].HasSeveralSizes())
    {
      this->FindCovered(static_cast<int>(lattice), isInner);
    }
  }
  this->SortCorners();
  return isInner;
}

//------------------------------------------------------------------------------
// Values that differ by rounding alone have one rank.
void SkdInnerFaces::FindRanks(int lattice)
{
  constexpr double rounding = 1e-4; // more than any, of the size of a cell
  struct Value
  {
    double X;
    double Size;
    std::size_t Corner;
  };
  const SkdVoxelLattice& voxels = this->Lattices[static_cast<std::size_t>(lattice)];
  std::vector<Value> values;
  for (int axis = 0; axis < 3; ++axis)
  {
    values.clear();
    for (std::size_t face = 0; face < this->PieceOf.size(); ++face)
    {
      const std::size_t end = this->LatticeOf(face) == lattice ? this->FirstGiven[face + 1] : 0;
      for (std::size_t corner = this->FirstGiven[face]; corner < end; ++corner)
      {
        if (IsFinite(this->Given[corner]))
        {
          values.push_back({ voxels.GetCoordinate(this->Given[corner], axis),
            this->SizeOfPiece[this->PieceOf[face]][axis], corner });
        }
      }
    }
    std::sort(
      values.begin(), values.end(), [](const Value& a, const Value& b) { return a.X < b.X; });
    int rank = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const Value& value = values[i];
      const Value& last = values[i > 0 ? i - 1 : 0];
      rank += value.X - last.X > rounding * std::min(value.Size, last.Size) ? 1 : 0;
      Position& position = this->GivenPositions[value.Corner];
      position.Lattice = lattice;
      position.Ranks[static_cast<std::size_t>(axis)] = rank;
    }
  }
}

//------------------------------------------------------------------------------
/// Gives one number to the corners at one position, or at equal coordinates.
class SkdInnerFaces::Numbering
{
public:
  explicit Numbering(std::size_t lattices)
    : ByPosition(lattices)
  {
  }

  /// -1 if it is not known; then it is to be set. Those of positions come first: of these
  /// coordinates may differ by rounding.
  vtkIdType Find(const Vector3& point, const Position& position)
  {
    this->OfPoint = &this->ByPoint.SlotOf(point);
    this->OfPosition = &this->None;
    this->None = -1;
    if (position.Lattice >= 0)
    {
      const std::array<int, 3>& ranks = position.Ranks;
      this->OfPosition = &this->ByPosition[static_cast<std::size_t>(position.Lattice)].SlotOf(
        { { double(ranks[0]), double(ranks[1]), double(ranks[2]) } });
    }
    return *this->OfPosition >= 0 ? *this->OfPosition : *this->OfPoint;
  }

  /// Of what was looked for last.
  void Set(vtkIdType number)
  {
    *this->OfPosition = number;
    *this->OfPoint = *this->OfPoint >= 0 ? *this->OfPoint : number;
  }

private:
  struct Table
  {
    SkdWeld Keys;
    std::vector<vtkIdType> Numbers;

    vtkIdType& SlotOf(const Vector3& key)
    {
      const auto slot = static_cast<std::size_t>(this->Keys.GetId(key.X));
      this->Numbers.resize(std::max(this->Numbers.size(), slot + 1), -1);
      return this->Numbers[slot];
    }
  };

  Table ByPoint;
  std::vector<Table> ByPosition; // by lattice
  vtkIdType None = -1;
  vtkIdType* OfPoint = nullptr;
  vtkIdType* OfPosition = nullptr;
};

//------------------------------------------------------------------------------
void SkdInnerFaces::NumberCorners()
{
  this->GivenPositions.resize(this->Given.size());
  for (std::size_t lattice = 0; lattice < this->Lattices.size(); ++lattice)
  {
    this->FindRanks(static_cast<int>(lattice));
  }
  Numbering numbering(this->Lattices.size());
  std::vector<vtkIdType> numbers(this->Given.size());
  for (const bool areVoxels : { true, false })
  {
    for (std::size_t corner = 0; corner < this->Given.size(); ++corner)
    {
      const Position& position = this->GivenPositions[corner];
      if ((position.Lattice >= 0) != areVoxels)
      {
        continue;
      }
      vtkIdType& number = numbers[corner];
      number = numbering.Find(this->Given[corner], position);
      if (number < 0)
      {
        number = static_cast<vtkIdType>(this->Points.size());
        this->Points.push_back(this->Given[corner]);
        this->Positions.push_back(position);
      }
      numbering.Set(number);
    }
  }
  for (std::size_t face = 0; face < this->PieceOf.size(); ++face)
  {
    const auto at = [&](std::size_t corner)
    { return numbers.begin() + static_cast<std::ptrdiff_t>(corner); };
    this->Corners.Add(at(this->FirstGiven[face]), at(this->FirstGiven[face + 1]));
  }
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
// Whether it is one: of a voxel.
bool SkdInnerFaces::FindRectangle(std::size_t face, Rectangle& rectangle) const
{
  const std::size_t begin = this->FirstGiven[face];
  const std::size_t end = this->FirstGiven[face + 1];
  const auto rankOf = [&](std::size_t corner, std::size_t axis)
  { return this->GivenPositions[corner].Ranks[axis]; };
  std::array<std::size_t, 3> low{ begin, begin, begin }; // corners, by axis
  std::array<std::size_t, 3> high = low;
  bool isRectangle = end - begin == 4;
  for (std::size_t corner = begin; corner < end; ++corner)
  {
    isRectangle = isRectangle && this->GivenPositions[corner].Lattice >= 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = rankOf(corner, axis) < rankOf(low[axis], axis) ? corner : low[axis];
      high[axis] = rankOf(corner, axis) > rankOf(high[axis], axis) ? corner : high[axis];
    }
  }
  const auto isFlat = [&](std::size_t axis)
  { return rankOf(low[axis], axis) == rankOf(high[axis], axis); };
  const std::size_t across = isFlat(0) ? 0 : isFlat(1) ? 1 : 2;
  const std::array<std::size_t, 2> along{ (across + 1) % 3, (across + 2) % 3 };
  if (!isRectangle || !isFlat(across) || isFlat(along[0]) || isFlat(along[1]))
  {
    return false;
  }
  const SkdVoxelLattice& voxels = this->Lattices[static_cast<std::size_t>(this->LatticeOf(face))];
  rectangle.Face = face;
  rectangle.Axis = static_cast<int>(across);
  rectangle.Plane = rankOf(begin, across);
  rectangle.IsCellBelow = voxels.GetCoordinate(this->Within[face], rectangle.Axis) <
    voxels.GetCoordinate(this->Given[begin], rectangle.Axis);
  rectangle.Area = 1.0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::size_t axis = along[i];
    rectangle.First[i] = rankOf(low[axis], axis);
    rectangle.Last[i] = rankOf(high[axis], axis);
    rectangle.Area *= voxels.GetCoordinate(
      this->Given[high[axis]] - this->Given[low[axis]], static_cast<int>(axis));
  }
  return true;
}

//------------------------------------------------------------------------------
// Larger faces that smaller ones cover wholly, and these.
void SkdInnerFaces::FindCovered(int lattice, std::vector<unsigned char>& isInner) const
{
  std::vector<Rectangle> rectangles;
  std::vector<skd::Box3> boxes;
  for (std::size_t face = 0; face < isInner.size(); ++face)
  {
    Rectangle rectangle{};
    if (isInner[face] == 0 && this->LatticeOf(face) == lattice &&
      this->FindRectangle(face, rectangle))
    {
      rectangles.push_back(rectangle);
      boxes.push_back(rectangle.GetBox());
    }
  }
  const skd::PackedRTree tree(boxes);
  std::vector<std::vector<const Rectangle*>> parts(rectangles.size());
  for (const Rectangle& part : rectangles)
  {
    const Vector3 middle = part.GetBox().Centroid();
    tree.ForEachOverlapping({ middle, middle },
      [&](std::uint32_t whole)
      {
        if (rectangles[whole].HasWithin(part))
        {
          parts[whole].push_back(&part);
        }
      });
  }
  for (std::size_t whole = 0; whole < rectangles.size(); ++whole)
  {
    if (!parts[whole].empty() && rectangles[whole].IsTiledBy(parts[whole]))
    {
      isInner[rectangles[whole].Face] = 1;
      for (const Rectangle* part : parts[whole])
      {
        isInner[part->Face] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
void SkdInnerFaces::SortCorners()
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::vector<vtkIdType>& order = this->OnLines[axis];
    order.resize(this->Lattices.empty() ? 0 : this->Points.size());
    std::iota(order.begin(), order.end(), vtkIdType(0));
    std::sort(order.begin(), order.end(),
      [&](vtkIdType a, vtkIdType b)
      { return this->PositionOf(a).AlongLast(axis) < this->PositionOf(b).AlongLast(axis); });
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
// The axis that the side between two positions runs along, none if it runs along no one.
std::optional<std::size_t> SkdInnerFaces::AxisBetween(const Position& from, const Position& to)
{
  std::optional<std::size_t> found;
  int along = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (from.Ranks[axis] != to.Ranks[axis])
    {
      found = axis;
      ++along;
    }
  }
  return from.Lattice >= 0 && from.Lattice == to.Lattice && along == 1 ? found : std::nullopt;
}

//------------------------------------------------------------------------------
// In their order from one to the other.
void SkdInnerFaces::AddCornersBetween(
  vtkIdType from, vtkIdType to, std::vector<vtkIdType>& corners) const
{
  const std::optional<std::size_t> axis = AxisBetween(this->PositionOf(from), this->PositionOf(to));
  if (!axis)
  {
    return;
  }
  const auto keyOf = [&](vtkIdType corner) { return this->PositionOf(corner).AlongLast(*axis); };
  std::array<int, 4> least = keyOf(from);
  std::array<int, 4> most = keyOf(to);
  const bool isBackward = most < least;
  if (isBackward)
  {
    std::swap(least, most);
  }
  const std::vector<vtkIdType>& order = this->OnLines[*axis];
  const auto begin = std::upper_bound(order.begin(), order.end(), least,
    [&](const auto& key, vtkIdType corner) { return key < keyOf(corner); });
  const auto end = std::lower_bound(begin, order.end(), most,
    [&](vtkIdType corner, const auto& key) { return keyOf(corner) < key; });
  const auto first = static_cast<std::ptrdiff_t>(corners.size());
  corners.insert(corners.end(), begin, end);
  if (isBackward)
  {
    std::reverse(corners.begin() + first, corners.end());
  }
}
}
