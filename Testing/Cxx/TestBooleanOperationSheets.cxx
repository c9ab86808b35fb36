// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: an open Source (a sheet) cuts the Input, or leaves it whole.

#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

/// Horizontal, with its normals up; what is behind it is below.
Mesh SheetAt(double z, double halfWidth, bool isUp = true, double x = 0.0)
{
  Mesh sheet;
  const int n = 4;
  for (int i = 0; i <= n; ++i)
  {
    for (int k = 0; k <= n; ++k)
    {
      sheet.Add(Point{ x + halfWidth * (2.0 * i / n - 1.0), halfWidth * (2.0 * k / n - 1.0), z });
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int k = 0; k < n; ++k)
    {
      const vtkIdType a = (n + 1) * i + k;
      sheet.Add(VTK_TRIANGLE, { a, a + n + 1, a + n + 2 });
      sheet.Add(VTK_TRIANGLE, { a, a + n + 2, a + 1 });
    }
  }
  return isUp ? sheet : Inverted(sheet);
}

Mesh Both(Mesh a, const Mesh& b)
{
  Append(a, b);
  return a;
}

Mesh Box(double halfWidth, double z = 0.0)
{
  const double h = halfWidth;
  return BoxTriangles({ -h, -h, z - h }, { h, h, z + h });
}

/// What is left of a body, and what is cut off, with the warnings.
struct Cut
{
  double InFront;
  double Behind;
  int Warnings = 0;
  std::string Warning;

  Cut(const Mesh& body, const Mesh& sheet)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(MakePolyData(body));
    filter->SetSourceData(MakePolyData(sheet));
    EventCounter events(filter);
    filter->SetOperationToDifference();
    this->InFront = Measures(RunSolid(filter)).Volume;
    filter->SetOperationToIntersection();
    this->Behind = Measures(RunSolid(filter)).Volume;
    this->Warnings = events.Warnings;
    this->Warning = events.Warning;
  }
};

void ExpectCut(const Mesh& body, const Mesh& sheet, double inFront, double behind, int warnings = 0)
{
  const Cut cut(body, sheet);
  EXPECT_NEAR(cut.InFront, inFront, 1e-13);
  EXPECT_NEAR(cut.Behind, behind, 1e-13);
  EXPECT_EQ(cut.Warnings, warnings) << cut.Warning;
}

/// It divides nothing, wherever it is and however it faces.
TEST(BooleanOperationSheets, WithinABodyTheyLeaveItWhole)
{
  for (const bool isUp : { true, false })
  {
    for (const double z : { -0.875, -0.25, 0.125, 0.8 })
    {
      SCOPED_TRACE(z);
      ExpectCut(Box(1), SheetAt(z, 0.1, isUp), 8.0, 0.0, 1);
      ExpectCut(Box(1), SheetAt(z, 0.9, isUp, 0.5), 8.0, 0.0, 1); // cuts in from one side
    }
    ExpectCut(Box(1), Both(SheetAt(-0.5, 0.1, isUp), SheetAt(0.5, 0.1, isUp)), 8.0, 0.0, 1);
    EXPECT_NE(
      Cut(Box(1), SheetAt(0.5, 0.1)).Warning.find("does not cut through"), std::string::npos);
  }
}

TEST(BooleanOperationSheets, ThatCutThroughMayBeWithOthersThatDoNot)
{
  ExpectCut(Box(1), SheetAt(0.5, 2), 2.0, 6.0);
  ExpectCut(Box(1), SheetAt(0.5, 2, false), 6.0, 2.0);
  ExpectCut(Box(1), Both(SheetAt(0.5, 2), SheetAt(-0.5, 0.1)), 2.0, 6.0, 1);
  ExpectCut(Box(1), Both(SheetAt(0.5, 2), SheetAt(0.75, 0.1, false)), 2.0, 6.0, 1);
}

/// In front is what is in front of all.
TEST(BooleanOperationSheets, SeveralCutOffSeveralParts)
{
  ExpectCut(Box(1), Both(SheetAt(0.5, 2), SheetAt(-0.25, 2)), 2.0, 6.0);
  ExpectCut(Box(1), Both(SheetAt(0.5, 2, false), SheetAt(-0.25, 2)), 3.0, 5.0);
  ExpectCut(Box(1), Both(SheetAt(0.5, 2), SheetAt(-0.25, 2, false)), 5.0, 3.0);
}

