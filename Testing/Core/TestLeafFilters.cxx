// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Leaf filters leave nothing out that an exact test would take, whatever the triangles and cells
// are like.
#include "Core/Geometry/Cells/ClosestPointInCell.h"
#include "Core/Geometry/Intersection/SegmentTriangle.h"
#include "Core/Search/LeafFilters/PlaneRow.h"
#include "Core/Search/LeafFilters/TriangleCrossings.h"
#include "Core/Search/LeafFilters/TriangleDistances.h"
#include "GeometryReference.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

using coretest::Dice;
using skd::Box3;
using skd::Frame;
using skd::QuantizationGrid;
using skd::Vector3;

constexpr int Width = skd::TrianglePacket::Width;

/// Eight triangles of a data set, in the world and as a leaf filter keeps them.
struct Packed
{
  Vector3 Corners[Width][3];
  Frame<3> TheFrame;
  skd::TrianglePacket Packet;

  /// The data set spans `bounds`, in which all triangles are.
  void Fill(const Box3& bounds)
  {
    Box3 box;
    for (const auto& triangle : this->Corners)
    {
      for (const Vector3& corner : triangle)
      {
        box.Add(corner);
      }
    }
    this->TheFrame = Frame<3>::Of(bounds);
    this->Packet.Grid = QuantizationGrid(this->TheFrame.Outward(box));
    for (int lane = 0; lane < Width; ++lane)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->Packet.Set(corner, lane, this->TheFrame.Local(this->Corners[lane][corner]));
      }
    }
  }

  double UnitInWorld() const { return this->Packet.Grid.Unit / this->TheFrame.Scale; }
};

/// Triangles of all kinds about a place, `size` large.
Packed RandomPacket(Dice& dice, const Vector3& position, double size, const Box3& bounds)
{
  Packed packed;
  for (auto& triangle : packed.Corners)
  {
    for (Vector3& corner : triangle)
    {
      corner = position + dice.Point(size);
    }
    switch (dice.Below(6))
    {
      case 0: // a needle
        triangle[2] = triangle[1] + 1e-7 * (triangle[2] - triangle[1]);
        break;
      case 1: // a segment
        triangle[2] = skd::Lerp(triangle[0], triangle[1], dice.Between(-1.0, 1.0));
        break;
      case 2: // a point
        triangle[2] = triangle[1] = triangle[0];
        break;
      case 3: // small beside the others
        triangle[1] = triangle[0] + 1e-3 * (triangle[1] - triangle[0]);
        triangle[2] = triangle[0] + 1e-3 * (triangle[2] - triangle[0]);
        break;
      default:
        break;
    }
  }
  packed.Fill(bounds);
  return packed;
}

/// Where a data set is, and how small the triangles are in it.
struct Setting
{
  Vector3 Offset;
  double Scale;
  double Smallness;
};

class LeafFilters : public ::testing::TestWithParam<Setting>
{
protected:
  Dice Random{ 21 };

  Box3 Bounds() const
  {
    const double s = GetParam().Scale;
    const Vector3 maxDistance{ { 2.0 * s, 2.0 * s, 2.0 * s } };
    return Box3(GetParam().Offset - maxDistance, GetParam().Offset + maxDistance);
  }

  double Size() const { return GetParam().Scale * GetParam().Smallness; }

  Packed Make()
  {
    const Vector3 position = GetParam().Offset + this->Random.Point(0.5 * GetParam().Scale);
    return RandomPacket(this->Random, position, this->Size(), this->Bounds());
  }

