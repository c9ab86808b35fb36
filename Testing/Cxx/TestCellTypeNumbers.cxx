// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of every type number that a file may have, also of types that VTK declares without a class
// or does not know, with and without points, in every part that a mesh may take in a filter: all
// filters end, and their results are those of a mesh with empty cells in the same places.

#include "Support/EachFilter.h"
#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/HarmedMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "vtkSkdTreeCellLocator.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <numeric>

using namespace skdtest;

namespace
{

constexpr int NumberOfTypes = 256; // types are stored as bytes

bool HasClass(int type)
{
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type)) != nullptr;
}

/// How the cells of odd types lie among ordinary ones.
enum class Company
{
  None,
  Before,
  After,
  Between
};

constexpr Company AllCompanies[] = { Company::None, Company::Before, Company::After,
  Company::Between };

/// The first points; of a polyhedron one face of them.
Ids FirstPoints(int type, std::size_t size)
{
  Ids ids(size);
  std::iota(ids.begin(), ids.end(), 0);
  if (type == VTK_POLYHEDRON)
  {
    ids.insert(ids.begin(), static_cast<vtkIdType>(size));
    ids.insert(ids.begin(), size > 0 ? 1 : 0);
    ids.resize(size > 0 ? size + 2 : 1);
  }
  return ids;
}

/// Cells of these types, of the first `size` points each, among `ordinary` ones.
Mesh MakeOdd(const Mesh& ordinary, const std::vector<int>& types, std::size_t size, Company company)
{
  Mesh mesh;
  mesh.Points = ordinary.Points;
  const std::size_t all = company == Company::None ? 0 : ordinary.Cells.size();
  const std::size_t before = company == Company::After ? all
    : company == Company::Between                      ? all / 2
                                                       : 0;
  mesh.Cells.assign(ordinary.Cells.begin(), ordinary.Cells.begin() + std::ptrdiff_t(before));
  for (const int type : types)
  {
    mesh.Add(type, FirstPoints(type, size));
  }
  mesh.Cells.insert(mesh.Cells.end(), ordinary.Cells.begin() + std::ptrdiff_t(before),
    ordinary.Cells.begin() + std::ptrdiff_t(all));
  return mesh;
}

/// Types that stand for all, alone in their mesh; all of them if the environment asks for it.
std::vector<int> TypesAlone()
{
  if (!std::getenv("SKDTREE_ALL_HARMS"))
  {
    return { 0, 1, 2, 3, 4, 5, 6, 7, 9, 10, 12, 21, 24, 36, 41, 42, 51, 60, 68, 70, 74, 75, 81, 82,
      200, 255 };
  }
  std::vector<int> all;
  for (int type = 0; type < NumberOfTypes; ++type)
  {
    all.push_back(type);
  }
  return all;
}

/// The types with or without a class.
std::vector<int> TypesWith(bool hasClass)
{
  std::vector<int> types;
  for (int type = 1; type < NumberOfTypes; ++type)
  {
    if (HasClass(type) == hasClass)
    {
      types.push_back(type);
    }
  }
  return types;
}

Mesh OrdinaryCells()
{
  Mesh mesh = Hexahedra(2);
  mesh.Add(VTK_TETRA, { 0, 1, 3, 9 });
  mesh.Add(VTK_TRIANGLE, { 2, 11, 24 });
  mesh.Add(VTK_POLY_LINE, { 0, 4, 13, 26 });
  mesh.Add(VTK_VERTEX, { 26 });
  return Transformed(mesh, 1.1, { 0.01, 0.02, 0.03 });
}

/// Of vtkPolyData, in its order.
Mesh OrdinaryPolygons()
{
  Mesh mesh = Transformed(SphereTriangles(2), 0.8, { 1.21, 1.27, 1.23 });
  Mesh ordered;
  ordered.Points = mesh.Points;
  ordered.Add(VTK_POLY_VERTEX, { 0, 1 });
  ordered.Add(VTK_POLY_LINE, { 0, 1, 2 });
  ordered.Cells.insert(ordered.Cells.end(), mesh.Cells.begin(), mesh.Cells.end());
  ordered.Add(VTK_TRIANGLE_STRIP, { 0, 1, 2, 3 });
  return ordered;
}

void Announce(const std::string& what)
{
  if (std::getenv("SKDTREE_ALL_HARMS"))
  {
    std::cerr << what << std::endl;
  }
}

class CellTypeNumbers : public EachFilter
{
protected:
  std::vector<double> Run(vtkDataSet* mesh, const std::string& what) const
  {
    Announce(this->Setup.Name + ": " + what);
    const auto filter = this->Setup.Make(mesh);
    filter->Update();
    return AnswersOf(filter);
  }

