// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: of a Source that is moved again and again only what is near the Input
// is arranged, and the output is that of all.

#include "Support/InOutRun.h"
#include "Support/MotionRun.h"
#include "Support/Reported.h"
#include "Support/SurfaceMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

Mesh Sphere(int n, double size, const Point& centre = { 0, 0, 0 })
{
  return Transformed(Outward(SphereTriangles(n)), size, centre);
}

Mesh Torus(int n, double size)
{
  return Transformed(TorusTriangles(2 * n, n), size, { 0, 0, 0 });
}

/// Within it is nothing.
Mesh Hollow(int n, double size)
{
  return Together({ Sphere(n, size), Inverted(Sphere(n, 0.6 * size)) });
}

/// A closed surface that does not intersect itself.
Mesh MakeSolid(Random& random, std::string& what)
{
  const int n = 4 + random.Index(5);
  const int kind = random.Index(7);
  what += " " + std::to_string(kind) + "." + std::to_string(n);
  switch (kind)
  {
    case 0:
      return Torus(n, 0.8);
    case 1:
      return Together({ Sphere(n, 0.5, { -0.6, 0, 0 }), Sphere(n, 0.5, { 0.6, 0.1, 0 }) });
    case 2:
      return Hollow(n, 0.9);
    case 3:
      return Together({ Hollow(n, 0.9), Sphere(n, 0.3) }); // a body in the cavity
    case 4:
      return Inverted(Sphere(n, 0.7));
    case 5:
      return Transformed(Outward(CubeTriangles(n)), 1.2 / n, { -0.6, -0.6, -0.6 });
    default:
      return Sphere(n, 0.8);
  }
}

/// With an array of points and one of cells.
vtkSmartPointer<vtkPolyData> WithData(const Mesh& mesh, double offset)
{
  vtkSmartPointer<vtkPolyData> data = MakePolyData(mesh);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    heights->InsertNextValue(offset + 0.37 * static_cast<double>(i));
  }
  data->GetPointData()->AddArray(heights);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    numbers->InsertNextValue(offset + static_cast<double>(i / 3));
  }
  data->GetCellData()->AddArray(numbers);
  return data;
}

vtkPolyData* OutputOf(Filter* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

/// The output of a filter with the motion that it has, and that of a new one on moved data.
void ExpectAsNew(Filter* filter, const Mesh& body, const Mesh& tool, const vtkMatrix4x4* motion)
{
  RunSolid(filter);
  vtkNew<Filter> other;
  other->SetInputData(0, WithData(body, 0.0));
  other->SetSourceData(WithData(Moved(motion, tool), 1000.0));
  other->SetOperation(filter->GetOperation());
  other->SetInsideRule(filter->GetInsideRule());
  other->SetJoinPieces(filter->GetJoinPieces());
  other->SetMergePieces(filter->GetMergePieces());
  other->SetKeepPolygons(filter->GetKeepPolygons());
  RunSolid(other);
  ExpectEqual(OutputOf(filter), OutputOf(other));
  for (const char* name : { "Volume", "Area", "InputVolume", "InputArea", "SourceVolume",
         "SourceArea", "BadEdges", "TrianglesSplit", "TrianglesFolded", "Solids" })
  {
    const double expected = Reported(other, name);
    EXPECT_NEAR(Reported(filter, name), expected, 1e-12 * (1.0 + std::abs(expected))) << name;
  }
}

/// Of a filter whose Source has moved to a place.
bool IsOnlyNearArranged(Filter* filter, const Mesh& body, const Mesh& tool)
{
  const double arranged = Reported(filter, "TrianglesArranged");
  const double all = static_cast<double>(body.Cells.size() + tool.Cells.size());
  EXPECT_LE(arranged, all);
  return arranged < all;
}

TEST(BooleanOperationNear, IsThatOfAllTriangles)
{
  const int pairs = SetInEnvironment("SKDTREE_TEST_PAIRS", 24);
  int steps = 0;
  int near = 0;
  for (int number = 0; number < pairs; ++number)
  {
    Random random(static_cast<std::uint64_t>(number + 7));
    std::string what = std::to_string(number);
    const Mesh body = MakeSolid(random, what);
    const Mesh tool = MakeSolid(random, what);
    SCOPED_TRACE(what);
    vtkNew<Filter> filter;
    filter->SetInputData(0, WithData(body, 0.0));
    filter->SetSourceData(WithData(tool, 1000.0));
    filter->SetJoinPieces(number % 4 != 0);
    filter->SetMergePieces(number % 3 == 0);
    for (int step = 0; step < 6; ++step)
    {
      vtkNew<vtkTransform> transform;
      const double far = step == 2 ? 4.0 : (step % 2 == 0 ? 0.4 : 0.9);
      const Point shift = far * random.Direction();
      transform->Translate(shift.data());
      if (number % 2 == 0)
      {
        transform->RotateZ(20.0 * step);
        transform->RotateX(-7.0 * step);
      }
      filter->SetTransform(transform->GetMatrix());
      filter->SetOperation((number + step / 3) % 5);
      filter->SetInsideRule(number % 3);
      ExpectAsNew(filter, body, tool, transform->GetMatrix());
      steps += step > 1;
      near += step > 1 && IsOnlyNearArranged(filter, body, tool);
    }
  }
  EXPECT_GT(2 * near, steps); // of small meshes all may be near
}

/// A filter that has moved its Source twice.
struct MovedTwice
{
  vtkNew<Filter> It;
  Mesh Body;
  Mesh Tool;
  vtkNew<vtkMatrix4x4> Motion;

  MovedTwice(const Mesh& body, const Mesh& tool, int operation = Filter::UNION)
    : Body(body)
    , Tool(tool)
  {
    this->It->SetInputData(0, WithData(body, 0.0));
    this->It->SetSourceData(WithData(tool, 1000.0));
    this->It->SetOperation(operation);
    this->Move({ 0.3, 0.01, 0.02 });
    this->Move({ 0.31, 0.02, 0.03 });
  }

  void Move(const Point& shift)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Motion->SetElement(i, 3, shift[i]);
    }
    this->It->SetTransform(this->Motion);
    this->It->Update();
  }

  void ExpectAsNew() { ::ExpectAsNew(this->It, this->Body, this->Tool, this->Motion); }
  bool IsNear() { return IsOnlyNearArranged(this->It, this->Body, this->Tool); }
};

