// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap of warped and curved cells of every type: cells that share a side leave no gap
// there and have nothing in common, and integrals are kept, of cell data and of point data.

#include "Support/CurvedMeshes.h"
#include "Support/EventCounter.h"
#include "Support/RemapRun.h"
#include "Support/SphereMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "vtkStringArray.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

constexpr double Rounding = 1e-13;

double Linear(const Point& p)
{
  return 2.0 + p[0] - 3.0 * p[1] + 0.5 * p[2];
}

/// Fields of points and of cells: one, and values between -1 and 1; of points a linear one as well.
GridPointer WithFields(const GridPointer& mesh, int seed)
{
  Random random(seed);
  const auto add = [&](vtkDataSetAttributes* to, vtkIdType size, const std::string& name,
                     const std::function<double(vtkIdType)>& value)
  { to->AddArray(MakeArray(name.c_str(), size, value)); };
  const auto one = [](vtkIdType) { return 1.0; };
  const auto anything = [&](vtkIdType) { return random.Between(-1.0, 1.0); };
  add(mesh->GetCellData(), mesh->GetNumberOfCells(), "CellOne", one);
  add(mesh->GetCellData(), mesh->GetNumberOfCells(), "CellRandom", anything);
  add(mesh->GetPointData(), mesh->GetNumberOfPoints(), "PointOne", one);
  add(mesh->GetPointData(), mesh->GetNumberOfPoints(), "PointRandom", anything);
  add(mesh->GetPointData(), mesh->GetNumberOfPoints(), "PointLinear",
    [&](vtkIdType i)
    {
      Point p;
      mesh->GetPoint(i, p.data());
      return Linear(p);
    });
  return mesh;
}

double ReportedOf(vtkAlgorithm* filter, const std::string& array, const std::string& what)
{
  vtkFieldData* report = filter->GetOutputDataObject(0)->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(report->GetAbstractArray("SkdReportArray"));
  const vtkIdType at = names ? names->LookupValue(array) : -1;
  vtkDataArray* values = report->GetArray(("SkdReport" + what).c_str());
  return at < 0 || !values ? std::nan("") : values->GetTuple1(at);
}

Bounds BoundsOf(vtkDataSet* mesh)
{
  Bounds b;
  mesh->GetBounds(b.data());
  return b;
}

/// As many cells along each axis as hold the mesh, of which some are outside of it.
GridPointer GridAround(const GridPointer& mesh, int n, int dimension)
{
  const Bounds b = BoundsOf(mesh);
  const double size = 1.04 * std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] });
  const Point corner = { b[0] - 0.017 * size, b[2] - 0.019 * size, b[4] - 0.021 * size };
  return dimension == 3
    ? MakeGrid(Transformed(Hexahedra(n), size / n, corner))
    : MakeGrid(Transformed(Sheet(n, VTK_QUAD), size / n, { corner[0], corner[1], 0 }));
}

struct Result
{
  RemapPointer Filter;
  std::vector<double> Coverage;
};

/// Maps both ways of fields by a method, and expects of the integrals what is true where the input
/// covers all of the source.
Result ExpectKept(const GridPointer& input, const GridPointer& source, int method)
{
  Result result{ MakeRemap(input, source, method), {} };
  const EventCounter events(result.Filter);
  result.Coverage = RemappedCells(result.Filter, "SkdCoverage");
  const auto of = [&](const char* array, const char* what)
  { return ReportedOf(result.Filter, array, what); };
  const double whole = of("CellOne", "SourceIntegral");
  EXPECT_GT(whole, 0.0);
  for (const char* name : { "CellOne", "CellRandom", "PointOne", "PointRandom" })
  {
    const double expected = of(name, "SourceIntegral");
    EXPECT_NEAR(of(name, "OverlapIntegral"), expected, Rounding * whole) << name;
    EXPECT_NEAR(of(name, "TargetIntegral"), expected, Rounding * whole) << name;
  }
  const double linear = of("PointLinear", "SourceIntegral");
  EXPECT_NEAR(of("PointLinear", "TargetIntegral"), linear, 1e2 * Rounding * whole);
  EXPECT_NEAR(of("PointOne", "SourceIntegral"), whole, Rounding * whole);
  for (const double share : result.Coverage)
  {
    EXPECT_LE(share, 1.0 + Rounding);
  }
  EXPECT_EQ(events.Warning.find("overlap"), std::string::npos) << events.Warning;
  EXPECT_EQ(events.Errors, 0) << events.Error;
  return result;
}

/// Of input cells that are covered, the mean of a linear field is its value at their middle.
void ExpectLinear(const Result& result, const GridPointer& input)
{
  const std::vector<double> values = RemappedCells(result.Filter, "PointLinear");
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (result.Coverage[i] > 1.0 - Rounding)
    {
      Bounds b;
      input->GetCellBounds(static_cast<vtkIdType>(i), b.data());
      const Point middle = { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) };
      ASSERT_NEAR(values[i], Linear(middle), 1e-11) << i;
    }
  }
}

