// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Distance/Distance.h"
#include "Core/Meshing/Grid/Balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using skd::Contact;
using skd::Forest;

skd::Lattice UnitLattice(int dimension, int branch = 2, int baseCells = 1)
{
  std::array<std::vector<double>, 3> planes{ { { 0.5 }, { 0.5 }, { 0.5 } } };
  for (int axis = 0; axis < dimension; ++axis)
  {
    planes[axis].clear();
    for (int i = 0; i <= baseCells; ++i)
    {
      planes[axis].push_back(static_cast<double>(i) / baseCells);
    }
  }
  return skd::Lattice(planes, branch);
}

Forest ForestOf(const skd::Lattice& lattice)
{
  return Forest(
    { lattice.NumberOfBaseCells(0), lattice.NumberOfBaseCells(1), lattice.NumberOfBaseCells(2) },
    lattice.GetBranch());
}

/// Refines what `isCut(box)` says, level by level; the last element counts the cut cells of the
/// last level.
template <class IsCut>
std::vector<std::uint64_t> RefineAround(
  Forest& forest, const skd::Lattice& lattice, int levels, IsCut isCut)
{
  std::vector<std::uint64_t> cut;
  for (int level = 0; level <= levels; ++level)
  {
    cut.push_back(0);
    for (std::uint32_t cell = 0; cell < forest.NumberOfCells(level); ++cell)
    {
      if (isCut(lattice.BoxOf(level, forest.LatticePointOf(level, cell))))
      {
        ++cut.back();
        if (level < levels)
        {
          forest.Refine(level, cell);
        }
      }
    }
  }
  return cut;
}

/// The surface of a ball about the middle of the unit cube meets the closed box.
struct MeetsSphere
{
  double Radius;
  bool operator()(const skd::Box3& box) const
  {
    const skd::Vector3 centre{ { 0.5, 0.5, 0.5 } };
    const double radius2 = this->Radius * this->Radius;
    return skd::MinDistance2(centre, box) <= radius2 && radius2 <= skd::MaxDistance2(centre, box);
  }
};

bool MakeBalanced(Forest& forest, Contact contact)
{
  return skd::MakeBalanced(forest, contact,
    [&forest](int level, std::uint32_t cell)
    {
      forest.Refine(level, cell);
      return true;
    });
}

TEST(Forest, TheOctreeOfASphereHasTheCountsThatItMustHave)
{
  const skd::Lattice lattice = UnitLattice(3);
  Forest forest = ForestOf(lattice);
  EXPECT_EQ(RefineAround(forest, lattice, 6, MeetsSphere{ 0.3 }).back(), 6920u);
  EXPECT_EQ(forest.NumberOfLeaves(), 16416u);
  const std::uint64_t expected[3] = { 19104, 20784, 21512 };
  const Contact contacts[3] = { Contact::Face, Contact::Edge, Contact::Corner };
  for (int i = 0; i < 3; ++i)
  {
    Forest balanced = forest;
    EXPECT_FALSE(IsBalanced(balanced, contacts[i]));
    EXPECT_TRUE(MakeBalanced(balanced, contacts[i]));
    EXPECT_TRUE(IsBalanced(balanced, contacts[i]));
    EXPECT_EQ(balanced.NumberOfLeaves(), expected[i]);
  }
}

TEST(Forest, CutCellsOfASphereGrowAsItsArea)
{
  const double pi = std::acos(-1.0);
  const skd::Lattice lattice = UnitLattice(3);
  Forest forest = ForestOf(lattice);
  const auto cut = RefineAround(forest, lattice, 8, MeetsSphere{ 0.3 });
  const double asymptote = 6.0 * pi * 0.09;
  EXPECT_NEAR(static_cast<double>(cut[8]) / std::pow(4.0, 8), asymptote, 0.02 * asymptote);
  EXPECT_NEAR(static_cast<double>(forest.NumberOfLeaves()) / std::pow(4.0, 8),
    7.0 / 3.0 * asymptote, 0.02 * 7.0 / 3.0 * asymptote);
}