  /// Near the triangles, on one of them, or anywhere.
  Vector3 PointFor(const Packed& packed)
  {
    const auto& triangle = packed.Corners[this->Random.Below(Width)];
    switch (this->Random.Below(3))
    {
      case 0:
        return skd::Lerp(skd::Lerp(triangle[0], triangle[1], this->Random.Between(0.0, 1.0)),
          triangle[2], this->Random.Between(0.0, 1.0));
      case 1:
        return triangle[0] + this->Random.Point(3.0 * this->Size());
      default:
        return GetParam().Offset + this->Random.Point(100.0 * GetParam().Scale);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Everywhere, LeafFilters,
  ::testing::Values(Setting{ { { 0, 0, 0 } }, 1.0, 0.5 }, Setting{ { { 0, 0, 0 } }, 1.0, 1e-4 },
    Setting{ { { 0, 0, 0 } }, 1.0, 1e-12 }, Setting{ { { 1e6, -1e6, 3e5 } }, 1.0, 1e-2 },
    Setting{ { { 0, 0, 0 } }, 1e-20, 1e-3 }, Setting{ { { 0, 0, 0 } }, 1e20, 1e-3 }));

TEST_P(LeafFilters, DistancesAreWithinTheirBounds)
{
  int tight = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Packed packed = this->Make();
    const Vector3 x = this->PointFor(packed);
    const skd::TriangleDistances bounds(
      packed.Packet, packed.Packet.Grid.Of(packed.TheFrame.Local(x)));
    for (int lane = 0; lane < Width; ++lane)
    {
      const Vector3* p = packed.Corners[lane];
      const double distance =
        std::sqrt(skd::ClosestPointOnTriangle(p[0], p[1], p[2], x).Dist2) / packed.UnitInWorld();
      ASSERT_LE(bounds.Least[lane], distance);
      ASSERT_GE(bounds.Most[lane], distance);
      tight += bounds.Most[lane] - bounds.Least[lane] < 4.0 + 1e-3 * distance ? 1 : 0;
    }
  }
  EXPECT_GT(tight, 2000 * Width * 3 / 4);
}

TEST_P(LeafFilters, WithinTheLimitAreThoseThatMayBeNearEnough)
{
  for (int i = 0; i < 300; ++i)
  {
    const Packed packed = this->Make();
    const Vector3 x = this->PointFor(packed);
    const float unit = packed.Packet.Grid.Unit;
    const skd::TriangleDistances bounds(
      packed.Packet, packed.Packet.Grid.Of(packed.TheFrame.Local(x)));
    double nearest2 = std::numeric_limits<double>::infinity();
    for (const auto& p : packed.Corners)
    {
      nearest2 = std::min(nearest2, skd::ClosestPointOnTriangle(p[0], p[1], p[2], x).Dist2);
    }
    const float limit = packed.TheFrame.UpperBound2(nearest2);
    ASSERT_GE(packed.TheFrame.UpperBound2(
                bounds.LeastMost2(Width, unit) / packed.TheFrame.Scale / packed.TheFrame.Scale),
      nearest2 * packed.TheFrame.Scale * packed.TheFrame.Scale);
    float keys[Width];
    const unsigned wanted = bounds.Within(limit, unit, keys);
    for (int lane = 0; lane < Width; ++lane)
    {
      const Vector3* p = packed.Corners[lane];
      if (skd::ClosestPointOnTriangle(p[0], p[1], p[2], x).Dist2 == nearest2)
      {
        ASSERT_TRUE(wanted >> lane & 1u);
        ASSERT_LE(keys[lane], limit);
      }
    }
  }
}

TEST_P(LeafFilters, NoHitIsMissed)
{
  int hits = 0;
  int passed = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const Packed packed = this->Make();
    const auto& aim = packed.Corners[this->Random.Below(Width)];
    // At a corner, along an edge or at the inside of a triangle: shared by chance with no other.
    const Vector3 through = i % 3 == 0 ? aim[0]
      : i % 3 == 1                     ? skd::Lerp(aim[0], aim[1], this->Random.Between(0.0, 1.0))
                                       : (1.0 / 3.0) * (aim[0] + aim[1] + aim[2]);
    const Vector3 maxDistance = this->Random.Point(GetParam().Scale);
    const skd::Segment<3> segment{ through - maxDistance, through + maxDistance };
    const skd::SegmentView view(segment);
    skd::TriangleCrossings crossings(view.GetShear());
    crossings.Aim(packed.TheFrame.Local(segment.A), 1e-15);
    const unsigned met = crossings.MayIntersect(packed.Packet);
    for (int lane = 0; lane < Width; ++lane)
    {
      const Vector3* p = packed.Corners[lane];
      passed += met >> lane & 1u;
      if (skd::Intersect(view, p[0], p[1], p[2]))
      {
        ++hits;
        ASSERT_TRUE(met >> lane & 1u);
      }
    }
  }
  EXPECT_GT(hits, 500);
  if (GetParam().Smallness > 1e-9) // else they are about as small as the grid resolves
  {
    EXPECT_LT(passed, 3000 * Width * 3 / 4);
  }
}

