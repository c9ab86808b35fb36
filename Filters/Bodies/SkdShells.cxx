// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdShells.h"

#include "Bodies/SkdEdgePairs.h"
#include "Cells/Search/SkdBuildTree.h"
#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/Intersection/TriangleContact.h"
#include "Core/Geometry/Predicates/ExactScale.h"
#include "Core/Geometry/Rows.h"
#include "Core/Search/Queries/OverlappingPairs.h"
#include "Core/Search/Tree/LazyTree.h"
#include "Core/Search/Tree/WalkPairs.h"

#include <algorithm>
#include <array>
#include <memory>

namespace skdtree
{
//------------------------------------------------------------------------------
SkdShells::SkdShells(
  const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles)
  : ShellOf(triangles.size(), -1)
  , Reversed(vtkSmartPointer<vtkUnsignedCharArray>::New())
{
  this->Reversed->SetNumberOfValues(static_cast<vtkIdType>(triangles.size()));
  this->Reversed->Fill(0.0);
  const SkdEdgePairs pairing(points.size(), triangles);
  for (std::uint32_t first = 0; first < triangles.size(); ++first)
  {
    if (this->ShellOf[first] < 0)
    {
      this->Follow(first, pairing);
    }
  }
  this->Measure(points, triangles);
  this->OrientOutward();
}

// All that are connected to the first, oriented like it.
void SkdShells::Follow(std::uint32_t first, const SkdEdgePairs& pairing)
{
  const int number = static_cast<int>(this->Shells.size());
  Shell shell;
  std::vector<std::uint32_t> open{ first };
  this->ShellOf[first] = number;
  while (!open.empty())
  {
    const std::uint32_t triangle = open.back();
    open.pop_back();
    const unsigned char isReversed = this->Reversed->GetValue(triangle);
    for (int edge = 0; edge < 3; ++edge)
    {
      const SkdEdgePairs::Neighbour next = pairing.Get(triangle, edge);
      const unsigned char reversed = next.IsAlike ? isReversed : 1 - isReversed;
      shell.IsCoherent = shell.IsCoherent && next.IsAlike;
      if (this->ShellOf[next.Triangle] < 0)
      {
        this->ShellOf[next.Triangle] = number;
        this->Reversed->SetValue(next.Triangle, reversed);
        open.push_back(next.Triangle);
      }
      else if (this->Reversed->GetValue(next.Triangle) != reversed)
      {
        shell.IsOneSided = true;
      }
    }
  }
  this->Shells.push_back(shell);
}

void SkdShells::Measure(
  const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles)
{
  std::vector<char> isBegun(this->Shells.size(), 0);
  std::vector<skd::Vector3> origins(this->Shells.size()); // numbers lose nothing far from 0
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto number = static_cast<std::size_t>(this->ShellOf[i]);
    Shell& shell = this->Shells[number];
    if (!isBegun[number])
    {
      origins[number] = points[triangles[i][0]];
      shell.Extremes.fill(origins[number]);
      isBegun[number] = 1;
    }
    skd::Vector3 relative[3];
    for (int k = 0; k < 3; ++k)
    {
      const skd::Vector3& p = points[triangles[i][k]];
      relative[k] = p - origins[number];
      for (int axis = 0; axis < 3; ++axis)
      {
        skd::Vector3& low = shell.Extremes[2 * axis];
        skd::Vector3& high = shell.Extremes[2 * axis + 1];
        low = p[axis] < low[axis] ? p : low;
        high = p[axis] > high[axis] ? p : high;
      }
    }
    const double volume = skd::Dot(relative[0], skd::Cross(relative[1], relative[2]));
    shell.Volume += this->Reversed->GetValue(static_cast<vtkIdType>(i)) ? -volume : volume;
  }
}

void SkdShells::OrientOutward()
{
  bool isAny = false;
  for (std::size_t i = 0; i < this->ShellOf.size(); ++i)
  {
    const auto triangle = static_cast<vtkIdType>(i);
    const bool isInward = this->Shells[this->ShellOf[i]].Volume < 0.0;
    const bool isReversed = (this->Reversed->GetValue(triangle) != 0) != isInward;
    this->Reversed->SetValue(triangle, isReversed ? 1 : 0);
    isAny = isAny || isReversed;
  }
  if (!isAny)
  {
    this->Reversed = nullptr;
  }
}