/// A series in time: what was found of inputs before must not be used for others.
TEST(BooleanOperationNear, InputsThatChangeAreArranged)
{
  MovedTwice run(Sphere(12, 1.0), Sphere(10, 0.7), Filter::DIFFERENCE);
  run.It->SetInsideRuleToPositive();
  EXPECT_TRUE(run.IsNear());
  for (int step = 0; step < 12; ++step)
  {
    const bool isSourceNew = step == 3 || step == 7;
    if (isSourceNew)
    {
      run.Tool = Inverted(run.Tool); // nothing is inside then
      run.It->SetSourceData(WithData(run.Tool, 1000.0));
    }
    if (step == 5 || step > 9)
    {
      run.Body = Transformed(run.Body, 1.0, { 0.01, 0.1, 0 });
      run.It->SetInputData(0, WithData(run.Body, 0.0));
    }
    run.Move({ 0.4 - 0.01 * step, 0.03 * step, 0.01 });
    run.ExpectAsNew();
    EXPECT_EQ(run.IsNear(), !isSourceNew && step != 5 && step <= 9) << step;
  }
}

/// Other operations than on two solids find others, which the next union must not have.
TEST(BooleanOperationNear, OtherOperationsAreBetween)
{
  MovedTwice run(Hollow(9, 1.0), Hollow(8, 0.7));
  for (const int operation : { Filter::AT_LEAST, Filter::SPLIT, Filter::IMPRINT })
  {
    for (int step = 0; step < 4; ++step)
    {
      const bool isUnion = step % 2 == 1;
      run.It->SetOperation(isUnion ? Filter::UNION : operation);
      const double shift = 0.3 + 0.02 * (step == 3 ? 1 : step); // at rest, too
      run.Move({ shift, 0.013, 0.007 });
      if (isUnion)
      {
        run.ExpectAsNew();
      }
    }
  }
  run.It->SetOperationToUnion();
  run.Move({ 0.2, 0.1, 0.1 });
  run.It->SetOperationToImprint(); // of a Source at rest that only near triangles were arranged of
  run.It->Update();
  vtkNew<Filter> other;
  other->SetInputData(0, WithData(run.Body, 0.0));
  other->SetSourceData(WithData(Moved(run.Motion, run.Tool), 1000.0));
  other->SetOperationToImprint();
  other->Update();
  ExpectEqual(OutputOf(run.It), OutputOf(other));
  run.It->SetOperationToUnion();
  run.ExpectAsNew();
}

/// A tool that leaves the body and comes back, is within it, or around it.
TEST(BooleanOperationNear, WithinAndOutside)
{
  for (const double size : { 0.3, 3.0 })
  {
    for (const int operation : { Filter::UNION, Filter::INTERSECTION, Filter::DIFFERENCE })
    {
      MovedTwice run(Sphere(10, 1.0), Sphere(7, size), operation);
      for (const double shift : { 0.01, 0.9, 9.0, 8.0, 0.8, 0.02, -0.01 })
      {
        run.Move({ shift, 0.017, 0.005 });
        run.ExpectAsNew();
        EXPECT_TRUE(run.IsNear()) << shift;
        const bool areNear = size < 1.0 && (shift == 0.9 || shift == 0.8);
        EXPECT_EQ(Reported(run.It, "TrianglesArranged") > 0.0, areNear) << shift;
      }
    }
  }
}

