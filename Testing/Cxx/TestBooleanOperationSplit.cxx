// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: all parts of a solid that is cut, in one operation, and the section.

#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

Mesh Box(const Point& low, const Point& high)
{
  return BoxTriangles({ low[0], low[1], low[2] }, { high[0], high[1], high[2] });
}

/// One horizontal quad.
Mesh Sheet(double z, double halfWidth = 9.0, bool isUp = true)
{
  const double h = halfWidth;
  Mesh sheet;
  for (const Point& x : { Point{ -h, -h, z }, { h, -h, z }, { h, h, z }, { -h, h, z } })
  {
    sheet.Add(x);
  }
  sheet.Add(VTK_QUAD, isUp ? Ids{ 0, 1, 2, 3 } : Ids{ 3, 2, 1, 0 });
  return sheet;
}

/// A split, with its outputs.
struct Split
{
  vtkNew<Filter> Run;
  EventCounter Events{ this->Run };

  Split(const Mesh& body, const Mesh& cutter)
  {
    this->Run->SetInputData(MakePolyData(body));
    this->Run->SetSourceData(MakePolyData(cutter));
    this->Run->SetOperationToSplit();
    this->Run->KeepPolygonsOff();
  }

  vtkPolyData* Get(int port)
  {
    this->Run->Update();
    return vtkPolyData::SafeDownCast(this->Run->GetOutputDataObject(port));
  }

  /// The faces of a part, with the numbers of points in all of the output.
  Mesh GetPart(int part)
  {
    vtkPolyData* output = this->Get(0);
    auto* parts = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray("SkdPartId"));
    const Mesh all = MeshOf(output);
    Mesh found;
    found.Points = all.Points;
    for (std::size_t i = 0; i < all.Cells.size(); ++i)
    {
      if (parts->GetValue(static_cast<vtkIdType>(i)) == part)
      {
        found.Cells.push_back(all.Cells[i]);
      }
    }
    return found;
  }

  double GetReport(const char* name, vtkIdType row = 0)
  {
    return this->Get(0)->GetFieldData()->GetArray(name)->GetTuple1(row);
  }
};

std::set<vtkIdType> PointsOf(const Mesh& mesh)
{
  std::set<vtkIdType> points;
  for (const CellSpec& cell : mesh.Cells)
  {
    points.insert(cell.Points.begin(), cell.Points.end());
  }
  return points;
}

double AreaOfPolygons(vtkPolyData* section)
{
  double area = 0.0;
  for (vtkIdType i = 0; i < section->GetNumberOfCells(); ++i)
  {
    vtkPoints* points = section->GetCell(i)->GetPoints();
    Point sum{ 0, 0, 0 };
    for (vtkIdType k = 1; k + 1 < points->GetNumberOfPoints(); ++k)
    {
      Point a, b, c;
      points->GetPoint(0, a.data());
      points->GetPoint(k, b.data());
      points->GetPoint(k + 1, c.data());
      sum = sum + 0.5 * Cross(b - a, c - a);
    }
    area += Length(sum);
  }
  return area;
}

TEST(BooleanOperationSplit, HasWhatTwoOperationsHave)
{
  for (int number = 0; number < 40; ++number)
  {
    SCOPED_TRACE(number);
    Random random(static_cast<std::uint64_t>(number));
    std::string what;
    const Mesh body = AnySolid(random, what);
    const bool isClosed = number % 2 == 0;
    Mesh cutter = isClosed ? AnySolid(random, what)
                           : Sheet(random.InBox(Bounds{ -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 })[2]);
    if (!isClosed)
    {
      cutter.Map(RandomRotation(random, number % 4 == 1));
    }
    SCOPED_TRACE(what);
    Split split(body, cutter);
    const Mesh front = split.GetPart(0);
    const Mesh behind = split.GetPart(1);
    EXPECT_EQ(CountBadEdges(front) + CountBadEdges(behind), 0);
    const std::array<Mesh, 2> expected{ Combine(body, cutter, Filter::DIFFERENCE),
      Combine(body, cutter, Filter::INTERSECTION) };
    const double scale = Measures(body).Area;
    EXPECT_NEAR(Measures(front).Volume, Measures(expected[0]).Volume, 1e-13 * scale);
    EXPECT_NEAR(Measures(behind).Volume, Measures(expected[1]).Volume, 1e-13 * scale);
    EXPECT_NEAR(Measures(front).Area, Measures(expected[0]).Area, 1e-13 * scale);
    EXPECT_NEAR(Measures(behind).Area, Measures(expected[1]).Area, 1e-13 * scale);
    const std::set<vtkIdType> inFront = PointsOf(front);
    for (const vtkIdType point : PointsOf(behind))
    {
      EXPECT_EQ(inFront.count(point), 0u);
    }
    EXPECT_EQ(split.GetReport("SkdReportBadEdges"), 0.0);
    EXPECT_EQ(split.Events.Errors + split.Events.Warnings, 0) << split.Events.Warning;
  }
}

