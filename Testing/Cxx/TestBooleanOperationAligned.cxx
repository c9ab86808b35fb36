// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: faces that are flush but for the rounding of points to floats are put
// in one plane (AlignFaces). Volumes and areas of boxes are known; chains are in
// TestBooleanOperationChains.

#include "Support/ClosedSurface.h"
#include "Support/Reported.h"
#include "Support/SolidRun.h"
#include "Support/TestAmount.h"

#include "vtkCylinderSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <limits>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;
using Surface = vtkSmartPointer<vtkPolyData>;
constexpr double FloatRounding = 0.5 * std::numeric_limits<float>::epsilon();

Surface TurnedBox(
  const RandomRotation& rotation, const Point& low, const Point& high, int pointType = VTK_FLOAT)
{
  return MakePolyData(BoxTriangles(low, high).Map(rotation), pointType);
}

Surface OutputOf(Filter* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

Surface Combine(const Surface& input, const Surface& source, int operation, bool aligns = true)
{
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetSourceData(source);
  filter->SetOperation(operation);
  filter->SetAlignFaces(aligns);
  filter->Update();
  const Surface output = OutputOf(filter);
  EXPECT_EQ(Reported(output, "BadEdges"), 0.0);
  ExpectClosed(output);
  return output;
}

void ExpectMeasures(const Surface& made, double volume, double area)
{
  EXPECT_NEAR(Reported(made, "Volume"), volume, 1e-6 * volume);
  EXPECT_NEAR(Reported(made, "Area"), area, 1e-6 * area);
}

/// The least distance of each point of one surface from those of another, the largest of all.
double FarthestFrom(vtkPolyData* some, vtkPolyData* others)
{
  double farthest = 0.0;
  for (vtkIdType i = 0; i < some->GetNumberOfPoints(); ++i)
  {
    double least = std::numeric_limits<double>::infinity();
    for (vtkIdType k = 0; k < others->GetNumberOfPoints(); ++k)
    {
      Point a, b;
      some->GetPoint(i, a.data());
      others->GetPoint(k, b.data());
      least = std::min(least, Distance(a, b));
    }
    farthest = std::max(farthest, least);
  }
  return farthest;
}

TEST(BooleanOperationAligned, OnlyIfItIsOn)
{
  Random random(501);
  int surplus = 0;
  for (int turn = 0; turn < 20; ++turn)
  {
    const RandomRotation rotation(random, false);
    const Surface block = TurnedBox(rotation, { 0, 0, 0 }, { 2, 2, 2 });
    const Surface notch = TurnedBox(rotation, { 0, 1, 0 }, { 2, 2, 1 });
    const Surface aligned = Combine(block, notch, Filter::DIFFERENCE);
    ExpectMeasures(aligned, 6.0, 22.0);
    EXPECT_GT(Reported(aligned, "PointsAligned"), 0.0);
    EXPECT_EQ(Reported(aligned, "CoordinateBits"), 24.0);
    const Surface asIs = Combine(block, notch, Filter::DIFFERENCE, false);
    EXPECT_EQ(Reported(asIs, "PointsAligned"), 0.0);
    surplus += Reported(asIs, "Area") > 22.5;
  }
  EXPECT_GT(surplus, 10);
}

TEST(BooleanOperationAligned, PointsMoveByRoundingsOnly)
{
  Random random(502);
  for (int turn = 0; turn < 10; ++turn)
  {
    const RandomRotation rotation(random, false);
    const Surface block = TurnedBox(rotation, { 0, 0, 0 }, { 2, 2, 2 });
    const Surface peg = TurnedBox(rotation, { 0.5, 2, 0.5 }, { 1.5, 3, 1.5 });
    const Surface both = Combine(block, peg, Filter::UNION);
    EXPECT_LE(FarthestFrom(block, both), 128 * 4.0 * FloatRounding);
    EXPECT_LE(FarthestFrom(peg, both), 128 * 4.0 * FloatRounding);
    ExpectMeasures(both, 9.0, 28.0);
  }
}

TEST(BooleanOperationAligned, PointsOfDoublesStay)
{
  Random random(503);
  for (int turn = 0; turn < 10; ++turn)
  {
    const RandomRotation rotation(random, false);
    const Surface block = TurnedBox(rotation, { 0, 0, 0 }, { 2, 2, 2 }, VTK_DOUBLE);
    const Surface peg = TurnedBox(rotation, { 0.5, 2, 0.5 }, { 1.5, 3, 1.5 });
    const Surface both = Combine(block, peg, Filter::UNION);
    ExpectMeasures(both, 9.0, 28.0);
    EXPECT_EQ(FarthestFrom(block, both), 0.0);
    const Surface pegOfDoubles = TurnedBox(rotation, { 0.5, 2, 0.5 }, { 1.5, 3, 1.5 }, VTK_DOUBLE);
    const Surface ofDoubles = Combine(block, pegOfDoubles, Filter::UNION);
    EXPECT_EQ(Reported(ofDoubles, "PointsAligned"), 0.0);
    EXPECT_EQ(Reported(ofDoubles, "CoordinateBits"), 53.0);
  }
}

/// Its other faces are of one triangle each, which say nothing of where its points are to be.
TEST(BooleanOperationAligned, TetrahedronOfFloatsOnABlockOfDoubles)
{
  Random random(508);
  Mesh tetrahedron;
  tetrahedron.Points = { { 0.5, 2, 0.5 }, { 1.5, 2, 0.5 }, { 0.5, 2, 1.5 }, { 0.6, 3, 0.7 } };
  for (const Ids& face : { Ids{ 0, 1, 2 }, Ids{ 0, 3, 1 }, Ids{ 1, 3, 2 }, Ids{ 2, 3, 0 } })
  {
    tetrahedron.Add(VTK_TRIANGLE, face);
  }
  for (int turn = 0; turn < 20; ++turn)
  {
    SCOPED_TRACE(turn);
    const RandomRotation rotation(random, false);
    const Surface block = TurnedBox(rotation, { 0, 0, 0 }, { 2, 2, 2 }, VTK_DOUBLE);
    Mesh turned = tetrahedron;
    const Surface peak = MakePolyData(turned.Map(rotation), VTK_FLOAT);
    const Surface both = Combine(block, peak, Filter::UNION);
    EXPECT_NEAR(Reported(both, "Volume"), 8.0 + 1.0 / 6.0, 1e-5);
    EXPECT_NEAR(Reported(both, "Area"),
      24.0 + Reported(Combine(peak, peak, Filter::UNION), "Area") - 1.0, 1e-5);
  }
}

/// Outputs are doubles, but say that they are of floats.
TEST(BooleanOperationAligned, OutputsOfOperationsBefore)
{
  Random random(504);
  for (int turn = 0; turn < 20; ++turn)
  {
    SCOPED_TRACE(turn);
    const RandomRotation rotation(random, false);
    const auto box = [&](const Point& low, const Point& high)
    { return TurnedBox(rotation, low, high); };
    const Surface first =
      Combine(box({ 0, 0, 0 }, { 2, 2, 2 }), box({ 2, 0, 0 }, { 4, 2, 1 }), Filter::UNION);
    ExpectMeasures(first, 12.0, 36.0);
    const Surface second =
      Combine(box({ 1, 1, 0 }, { 3, 2, 1 }), box({ 1, 0, 1 }, { 2, 2, 2 }), Filter::UNION);
    const Surface made = Combine(first, second, Filter::DIFFERENCE);
    // 8 + 4 - 2 - 2; the faces of cubes of 1 that are not between two of the rest.
    ExpectMeasures(made, 8.0, 32.0);
  }
}

TEST(BooleanOperationAligned, ChangesWithItsPropertyAndInputs)
{
  Random random(505);
  const RandomRotation rotation(random, false);
  vtkNew<Filter> filter;
  for (const double height : { 1.0, 0.5, 1.0 })
  {
    const Surface block = TurnedBox(rotation, { 0, 0, 0 }, { 2, 2, 2 });
    const Surface notch = TurnedBox(rotation, { 0, height, 0 }, { 2, 2, 1 });
    filter->SetInputData(block);
    filter->SetSourceData(notch);
    filter->SetOperationToDifference();
    for (const bool aligns : { true, false, true })
    {
      filter->SetAlignFaces(aligns);
      filter->Update();
      const Surface fresh = Combine(block, notch, Filter::DIFFERENCE, aligns);
      EXPECT_EQ(Reported(OutputOf(filter), "Area"), Reported(fresh, "Area"));
      EXPECT_EQ(Reported(OutputOf(filter), "PointsAligned"), Reported(fresh, "PointsAligned"));
    }
  }
}

/// Sides of cylinders are flush with each other, at small angles to those beside them.
TEST(BooleanOperationAligned, StackedCylinders)
{
  for (const int sides : { 3, 6, 17, 64, 200 })
  {
    SCOPED_TRACE(sides);
    vtkNew<vtkMultiBlockDataSet> all;
    for (unsigned int i = 0; i < 5; ++i)
    {
      vtkNew<vtkCylinderSource> cylinder;
      cylinder->SetResolution(sides);
      cylinder->SetCenter(0.0, 0.5 + i, 0.0);
      cylinder->SetRadius(1.0);
      vtkNew<vtkTransform> turn;
      turn->RotateWXYZ(37.0, 1.0, 2.0, 3.0);
      vtkNew<vtkTransformPolyDataFilter> turned;
      turned->SetTransform(turn);
      turned->SetInputConnection(cylinder->GetOutputPort());
      turned->Update();
      all->SetBlock(i, turned->GetOutput());
    }
    vtkNew<Filter> filter;
    filter->SetInputDataObject(0, all);
    filter->Update();
    const double angle = 3.14159265358979323846 / sides;
    const double end = sides * std::sin(angle) * std::cos(angle);
    ExpectMeasures(OutputOf(filter), 5.0 * end, 2.0 * end + 5.0 * 2.0 * sides * std::sin(angle));
    EXPECT_EQ(Reported(OutputOf(filter), "BadEdges"), 0.0);
  }
}

/// Roundings are those of each coordinate along its axis: heights far from the origin are exact.
TEST(BooleanOperationAligned, HeightsFarFromTheOriginStay)
{
  const Point corner = { 500000, 4000000, 30 };
  const auto box = [&](const Point& low, const Point& high)
  { return MakePolyData(BoxTriangles(corner + low, corner + high), VTK_FLOAT); };
  const Surface house = box({ 0, 0, 0 }, { 200, 200, 30 });
  const Surface beside = Combine(house, box({ 200, 0, 0 }, { 400, 200, 33 }), Filter::UNION);
  ExpectMeasures(beside, 2520000.0, 198400.0);
  EXPECT_EQ(Reported(beside, "PointsAligned"), 0.0);
  const Surface sunk = box({ 50, 50, 28 }, { 150, 150, 40 });
  ExpectMeasures(Combine(house, sunk, Filter::INTERSECTION), 20000.0, 20800.0);
}

/// Their two sides are in one plane to within roundings, too.
TEST(BooleanOperationAligned, ThinLayersStay)
{
  Random random(506);
  const RandomRotation rotation(random, false);
  constexpr double thickness = 4.0 * FloatRounding;
  vtkNew<vtkMultiBlockDataSet> layers;
  for (unsigned int i = 0; i < 15; ++i)
  {
    const double low = i * thickness;
    layers->SetBlock(i, TurnedBox(rotation, { 0, 0, low }, { 1, 1, low + thickness }, VTK_FLOAT));
  }
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, layers);
  filter->Update();
  EXPECT_NEAR(Reported(OutputOf(filter), "Volume"), 15.0 * thickness, 2.0 * FloatRounding);
}

