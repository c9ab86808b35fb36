// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: a Source that is moved by properties.

#include "Support/MotionRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkTransform.h"

#include <set>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

/// Whatever was executed before, the output is that of an operation on the moved Source.
TEST(BooleanOperationMotion, IsThatOfAMovedSource)
{
  for (int number = 0; number < 12; ++number)
  {
    Random random(static_cast<std::uint64_t>(number));
    std::string what;
    const Mesh body = AnySolid(random, what); // may intersect itself
    const Mesh tool = AnySolid(random, what);
    SCOPED_TRACE(what);
    vtkNew<Filter> filter;
    filter->SetInputData(MakePolyData(body));
    filter->SetSourceData(MakePolyData(tool));
    filter->SetOperation(number % 5);
    for (int step = 0; step < 5; ++step)
    {
      const Point shift = 0.4 * random.Direction();
      const Point angles = step < 2 ? Point{ 0, 0, 0 } : 90.0 * random.Direction();
      vtkNew<vtkTransform> transform;
      if (step < 4)
      {
        transform->Translate(shift.data());
        transform->RotateZ(angles[2]);
        transform->RotateX(angles[0]);
        transform->RotateY(angles[1]);
        filter->SetTranslation(shift.data());
        filter->SetRotation(angles.data());
      }
      else // back to where it was
      {
        filter->SetTranslation(0, 0, 0);
        filter->SetRotation(0, 0, 0);
      }
      Mesh moved = tool;
      moved.Map([&](const Point& x) { return Moved(transform->GetMatrix(), x); });
      ExpectEqual(RunSolid(filter), Combine(body, moved, number % 5));
    }
  }
}

TEST(BooleanOperationMotion, InputsAreNotedWhenTheyChange)
{
  vtkNew<Filter> filter;
  const auto box = [](double size) { return BoxTriangles({ 0, 0, 0 }, { size, size, size }); };
  filter->SetInputData(MakePolyData(box(2)));
  filter->SetSourceData(MakePolyData(box(1)));
  filter->SetOperationToDifference();
  filter->SetTranslation(1.5, 0, 0);
  EXPECT_NEAR(Measures(RunSolid(filter)).Volume, 7.5, 1e-14);
  filter->SetInputData(MakePolyData(box(3)));
  EXPECT_NEAR(Measures(RunSolid(filter)).Volume, 26.0, 1e-13);
  filter->SetSourceData(MakePolyData(box(1.5)));
  EXPECT_NEAR(Measures(RunSolid(filter)).Volume, 27.0 - 3.375, 1e-13);
  filter->SetTranslation(0, 0, 0);
  filter->SetInputData(MakePolyData(box(2)));
  EXPECT_NEAR(Measures(RunSolid(filter)).Volume, 8.0 - 3.375, 1e-13);
  filter->SetTranslation(1, 1, 1);
  filter->SetInputData(MakePolyData(Mesh()));
  filter->SetOperationToUnion();
  EXPECT_NEAR(Measures(RunSolid(filter)).Volume, 3.375, 1e-13);
}

/// A reflection leaves the outside outside, and sheets have their normals reflected.
TEST(BooleanOperationMotion, MayReflect)
{
  vtkNew<vtkMatrix4x4> mirror;
  mirror->SetElement(0, 0, -1.0);
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(BoxTriangles({ -2, 0, 0 }, { 2, 1, 1 })));
  filter->SetSourceData(MakePolyData(BoxTriangles({ 1, 0, 0 }, { 3, 1, 1 })));
  filter->SetInsideRuleToPositive();
  filter->SetTransform(mirror);
  EXPECT_NEAR(Measures(RunSolid(filter)).Volume, 5.0, 1e-14);
  vtkNew<vtkMatrix4x4> wrong;
  wrong->SetElement(0, 0, 2.0);
  EventCounter events(filter);
  filter->SetTransform(wrong);
  EXPECT_EQ(events.Errors, 1);
  EXPECT_EQ(filter->GetTransform()->GetElement(0, 0), -1.0);
}

/// Triangles that rounding makes flat are left out, and what is left is closed.
TEST(BooleanOperationMotion, FarAwayPointsMayBecomeOne)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(BoxTriangles({ 0, 0, 0 }, { 1, 1, 1 })));
  Mesh tool = Outward(SphereTriangles(8));
  filter->SetSourceData(MakePolyData(tool));
  for (const double far : { 1e14, 1e15, 4e15 })
  {
    filter->SetTranslation(far, 0, 0);
    EXPECT_EQ(CountBadEdges(RunSolid(filter)), 0);
  }
  filter->SetTranslation(1.7e308, 1.7e308, 0);
  filter->SetRotation(0, 0, 45);
  filter->SetRotationCenter(-1.7e308, 1.7e308, 0);
  EventCounter events(filter);
  filter->SetInputData(MakePolyData(BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 })));
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  filter->SetTranslation(5, 0, 0);
  filter->SetRotation(0, 0, 0);
  EXPECT_NEAR(Measures(RunSolid(filter)).Volume, 8.0 + Measures(tool).Volume, 1e-13);
}

/// Bodies of the Source that are apart by no more than rounding touch after some motions and not
/// after others. Where pieces are joined, the walls between them are taken out.
TEST(BooleanOperationMotion, BodiesThatRoundingMovesTogether)
{
  Mesh body = BoxTriangles({ 0, 0, 0 }, { 1, 1, 1 });
  Append(body, BoxTriangles({ 0, 0, -5 }, { 1, 1, -4 })); // so that sizes stay the same
  Mesh tool = BoxTriangles({ 0.3, 0.3, 0.3 }, { 0.7, 0.7, 0.7 });
  const double next = 0.7 + 2e-16; // the next number
  Append(tool, BoxTriangles({ 0.4, 0.4, next }, { 0.6, 0.6, 1.3 }));
  for (const bool joins : { true, false })
  {
    vtkNew<Filter> filter;
    filter->SetInputData(MakePolyData(body));
    filter->SetSourceData(MakePolyData(tool));
    filter->SetJoinPieces(joins);
    std::set<std::size_t> numbers; // of faces
    for (int step = 0; step < 12; ++step)
    {
      vtkNew<vtkTransform> transform;
      transform->Translate(0.01 * step, 0.02, step < 2 ? 0.0 : 0.1 * step);
      transform->RotateX(step < 6 ? 0.0 : 7.0 * step);
      filter->SetTransform(transform->GetMatrix());
      Mesh moved = tool;
      moved.Map([&](const Point& x) { return Moved(transform->GetMatrix(), x); });
      const Mesh result = RunSolid(filter);
      vtkNew<Filter> atOnce;
      atOnce->SetInputData(MakePolyData(body));
      atOnce->SetSourceData(MakePolyData(moved));
      atOnce->SetJoinPieces(joins);
      ExpectEqual(result, RunSolid(atOnce));
      numbers.insert(result.Cells.size());
    }
    EXPECT_GT(numbers.size(), joins ? 1u : 3u);
  }
}
}