TEST(BooleanOperationSplit, SheetsMakeSlabs)
{
  Mesh sheets = Sheet(0.5);
  Append(sheets, Sheet(0.25));
  Append(sheets, Sheet(-0.75));
  Split split(Box({ -1, -1, -1 }, { 1, 1, 1 }), sheets);
  const double volumes[] = { 2.0, 1.0, 4.0, 1.0 };
  for (int part = 0; part < 4; ++part)
  {
    const Mesh slab = split.GetPart(part);
    EXPECT_EQ(CountBadEdges(slab), 0);
    EXPECT_EQ(slab.Cells.size(), 12u);
    EXPECT_NEAR(Measures(slab).Volume, volumes[part], 1e-14);
    EXPECT_NEAR(split.GetReport("SkdReportPartVolumes", part), volumes[part], 1e-14);
  }
  EXPECT_NEAR(split.GetReport("SkdReportVolume"), 8.0, 1e-14);
  split.Run->KeepPolygonsOn();
  vtkPolyData* section = split.Get(1);
  EXPECT_EQ(section->GetNumberOfCells(), 3);
  EXPECT_NEAR(AreaOfPolygons(section), 12.0, 1e-14);
}

/// Two faces of different parts have no number in common: they would become one again.
TEST(BooleanOperationSplit, NumbersFacesOfPartsApart)
{
  Split split(Box({ -1, -1, -1 }, { 1, 1, 1 }), Sheet(0.25));
  vtkCellData* data = split.Get(0)->GetCellData();
  auto* faces = vtkIdTypeArray::SafeDownCast(data->GetArray("SkdFaceId"));
  auto* parts = vtkIntArray::SafeDownCast(data->GetArray("SkdPartId"));
  std::map<vtkIdType, int> partOf;
  for (vtkIdType i = 0; i < faces->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(
      partOf.emplace(faces->GetValue(i), parts->GetValue(i)).first->second, parts->GetValue(i));
  }
  EXPECT_EQ(partOf.size(), 14u); // top and bottom are not cut and stay two triangles each
}

TEST(BooleanOperationSplit, SectionsAreClosedPolygons)
{
  for (const bool isUp : { true, false })
  {
    for (const int operation : { Filter::DIFFERENCE, Filter::INTERSECTION, Filter::SPLIT })
    {
      Split split(Box({ -1, -1, -1 }, { 1, 1, 1 }), Sheet(0.25, 9.0, isUp));
      split.Run->KeepPolygonsOn();
      split.Run->SetOperation(operation);
      vtkPolyData* section = split.Get(1);
      ASSERT_EQ(section->GetNumberOfCells(), 1);
      EXPECT_EQ(section->GetCell(0)->GetNumberOfPoints(), 4);
      EXPECT_EQ(section->GetNumberOfPoints(), 4);
      EXPECT_NEAR(AreaOfPolygons(section), 4.0, 1e-14);
      Point a, b, c;
      section->GetPoint(section->GetCell(0)->GetPointId(0), a.data());
      section->GetPoint(section->GetCell(0)->GetPointId(1), b.data());
      section->GetPoint(section->GetCell(0)->GetPointId(2), c.data());
      EXPECT_EQ(Cross(b - a, c - b)[2] > 0.0, isUp);
    }
  }
}