/// By both methods onto a grid that holds the mesh.
void ExpectWhole(const Mesh& mesh, int dimension, int seed)
{
  const GridPointer source = WithFields(MakeGrid(mesh), seed);
  const GridPointer grid = GridAround(source, dimension == 3 ? 3 : 5, dimension);
  for (const int method : { Remap::CONSERVATIVE_FIRST_ORDER, Remap::CONSERVATIVE_SECOND_ORDER })
  {
    ExpectLinear(ExpectKept(grid, source, method), grid);
  }
}

/// Onto cells within the mesh: there is no gap between its cells, and nothing is there twice.
void ExpectNoGaps(const Mesh& mesh, const Mesh& inside)
{
  const RemapPointer remap =
    MakeRemap(MakeGrid(inside), WithFields(MakeGrid(mesh), 1), Remap::CONSERVATIVE_FIRST_ORDER);
  for (const double share : RemappedCells(remap, "SkdCoverage"))
  {
    EXPECT_NEAR(share, 1.0, Rounding);
  }
  for (const double one : RemappedCells(remap, "PointOne"))
  {
    EXPECT_NEAR(one, 1.0, Rounding);
  }
}

/// Points moved by up to `most`, along the first axes.
Mesh Jittered(Mesh mesh, double most, int seed, int dimension = 3)
{
  Random random(seed);
  return mesh.Map(
    [&](const Point& p)
    {
      Point moved = p;
      for (int axis = 0; axis < dimension; ++axis)
      {
        moved[static_cast<std::size_t>(axis)] += random.Between(-most, most);
      }
      return moved;
    });
}

/// Cells of a curved type that share sides: two hexahedra, or what a cube is made of.
Mesh CurvedNeighbours(int type, int order)
{
  Mesh linear = LinearBlock(LinearTypeOf(type), LinearTypeOf(type) == VTK_HEXAHEDRON ? 2 : 1);
  if (LinearTypeOf(type) == VTK_HEXAHEDRON)
  {
    linear.Cells.resize(2);
  }
  return Elevated(linear, type, order);
}

/// Orders of a type that tests try.
std::vector<int> OrdersOf(int type)
{
  const bool isSlow = LinearTypeOf(type) != VTK_HEXAHEDRON && type >= VTK_BEZIER_CURVE; // in VTK
  return IsHigherOrder(type) && HighestOrder() > 2 && !isSlow ? std::vector<int>{ 2, 3 }
                                                              : std::vector<int>{ 2 };
}

Mesh Prism(int type)
{
  return ReferenceCell(type, 1);
}

}

/// Every curved volume type, bent and with random points, so that no side is like another.
class RemapCurved : public ::testing::TestWithParam<int>
{
};

TEST_P(RemapCurved, NeighboursFitAndIntegralsAreKept)
{
  for (const int order : OrdersOf(GetParam()))
  {
    SCOPED_TRACE(order);
    const Mesh mesh =
      Jittered(CurvedNeighbours(GetParam(), order).Map(Bowed), 0.03, 7 * order + GetParam());
    ExpectWhole(mesh, 3, order);
  }
}

TEST_P(RemapCurved, OntoEachOther)
{
  const Mesh mesh = Jittered(CurvedNeighbours(GetParam(), 2).Map(Bowed), 0.02, GetParam());
  Mesh inside = CurvedNeighbours(GetParam(), 2);
  inside =
    Jittered(Transformed(inside, 0.5, { 0.27, 0.24, 0.23 }).Map(Bowed), 0.01, GetParam() + 1);
  ExpectNoGaps(mesh, inside);
}

