// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/Bodies/SkdSpreadShells.h"

#include "Bodies/SkdEdgePairs.h"
#include "Bodies/SkdWeld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// Volumes of shells are sums in different orders on different numbers of processes: smaller ones,
/// relative to what was added, may have either sign.
constexpr double SmallestVolume = 1e-9;

/// Own triangles that are connected on this process.
struct Component
{
  double Volume = 0.0; // signed, six times
  double Sum = 0.0;    // of magnitudes
  int IsOneSided = 0;
};

/// Beyond an edge of an own triangle lies one of another process. Both tell of it.
struct Border
{
  std::array<double, 12> Geometry; // the ends of the edge, and the corners opposite, in order
  int Process;
  int Component;
  int IsForward; // from the lower to the higher end, as its component is oriented
};

/// Two components that are connected, numbered over all processes.
struct Link
{
  int First;
  int Second;
  int IsOpposite; // one must be reversed for both to be oriented alike

  bool operator<(const Link& other) const
  {
    return std::tie(this->First, this->Second, this->IsOpposite) <
      std::tie(other.First, other.Second, other.IsOpposite);
  }
  bool operator==(const Link& other) const { return !(*this < other) && !(other < *this); }
};

bool IsLower(const Vector3& a, const Vector3& b)
{
  return std::lexicographical_compare(a.X, a.X + 3, b.X, b.X + 3);
}

/// Of the triangles of this process.
class OwnComponents
{
public:
  OwnComponents(const std::vector<Vector3>& points, const std::vector<SkdTriangleIds>& triangles,
    const std::vector<unsigned char>& isOwn, const Vector3& origin, int process)
    : Points(points)
    , Triangles(triangles)
    , IsOwn(isOwn)
    , Origin(origin)
    , Process(process)
    , Pairs(points.size(), triangles)
    , ComponentOf(triangles.size(), -1)
    , Reversed(triangles.size(), 0)
  {
    for (std::uint32_t first = 0; first < triangles.size(); ++first)
    {
      if (isOwn[first] != 0 && this->ComponentOf[first] < 0)
      {
        this->Follow(first);
      }
    }
  }

  const std::vector<Component>& Get() const { return this->Components; }
  const std::vector<Border>& GetBorders() const { return this->Borders; }
  int GetComponentOf(std::size_t triangle) const { return this->ComponentOf[triangle]; }
  bool IsReversed(std::size_t triangle) const { return this->Reversed[triangle] != 0; }

private:
  void Follow(std::uint32_t first)
  {
    const auto number = static_cast<int>(this->Components.size());
    this->Components.emplace_back();
    std::vector<std::uint32_t> open{ first };
    this->ComponentOf[first] = number;
    while (!open.empty())
    {
      const std::uint32_t triangle = open.back();
      open.pop_back();
      this->Measure(triangle);
      for (int edge = 0; edge < 3; ++edge)
      {
        const SkdEdgePairs::Neighbour next = this->Pairs.Get(triangle, edge);
        if (this->IsOwn[next.Triangle] == 0)
        {
          this->AddBorder(triangle, edge, next.Triangle);
        }
        else if (this->Visit(triangle, next, number))
        {
          open.push_back(next.Triangle);
        }
      }
    }
  }

  /// Returns whether the neighbour is new.
  bool Visit(std::uint32_t triangle, const SkdEdgePairs::Neighbour& next, int number)
  {
    const unsigned char isReversed = this->Reversed[triangle];
    const unsigned char reversed = next.IsAlike ? isReversed : 1 - isReversed;
    if (this->ComponentOf[next.Triangle] >= 0)
    {
      const bool isSame = this->Reversed[next.Triangle] == reversed;
      this->Components.back().IsOneSided |= isSame ? 0 : 1;
      return false;
    }
    this->ComponentOf[next.Triangle] = number;
    this->Reversed[next.Triangle] = reversed;
    return true;
  }

  const Vector3& CornerOf(std::uint32_t triangle, int corner) const
  {
    return this->Points[static_cast<std::size_t>(this->Triangles[triangle][corner % 3])];
  }

