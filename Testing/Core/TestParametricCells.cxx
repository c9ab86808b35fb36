// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Volume cells: their maps, the inverses of these, and their nearest points.
#include "GeometryReference.h"

#include <gtest/gtest.h>

namespace
{

using coretest::Dice;
using skd::ClosestPointInCell;
using skd::Evaluate;
using skd::ParametricCoordinates;
using skd::Vector3;
using skd::VolumePoint;
using Points = std::vector<Vector3>;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr Vector3 Zero{ { 0.0, 0.0, 0.0 } };

template <class Shape>
class ParametricCells : public ::testing::Test
{
protected:
  Dice Random{ 14 };

  /// How far points may be moved so that the shape is still what it is: a voxel is not warped.
  static constexpr double Bendable = std::is_same_v<Shape, skd::Voxel> ? 0.0 : 1.0;

  Points Cell(double warp) { return coretest::RandomCell<Shape>(this->Random, Bendable * warp); }
  Vector3 Position() { return coretest::MoveIntoDomain<Shape>(this->Random); }

  static VolumePoint Closest(const Points& points, const Vector3& x, double limit2 = Infinity)
  {
    return ClosestPointInCell<Shape>(points.data(), x, limit2);
  }

  /// Whether the parametric coordinates are in the domain, and give the point at that distance.
  static void ExpectConsistent(
    const Points& points, const Vector3& x, const VolumePoint& found, double tolerance)
  {
    const Vector3 clamped = Shape::ClampToDomain(found.PCoords);
    EXPECT_LE(skd::MaxNorm(found.PCoords - clamped), 1e-15);
    const Vector3 fromX = Evaluate<Shape>(points.data(), found.PCoords, x);
    EXPECT_NEAR(skd::Norm(fromX), std::sqrt(found.Dist2), tolerance);
    EXPECT_LE(skd::Norm(fromX - (found.Point - x)), tolerance);
  }