/// Where faces lie in one plane, and points and edges on each other, all triangles are arranged.
TEST(BooleanOperationNear, ContactsThatShareAnAreaAreOfAll)
{
  const auto box = [](int n, double size) {
    return Transformed(Outward(CubeTriangles(n)), size / n, { 0.0, 0.0, 0.0 });
  };
  MovedTwice run(box(8, 2.0), box(4, 1.0));
  for (const Point& shift : std::initializer_list<Point>{ { 0.5, 0.5, 1.0 }, { 0.6, 0.3, 1.5 },
         { 0.5, 2.0, 0.25 }, { 2.0, 2.0, 2.0 }, { -1.0, 0.25, 0.5 }, { 0.35, 0.15, 1.65 },
         { 2.0, 0.123, 0.456 }, { 1.75, 1.75, 1.75 }, { 1.7123, 1.6234, 1.8345 } })
  {
    run.Move(shift);
    run.ExpectAsNew();
  }
  EXPECT_TRUE(run.IsNear());
}

/// Corners that touch the other body's faces.
TEST(BooleanOperationNear, PointsTouchFaces)
{
  const Mesh spike = Transformed(Outward(Octahedron(1.0)), 0.5, { 0, 0, 0 });
  MovedTwice run(Transformed(Outward(CubeTriangles(8)), 0.25, { -1, -1, -1 }), spike);
  for (const Point& shift : std::initializer_list<Point>{ { 0.05, 0.1, 1.5 }, { 0.05, 0.1, 0.5 },
         { 0.0625, 0.125, 1.5 }, { 0.25, 0.25, 1.5 }, { 0.125, 0.125, 0.5 }, { 0.1, 0.2, 1.2 } })
  {
    run.Move(shift);
    run.ExpectAsNew();
  }
}

/// Faces of an operation before have numbers, by which triangles that are far apart are of one.
TEST(BooleanOperationNear, ResultsAreInputs)
{
  vtkNew<Filter> first;
  first->SetInputData(0, WithData(Transformed(Outward(CubeTriangles(6)), 0.3, { -1, -1, -1 }), 0));
  first->SetSourceData(WithData(Sphere(9, 0.8, { 0.5, 0.4, 0.3 }), 500.0));
  first->SetOperationToDifference();
  first->Update();
  vtkNew<vtkPolyData> body;
  body->ShallowCopy(OutputOf(first));
  const Mesh tool = Sphere(8, 0.5);
  vtkNew<Filter> filter;
  filter->SetInputData(0, body);
  filter->SetSourceData(WithData(tool, 1000.0));
  for (int step = 0; step < 4; ++step)
  {
    vtkNew<vtkTransform> transform;
    transform->Translate(-0.9 + 0.03 * step, 0.02, 0.01);
    filter->SetTransform(transform->GetMatrix());
    RunSolid(filter);
    vtkNew<Filter> other;
    other->SetInputData(0, body);
    other->SetSourceData(WithData(Moved(transform->GetMatrix(), tool), 1000.0));
    RunSolid(other);
    ExpectEqual(OutputOf(filter), OutputOf(other));
  }
}

/// What one motion rounds is told apart by another; far away all is arranged.
TEST(BooleanOperationNear, LargeShiftsRoundMore)
{
  MovedTwice run(Sphere(9, 1.0), Sphere(8, 0.6));
  EXPECT_TRUE(run.IsNear());
  for (const double far : { 1e3, 1e7, 1e9, 1e13 })
  {
    run.Move({ far, 0.1, 0.2 });
    run.ExpectAsNew();
    EXPECT_EQ(run.IsNear(), far < 2e3) << far;
  }
  run.Move({ 0.5, 0.1, 0.2 });
  run.ExpectAsNew();
  EXPECT_TRUE(run.IsNear());
}

/// Reflections turn triangles; the next motion may be one or not.
TEST(BooleanOperationNear, ReflectionsAreToldApart)
{
  MovedTwice run(Sphere(9, 1.0), Sphere(8, 0.6, { 0.1, 0.2, 0.3 }));
  for (int step = 0; step < 6; ++step)
  {
    run.Motion->SetElement(0, 0, step % 4 < 2 ? -1.0 : 1.0);
    run.Move({ 0.5 + 0.01 * step, 0.1, 0.2 });
    vtkNew<Filter> other;
    other->SetInputData(0, WithData(run.Body, 0.0));
    other->SetSourceData(WithData(run.Tool, 1000.0));
    other->SetTransform(run.Motion);
    RunSolid(other);
    ExpectEqual(OutputOf(run.It), OutputOf(other));
  }
}
}