TEST(Forest, APlaneOnTheGridCutsTheCellsOnBothSides)
{
  const skd::Lattice lattice = UnitLattice(3);
  Forest forest = ForestOf(lattice);
  const auto cut = RefineAround(forest, lattice, 6,
    [](const skd::Box3& box) { return box.Min[0] <= 0.5 && 0.5 <= box.Max[0]; });
  for (int level = 1; level <= 6; ++level)
  {
    EXPECT_EQ(cut[level], 2u << (2 * level));
  }
}

TEST(Forest, PlacesParentsAndChildrenAgree)
{
  std::mt19937 random(3);
  for (int branch = 2; branch <= 3; ++branch)
  {
    for (int dimension = 1; dimension <= 3; ++dimension)
    {
      const skd::Lattice lattice = UnitLattice(dimension, branch, 2);
      Forest forest = ForestOf(lattice);
      RefineAround(forest, lattice, 4, [&](const skd::Box3&) { return random() % 3 == 0; });
      EXPECT_EQ(forest.FamilySize(), static_cast<unsigned>(std::pow(branch, dimension)));
      std::uint64_t leaves = 0;
      double measure = 0.0;
      for (int level = 0; level < forest.NumberOfLevels(); ++level)
      {
        for (std::uint32_t cell = 0; cell < forest.NumberOfCells(level); ++cell)
        {
          const skd::LatticePoint position = forest.LatticePointOf(level, cell);
          const Forest::Node there = forest.Find(level, position);
          EXPECT_TRUE(there.Level == level && there.Index == cell);
          const skd::Box3 box = lattice.BoxOf(level, position);
          if (level > 0)
          {
            const std::uint32_t parent = forest.Parent(level, cell);
            const skd::Box3 outer =
              lattice.BoxOf(level - 1, forest.LatticePointOf(level - 1, parent));
            EXPECT_TRUE(outer.Contains(box));
            const std::uint32_t first = forest.FirstChild(level - 1, parent);
            EXPECT_TRUE(cell >= first && cell < first + forest.FamilySize());
          }
          if (forest.IsLeaf(level, cell))
          {
            ++leaves;
            double size = 1.0;
            for (int axis = 0; axis < dimension; ++axis)
            {
              size *= box.Length(axis);
            }
            measure += size;
          }
        }
      }
      EXPECT_EQ(leaves, forest.NumberOfLeaves());
      EXPECT_NEAR(measure, 1.0, 1e-11);
    }
  }
}

TEST(Forest, APlaceIsFoundInTheLeafThatCoversIt)
{
  const skd::Lattice lattice = UnitLattice(3, 3, 2);
  Forest forest = ForestOf(lattice);
  forest.Refine(0, 5);
  const Forest::Node covering = forest.Find(3, { 53, 53, 53 });
  EXPECT_EQ(covering.Level, 0);
  EXPECT_EQ(covering.Index, 7u);
  EXPECT_EQ(forest.Find(1, { 5, 2, 5 }).Level, 1);
  EXPECT_EQ(forest.Find(1, { 6, 0, 0 }).Level, -1);
  EXPECT_EQ(forest.Find(0, { 0, 0, -1 }).Level, -1);
}

TEST(Forest, NeighboursOfAllLevelsAgreeOnTheirFace)
{
  const skd::Lattice lattice({ { { 0.1, 0.7, 1.9 }, { 0.0, 1e-3 }, { 5.0 } } }, 3);
  for (int level = 0; level < 20; ++level)
  {
    const std::int64_t cells = lattice.CellsAcross(level, 0);
    for (std::int64_t i = 1; i < std::min<std::int64_t>(2 * cells, 50); ++i)
    {
      const double face = lattice.BoxOf(level, { i, 0, 0 }).Min[0];
      EXPECT_EQ(face, lattice.BoxOf(level, { i - 1, 0, 0 }).Max[0]);
      EXPECT_EQ(face, lattice.BoxOf(level + 1, { 3 * i - 1, 0, 0 }).Max[0]);
      EXPECT_EQ(face, lattice.BoxOf(level + 1, { 3 * i, 0, 0 }).Min[0]);
    }
    const skd::Box3 last = lattice.BoxOf(level, { 2 * cells - 1, 0, 0 });
    EXPECT_EQ(last.Max[0], 1.9);
    EXPECT_EQ(last.Min[2], 5.0);
    EXPECT_EQ(last.Max[2], 5.0);
  }
}