  /// A point that was computed in the cell is in it.
  void ExpectFound(const Points& points, double tolerance)
  {
    const Vector3 x = Evaluate<Shape>(points.data(), this->Position(), Zero);
    const VolumePoint found = Closest(points, x);
    EXPECT_LE(std::sqrt(found.Dist2), tolerance);
    ExpectConsistent(points, x, found, 10.0 * tolerance);
  }
};

using Shapes =
  ::testing::Types<skd::Tetrahedron, skd::Voxel, skd::Hexahedron, skd::Wedge, skd::Pyramid>;

struct ShapeNames
{
  template <class Shape>
  static std::string GetName(int index)
  {
    static const char* names[] = { "Tetrahedron", "Voxel", "Hexahedron", "Wedge", "Pyramid" };
    return names[index];
  }
};

TYPED_TEST_SUITE(ParametricCells, Shapes, ShapeNames);

TYPED_TEST(ParametricCells, WeightsAreOneAtTheirOwnCornerAndSumToOne)
{
  double weights[8];
  for (int corner = 0; corner < TypeParam::Size; ++corner)
  {
    const double* p = TypeParam::Corners[corner];
    TypeParam::Weights({ { p[0], p[1], p[2] } }, weights);
    for (int i = 0; i < TypeParam::Size; ++i)
    {
      EXPECT_EQ(weights[i], i == corner ? 1.0 : 0.0);
    }
  }
  TypeParam::Weights(this->Position(), weights);
  double sum = 0.0;
  for (int i = 0; i < TypeParam::Size; ++i)
  {
    EXPECT_GE(weights[i], -1e-16);
    sum += weights[i];
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
}

// Weights are linear along each parametric coordinate: differences are exact derivatives.
TYPED_TEST(ParametricCells, DerivativesAreDifferencesOfWeights)
{
  const Vector3 p = this->Position();
  double derivatives[24];
  TypeParam::Derivatives(p, derivatives);
  for (int axis = 0; axis < 3; ++axis)
  {
    double low[8];
    double high[8];
    Vector3 end = p;
    end[axis] = 0.0;
    TypeParam::Weights(end, low);
    end[axis] = 1.0;
    TypeParam::Weights(end, high);
    for (int i = 0; i < TypeParam::Size; ++i)
    {
      EXPECT_NEAR(derivatives[axis * TypeParam::Size + i], high[i] - low[i], 1e-15);
    }
  }
}

TYPED_TEST(ParametricCells, PositionsOnFacesAreWhereTheMapPutsThem)
{
  const Points points = this->Cell(0.3);
  for (int face = 0; face < TypeParam::NumberOfFaces; ++face)
  {
    const skd::CellFace<TypeParam> corners(points.data(), face);
    const Vector3 x = this->Random.Point(1.0);
    const skd::PatchPoint onFace = corners.ClosestPoint(x, Infinity);
    const Vector3 pcoords = skd::PCoordsOnFace<TypeParam>(face, onFace.R, onFace.S);
    EXPECT_TRUE(TypeParam::InDomain(TypeParam::ClampToDomain(pcoords)));
    EXPECT_LE(skd::Norm(Evaluate<TypeParam>(points.data(), pcoords, Zero) - onFace.Point), 2e-15);
  }
}

TYPED_TEST(ParametricCells, ThePositionOfAPointInAPlainCellIsFound)
{
  for (int i = 0; i < 1000; ++i)
  {
    const Points points =
      coretest::PlainCell<TypeParam>(this->Random, this->Random.Point(1.0), 0.1 * this->Bendable);
    const Vector3 position = this->Position();
    const Vector3 x = Evaluate<TypeParam>(points.data(), position, Zero);
    const std::optional<Vector3> found = ParametricCoordinates<TypeParam>(points.data(), x);
    if (found)
    {
      EXPECT_LE(skd::MaxNorm((1.0 - position[2]) * (*found - position)), 1e-13);
    }
    else
    {
      EXPECT_LE(std::sqrt(this->Closest(points, x).Dist2), 2e-15); // rounded out of the cell
    }
  }
}

TYPED_TEST(ParametricCells, PointsInsideAreInside)
{
  for (const double warp : { 0.0, 1e-9, 0.05, 0.3, 1.0 })
  {
    for (int i = 0; i < 1000; ++i)
    {
      this->ExpectFound(this->Cell(warp), 4e-15);
    }
  }
}

TYPED_TEST(ParametricCells, PointsInsideSliversAreInside)
{
  for (int i = 0; i < 2000; ++i)
  {
    const double thickness = std::pow(10.0, -this->Random.Between(1.0, 12.0));
    const Vector3 edges[3] = { this->Random.Point(1.0), this->Random.Point(1.0),
      thickness * this->Random.Point(1.0) };
    const double warp = 0.2 * thickness * this->Bendable;
    this->ExpectFound(
      coretest::CellFromEdges<TypeParam>(this->Random, this->Random.Point(1.0), edges, warp),
      4e-15);
  }
}

TYPED_TEST(ParametricCells, PointsInsideCellsWithCollapsedPointsAreInside)
{
  if (this->Bendable == 0.0)
  {
    return; // a voxel with collapsed points is no voxel
  }
  for (int i = 0; i < 2000; ++i)
  {
    Points points = this->Cell(i % 3 * 0.2);
    for (int collapse = 0; collapse <= i % 4; ++collapse)
    {
      points[this->Random.Below(TypeParam::Size)] = points[this->Random.Below(TypeParam::Size)];
    }
    this->ExpectFound(points, 4e-15);
  }
}

TYPED_TEST(ParametricCells, PointsOutsideAreNearestToAFace)
{
  for (int i = 0; i < 150; ++i)
  {
    const Points points = this->Cell(0.3 * (i % 3));
    const Vector3 x = this->Random.Point(2.5);
    const VolumePoint found = this->Closest(points, x);
    this->ExpectConsistent(points, x, found, 4e-15);
    if (coretest::IsInsideByNewton<TypeParam>(points.data(), x))
    {
      EXPECT_LE(std::sqrt(found.Dist2), 4e-15);
    }
    else
    {
      const double faces = coretest::FacesDistance<TypeParam>(points.data(), x);
      EXPECT_NEAR(std::sqrt(found.Dist2), faces, 4e-15);
    }
  }
}

TYPED_TEST(ParametricCells, CellsWithoutVolumeAreMeasuredByTheirFaces)
{
  for (int i = 0; i < 60; ++i)
  {
    const int rank = i % 3; // a point, a segment, a flat
    const Vector3 edges[3] = { (rank > 0 ? 1.0 : 0.0) * this->Random.Point(1.0),
      (rank > 1 ? 1.0 : 0.0) * this->Random.Point(1.0), Zero };
    const Points points =
      coretest::CellFromEdges<TypeParam>(this->Random, this->Random.Point(1.0), edges, 0.0);
    const Vector3 x = this->Random.Point(2.0);
    const VolumePoint found = this->Closest(points, x);
    EXPECT_NEAR(
      std::sqrt(found.Dist2), coretest::FacesDistance<TypeParam>(points.data(), x), 4e-15);
    this->ExpectConsistent(points, x, found, 4e-15);
    this->ExpectFound(points, 4e-15);
  }
}

TYPED_TEST(ParametricCells, ALimitHidesOnlyWhatIsBeyondIt)
{
  for (int i = 0; i < 1000; ++i)
  {
    const Points points = this->Cell(0.1 * (i % 5));
    const Vector3 x = this->Random.Point(3.0);
    const double dist2 = this->Closest(points, x).Dist2;
    const double within = this->Closest(points, x, dist2 * (1.0 + 1e-12) + 1e-30).Dist2;
    EXPECT_NEAR(std::sqrt(within), std::sqrt(dist2), 1e-15);
    EXPECT_GE(this->Closest(points, x, 0.25 * dist2).Dist2, dist2 * (1.0 - 1e-12));
  }
}

TYPED_TEST(ParametricCells, CornersAreInTheCell)
{
  for (int i = 0; i < 300; ++i)
  {
    const Points points = this->Cell(0.2);
    for (const Vector3& corner : points)
    {
      EXPECT_LE(std::sqrt(this->Closest(points, corner, 1e-28).Dist2), 2e-15);
    }
  }
}

// Grids far from the origin: what remains of the coordinates is all that counts.
TYPED_TEST(ParametricCells, ALargeCommonOffsetCostsNothingMore)
{
  for (int i = 0; i < 100; ++i)
  {
    const Vector3 offset = this->Random.Point(std::pow(10.0, this->Random.Between(6.0, 9.0)));
    const Points points =
      coretest::PlainCell<TypeParam>(this->Random, offset, 0.1 * this->Bendable);
    const Vector3 x = offset + this->Random.Point(1.5);
    const double distance = std::sqrt(this->Closest(points, x).Dist2);
    const bool isInside = coretest::IsInsideByNewton<TypeParam>(points.data(), x);
    EXPECT_NEAR(
      distance, isInside ? 0.0 : coretest::FacesDistance<TypeParam>(points.data(), x), 4e-15);
  }
}

TYPED_TEST(ParametricCells, WorksAtAllScales)
{
  for (const double scale : { 1e-45, 1e-15, 1e15, 1e45 })
  {
    for (int i = 0; i < 100; ++i)
    {
      Points points = this->Cell(0.2);
      const Vector3 x = this->Random.Point(1.5);
      const double plain = std::sqrt(this->Closest(points, x).Dist2);
      for (Vector3& point : points)
      {
        point = scale * point;
      }
      EXPECT_NEAR(std::sqrt(this->Closest(points, scale * x).Dist2) / scale, plain, 1e-14) << scale;
    }
  }
}

TYPED_TEST(ParametricCells, NaNAndInfinityGiveNoDistance)
{
  const Points points = this->Cell(0.1);
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), Infinity, -Infinity })
  {
    EXPECT_FALSE(this->Closest(points, { { bad, 0.0, 0.0 } }).Dist2 < 1e300);
    EXPECT_FALSE(this->Closest(points, { { 0.0, 0.0, bad } }, 1.0).Dist2 < 1e300);
    EXPECT_FALSE(ParametricCoordinates<TypeParam>(points.data(), { { 0.0, bad, 0.0 } }));
  }
}

}
