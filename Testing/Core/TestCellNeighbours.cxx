// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that fill space leave no gap: whatever the query point, on shared faces, edges and
// corners too, one of them holds it to within the rounding of its coordinates.
#include "GeometryReference.h"

#include <gtest/gtest.h>

namespace
{

using coretest::Dice;
using skd::Vector3;
using Points = std::vector<Vector3>;

/// Two by two by two bricks whose corners, but those on the outside, are moved.
struct Bricks
{
  Points Nodes;

  Bricks(Dice& dice, const Vector3& offset, double warp)
  {
    for (int i = 0; i < 27; ++i)
    {
      const bool isMiddle = i == 13;
      const Vector3 node{ { i % 3 * 1.0, i / 3 % 3 * 1.0, i / 9 * 1.0 } };
      this->Nodes.push_back(offset + node + (isMiddle ? 1.0 : 0.3) * dice.Point(warp));
    }
  }

  /// The corners of a brick; the bits of a corner's number are its place.
  Points Corners(int brick) const
  {
    Points corners;
    for (int i = 0; i < 8; ++i)
    {
      const int x = (brick & 1) + (i & 1);
      const int y = (brick >> 1 & 1) + (i >> 1 & 1);
      const int z = (brick >> 2) + (i >> 2);
      corners.push_back(this->Nodes[x + 3 * y + 9 * z]);
    }
    return corners;
  }
};

Points Chosen(const Points& from, std::initializer_list<int> indices)
{
  Points chosen;
  for (const int index : indices)
  {
    chosen.push_back(from[index]);
  }
  return chosen;
}

/// The cells of each shape that fill a brick, and do so to both sides of a face alike.
template <class Shape>
std::vector<Points> Fill(const Points& brick);

template <>
std::vector<Points> Fill<skd::Voxel>(const Points& brick)
{
  return { brick };
}

template <>
std::vector<Points> Fill<skd::Hexahedron>(const Points& brick)
{
  return { Chosen(brick, { 0, 1, 3, 2, 4, 5, 7, 6 }) };
}

template <>
std::vector<Points> Fill<skd::Wedge>(const Points& brick)
{
  return { Chosen(brick, { 0, 1, 3, 4, 5, 7 }), Chosen(brick, { 0, 3, 2, 4, 7, 6 }) };
}

template <>
std::vector<Points> Fill<skd::Tetrahedron>(const Points& brick)
{
  return { Chosen(brick, { 0, 1, 3, 7 }), Chosen(brick, { 0, 3, 2, 7 }),
    Chosen(brick, { 0, 2, 6, 7 }), Chosen(brick, { 0, 6, 4, 7 }), Chosen(brick, { 0, 4, 5, 7 }),
    Chosen(brick, { 0, 5, 1, 7 }) };
}

template <>
std::vector<Points> Fill<skd::Pyramid>(const Points& brick)
{
  Points points = brick;
  Vector3 middle = brick[0];
  for (const Vector3& corner : brick)
  {
    middle = middle + 0.125 * (corner - brick[0]);
  }
  points.push_back(middle);
  return { Chosen(points, { 0, 1, 3, 2, 8 }), Chosen(points, { 4, 6, 7, 5, 8 }),
    Chosen(points, { 0, 4, 5, 1, 8 }), Chosen(points, { 2, 3, 7, 6, 8 }),
    Chosen(points, { 0, 2, 6, 4, 8 }), Chosen(points, { 1, 5, 7, 3, 8 }) };
}

template <class Shape>
class CellNeighbours : public ::testing::Test
{
protected:
  static constexpr double Warp = std::is_same_v<Shape, skd::Voxel> ? 0.0 : 0.2;
  Dice Random{ 15 };

  std::vector<Points> Cells(const Bricks& bricks)
  {
    std::vector<Points> cells;
    for (int brick = 0; brick < 8; ++brick)
    {
      for (const Points& cell : Fill<Shape>(bricks.Corners(brick)))
      {
        cells.push_back(cell);
      }
    }
    return cells;
  }

  /// A point well inside: of a brick, its faces, edges or the corner that all bricks share.
  Vector3 PointInside(const Bricks& bricks)
  {
    Vector3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = this->Random.Below(2) == 0 ? 1.0 : this->Random.Between(0.5, 1.0);
    }
    const Points points = Fill<skd::Hexahedron>(bricks.Corners(0))[0];
    return skd::Evaluate<skd::Hexahedron>(points.data(), position, { { 0.0, 0.0, 0.0 } });
  }

  void ExpectNoGap(double magnitude)
  {
    const Bricks bricks(this->Random, this->Random.Point(magnitude), Warp);
    const std::vector<Points> cells = this->Cells(bricks);
    for (int i = 0; i < 200; ++i)
    {
      const Vector3 x = this->PointInside(bricks);
      const double ulp =
        std::nextafter(skd::MaxNorm(x), std::numeric_limits<double>::max()) - skd::MaxNorm(x);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Points& cell : cells)
      {
        nearest =
          std::min(nearest, skd::ClosestPointInCell<Shape>(cell.data(), x, 64.0 * ulp * ulp).Dist2);
      }
      EXPECT_LE(std::sqrt(nearest), 8.0 * ulp) << magnitude;
    }
  }
};

using Shapes =
  ::testing::Types<skd::Tetrahedron, skd::Voxel, skd::Hexahedron, skd::Wedge, skd::Pyramid>;
TYPED_TEST_SUITE(CellNeighbours, Shapes);

TYPED_TEST(CellNeighbours, LeaveNoGap)
{
  for (const double magnitude : { 0.0, 1.0, 1e3, 1e6, 1e9 })
  {
    for (int i = 0; i < 20; ++i)
    {
      this->ExpectNoGap(magnitude);
    }
  }
}

}
