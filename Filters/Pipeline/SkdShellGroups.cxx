// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdShells.h"

#include "Core/Geometry/Intersection/TriangleContact.h"
#include "Core/Queries/OverlappingPairs.h"
#include "Core/Tree/LazyTree.h"
#include "Core/Tree/WalkPairs.h"
#include "Pipeline/SkdExactScale.h"

#include <array>
#include <memory>
#include <numeric>

namespace
{
using Tree = skd::LazyTree<3>;

/// The triangles of each shell, in a tree of their own once they are asked.
class ShellTrees
{
public:
  ShellTrees(const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles,
    const SkdShells& shells)
    : Points(points)
    , Triangles(triangles)
    , Lists(shells.Get().size())
    , Trees(shells.Get().size())
  {
    double reach = 0.0;
    for (const skd::Vector3& p : points)
    {
      reach = std::max({ reach, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    }
    this->Scale = SkdExactScale(reach);
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      this->Lists[shells.GetShellsOf()[i]].push_back(static_cast<std::uint32_t>(i));
    }
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
      std::vector<skd::Box3> boxes(this->Lists[shell].size());
      for (std::size_t i = 0; i < boxes.size(); ++i)
      {
        for (const vtkIdType id : this->Triangles[this->Lists[shell][i]])
        {
          boxes[i].Add(this->Points[id]);
        }
      }
      this->Trees[shell] = std::make_unique<Tree>(skd::MakeTreeInput(boxes, 0.0));
    }
    return *this->Trees[shell];
  }

  const std::vector<skd::Vector3>& Points;
  const std::vector<SkdTriangleIds>& Triangles;
  std::vector<std::vector<std::uint32_t>> Lists; // of triangles
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
// Of shells that are joined already no more is asked.
std::vector<int> SkdFindShellGroups(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles, const SkdShells& shells)
{
  std::vector<int> groups(shells.Get().size()); // of a shell another of its group, or itself
  std::iota(groups.begin(), groups.end(), 0);
  const auto find = [&](int shell)
  {
    while (groups[shell] != shell)
    {
      shell = groups[shell] = groups[groups[shell]];
    }
    return shell;
  };
  ShellTrees trees(points, triangles, shells);
  auto join = [&](std::uint32_t a, std::uint32_t b)
  {
    const int groupA = find(static_cast<int>(a));
    const int groupB = find(static_cast<int>(b));
    if (groupA != groupB && trees.Touch(a, b))
    {
      groups[std::max(groupA, groupB)] = std::min(groupA, groupB);
    }
    return true;
  };
  using Query = skd::OverlappingPairs<3, skd::SameWorld, decltype(join)>;
  const Tree boxes(skd::MakeTreeInput(BoxesOf(shells), 0.0));
  const skd::SameWorld world;
  Query query(boxes.GetFrame(), boxes.GetFrame(), world, join);
  skd::PairWalk<Tree, Tree, Query>(boxes, query).Run();
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    groups[i] = find(static_cast<int>(i));
  }
  return groups;
}
