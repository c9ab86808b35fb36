// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidRun.h
 * @brief vtkSkdTreeBooleanOperation on meshes, and what its results must be like
 */
#ifndef skdtest_SolidRun_h
#define skdtest_SolidRun_h

#include "Support/EventCounter.h"
#include "Support/IntegerBodies.h"
#include "Support/RandomSolids.h"
#include "Support/WindingReference.h"

#include "vtkFieldData.h"
#include "vtkSkdTreeBooleanOperation.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

namespace skdtest
{

/// How much is tried, unless the environment sets it.
inline int SetInEnvironment(const char* name, int otherwise)
{
  const char* set = std::getenv(name);
  return set ? std::atoi(set) : otherwise;
}

/// The polygons of an output, which are triangles.
inline Mesh MeshOf(vtkPolyData* surface)
{
  Mesh mesh;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Point x;
    surface->GetPoint(i, x.data());
    mesh.Add(x);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    mesh.Add(VTK_TRIANGLE, { ids->begin(), ids->end() });
  }
  return mesh;
}

/// The output of a filter that is set up, as triangles; closed, and found without an error.
inline Mesh RunSolid(vtkSkdTreeBooleanOperation* filter)
{
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 0) << events.Error;
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* badEdges = output->GetFieldData()->GetArray("SkdReportBadEdges");
  EXPECT_TRUE(badEdges && badEdges->GetTuple1(0) == 0.0);
  return MeshOf(output);
}

/// Two solids by an operation.
inline Mesh Combine(
  const Mesh& a, const Mesh& b, int operation, int rule = vtkSkdTreeBooleanOperation::NONZERO)
{
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputData(0, MakePolyData(a));
  filter->SetSourceData(MakePolyData(b));
  filter->SetOperation(operation);
  filter->SetInsideRule(rule);
  return RunSolid(filter);
}

