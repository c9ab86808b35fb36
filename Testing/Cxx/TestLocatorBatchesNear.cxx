// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Batches of neighbours, of weights, of segments and of rays have the results of single queries.

#include "Support/EventCounter.h"
#include "Support/LocatorOnMesh.h"

#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace skdtest;

namespace
{
constexpr int NumberOfQueries = 300; // of more than one thread's piece

/// Rows of numbers as an array.
vtkSmartPointer<vtkDoubleArray> ToArray(const std::vector<std::vector<double>>& rows)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(static_cast<int>(rows[0].size()));
  for (const std::vector<double>& row : rows)
  {
    array->InsertNextTuple(row.data());
  }
  return array;
}

class BatchesNear : public BuiltLocator
{
protected:
  BatchesNear()
    : Length(Diagonal(this->Box))
  {
    Random random(190);
    for (int i = 0; i < NumberOfQueries; ++i)
    {
      const Point x = random.InBox(Grown(this->Box, 0.2 * this->Length));
      this->Points.push_back(x);
      this->Rows.push_back({ x[0], x[1], x[2] });
      this->Spheres.push_back({ x[0], x[1], x[2], 0.02 * this->Length * random.Index(10) });
    }
    this->Rows[99][2] = std::nan("");
    this->Points[99][2] = std::nan("");
    this->Spheres[99][3] = -1.0;
  }

  void ExpectNeighbours()
  {
    constexpr int n = 5;
    vtkNew<vtkIdTypeArray> ids, offsets, lists;
    vtkNew<vtkDoubleArray> distances, listed;
    const double limit = 0.3 * this->Length;
    this->Locator->FindClosestNCells(ToArray(this->Rows), n, ids, distances);
    const vtkIdType number =
      this->Locator->FindCellsWithinSpheres(ToArray(this->Spheres), offsets, lists, listed);
    EXPECT_EQ(number, lists->GetNumberOfTuples());
    for (int i = 0; i < NumberOfQueries; ++i)
    {
      const Ranked near = FindClosestCells(this->Locator, this->Points[i], n);
      for (int k = 0; k < n; ++k)
      {
        const bool isFound = k < near.Number;
        ASSERT_EQ(ids->GetTypedComponent(i, k), isFound ? near.Cells[k] : -1) << i;
        ASSERT_TRUE(isFound ? distances->GetTypedComponent(i, k) == near.Distances[k]
                            : std::isnan(distances->GetTypedComponent(i, k)));
      }
      const Point centre{ this->Spheres[i][0], this->Spheres[i][1], this->Spheres[i][2] };
      const Ranked in = FindWithinRadius(this->Locator, centre, this->Spheres[i][3]);
      const vtkIdType first = offsets->GetValue(i);
      ASSERT_EQ(offsets->GetValue(i + 1) - first, in.Number) << i;
      for (vtkIdType k = 0; k < in.Number; ++k)
      {
        EXPECT_EQ(lists->GetValue(first + k), in.Cells[k]);
        EXPECT_EQ(listed->GetValue(first + k), in.Distances[k]);
      }
    }
    vtkNew<vtkDoubleArray> limited;
    this->Locator->FindClosestNCells(ToArray(this->Rows), n, nullptr, limited, limit);
    for (vtkIdType i = 0; i < limited->GetNumberOfValues(); ++i)
    {
      const double distance = distances->GetValue(i);
      ASSERT_TRUE(
        distance <= limit ? limited->GetValue(i) == distance : std::isnan(limited->GetValue(i)));
    }
  }