TEST(BooleanOperationSheets, ThatTouchABodyOrPassItByHaveItOnOneSide)
{
  for (const double z : { 1.0, 3.0 }) // on its top, and above it
  {
    ExpectCut(Box(1), SheetAt(z, 2), 0.0, 8.0);
    ExpectCut(Box(1), SheetAt(z, 2, false), 8.0, 0.0);
    ExpectCut(Box(1), SheetAt(-z, 2), 8.0, 0.0);
    ExpectCut(Box(1), SheetAt(-z, 2, false), 0.0, 8.0);
  }
  ExpectCut(Both(Box(1), Box(0.5, 5.0)), SheetAt(0.5, 2), 3.0, 6.0);
}

/// A part of space is on one side, although surfaces around it are not connected.
TEST(BooleanOperationSheets, CavitiesAreOfTheirBody)
{
  const Mesh hollow = Both(Box(1), Inverted(Box(0.25, 0.5)));
  for (const double z : { -0.875, -0.5, 0.2 })
  {
    const double below = 4.0 * (z + 1.0);
    ExpectCut(hollow, SheetAt(z, 2), 7.875 - below, below);
    ExpectCut(hollow, SheetAt(z, 2, false), below, 7.875 - below);
  }
  ExpectCut(hollow, SheetAt(0.625, 2), 1.5 - 0.03125, 6.5 - 0.09375);
  ExpectCut(hollow, SheetAt(-0.5, 0.1), 7.875, 0.0, 1);
  ExpectCut(hollow, SheetAt(-0.5, 0.1, false), 7.875, 0.0, 1);
  const Mesh nested = Both(hollow, Box(0.125, 0.5));
  ExpectCut(nested, SheetAt(-0.5, 2), 5.875 + 0.015625, 2.0);
}

TEST(BooleanOperationSheets, FacesOfOppositeOrientationAreToldOf)
{
  Mesh sheet = SheetAt(0.5, 2);
  std::swap(sheet.Cells[12].Points[0], sheet.Cells[12].Points[1]);
  const Cut cut(Box(1), sheet);
  EXPECT_NEAR(cut.InFront, 8.0, 1e-13);
  EXPECT_NEAR(cut.Behind, 0.0, 1e-13);
  EXPECT_EQ(cut.Warnings, 1);
  EXPECT_NE(cut.Warning.find("both in front of it and behind"), std::string::npos) << cut.Warning;
}

/// Through the middle of a convex body: with a hole there it divides nothing, with one outside it
/// cuts as a half space does.
TEST(BooleanOperationSheets, AHoleMattersWhereItIsInTheBody)
{
  for (int number = 0; number < 24; ++number)
  {
    SCOPED_TRACE(number);
    Random random(static_cast<std::uint64_t>(number));
    const RandomRotation rotation(random, number % 4 == 0);
    const double z = random.InBox({ -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 })[2];
    Mesh body = Outward(SphereTriangles(5));
    body.Map(rotation);
    Mesh below = BoxTriangles({ -9, -9, -9 }, { 9, 9, z });
    Mesh sheet = SheetAt(z, 4, number % 2 == 0);
    const bool isInBody = number % 3 == 0;
    const auto hole = std::find_if(sheet.Cells.begin(), sheet.Cells.end(),
      [&](const CellSpec& cell)
      {
        const auto isInMiddle = [&](vtkIdType i)
        { return std::abs(sheet.Points[i][0]) + std::abs(sheet.Points[i][1]) == 0.0; };
        const bool hasMiddle = std::any_of(cell.Points.begin(), cell.Points.end(), isInMiddle);
        return hasMiddle == isInBody && (isInBody || sheet.Points[cell.Points[0]][0] > 1.5);
      });
    ASSERT_NE(hole, sheet.Cells.end());
    sheet.Cells.erase(hole);
    const double whole = Measures(body).Volume;
    const double lower = Measures(Combine(body, below, 1)).Volume;
    const double behind = isInBody ? 0.0 : number % 2 == 0 ? lower : whole - lower;
    const Cut cut(body, sheet);
    EXPECT_NEAR(cut.Behind, behind, 1e-13);
    EXPECT_NEAR(cut.InFront, whole - behind, 1e-13);
    EXPECT_EQ(cut.Warnings, isInBody ? 1 : 0) << cut.Warning;
  }
}
}