/// Edges that are not passed as often in one direction as in the other.
inline std::ptrdiff_t CountBadEdges(const Mesh& mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> passes;
  for (const CellSpec& cell : mesh.Cells)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = cell.Points[i];
      const vtkIdType b = cell.Points[(i + 1) % 3];
      passes[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  return std::count_if(
    passes.begin(), passes.end(), [](const auto& edge) { return edge.second != 0; });
}

/// Volume, area, and the volume by which they may be wrong if each point is rounded.
struct Measures
{
  double Volume = 0.0;
  double Area = 0.0;
  double Rounding = 0.0;

  explicit Measures(const Mesh& mesh)
  {
    const Point origin = mesh.Points.empty() ? Point{} : mesh.Points[0];
    double largest = 0.0;
    for (const CellSpec& cell : mesh.Cells)
    {
      const Point a = mesh.Points[cell.Points[0]] - origin;
      const Point b = mesh.Points[cell.Points[1]] - origin;
      const Point c = mesh.Points[cell.Points[2]] - origin;
      this->Volume += Dot(a, Cross(b, c)) / 6.0;
      this->Area += 0.5 * Length(Cross(b - a, c - a));
      for (const double x : mesh.Points[cell.Points[0]])
      {
        largest = std::max(largest, std::abs(x));
      }
    }
    this->Rounding = std::numeric_limits<double>::epsilon() * largest * this->Area;
  }
};

/// The winding number, nothing on the surface.
inline std::optional<long> WindingAt(const Mesh& solid, const Point& x)
{
  const double winding = WindingNumber(solid, x);
  const bool isSure = std::abs(winding - std::round(winding)) < 1e-3;
  return isSure ? std::optional<long>(std::lround(winding)) : std::nullopt;
}

/// Whether a point is in a solid, nothing on its surface.
using InsideTest = std::function<std::optional<bool>(const Point&)>;

/// By an InsideRule.
inline InsideTest InsideTestOf(const Mesh& solid, int rule = vtkSkdTreeBooleanOperation::NONZERO)
{
  return [solid, rule](const Point& x) -> std::optional<bool>
  {
    const std::optional<long> winding = WindingAt(solid, x);
    const bool isIn = rule == vtkSkdTreeBooleanOperation::NONZERO ? winding.value_or(0) != 0
      : rule == vtkSkdTreeBooleanOperation::ODD                   ? winding.value_or(0) % 2 != 0
                                                                  : winding.value_or(0) > 0;
    return winding ? std::optional<bool>(isIn) : std::nullopt;
  };
}

/// Whether what an operation makes of two solids is solid.
inline bool IsSolid(int operation, bool a, bool b)
{
  return std::array<bool, 5>{ a || b, a && b, a && !b, b && !a, a != b }[operation];
}

inline InsideTest Combined(int operation, InsideTest a, InsideTest b)
{
  return [operation, a = std::move(a), b = std::move(b)](const Point& x) -> std::optional<bool>
  {
    const std::optional<bool> inA = a(x);
    const std::optional<bool> inB = b(x);
    return inA && inB ? std::optional<bool>(IsSolid(operation, *inA, *inB)) : std::nullopt;
  };
}

/// Where results must agree: anywhere around both, and near middles of their faces.
inline std::vector<Point> MakeQueries(Random& random, const std::vector<const Mesh*>& solids)
{
  std::vector<Point> queries;
  for (const Mesh* solid : solids)
  {
    Bounds box = EmptyBounds();
    for (const Point& p : solid->Points)
    {
      Extend(box, p);
    }
    // What rounding leaves between faces that should be one is thinner than rounding: a point of
    // its bounds would be on the surfaces of what it was made of, on a side that nobody can tell.
    box = Grown(box, 1e-6 * Diagonal(box));
    for (int i = 0; i < 10 && !solid->Cells.empty(); ++i)
    {
      const Ids& ids = solid->Cells[random.Index(static_cast<int>(solid->Cells.size()))].Points;
      const Point& corner = solid->Points[ids[0]];
      const Point middle = (1.0 / 3.0) * (corner + solid->Points[ids[1]] + solid->Points[ids[2]]);
      const double from = std::max(2e-3 * Distance(corner, middle), 1e-6 * Diagonal(box));
      queries.push_back(middle + from * random.Direction());
      queries.push_back(random.InBox(box));
    }
  }
  return queries;
}

/// A solid that is not empty and not inside out.
inline Mesh AnySolid(Random& random, std::string& what)
{
  for (;;)
  {
    RandomSolid solid = MakeRandomSolid(random);
    if (!solid.Triangles.Cells.empty())
    {
      what += solid.Kind;
      const bool isTurned = Measures(solid.Triangles).Volume < 0.0;
      return isTurned ? Inverted(solid.Triangles) : solid.Triangles;
    }
  }
}

/// Moves a solid by nothing, by quarters, or by anything; turns it or does not.
inline Mesh MovedAnywhere(Random& random, Mesh solid, std::string& what)
{
  const int turn = random.Index(3);
  if (turn > 0)
  {
    solid.Map(RandomRotation(random, turn == 1));
    what += turn == 1 ? ", turned by right angles" : ", turned";
  }
  const int direction = random.Index(3);
  const auto quarters = [&] { return 0.25 * (random.Index(9) - 4); };
  const Point by = direction == 0 ? Point{ 0, 0, 0 }
    : direction == 1              ? Point{ quarters(), quarters(), quarters() }
                                  : random.InBox({ -0.7, 0.7, -0.7, 0.7, -0.7, 0.7 });
  what += direction == 0 ? "" : direction == 1 ? ", moved by quarters" : ", moved";
  return Transformed(std::move(solid), 1.0, by);
}

/// A result is closed, and where it should be.
inline void ExpectSolid(Random& random, const std::vector<const Mesh*>& solids,
  const InsideTest& isInside, const Mesh& result)
{
  EXPECT_EQ(CountBadEdges(result), 0);
  for (const Point& x : MakeQueries(random, solids))
  {
    if (const std::optional<bool> isIn = isInside(x))
    {
      EXPECT_NEAR(WindingNumber(result, x), *isIn ? 1.0 : 0.0, 1e-3)
        << x[0] << " " << x[1] << " " << x[2];
    }
  }
}

}

#endif