  void ExpectWeights()
  {
    vtkNew<vtkIdTypeArray> ids, pointIds;
    vtkNew<vtkDoubleArray> pcoords, weights;
    const double tol2 = 0.01 * this->Length * this->Length;
    this->Locator->FindCellsAndWeights(ToArray(this->Rows), ids, pcoords, pointIds, weights, tol2);
    vtkNew<vtkIdList> corners;
    for (int i = 0; i < NumberOfQueries; ++i)
    {
      const Found cell = FindCell(this->Locator, this->Points[i], tol2);
      ASSERT_EQ(ids->GetValue(i), cell.Cell) << i;
      corners->Reset();
      if (cell.Cell >= 0)
      {
        this->Data->GetCellPoints(cell.Cell, corners);
      }
      const int width = weights->GetNumberOfComponents();
      ASSERT_LE(corners->GetNumberOfIds(), width);
      for (int k = 0; k < width; ++k)
      {
        const bool isCorner = k < corners->GetNumberOfIds();
        const double weight = weights->GetTypedComponent(i, k);
        ASSERT_EQ(pointIds->GetTypedComponent(i, k), isCorner ? corners->GetId(k) : -1);
        const double expected = isCorner ? cell.Weights[k] : 0.0;
        ASSERT_TRUE(cell.Cell < 0 ? std::isnan(weight) : weight == expected) << i;
      }
    }
  }

  double Length;
  std::vector<Point> Points;
  std::vector<std::vector<double>> Rows, Spheres;
};

INSTANTIATE_TEST_SUITE_P(All, BatchesNear, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(BatchesNear, AnswerAsQueriesForOne)
{
  this->ExpectNeighbours();
  this->ExpectWeights();
  vtkNew<vtkMatrix4x4> motion; // a quarter turn and a shift
  const double values[16] = { 0, -1, 0, 0.5, 1, 0, 0, 0, 0, 0, 1, -0.25, 0, 0, 0, 1 };
  motion->DeepCopy(values);
  this->Locator->SetTransform(motion);
  this->ExpectNeighbours();
  this->ExpectWeights();
}

/// A ray that may go as far as a line is long hits what the line hits; one without end all there
/// is.
TEST_P(BatchesNear, RaysHitWhatLinesHit)
{
  std::vector<std::vector<double>> directions, lines;
  for (int i = 0; i < NumberOfQueries; ++i)
  {
    const Point& from = this->Points[i];
    const Point along = this->Points[(i + 1) % NumberOfQueries] - from;
    const Point to = from + (4.0 * this->Length / skdtest::Length(along)) * along;
    directions.push_back({ along[0], along[1], along[2] });
    lines.push_back({ from[0], from[1], from[2], to[0], to[1], to[2] });
  }
  vtkNew<vtkIdTypeArray> ids, lineIds, offsets, lineOffsets;
  vtkNew<vtkDoubleArray> distances, ts, xs, lineXs;
  const auto origins = ToArray(this->Rows);
  const vtkIdType found =
    this->Locator->IntersectWithRays(origins, ToArray(directions), ids, distances, xs);
  EXPECT_EQ(found, this->Locator->IntersectWithLines(ToArray(lines), lineIds, ts, lineXs));
  for (int i = 0; i < NumberOfQueries; ++i)
  {
    const bool isHit = lineIds->GetValue(i) >= 0;
    ASSERT_EQ(ids->GetValue(i) >= 0, isHit) << i;
    for (int axis = 0; isHit && axis < 3; ++axis)
    {
      EXPECT_NEAR(
        xs->GetTypedComponent(i, axis), lineXs->GetTypedComponent(i, axis), 1e-9 * this->Length);
    }
    if (isHit)
    {
      EXPECT_NEAR(
        distances->GetValue(i), 4.0 * this->Length * ts->GetValue(i), 1e-9 * this->Length);
    }
  }
  this->Locator->FindAllRayHits(origins, ToArray(directions), offsets, ids, distances, nullptr);
  this->Locator->FindAllHits(ToArray(lines), lineOffsets, lineIds, nullptr, nullptr);
  for (int i = 0; i <= NumberOfQueries; ++i)
  {
    ASSERT_EQ(offsets->GetValue(i), lineOffsets->GetValue(i)) << i;
  }
}

void ExpectSameBytes(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  const vtkIdType size = a->GetNumberOfValues() * a->GetDataTypeSize();
  EXPECT_TRUE(size == 0 || !std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size));
}

