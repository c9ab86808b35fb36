// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshScenes.h"

#include "Core/Geometry/Polygons/Ears.h"
#include "Core/Meshing/Mesh/Bisection.h"
#include "Core/Meshing/Mesh/GivenHangingNodes.h"
#include "Core/Meshing/Mesh/HangingNodes.h"
#include "Core/Meshing/Mesh/RegularCuts.h"
#include "Core/Meshing/Mesh/SmallestAngle.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace
{

using skd::CellKind;
using skd::RefinedMesh;
using skd::Vector3;

std::vector<std::uint32_t> SomeLeaves(const RefinedMesh& mesh, std::mt19937& random)
{
  std::vector<std::uint32_t> some;
  for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (mesh[cell].IsLeaf() && random() % 5 == 0)
    {
      some.push_back(cell);
    }
  }
  return some;
}

/// Two polygons beside each other and one above both: node 4 is in the middle of its lower edge.
RefinedMesh TwoBelowOne(const Vector3& lower, const Vector3& middle, const Vector3& upper)
{
  RefinedMesh mesh;
  for (const double y : { 0.0, 1.0 })
  {
    for (const Vector3& x : { lower, middle, upper })
    {
      mesh.AddNode({ { x[0], x[1] + y, x[2] } });
    }
  }
  mesh.AddNode({ { lower[0], lower[1] + 2.0, lower[2] } });
  mesh.AddNode({ { upper[0], upper[1] + 2.0, upper[2] } });
  const std::uint32_t cells[][4] = { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 3, 5, 7, 6 } };
  for (std::uint32_t i = 0; i < 3; ++i)
  {
    mesh.AddCell(CellKind::Polygon, cells[i], 4, i, 0);
  }
  return mesh;
}

TEST(GivenHangingNodes, AreMiddlesInThePrecisionOfTheEnds)
{
  const double a = 0.1f;
  const double b = 0.3f;
  const auto single = static_cast<double>(static_cast<float>(0.5 * (a + b)));
  ASSERT_NE(single, 0.5 * (a + b));
  EXPECT_EQ(
    skd::GivenHangingNodes(TwoBelowOne({ { a, 0, a } }, { { single, 0, a } }, { { b, 0, a } }))
      .First,
    4u);
  EXPECT_EQ(skd::GivenHangingNodes(
              TwoBelowOne({ { a, 0, a } }, { { 0.5 * (a + b), 0, a } }, { { b, 0, a } }))
              .First,
    4u);
  // The ends have double precision: what is not their middle in that is not in the middle.
  const double c = std::nextafter(b, 1.0);
  EXPECT_EQ(
    skd::GivenHangingNodes(TwoBelowOne({ { a, 0, a } }, { { single, 0, a } }, { { c, 0, a } }))
      .Count,
    0u);
}

TEST(TupleNumbers, AreThoseOfAMap)
{
  skd::TupleNumbers<3> numbers;
  std::map<std::set<std::uint32_t>, std::uint32_t> reference;
  std::mt19937 random(1);
  EXPECT_EQ(numbers.Find({ 1, 2, 3 }), skd::TupleNumbers<3>::None);
  for (int i = 0; i < 5000; ++i)
  {
    const std::uint32_t a = random() % 20;
    const std::uint32_t b = 20 + random() % 20;
    const std::uint32_t c = 40 + random() % 4;
    const auto next = static_cast<std::uint32_t>(reference.size());
    const std::uint32_t expected = reference.emplace(std::set{ a, b, c }, next).first->second;
    EXPECT_EQ(numbers.FindOrAdd({ c, a, b }), expected);
    EXPECT_EQ(numbers.Find({ b, c, a }), expected);
  }
  EXPECT_EQ(numbers.Size(), reference.size());
}

TEST(RefinedMesh, GoesBackToWhereItWas)
{
  for (const bool isRegular : { false, true })
  {
    RefinedMesh mesh = MakeSquare(4);
    std::mt19937 random(3);
    const auto refine = [&](std::uint64_t limit)
    {
      const std::vector<std::uint32_t> cells = SomeLeaves(mesh, random);
      return isRegular ? skd::RegularCuts(mesh, limit, skd::Contact::Corner).Refine(cells)
                       : skd::Bisection(mesh, limit).Refine(cells);
    };
    ASSERT_TRUE(refine(100000) && refine(100000));
    const auto before = LeavesOf(mesh);
    const std::uint32_t nodes = mesh.NumberOfNodes();
    EXPECT_FALSE(refine(mesh.NumberOfLeaves() + 5));
    EXPECT_EQ(LeavesOf(mesh), before);
    EXPECT_EQ(mesh.NumberOfNodes(), nodes);
    EXPECT_EQ(mesh.NumberOfLeaves(), before.size());
    // And it can go on from there.
    ASSERT_TRUE(refine(100000));
    EXPECT_GT(mesh.NumberOfLeaves(), before.size());
    const skd::HangingNodes hanging(mesh);
    for (std::uint32_t node = 0; node < mesh.NumberOfNodes() && !isRegular; ++node)
    {
      EXPECT_FALSE(hanging[node]);
    }
  }
}

