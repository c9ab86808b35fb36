// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Curved faces as facets: how near they are, and that those of neighbours fit together.

#include "Core/Curves/PatchFacets.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace
{

using namespace skd;

struct Kind
{
  int DegreeR;
  int DegreeS;
  bool IsTriangle;
  NodeMeaning Meaning;
};

constexpr Kind Kinds[] = { { 1, 1, false, NodeMeaning::Values },
  { 2, 2, false, NodeMeaning::Values }, { 2, 2, false, NodeMeaning::Serendipity },
  { 2, 1, false, NodeMeaning::Values }, { 3, 5, false, NodeMeaning::Values },
  { 2, 3, false, NodeMeaning::Controls }, { 1, 1, true, NodeMeaning::Values },
  { 2, 2, true, NodeMeaning::Values }, { 2, 2, true, NodeMeaning::Bubble },
  { 4, 4, true, NodeMeaning::Values }, { 3, 3, true, NodeMeaning::Controls },
  { 10, 10, true, NodeMeaning::Values }, { 10, 10, false, NodeMeaning::Values } };

/// What random nodes may be off by: equidistant nodes of a high degree make much of little.
double CurvingOf(const Kind& kind)
{
  return kind.DegreeR > 5 ? 1e-5 : (kind.DegreeS > 3 ? 0.01 : 0.1);
}

/// A face of about a given size, its nodes off a plane's lattice by a share of it.
NodePatch RandomFace(const Kind& kind, double curving, double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto any = [&]() { return curving * uniform(random); };
  const auto node = [&](double r, double s)
  {
    const double weight = kind.Meaning == NodeMeaning::Controls ? 1.0 + 0.4 * uniform(random) : 1.0;
    return PatchNode{ { size * (r + any() + 3.0), size * (s + any()), size * (any() - 2.0),
      weight } };
  };
  NodePatch face;
  face.DegreeR = kind.DegreeR;
  face.DegreeS = kind.DegreeS;
  face.IsTriangle = kind.IsTriangle;
  face.Meaning = kind.Meaning;
  for (int j = 0; j <= face.DegreeS; ++j)
  {
    for (int i = 0; i <= face.Last(j); ++i)
    {
      face.At(i, j) = node(double(i) / face.DegreeR, double(j) / face.DegreeS);
    }
  }
  face.Middle = node(1.0 / 3.0, 1.0 / 3.0);
  return face;
}

std::vector<std::array<Vector3, 3>> TrianglesOf(const PatchFacets& facets)
{
  std::vector<std::array<Vector3, 3>> triangles;
  const auto& x = facets.GetPoints();
  if (facets.IsPolygon())
  {
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
    {
      triangles.push_back({ x[0], x[i], x[i + 1] });
    }
  }
  for (const auto& t : facets.GetTriangles())
  {
    triangles.push_back({ x[t[0]], x[t[1]], x[t[2]] });
  }
  return triangles;
}

TEST(PatchFacets, AreNoFartherThanTheDeviation)
{
  std::mt19937 random(7);
  PatchFacets facets;
  for (const Kind& kind : Kinds)
  {
    for (const double size : { 1.0, 1e-150, 1e150 })
    {
      const NodePatch face = RandomFace(kind, CurvingOf(kind), size, random);
      const double deviation = 1e-3 * size;
      facets.Cut(face, deviation);
      EXPECT_TRUE(facets.IsKept());
      const BezierPatch patch = ToBezier(face, face.Corner(0));
      const auto triangles = TrianglesOf(facets);
      for (int k = 0; k < 60; ++k)
      {
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        double r = uniform(random);
        double s = uniform(random);
        if (face.IsTriangle && r + s > 1.0)
        {
          r = 1.0 - r;
          s = 1.0 - s;
        }
        const Vector3 x = (1.0 / size) * (face.Corner(0) + Projected(patch.WeightedAt(r, s)));
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& t : triangles)
        {
          const double dist2 =
            ClosestPointOnTriangle((1.0 / size) * t[0], (1.0 / size) * t[1], (1.0 / size) * t[2], x)
              .Dist2;
          nearest = std::min(nearest, dist2);
        }
        ASSERT_LE(std::sqrt(nearest), 1.05e-3) << kind.DegreeR << " " << kind.DegreeS;
      }
    }
  }
}

/// How often each edge of the facets is used, less how often the other way.
std::map<std::array<Vector3, 2>, int> EdgesOf(const PatchFacets& facets)
{
  std::map<std::array<Vector3, 2>, int> edges;
  for (const auto& t : TrianglesOf(facets))
  {
    for (int i = 0; i < 3; ++i)
    {
      const Vector3& a = t[i];
      const Vector3& b = t[(i + 1) % 3];
      a < b ? ++edges[{ a, b }] : --edges[{ b, a }];
    }
  }
  return edges;
}

TEST(PatchFacets, AreBoundedByTheirSidesAlone)
{
  std::mt19937 random(11);
  PatchFacets facets;
  for (const Kind& kind : Kinds)
  {
    for (const double curving : { 0.0, 0.1, 1.0, 4.0 })
    {
      const NodePatch face = RandomFace(kind, curving * CurvingOf(kind), 1.0, random);
      facets.Cut(face, 1e-2);
      std::size_t border = 0;
      for (const auto& [edge, uses] : EdgesOf(facets))
      {
        ASSERT_LE(std::abs(uses), 1);
        border += uses != 0 ? 1 : 0;
      }
      bool isKept = true;
      std::size_t pieces = 0;
      for (int side = 0; side < face.NumberOfSides(); ++side)
      {
        pieces += static_cast<std::size_t>(
          PatchFacets::CountPieces(CommonSide(face, side).Curve, 0.7e-2, isKept));
      }
      EXPECT_EQ(border, pieces);
    }
  }
}

// However a face is put down, it is cut the same, to the last bit.
TEST(PatchFacets, AreTheSameFromBothSides)
{
  std::mt19937 random(13);
  for (const Kind& kind : Kinds)
  {
    const NodePatch face = RandomFace(kind, 0.5 * CurvingOf(kind), 1.0, random);
    PatchFacets facets;
    facets.Cut(face, 1e-3);
    for (int direction = 0; direction < (face.IsTriangle ? 6 : 8); ++direction)
    {
      bool isOver;
      PatchFacets others;
      others.Cut(PutDown(face, direction, isOver), 1e-3);
      EXPECT_EQ(others.IsFlipped(), facets.IsFlipped() != isOver) << direction;
      EXPECT_TRUE(others.GetPoints() == facets.GetPoints()) << direction;
      EXPECT_EQ(others.GetTriangles(), facets.GetTriangles()) << direction;
    }
  }
}

TEST(PatchFacets, EndHoweverFineTheyAreWanted)
{
  std::mt19937 random(17);
  PatchFacets facets;
  const NodePatch face = RandomFace(Kinds[1], 0.3, 1.0, random);
  facets.Cut(face, 1e-14);
  EXPECT_FALSE(facets.IsKept());
  EXPECT_EQ(facets.GetTriangles().size(), 2u * 128 * 128);
}

TEST(PatchFacets, OfAStraightFaceAreOnePolygon)
{
  std::mt19937 random(19);
  PatchFacets facets;
  for (const Kind& kind : Kinds)
  {
    facets.Cut(RandomFace(kind, 0.0, 1.0, random), 1e-6);
    EXPECT_TRUE(facets.IsPolygon());
    EXPECT_EQ(facets.GetPoints().size(), kind.IsTriangle ? 3u : 4u);
  }
}

}