TEST(Forest, BalancingADeepCornerGradesEveryWay)
{
  for (int dimension = 1; dimension <= 3; ++dimension)
  {
    const skd::Lattice lattice = UnitLattice(dimension, 2, 3);
    Forest forest = ForestOf(lattice);
    RefineAround(forest, lattice, 12,
      [&](const skd::Box3& box)
      {
        return box.Contains(
          skd::Vector3{ { 0.34, dimension > 1 ? 0.34 : 0.5, dimension > 2 ? 0.34 : 0.5 } });
      });
    const std::uint64_t before = forest.NumberOfLeaves();
    EXPECT_TRUE(MakeBalanced(forest, Contact::Corner));
    EXPECT_TRUE(IsBalanced(forest, Contact::Corner));
    EXPECT_TRUE(IsBalanced(forest, Contact::Face));
    EXPECT_GT(forest.NumberOfLeaves(), before);
    EXPECT_EQ(forest.NumberOfLevels(), 13);
  }
}

/// Every pair of leaves that touch, by their boxes: nothing of the forest's own is used.
TEST(Forest, BalancedLeavesThatTouchDifferByOneLevel)
{
  std::mt19937 random(7);
  const skd::Lattice lattice = UnitLattice(3, 2, 2);
  for (const Contact contact : { Contact::Face, Contact::Edge, Contact::Corner })
  {
    Forest forest = ForestOf(lattice);
    RefineAround(forest, lattice, 4, [&](const skd::Box3&) { return random() % 2 == 0; });
    MakeBalanced(forest, contact);
    std::vector<std::pair<int, skd::Box3>> leaves;
    for (int level = 0; level < forest.NumberOfLevels(); ++level)
    {
      for (std::uint32_t cell = 0; cell < forest.NumberOfCells(level); ++cell)
      {
        if (forest.IsLeaf(level, cell))
        {
          leaves.emplace_back(level, lattice.BoxOf(level, forest.LatticePointOf(level, cell)));
        }
      }
    }
    for (const auto& a : leaves)
    {
      for (const auto& b : leaves)
      {
        int apart = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
          apart +=
            a.second.Max[axis] == b.second.Min[axis] || b.second.Max[axis] == a.second.Min[axis];
        }
        const bool isNear = a.second.Overlaps(b.second) && apart <= static_cast<int>(contact);
        ASSERT_TRUE(!isNear || std::abs(a.first - b.first) <= 1);
      }
    }
  }
}

TEST(Forest, LayersReachThatManyCellsAndNoFarther)
{
  const skd::Lattice lattice = UnitLattice(3);
  Forest forest = ForestOf(lattice);
  RefineAround(forest, lattice, 4, [](const skd::Box3&) { return true; });
  std::vector<char> marks(forest.NumberOfCells(4), 0);
  const std::uint32_t middle = forest.Find(4, { 5, 8, 15 }).Index;
  marks[middle] = 1;
  for (int layers = 0; layers < 4; ++layers)
  {
    const std::vector<char> grown = skd::Grown(forest, 4, marks, layers);
    for (std::uint32_t cell = 0; cell < marks.size(); ++cell)
    {
      const skd::LatticePoint position = forest.LatticePointOf(4, cell);
      const bool isNear = std::abs(position[0] - 5) <= layers &&
        std::abs(position[1] - 8) <= layers && std::abs(position[2] - 15) <= layers;
      EXPECT_EQ(grown[cell] != 0, isNear);
    }
  }
}

}