TEST_P(BatchesNear, SegmentsWithEndsInTwoArraysAreLines)
{
  std::vector<std::vector<double>> ends = this->Rows, lines;
  std::rotate(ends.begin(), ends.begin() + 1, ends.end());
  for (int i = 0; i < NumberOfQueries; ++i)
  {
    lines.push_back(this->Rows[i]);
    lines.back().insert(lines.back().end(), ends[i].begin(), ends[i].end());
  }
  vtkNew<vtkIdTypeArray> ids, lineIds, offsets, lineOffsets;
  vtkNew<vtkDoubleArray> ts, lineTs, xs, lineXs;
  const auto expectEqual = [&]
  {
    ExpectSameBytes(ids, lineIds);
    ExpectSameBytes(offsets, lineOffsets);
    ExpectSameBytes(ts, lineTs);
    ExpectSameBytes(xs, lineXs);
  };
  const auto from = ToArray(this->Rows), to = ToArray(ends), both = ToArray(lines);
  EXPECT_EQ(this->Locator->IntersectWithSegments(from, to, ids, ts, xs, 0.01),
    this->Locator->IntersectWithLines(both, lineIds, lineTs, lineXs, 0.01));
  expectEqual();
  EXPECT_EQ(this->Locator->FindAllSegmentHits(from, to, offsets, ids, ts, xs, 0.01),
    this->Locator->FindAllHits(both, lineOffsets, lineIds, lineTs, lineXs, 0.01));
  expectEqual();
}

TEST(BatchesOfRays, EndWhereTheyMayGoNoFarther)
{
  const auto locator = MakeLocator(MakeGrid(Hexahedra(2)));
  const auto origins = ToArray({ { -3, 0.25, 0.5 }, { -3, 0.25, 0.5 }, { 1e9, 0.25, 0.5 } });
  const auto along = ToArray({ { 2, 0, 0 }, { 0, 0, 0 }, { -1e300, 0, 0 } });
  vtkNew<vtkIdTypeArray> ids;
  EXPECT_EQ(locator->IntersectWithRays(origins, along, ids, nullptr, nullptr), 2);
  EXPECT_EQ(ids->GetValue(1), -1);
  EXPECT_EQ(locator->IntersectWithRays(origins, along, nullptr, nullptr, nullptr, 3.0), 1);
  EXPECT_EQ(locator->IntersectWithRays(origins, along, nullptr, nullptr, nullptr, 2.999), 0);
  EXPECT_EQ(locator->IntersectWithRays(origins, along, nullptr, nullptr, nullptr, -1.0), 0);
  EXPECT_EQ(locator->IntersectWithRays(origins, along, nullptr, nullptr, nullptr, std::nan("")), 0);
  EXPECT_EQ(MakeLocator(nullptr)->IntersectWithRays(origins, along, ids, nullptr, nullptr), 0);
}

TEST(BatchesOfRays, AndNeighboursThatCannotBeAskedAreRefused)
{
  const auto locator = MakeLocator(MakeGrid(Hexahedra(2)));
  const EventCounter events(locator);
  const auto two = ToArray({ { 0, 0, 0 }, { 1, 1, 1 } });
  const auto one = ToArray({ { 0, 0, 0 } });
  const auto wide = ToArray({ { 0, 0, 0, 1 } });
  EXPECT_EQ(locator->IntersectWithRays(two, one, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(locator->IntersectWithRays(one, nullptr, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(locator->FindAllRayHits(one, wide, nullptr, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(locator->IntersectWithSegments(two, one, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(locator->FindAllSegmentHits(one, nullptr, nullptr, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(locator->FindClosestNCells(one, 0, nullptr, nullptr), -1);
  EXPECT_EQ(locator->FindCellsWithinSpheres(one, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(locator->FindCellsAndWeights(wide, nullptr, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(events.Errors, 8);
}
}