bool SkdShells::HasOneSided() const
{
  return std::any_of(
    this->Shells.begin(), this->Shells.end(), [](const Shell& shell) { return shell.IsOneSided; });
}

namespace
{
using Tree = skd::LazyTree<3>;

/// The triangles of each shell, in a tree of their own once they are queried.
class ShellTrees
{
public:
  ShellTrees(const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles,
    const SkdShells& shells)
    : Points(points)
    , Triangles(triangles)
    , Lists(shells.Get().size(),
        [&](const auto& add)
        {
          for (std::size_t i = 0; i < triangles.size(); ++i)
          {
            add(static_cast<std::size_t>(shells.GetShellsOf()[i]), static_cast<std::uint32_t>(i));
          }
        })
    , Trees(shells.Get().size())
  {
    double extent = 0.0;
    for (const skd::Vector3& p : points)
    {
      extent = std::max({ extent, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    }
    this->Scale = skd::ExactScale(extent);
  }

  bool Touch(std::uint32_t a, std::uint32_t b)
  {
    bool isFound = false;
    auto block = [&](std::uint32_t first, std::uint32_t second)
    {
      const skd::TriangleInPlane triangle(this->CornersOf(this->Lists[a][first]));
      const auto other = this->CornersOf(this->Lists[b][second]);
      isFound = skd::FindContact(triangle, other).Count > 0;
      return !isFound;
    };
    using Query = skd::OverlappingPairs<3, skd::SameWorld, decltype(block)>;
    const Tree& first = this->GetTree(a);
    const Tree& second = this->GetTree(b);
    const skd::SameWorld world;
    Query query(first.GetFrame(), second.GetFrame(), world, block);
    skd::PairWalk<Tree, Tree, Query>(first, second, query).Run();
    return isFound;
  }

private:
  std::array<skd::Vector3, 3> CornersOf(std::uint32_t triangle) const
  {
    const SkdTriangleIds& ids = this->Triangles[triangle];
    return { this->Scale * this->Points[ids[0]], this->Scale * this->Points[ids[1]],
      this->Scale * this->Points[ids[2]] };
  }

  const Tree& GetTree(std::uint32_t shell)
  {
    if (!this->Trees[shell])
    {
      const skd::IndexRows::Row triangles = this->Lists[shell];
      std::vector<skd::Box3> boxes(triangles.size());
      for (std::size_t i = 0; i < boxes.size(); ++i)
      {
        for (const vtkIdType id : this->Triangles[triangles[i]])
        {
          boxes[i].Add(this->Points[id]);
        }
      }
      this->Trees[shell] = std::make_unique<Tree>(SkdBuildLazyTree(skd::MakeTreeInput(boxes, 0.0)));
    }
    return *this->Trees[shell];
  }

  const std::vector<skd::Vector3>& Points;
  const std::vector<SkdTriangleIds>& Triangles;
  skd::IndexRows Lists; // of triangles
  std::vector<std::unique_ptr<Tree>> Trees;
  double Scale = 1.0;
};

std::vector<skd::Box3> BoxesOf(const SkdShells& shells)
{
  std::vector<skd::Box3> boxes(shells.Get().size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (const skd::Vector3& x : shells.Get()[i].Extremes)
    {
      boxes[i].Add(x);
    }
  }
  return boxes;
}
}

//------------------------------------------------------------------------------
// Shells that are joined already are not tested again.
std::vector<int> SkdFindShellGroups(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles, const SkdShells& shells)
{
  skd::DisjointSets<int> groups(shells.Get().size());
  ShellTrees trees(points, triangles, shells);
  auto join = [&](std::uint32_t a, std::uint32_t b)
  {
    const int pair[2] = { static_cast<int>(a), static_cast<int>(b) };
    if (groups.Find(pair[0]) != groups.Find(pair[1]) && trees.Touch(a, b))
    {
      groups.Unite(pair[0], pair[1]);
    }
    return true;
  };
  using Query = skd::OverlappingPairs<3, skd::SameWorld, decltype(join)>;
  const Tree boxes = SkdBuildLazyTree(skd::MakeTreeInput(BoxesOf(shells), 0.0));
  const skd::SameWorld world;
  Query query(boxes.GetFrame(), boxes.GetFrame(), world, join);
  skd::PairWalk<Tree, Tree, Query>(boxes, query).Run();
  return groups.Representatives();
}
}