/// With or without the cut closed, the section is the same; with holes it is triangles.
TEST(BooleanOperationSplit, SectionsMayHaveHoles)
{
  Mesh hollow = Box({ -1, -1, -1 }, { 1, 1, 1 });
  Append(hollow, Inverted(Box({ -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 })));
  for (const bool closes : { true, false })
  {
    Split split(hollow, Sheet(0.25));
    split.Run->KeepPolygonsOn();
    split.Run->SetCloseCut(closes);
    vtkPolyData* section = split.Get(1);
    EXPECT_EQ(section->GetNumberOfPoints(), 8);
    EXPECT_EQ(section->GetNumberOfCells(), 8);
    EXPECT_NEAR(AreaOfPolygons(section), 3.0, 1e-14);
    EXPECT_EQ(CountBadEdges(MeshOf(section)), 8);
    EXPECT_EQ(split.GetReport("SkdReportBadEdges") > 0.0, !closes);
  }
}

/// A section of a closed cutter is its surface within; nothing of what is on the surface.
TEST(BooleanOperationSplit, SectionsByClosedSolidsAreWithin)
{
  Split corner(Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 1, 1, 1 }, { 3, 3, 3 }));
  EXPECT_NEAR(AreaOfPolygons(corner.Get(1)), 3.0, 1e-14);
  EXPECT_NEAR(Measures(corner.GetPart(1)).Volume, 1.0, 1e-14);
  Split touching(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 0, 0 }, { 2, 1, 1 }));
  EXPECT_EQ(touching.Get(1)->GetNumberOfCells(), 0);
  EXPECT_NEAR(Measures(touching.GetPart(0)).Volume, 1.0, 1e-14);
  Split equal(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0, 0, 0 }, { 1, 1, 1 }));
  EXPECT_EQ(equal.GetPart(0).Cells.size(), 0u);
  EXPECT_NEAR(Measures(equal.GetPart(1)).Volume, 1.0, 1e-14);
  Split within(Box({ 0, 0, 0 }, { 3, 3, 3 }), Box({ 1, 1, 1 }, { 2, 2, 2 }));
  EXPECT_NEAR(AreaOfPolygons(within.Get(1)), 6.0, 1e-14);
  EXPECT_NEAR(Measures(within.GetPart(0)).Volume, 26.0, 1e-13);
}

/// Other operations have none, as it is a part of what they output.
TEST(BooleanOperationSplit, OtherOperationsHaveNoSection)
{
  for (const int operation : { Filter::UNION, Filter::DIFFERENCE })
  {
    Split split(Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 1, 1, 1 }, { 3, 3, 3 }));
    split.Run->SetOperation(operation);
    EXPECT_EQ(split.Get(1)->GetNumberOfCells(), 0);
    EXPECT_EQ(split.Get(0)->GetCellData()->GetArray("SkdPartId"), nullptr);
  }
}

TEST(BooleanOperationSplit, WithoutASourceTheFirstSolidIsDivided)
{
  vtkNew<Filter> filter;
  Mesh all = Box({ 0, 0, 0 }, { 4, 1, 1 });
  Append(all, Box({ 1, -1, -1 }, { 3, 2, 2 }));
  Append(all, Box({ 2, -2, -2 }, { 5, 3, 3 }));
  filter->SetInputData(MakePolyData(all));
  filter->SetOperationToSplit();
  RunSolid(filter);
  vtkDataArray* volumes = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))
                            ->GetFieldData()
                            ->GetArray("SkdReportPartVolumes");
  ASSERT_EQ(volumes->GetNumberOfTuples(), 3);
  EXPECT_NEAR(volumes->GetTuple1(0), 1.0, 1e-14); // in none
  EXPECT_NEAR(volumes->GetTuple1(1), 2.0, 1e-14); // in one
  EXPECT_NEAR(volumes->GetTuple1(2), 1.0, 1e-14); // in both
}

TEST(BooleanOperationSplit, EmptyInputsHaveEmptyOutputs)
{
  Split nothing(Mesh(), Sheet(0.0));
  EXPECT_EQ(nothing.Get(0)->GetNumberOfCells() + nothing.Get(1)->GetNumberOfCells(), 0);
  Split whole(Box({ 0, 0, 0 }, { 1, 1, 1 }), Mesh());
  EXPECT_NEAR(Measures(whole.GetPart(0)).Volume, 1.0, 1e-14);
  EXPECT_EQ(whole.Events.Errors, 0);
}
}
