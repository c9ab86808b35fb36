// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The outer ones of many faces against a map of their sorted points.

#include "Cells/Read/SkdFaceList.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

using namespace skdtree;

namespace
{

struct GivenFace
{
  SkdCellFace Face;
  std::vector<vtkIdType> Points;
  bool IsGhost;
};

/// Faces of three or four of a few points, so that many are equal but for where they start and
/// whichever way they go around.
std::vector<GivenFace> RandomFaces(std::size_t cells, vtkIdType points, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<GivenFace> faces;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    for (int i = 0; i < 4; ++i)
    {
      const auto id = static_cast<vtkIdType>(cell);
      faces.push_back({ { id, i }, {}, random() % 5 == 0 });
      for (std::size_t size = 3 + random() % 2; faces.back().Points.size() < size;)
      {
        faces.back().Points.push_back(static_cast<vtkIdType>(random()) % points);
      }
    }
  }
  return faces;
}

std::vector<std::pair<vtkIdType, int>> ExpectedOuter(const std::vector<GivenFace>& faces)
{
  std::map<std::vector<vtkIdType>, std::vector<const GivenFace*>> byPoints;
  for (const GivenFace& face : faces)
  {
    std::vector<vtkIdType> name = face.Points;
    std::sort(name.begin(), name.end());
    byPoints[name].push_back(&face);
  }
  std::vector<std::pair<vtkIdType, int>> outer;
  for (const auto& [name, equal] : byPoints)
  {
    if (equal.size() % 2 == 1 && !equal.back()->IsGhost)
    {
      outer.emplace_back(equal.back()->Face.CellId, equal.back()->Face.Face);
    }
  }
  std::sort(outer.begin(), outer.end());
  return outer;
}

TEST(FaceList, OuterFacesAreThoseOfAnOddNumberOfCells)
{
  std::size_t number = 0;
  for (const std::size_t cells : { 0u, 1u, 10u, 300u })
  {
    for (const vtkIdType points : { 3, 6, 12 })
    {
      const std::vector<GivenFace> faces = RandomFaces(cells, points, 3);
      SkdFaceList list;
      for (const GivenFace& face : faces)
      {
        list.Add(face.Face, face.Points.begin(), face.Points.end(), face.IsGhost);
      }
      std::vector<std::pair<vtkIdType, int>> outer;
      for (const SkdCellFace& face : list.TakeOuter())
      {
        outer.emplace_back(face.CellId, face.Face);
      }
      EXPECT_EQ(outer, ExpectedOuter(faces)) << cells << " cells, " << points << " points";
      EXPECT_TRUE(list.TakeOuter().empty());
      number += outer.size();
    }
  }
  EXPECT_GT(number, 100u);
}

}