// A line that runs past a triangle by the margin still passes.
TEST_P(LeafFilters, AMarginWidensTriangles)
{
  const double margin = 0.1 * this->Size() / GetParam().Scale;
  for (int i = 0; i < 500; ++i)
  {
    const Packed packed = this->Make();
    const auto& aim = packed.Corners[this->Random.Below(Width)];
    const Vector3 aside = this->Random.Point(0.5 * margin / packed.TheFrame.Scale);
    const Vector3 maxDistance = this->Random.Point(GetParam().Scale);
    const Vector3 through = aim[0] + aside;
    skd::TriangleCrossings crossings{ skd::Shear(maxDistance) };
    crossings.Aim(packed.TheFrame.Local(through - maxDistance), margin);
    const unsigned met = crossings.MayIntersect(packed.Packet);
    ASSERT_TRUE(met >> (&aim - packed.Corners) & 1u);
  }
}

/// Volume cells of one shape, eight a row of planes.
template <class Shape>
class CellLeafFilters : public ::testing::Test
{
};

using Shapes = ::testing::Types<skd::Tetrahedron, skd::Hexahedron, skd::Wedge, skd::Pyramid>;
TYPED_TEST_SUITE(CellLeafFilters, Shapes);

/// The planes of a cell's faces in one of the lanes.
template <class Shape>
struct CellPlanes
{
  QuantizationGrid TheGrid;
  skd::PlaneRow Rows[Shape::NumberOfFaces];

  CellPlanes(const std::vector<Vector3>& points, int lane)
    : TheGrid(skd::FloatBox<3>{ { -3, -3, -3 }, { 3, 3, 3 } })
  {
    std::vector<Vector3> onGrid;
    for (const Vector3& point : points)
    {
      onGrid.push_back(this->TheGrid.Of(point));
    }
    for (int face = 0; face < Shape::NumberOfFaces; ++face)
    {
      const Vector3 across = skd::FaceNormal<Shape>(onGrid.data(), face);
      this->Rows[face].SetAlongFace(lane, (face + lane) % 2 == 0 ? across : -1.0 * across,
        onGrid[Shape::Faces[face][0]], onGrid.data(), Shape::Size, skd::PlaneRow::Rounding);
    }
  }

  unsigned MayHold(const Vector3& x) const
  {
    unsigned held = 0xffu;
    for (const skd::PlaneRow& row : this->Rows)
    {
      held &= ~NegativeLanes(row.Inside(skd::WholePoint(this->TheGrid.Of(x))));
    }
    return held;
  }
};

TYPED_TEST(CellLeafFilters, NoPointOfACellIsOutsideOfItsPlanes)
{
  Dice dice(22);
  const int count = 3000;
  int passed = 0;
  for (int i = 0; i < count; ++i)
  {
    std::vector<Vector3> points = coretest::RandomCell<TypeParam>(dice, 0.1 * (i % 4));
    if (i % 7 == 0)
    {
      points[1] = points[0]; // collapsed
    }
    const CellPlanes<TypeParam> planes(points, i % 8);
    const Vector3 position = coretest::MoveIntoDomain<TypeParam>(dice);
    const Vector3 inside = skd::Evaluate<TypeParam>(points.data(), position, { { 0.0, 0.0, 0.0 } });
    ASSERT_EQ(planes.MayHold(inside), 0xffu); // lanes that were not set hold everything
    const Vector3 x = dice.Point(2.0);
    const bool isHeld = (planes.MayHold(x) >> (i % 8) & 1u) != 0;
    const bool isIn = skd::ClosestPointInCell<TypeParam>(points.data(), x, 1e-30).Dist2 == 0.0;
    ASSERT_TRUE(isHeld || !isIn);
    passed += isHeld ? 1 : 0;
  }
  EXPECT_LT(passed, count / 2); // and most of what is outside is left out
}