/// With straight sides it is what its functions say: a quadratic field, exactly.
TEST_P(RemapCurved, StraightCellsIntegrateTheirOwnFunctions)
{
  const bool isBezier = GetParam() >= VTK_BEZIER_CURVE;
  const bool isQuadratic = !isBezier && GetParam() != VTK_QUADRATIC_LINEAR_WEDGE &&
    LinearTypeOf(GetParam()) != VTK_PYRAMID; // the others have no such fields
  const double square = isQuadratic ? 1.0 : 0.0;
  const auto quadratic = [square](const Point& p)
  { return 1.0 + p[0] + square * (-2.0 * p[1] * p[1] + 3.0 * p[0] * p[2]); };
  const Mesh mesh = CurvedNeighbours(GetParam(), 2);
  const GridPointer source = MakeGrid(mesh);
  source->GetPointData()->AddArray(MakeArray("f", source->GetNumberOfPoints(),
    [&](vtkIdType i) { return quadratic(mesh.Points[static_cast<std::size_t>(i)]); }));
  const GridPointer grid = GridAround(source, 2, 3);
  const RemapPointer remap = MakeRemap(grid, source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->Update();
  const double length = LinearTypeOf(GetParam()) == VTK_HEXAHEDRON ? 2.0 : 1.0; // along x
  const double mean = 1.0 + 0.5 * length + square * (-2.0 / 3.0 + 0.75 * length);
  EXPECT_NEAR(ReportedOf(remap, "f", "TargetIntegral"), length * mean, 1e-12);
  EXPECT_NEAR(ReportedOf(remap, "f", "SourceIntegral"), length * mean, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Volumes, RemapCurved, ::testing::ValuesIn(CurvedVolumeTypes()),
  [](const auto& type) { return NameOfType(type.param); });

/// Hexahedra, wedges and pyramids of the same degree in a row.
TEST(RemapCurvedMixed, CellsOfDifferentTypesFit)
{
  const auto at = [](const Mesh& mesh, double x) { return Transformed(mesh, 1.0, { x, 0, 0 }); };
  const std::vector<std::array<int, 3>> families{ { VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
                                                    VTK_QUADRATIC_PYRAMID },
    { VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE, VTK_TRIQUADRATIC_PYRAMID },
    { VTK_TRIQUADRATIC_HEXAHEDRON, VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_LAGRANGE_WEDGE } };
  for (const auto& family : families)
  {
    const auto cube = [&](int i) { return CurvedBlock(family[static_cast<std::size_t>(i)], 1); };
    Mesh mesh =
      Welded(Together({ at(cube(0), 0), at(cube(1), 1), at(cube(2), 2), at(cube(0), 3) }));
    mesh = Jittered(mesh.Map(Bowed), 0.02, family[2]);
    ExpectWhole(mesh, 3, 3);
    Mesh inside = Transformed(Tetrahedra(2), 0.3, { 0, 0, 0 });
    inside.Map([](const Point& p) { return Bowed({ 0.5 + 5.0 * p[0], p[1] + 0.2, p[2] + 0.2 }); });
    ExpectNoGaps(mesh, inside);
  }
}

/// Linear cells with warped sides, random ones; one alone as well as neighbours.
TEST(RemapWarped, LinearCells)
{
  const std::vector<Mesh> meshes{ Hexahedra(1), InvertedHexahedra(1), Wedges(1), Pyramids(1),
    Tetrahedra(1), Polyhedra(1), Prism(VTK_PENTAGONAL_PRISM), Prism(VTK_HEXAGONAL_PRISM),
    Hexahedra(2), Wedges(2), Pyramids(2), Polyhedra(2) };
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    for (const double most : { 0.0, 1e-7, 0.12 })
    {
      SCOPED_TRACE(testing::Message() << i << " by " << most);
      ExpectWhole(Jittered(meshes[i], most, static_cast<int>(i)), 3, static_cast<int>(i));
    }
  }
}

/// A pentagonal and a hexagonal prism that share a warped quadrilateral with a hexahedron.
TEST(RemapWarped, PrismsAndTheirNeighbours)
{
  Mesh mesh;
  const auto position = [](double x, double y, double z) {
    return Point{ x + 0.1 * z * y, y - 0.15 * x * z, z + 0.2 * std::sin(3.0 * x * y) };
  };
  const std::vector<Point> outline{ { -1, 0, 0 }, { 0, -0.6, 0 }, { 0, 1, 0 }, { -1, 0.9, 0 },
    { -1.5, 0.4, 0 }, { 1, -0.5, 0 }, { 1, 1, 0 }, { 1.8, -0.6, 0 }, { 2.2, 0.1, 0 },
    { 2.2, 0.7, 0 }, { 1.7, 1.2, 0 } };
  for (const double z : { 0.0, 1.0 })
  {
    for (const Point& p : outline)
    {
      mesh.Add(position(p[0], p[1], z));
    }
  }
  const auto add = [&](int type, Ids bottom)
  {
    const std::size_t size = bottom.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      bottom.push_back(bottom[i] + 11);
    }
    mesh.Add(type, bottom);
  };
  add(VTK_PENTAGONAL_PRISM, { 0, 1, 2, 3, 4 });
  add(VTK_HEXAHEDRON, { 1, 5, 6, 2 });
  add(VTK_HEXAGONAL_PRISM, { 5, 7, 8, 9, 10, 6 });
  ExpectWhole(mesh, 3, 5);
  Mesh inside = Transformed(Wedges(2), 0.2, { 0, 0.2, 0.3 });
  ExpectNoGaps(mesh,
    inside.Map(
      [](const Point& p) {
        return Point{ 7.0 * p[0] - 0.9, p[1], p[2] };
      }));
}