/// Neighbours share their points to the last bit: nothing is off.
TEST(BooleanOperationAligned, RowsOfEqualBoxesStay)
{
  Random random(507);
  const RandomRotation rotation(random, false);
  Mesh row;
  for (int i = 0; i < 200; ++i)
  {
    Append(row, BoxTriangles({ 1.0 * i, 0, 0 }, { i + 1.0, 1, 1 }));
  }
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(row.Map(rotation), VTK_FLOAT));
  filter->Update();
  EXPECT_EQ(Reported(OutputOf(filter), "PointsAligned"), 0.0);
  EXPECT_NEAR(Reported(OutputOf(filter), "Area"), 802.0, 1e-3);
}

/// Faces are the same however cells are ordered: caps of slivers, too.
TEST(BooleanOperationAligned, CoaxialCylindersOfManySides)
{
  const auto cylinder = [](double radius, double height)
  {
    vtkNew<vtkCylinderSource> made;
    made->SetResolution(300);
    made->SetCenter(0.0, 0.5 * height, 0.0);
    made->SetHeight(std::abs(height));
    made->SetRadius(radius);
    vtkNew<vtkTransform> turn;
    turn->RotateWXYZ(37.0, 1.0, 2.0, 3.0);
    vtkNew<vtkTransformPolyDataFilter> turned;
    turned->SetTransform(turn);
    turned->SetInputConnection(made->GetOutputPort());
    turned->Update();
    return Surface(turned->GetOutput());
  };
  const double angle = 3.14159265358979323846 / 300;
  const double end = 300 * std::sin(angle) * std::cos(angle);
  const double side = 2.0 * 300 * std::sin(angle);
  ExpectMeasures(Combine(cylinder(1.0, 1.0), cylinder(0.6, -1.0), Filter::UNION),
    end * (1.0 + 0.36), 2.0 * end + side * (1.0 + 0.6));
}
}