// Cells of a shape beside each other have the planes that each has alone, in the lanes that are
// asked for.
TYPED_TEST(CellLeafFilters, SeveralCellsAtOnceHaveThePlanesOfEach)
{
  constexpr int size = TypeParam::Size;
  Dice dice(23);
  for (int i = 0; i < 200; ++i)
  {
    const auto lanes = static_cast<unsigned>(i % 256);
    skd::CornerLanes<TypeParam> corners;
    skd::PlaneRow alone[TypeParam::NumberOfFaces];
    skd::PlaneRow together[TypeParam::NumberOfFaces];
    for (int lane = 0; lane < skd::PlaneRow::Width; ++lane)
    {
      std::vector<Vector3> points = coretest::RandomCell<TypeParam>(dice, 0.1 * (i % 4));
      points[1] = (i + lane) % 7 == 0 ? points[0] : points[1]; // collapsed
      for (int corner = 0; corner < size; ++corner)
      {
        points[corner] = 9000.0 * points[corner];
        corners.Set(lane, corner, points[corner]);
      }
      for (int face = 0; face < TypeParam::NumberOfFaces && (lanes >> lane & 1u) != 0; ++face)
      {
        alone[face].SetAlongFace(lane, skd::FaceNormal<TypeParam>(points.data(), face),
          points[TypeParam::Faces[face][0]], points.data(), size, skd::PlaneRow::Rounding);
      }
    }
    for (int face = 0; face < TypeParam::NumberOfFaces; ++face)
    {
      together[face].SetAlongFaces(lanes, face, corners, skd::PlaneRow::Rounding);
      ASSERT_EQ(std::memcmp(&alone[face], &together[face], sizeof(skd::PlaneRow)), 0)
        << "face " << face << " of " << i;
    }
  }
}

// Any hexahedron is between its slabs; of one with parallel faces what is beside it is not.
TEST(SlabPacket, HoldsHexahedraAndWithParallelFacesLittleElse)
{
  using Shape = skd::Hexahedron;
  Dice dice(24);
  int outside = 0;
  for (int i = 0; i < 500; ++i)
  {
    const bool areParallel = i % 4 == 0;
    skd::CornerLanes<Shape> corners;
    std::vector<Vector3> cells[skd::SlabRow::Width];
    for (int lane = 0; lane < skd::SlabRow::Width; ++lane)
    {
      cells[lane] = coretest::RandomCell<Shape>(dice, 0.1 * (i % 4));
      cells[lane][1] = (i + lane) % 7 == 0 && !areParallel ? cells[lane][0] : cells[lane][1];
      for (int corner = 0; corner < Shape::Size; ++corner)
      {
        cells[lane][corner] = 9000.0 * cells[lane][corner];
        corners.Set(lane, corner, cells[lane][corner]);
      }
    }
    skd::SlabPacket packet;
    for (int slab = 0; slab < skd::SlabPacket::Number; ++slab)
    {
      packet.Slabs[slab].SetBetweenFaces(0xfeu, 2 * slab, corners, skd::SlabRow::Rounding);
    }
    const auto heldAt = [&](int lane, const Vector3& pcoords)
    {
      const Vector3 x = skd::Evaluate<Shape>(cells[lane].data(), pcoords, { { 0.0, 0.0, 0.0 } });
      return 0xffu & ~NegativeLanes(packet.Inside(skd::WholePoint(x)));
    };
    for (int lane = 1; lane < skd::SlabRow::Width; ++lane)
    {
      const std::vector<Vector3>& points = cells[lane];
      Vector3 pcoords = coretest::MoveIntoDomain<Shape>(dice);
      ASSERT_EQ(heldAt(lane, pcoords) & (1u << lane | 1u), 1u << lane | 1u); // 0 was not set
      const int axis = lane % 3;
      pcoords[axis] = i % 8 == 0 ? 1.1 : -0.1;
      const Vector3 normal = skd::FaceNormal<Shape>(points.data(), 2 * axis);
      const Vector3 edge = points[axis == 0 ? 1 : axis == 1 ? 3 : 4] - points[0];
      if (areParallel && 0.1 * std::abs(skd::Dot(normal, edge)) > 20.0 * skd::Norm(normal))
      {
        ASSERT_EQ(heldAt(lane, pcoords) >> lane & 1u, 0u);
        ++outside;
      }
    }
  }
  EXPECT_GT(outside, 300);
}

TEST(PlaneRow, ADirectionWithoutLengthExcludesNothing)
{
  const Vector3 points[1] = { { { 0.0, 0.0, 0.0 } } };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector3& direction : { Vector3{ { 0.0, 0.0, 0.0 } }, Vector3{ { nan, 0.0, 0.0 } } })
  {
    skd::PlaneRow row;
    row.SetAlongFace(2, direction, points[0], points, 1, 0.0);
    const skd::WholePoint far(Vector3{ { 3e4, -3e4, 3e4 } });
    EXPECT_EQ(NegativeLanes(row.Inside(far)), 0u);
  }
}

}