/// Curved surfaces in a plane.
TEST(RemapCurvedSurfaces, InAPlane)
{
  const auto bent = [](const Point& p) {
    return Point{ p[0] + 0.1 * std::sin(2.0 * p[1]), p[1] + 0.1 * p[0] * p[0], 0.0 };
  };
  for (const int type : CurvedSurfaceTypes())
  {
    for (const int order : OrdersOf(type))
    {
      SCOPED_TRACE(NameOfType(type));
      const Mesh mesh = Elevated(Sheet(2, LinearTypeOf(type)), type, order).Map(bent);
      ExpectWhole(Jittered(mesh, 0.02, type, 2), 2, type);
    }
  }
}

/// A strip, and a quadratic polygon, whose sides are straight between its points.
TEST(RemapCurvedSurfaces, StripsAndQuadraticPolygons)
{
  Mesh mesh = Jittered(Sheet(2, VTK_QUAD), 0.2, 4, 2);
  const auto middle = [&](std::size_t a, std::size_t b)
  { return mesh.Add(Lerp(mesh.Points[a], mesh.Points[b], 0.5)); };
  const Ids polygon{ 4, 5, 8, 7, middle(4, 5), mesh.Add({ 2.3, 1.6, 0 }), mesh.Add({ 1.4, 2.2, 0 }),
    middle(7, 4) };
  mesh.Cells = { { VTK_TRIANGLE_STRIP, { 0, 3, 1, 4, 2, 5 } }, { VTK_QUAD, { 3, 4, 7, 6 } },
    { VTK_QUADRATIC_POLYGON, polygon } };
  ExpectWhole(mesh, 2, 1);
}

/// The whole sphere by curved cells: as much as there is, and nothing twice.
TEST(RemapCurvedSurfaces, OnASphere)
{
  const GridPointer sphere = MakeGrid(CubedSphere(3));
  for (const int type : CurvedSurfaceTypes())
  {
    SCOPED_TRACE(NameOfType(type));
    const bool isQuad = LinearTypeOf(type) == VTK_QUAD;
    Mesh mesh = Elevated(isQuad ? CubedSphere(2) : Triangulated(CubedSphere(2)), type);
    mesh.Map([](const Point& p) { return (1.0 / Length(p)) * p; });
    const Result result =
      ExpectKept(sphere, WithFields(MakeGrid(mesh), type), Remap::CONSERVATIVE_SECOND_ORDER);
    EXPECT_NEAR(
      ReportedOf(result.Filter, "PointOne", "SourceIntegral"), 4.0 * std::acos(-1.0), 1e-12);
    for (const double share : result.Coverage)
    {
      EXPECT_NEAR(share, 1.0, Rounding);
    }
  }
}

/// What does not count is left out; what is left stays within its bounds.
TEST(RemapCurvedSurfaces, MissingValuesOfCurvedCells)
{
  const Mesh mesh = CurvedBlock(VTK_QUADRATIC_HEXAHEDRON, 1);
  const GridPointer source = MakeGrid(mesh);
  source->GetPointData()->AddArray(MakeArray("f", source->GetNumberOfPoints(),
    [](vtkIdType i) { return i % 3 == 0 ? std::nan("") : 1.0 + static_cast<double>(i % 2); }));
  const RemapPointer remap =
    MakeRemap(GridAround(source, 4, 3), source, Remap::CONSERVATIVE_FIRST_ORDER);
  for (const double value : RemappedCells(remap, "f"))
  {
    EXPECT_TRUE(std::isnan(value) || (value >= 1.0 && value <= 2.0)) << value;
  }
}

/// Cells that are partly turned inside out: integrals are kept.
TEST(RemapWarped, FoldedCellsKeepIntegrals)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    const std::vector<int> types{ VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_QUADRATIC_HEXAHEDRON,
      VTK_QUADRATIC_WEDGE, VTK_HEXAGONAL_PRISM };
    const int type = types[static_cast<std::size_t>(seed) % types.size()];
    SCOPED_TRACE(NameOfType(type));
    const GridPointer source =
      WithFields(MakeGrid(Jittered(ReferenceCell(type, 1), 0.35, seed)), seed);
    const GridPointer grid = MakeGrid(Transformed(Hexahedra(4), 1.0, { -1.51, -1.52, -1.53 }));
    const RemapPointer remap = MakeRemap(grid, source, Remap::CONSERVATIVE_FIRST_ORDER);
    remap->Update();
    for (const char* name : { "PointOne", "PointRandom", "CellOne", "CellRandom" })
    {
      const double expected = ReportedOf(remap, name, "SourceIntegral");
      EXPECT_NEAR(ReportedOf(remap, name, "OverlapIntegral"), expected, Rounding) << name;
    }
  }
}