/// What must be bisected, by looking at all cells again and again.
TEST(Bisection, CutsNoMoreThanItMust)
{
  RefinedMesh mesh = MakeSquare(5);
  std::mt19937 random(5);
  for (int round = 0; round < 6; ++round)
  {
    RefinedMesh slow = mesh;
    const std::vector<std::uint32_t> wanted = SomeLeaves(mesh, random);
    ASSERT_TRUE(skd::Bisection(mesh, 1u << 30).Refine(wanted));
    std::set<std::uint32_t> due(wanted.begin(), wanted.end());
    while (!due.empty())
    {
      for (const std::uint32_t cell : due)
      {
        const skd::OrderedEdge edge = skd::LongestEdgeOf(slow, cell);
        const std::uint32_t middle = slow.MakeMiddle(edge[0], edge[1]);
        std::array<std::uint32_t, 3> p;
        std::copy_n(slow.NodesOf(cell).First, 3, p.begin());
        slow.BeginCut(cell);
        for (int end = 0; end < 2; ++end)
        {
          std::array<std::uint32_t, 3> q = p;
          std::replace(q.begin(), q.end(), edge[end], middle);
          slow.AddChild(cell, CellKind::Triangle, { q[0], q[1], q[2] }, 1);
        }
        slow.EndCut(cell);
      }
      due.clear();
      for (std::uint32_t cell = 0; cell < slow.NumberOfCells(); ++cell)
      {
        const RefinedMesh::Nodes n = slow.NodesOf(cell);
        for (std::uint32_t i = 0; i < 3 && slow[cell].IsLeaf(); ++i)
        {
          if (slow.MiddleOf(n[i], n[(i + 1) % 3]) != RefinedMesh::None)
          {
            due.insert(cell);
          }
        }
      }
    }
    const auto shapes = [](const RefinedMesh& of)
    {
      std::set<std::set<Vector3>> all;
      for (const auto& leaf : LeavesOf(of))
      {
        std::set<Vector3> shape;
        for (const std::uint32_t node : leaf)
        {
          shape.insert(of.Point(node));
        }
        all.insert(shape);
      }
      return all;
    };
    EXPECT_EQ(shapes(mesh), shapes(slow));
  }
  EXPECT_GT(mesh.NumberOfLeaves(), 200u);
}

TEST(SmallestAngle, OfKnownCells)
{
  RefinedMesh mesh;
  const std::uint32_t p[4] = { mesh.AddNode({ { 0, 0, 0 } }), mesh.AddNode({ { 1, 0, 0 } }),
    mesh.AddNode({ { 0, 1, 0 } }), mesh.AddNode({ { 0, 0, 1 } }) };
  const double degree = std::atan(1.0) / 45.0;
  EXPECT_NEAR(
    skd::SmallestAngleOf(mesh, mesh.AddCell(CellKind::Triangle, p, 3, 0, 0)), 45 * degree, 1e-15);
  // Between the faces x = 0 and x + y + z = 1.
  EXPECT_NEAR(skd::SmallestAngleOf(mesh, mesh.AddCell(CellKind::Tetrahedron, p, 4, 0, 0)),
    std::acos(std::sqrt(1.0 / 3.0)), 1e-15);
  EXPECT_FALSE(std::isfinite(skd::SmallestAngleOf(mesh, mesh.AddCell(CellKind::Line, p, 2, 0, 0))));
}

//------------------------------------------------------------------------------
TEST(Ears, CutAConcavePolygonWithoutOverlap)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  for (int n = 3; n < 40; ++n)
  {
    std::vector<Vector3> star;
    double area = 0.0;
    for (int i = 0; i < n; ++i)
    {
      const double angle = 2 * std::acos(-1.0) * i / n;
      const double r = radius(random);
      star.push_back({ { r * std::cos(angle), r * std::sin(angle), 0.25 } });
    }
    for (int i = 0; i < n; ++i)
    {
      area += 0.5 * skd::Cross(star[i], star[(i + 1) % n])[2];
    }
    const auto triangles = skd::CutOffEars(star);
    ASSERT_EQ(triangles.size(), 3u * (n - 2));
    double sum = 0.0;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
    {
      const Vector3& a = star[triangles[i]];
      const double part =
        0.5 * skd::Cross(star[triangles[i + 1]] - a, star[triangles[i + 2]] - a)[2];
      EXPECT_GT(part, 0.0);
      sum += part;
    }
    EXPECT_NEAR(sum, area, 1e-13);
  }
  EXPECT_TRUE(
    skd::CutOffEars({ { { 0, 0, 0 } }, { { 1, 1, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } })
      .empty());
}

}