  void Measure(std::uint32_t triangle)
  {
    const Vector3 a = this->CornerOf(triangle, 0) - this->Origin;
    const Vector3 b = this->CornerOf(triangle, 1) - this->Origin;
    const Vector3 c = this->CornerOf(triangle, 2) - this->Origin;
    const double volume = skd::Dot(a, skd::Cross(b, c));
    this->Components.back().Volume += this->Reversed[triangle] != 0 ? -volume : volume;
    this->Components.back().Sum += std::abs(volume);
  }

  void AddBorder(std::uint32_t triangle, int edge, std::uint32_t beyond)
  {
    const Vector3& from = this->CornerOf(triangle, edge);
    const Vector3& to = this->CornerOf(triangle, edge + 1);
    const SkdTriangleIds& other = this->Triangles[beyond];
    const SkdTriangleIds& own = this->Triangles[triangle];
    const vtkIdType away = *std::find_if(other.begin(), other.end(),
      [&](vtkIdType id) { return id != own[edge] && id != own[(edge + 1) % 3]; });
    std::array<Vector3, 4> ends{ from, to, this->CornerOf(triangle, edge + 2),
      this->Points[static_cast<std::size_t>(away)] };
    const bool isForward = IsLower(from, to);
    std::sort(ends.begin(), ends.begin() + 2, IsLower);
    std::sort(ends.begin() + 2, ends.end(), IsLower);
    Border border{ {}, this->Process, this->ComponentOf[triangle],
      isForward != (this->Reversed[triangle] != 0) ? 1 : 0 };
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      std::copy_n(ends[i].X, 3, border.Geometry.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    this->Borders.push_back(border);
  }

  const std::vector<Vector3>& Points;
  const std::vector<SkdTriangleIds>& Triangles;
  const std::vector<unsigned char>& IsOwn;
  Vector3 Origin;
  int Process;
  SkdEdgePairs Pairs;
  std::vector<int> ComponentOf;
  std::vector<unsigned char> Reversed;
  std::vector<Component> Components;
  std::vector<Border> Borders;
};

/// Components of all processes, and which of them are one shell.
class Shells
{
public:
  explicit Shells(const SkdRowsByProcess<Component>& all)
  {
    for (const std::vector<Component>& some : all)
    {
      this->Offsets.push_back(static_cast<int>(this->Components.size()));
      this->Components.insert(this->Components.end(), some.begin(), some.end());
    }
    for (std::size_t i = 0; i < this->Components.size(); ++i)
    {
      this->Upper.emplace_back(static_cast<int>(i), false);
      this->HasOneSided = this->HasOneSided || this->Components[i].IsOneSided != 0;
    }
  }

  int GetNumberOf(int process, int component) const
  {
    return this->Offsets[static_cast<std::size_t>(process)] + component;
  }

  void Join(const Link& link)
  {
    const auto [first, isFirstOpposite] = this->Find(link.First);
    const auto [second, isSecondOpposite] = this->Find(link.Second);
    const bool isOpposite = (link.IsOpposite != 0) != (isFirstOpposite != isSecondOpposite);
    if (first != second)
    {
      this->Upper[static_cast<std::size_t>(std::max(first, second))] = { std::min(first, second),
        isOpposite };
    }
    else if (isOpposite)
    {
      this->HasOneSided = true;
    }
  }

  /// After all are joined.
  void Measure()
  {
    this->Whole.assign(this->Components.size(), Component());
    for (std::size_t i = 0; i < this->Components.size(); ++i)
    {
      const auto [shell, isOpposite] = this->Find(static_cast<int>(i));
      Component& whole = this->Whole[static_cast<std::size_t>(shell)];
      const double volume = this->Components[i].Volume;
      whole.Volume += isOpposite ? -volume : volume;
      whole.Sum += this->Components[i].Sum;
    }
  }

  bool AreSure() const
  {
    return std::none_of(this->Whole.begin(), this->Whole.end(),
      [](const Component& shell)
      { return shell.Sum > 0.0 && !(std::abs(shell.Volume) > SmallestVolume * shell.Sum); });
  }

  bool IsOpposite(int component)
  {
    const auto [shell, isOpposite] = this->Find(component);
    return isOpposite != (this->Whole[static_cast<std::size_t>(shell)].Volume < 0.0);
  }