  /// The same results as with empty cells instead.
  void ExpectEmpty(
    const Mesh& ordinary, const std::vector<int>& types, std::size_t size, Company company) const
  {
    const std::string what = std::to_string(types.size()) + " types from " +
      std::to_string(types.front()) + ", " + std::to_string(size) + " points, company " +
      std::to_string(static_cast<int>(company));
    const std::vector<int> empty(types.size(), VTK_EMPTY_CELL);
    const GridPointer odd = WithData(MakeGrid(MakeOdd(ordinary, types, size, company)));
    const GridPointer expected = WithData(MakeGrid(MakeOdd(ordinary, empty, 0, company)));
    EXPECT_TRUE(AreEqual(this->Run(odd, what), this->Run(expected, what + ", empty"))) << what;
  }
};

INSTANTIATE_TEST_SUITE_P(Filters, CellTypeNumbers,
  testing::Range<std::size_t>(0, AllFilterSetups().size()),
  [](const auto& info) { return AllFilterSetups()[info.param].Name; });

TEST_P(CellTypeNumbers, WithoutPointsAreEmpty)
{
  std::vector<int> all = TypesWith(true);
  for (const int type : TypesWith(false))
  {
    all.push_back(type);
  }
  for (const Company company : AllCompanies)
  {
    this->ExpectEmpty(OrdinaryCells(), all, 0, company);
  }
  for (const int type : TypesAlone())
  {
    this->Run(WithData(MakeGrid(MakeOdd(OrdinaryCells(), { type }, 0, Company::None))),
      "type " + std::to_string(type) + " alone without points");
  }
}

TEST_P(CellTypeNumbers, ThatHaveNoClassAreEmpty)
{
  for (const Company company : AllCompanies)
  {
    this->ExpectEmpty(OrdinaryCells(), TypesWith(false), company == Company::None ? 1 : 8, company);
  }
}

TEST_P(CellTypeNumbers, OfAnyNumberOfPointsAreSurvived)
{
  const std::vector<int> types = TypesWith(true);
  for (const std::size_t size : { 1, 2, 3, 5, 8, 13 })
  {
    this->Run(WithData(MakeGrid(MakeOdd(OrdinaryCells(), types, size, Company::Between))),
      std::to_string(size) + " points");
  }
}

TEST_P(CellTypeNumbers, OfMeshesWithoutPointsAreSurvived)
{
  for (const bool hasPoints : { false, true })
  {
    for (const int type : { 0, 3, 5, 12, 74, 200 })
    {
      const GridPointer grid = MakeGrid(MakeOdd({}, { type, type }, 0, Company::None));
      grid->SetPoints(hasPoints ? vtkSmartPointer<vtkPoints>::New() : nullptr);
      this->Run(grid, "no points at all, type " + std::to_string(type));
    }
  }
}

TEST_P(CellTypeNumbers, OfPolyDataWithoutPointsAreSurvived)
{
  const std::vector<int> kinds = { VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_POLYGON,
    VTK_TRIANGLE_STRIP };
  const auto run = [&](const std::vector<int>& types, Company company)
  {
    const Mesh mesh = MakeOdd(OrdinaryPolygons(), types, 0, company);
    this->Run(WithData(MakePolyData(mesh)),
      "polydata, company " + std::to_string(static_cast<int>(company)) + ", kinds from " +
        std::to_string(types.front()));
  };
  for (const Company company : AllCompanies)
  {
    run(kinds, company);
  }
  for (const int kind : kinds)
  {
    run({ kind }, Company::None);
    this->Run(MakePolyData(MakeOdd({}, { kind }, 0, Company::None)), "polydata without points");
  }
}

TEST(CellTypeNumbersOfLocator, WithoutPointsOrClassAreLeftOut)
{
  QuietWindow quiet;
  const Mesh ordinary = OrdinaryCells();
  for (int type = 0; type < NumberOfTypes; ++type)
  {
    for (const std::size_t size : { 0, 8 })
    {
      if (size > 0 && HasClass(type))
      {
        continue;
      }
      const std::string what = std::to_string(type) + " of " + std::to_string(size);
      const GridPointer expected = MakeGrid(MakeOdd(ordinary, { 0 }, 0, Company::Before));
      const GridPointer mesh = MakeGrid(MakeOdd(ordinary, { type }, size, Company::Before));
      EXPECT_EQ(LocatorAnswers(mesh), LocatorAnswers(expected)) << what;
      LocatorAnswers(MakeGrid(MakeOdd(ordinary, { type }, size, Company::None)));
    }
  }
}

TEST(CellTypeNumbersOfLocator, ThatHaveNoClassAreNamed)
{
  QuietWindow quiet;
  for (const int type : { 74, 200 })
  {
    const GridPointer mesh = MakeGrid(MakeOdd(OrdinaryCells(), { type }, 8, Company::After));
    vtkNew<vtkSkdTreeCellLocator> locator;
    EventCounter events(locator);
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    EXPECT_EQ(events.Warnings, 1);
    const std::string fault = "it is cell 12, which has the type " + std::to_string(type);
    EXPECT_NE(events.Warning.find(fault), std::string::npos) << events.Warning;
  }
}

}