  bool HasOneSided = false;

private:
  /// A component's representative, and whether it is oriented against it.
  std::pair<int, bool> Find(int component)
  {
    int root = component;
    bool isOpposite = false;
    while (this->UpperOf(root).first != root)
    {
      isOpposite = isOpposite != this->UpperOf(root).second;
      root = this->UpperOf(root).first;
    }
    for (bool rest = isOpposite; component != root;) // shortens the way of all on it
    {
      const std::pair<int, bool> next = std::exchange(this->UpperOf(component), { root, rest });
      rest = rest != next.second;
      component = next.first;
    }
    return { root, isOpposite };
  }

  std::pair<int, bool>& UpperOf(int component)
  {
    return this->Upper[static_cast<std::size_t>(component)];
  }

  std::vector<int> Offsets; // by process
  std::vector<Component> Components;
  std::vector<Component> Whole; // of representatives
  std::vector<std::pair<int, bool>> Upper;
};

/// Compares what processes tell of the same edges. Returns the links found here; `areSure` becomes
/// false of what not two have told.
std::vector<Link> FindLinks(
  SkdTransport& transport, const std::vector<Border>& own, const Shells& shells, bool& areSure)
{
  SkdRowsByProcess<Border> told(static_cast<std::size_t>(transport.GetNumber()));
  for (const Border& border : own)
  {
    const Vector3 low{ { border.Geometry[0], border.Geometry[1], border.Geometry[2] } };
    told[SkdWeld::HashOf(low) % told.size()].push_back(border);
  }
  std::vector<Border> borders;
  for (const std::vector<Border>& some : SkdExchangeRows(transport, told))
  {
    borders.insert(borders.end(), some.begin(), some.end());
  }
  std::sort(borders.begin(), borders.end(),
    [](const Border& a, const Border& b) { return a.Geometry < b.Geometry; });
  std::vector<Link> links;
  for (auto first = borders.begin(); first != borders.end();)
  {
    const auto last = std::find_if(first, borders.end(),
      [&](const Border& border) { return border.Geometry != first->Geometry; });
    areSure = areSure && last - first == 2;
    if (last - first == 2)
    {
      const int a = shells.GetNumberOf(first[0].Process, first[0].Component);
      const int b = shells.GetNumberOf(first[1].Process, first[1].Component);
      const int isOpposite = first[0].IsForward == first[1].IsForward ? 1 : 0;
      links.push_back({ std::min(a, b), std::max(a, b), isOpposite });
    }
    first = last;
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

/// Of own triangles, in their order.
vtkSmartPointer<vtkUnsignedCharArray> FindReversed(
  const OwnComponents& own, int process, Shells& shells, const std::vector<unsigned char>& isOwn)
{
  auto reversed = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bool isAny = false;
  for (std::size_t i = 0; i < isOwn.size(); ++i)
  {
    if (isOwn[i] != 0)
    {
      const int number = shells.GetNumberOf(process, own.GetComponentOf(i));
      const bool isReversed = own.IsReversed(i) != shells.IsOpposite(number);
      reversed->InsertNextValue(isReversed ? 1 : 0);
      isAny = isAny || isReversed;
    }
  }
  return isAny ? reversed : nullptr;
}
}

SkdSpreadShells SkdFindSpreadShells(SkdTransport& transport, const std::vector<Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles, const std::vector<unsigned char>& isOwn,
  const Vector3& origin)
{
  const OwnComponents own(points, triangles, isOwn, origin, transport.GetRank());
  Shells shells(SkdGatherRows(transport, own.Get()));
  SkdSpreadShells found;
  const std::vector<Link> links = FindLinks(transport, own.GetBorders(), shells, found.AreSure);
  for (const std::vector<Link>& some : SkdGatherRows(transport, links))
  {
    std::for_each(some.begin(), some.end(), [&](const Link& link) { shells.Join(link); });
  }
  shells.Measure();
  for (const std::vector<unsigned char>& isSure : SkdGatherRows(
         transport, std::vector<unsigned char>(1, found.AreSure && shells.AreSure() ? 1 : 0)))
  {
    found.AreSure = found.AreSure && isSure.front() != 0;
  }
  found.HasOneSided = shells.HasOneSided;
  found.Reversed = FindReversed(own, transport.GetRank(), shells, isOwn);
  return found;
}
}
