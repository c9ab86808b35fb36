// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Integers of 64 bits, of which a double has the first 53, interpolated: none overflows, and those
// that are the same all around a point are that there.

#include "Support/ClosestPointRun.h"
#include "Support/CurvedMeshes.h"
#include "Support/ProbeRun.h"
#include "Support/VolumeMeshes.h"

#include "vtkLongLongArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedLongLongArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

using namespace skdtest;

namespace
{
using Long = long long;
using Unsigned = unsigned long long;

constexpr Long Largest = std::numeric_limits<Long>::max();
constexpr Long Lowest = std::numeric_limits<Long>::min();
constexpr Unsigned LargestUnsigned = std::numeric_limits<Unsigned>::max();
constexpr Long Odd = (1LL << 60) + 1;

template <class Array, class ValueOf>
void AddPointArray(vtkDataSet* mesh, const char* name, const ValueOf& valueOf)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    array->SetValue(i, valueOf(i));
  }
  mesh->GetPointData()->AddArray(array);
}

GridPointer MakeCells()
{
  return MakeGrid(Transformed(Hexahedra(2), 0.7, { 0.1, 0.2, 0.3 }));
}

/// The source's point data at points within its cells, by the filters that interpolate them.
std::vector<vtkSmartPointer<vtkDataObject>> Interpolated(vtkDataObject* source, vtkDataSet* where)
{
  const auto queries = MakeQueries(MakePointsInCells(where, 60).Points);
  const auto probe = MakeProbe(queries, source);
  probe->Update();
  const auto closest = MakeFilter(queries, source);
  closest->InterpolateSourceDataOn();
  closest->Update();
  return { probe->GetOutputDataObject(0), closest->GetOutputDataObject(0) };
}

template <class Array>
Array* ArrayOf(vtkDataObject* output, const char* name)
{
  return Array::SafeDownCast(vtkDataSet::SafeDownCast(output)->GetPointData()->GetArray(name));
}
}

TEST(LongIntegers, ThatAreAllTheSameAreExact)
{
  const GridPointer mesh = MakeCells();
  const std::map<std::string, Long> values{ { "largest", Largest }, { "lowest", Lowest },
    { "odd", Odd }, { "near", Largest - 5 } };
  for (const auto& [name, value] : values)
  {
    AddPointArray<vtkLongLongArray>(mesh, name.c_str(), [v = value](vtkIdType) { return v; });
  }
  AddPointArray<vtkUnsignedLongLongArray>(
    mesh, "unsigned", [](vtkIdType) { return LargestUnsigned; });
  AddPointArray<vtkSOADataArrayTemplate<Long>>(mesh, "apart", [](vtkIdType) { return Largest; });
  for (const auto& output : Interpolated(mesh, mesh))
  {
    for (vtkIdType i = 0; i < 60; ++i)
    {
      for (const auto& [name, value] : values)
      {
        ASSERT_EQ(ArrayOf<vtkLongLongArray>(output, name.c_str())->GetValue(i), value) << name;
      }
      ASSERT_EQ(
        ArrayOf<vtkUnsignedLongLongArray>(output, "unsigned")->GetValue(i), LargestUnsigned);
      ASSERT_EQ(ArrayOf<vtkLongLongArray>(output, "apart")->GetValue(i), Largest);
    }
  }
}

TEST(LongIntegers, AreAmongThoseAround)
{
  const GridPointer mesh = MakeCells();
  AddPointArray<vtkLongLongArray>(mesh, "high", [](vtkIdType i) { return Largest - i % 7; });
  AddPointArray<vtkLongLongArray>(mesh, "low", [](vtkIdType i) { return Lowest + i % 7; });
  AddPointArray<vtkLongLongArray>(
    mesh, "both", [](vtkIdType i) { return i % 2 ? Lowest : Largest; });
  AddPointArray<vtkDoubleArray>(mesh, "share", [](vtkIdType i) { return i % 2 ? -1.0 : 1.0; });
  AddPointArray<vtkUnsignedLongLongArray>(
    mesh, "unsigned", [](vtkIdType i) { return LargestUnsigned - static_cast<Unsigned>(i % 7); });
  for (const auto& output : Interpolated(mesh, mesh))
  {
    for (vtkIdType i = 0; i < 60; ++i)
    {
      ASSERT_GE(ArrayOf<vtkLongLongArray>(output, "high")->GetValue(i), Largest - 6);
      ASSERT_LE(ArrayOf<vtkLongLongArray>(output, "low")->GetValue(i), Lowest + 6);
      ASSERT_GE(
        ArrayOf<vtkUnsignedLongLongArray>(output, "unsigned")->GetValue(i), LargestUnsigned - 6);
      const double share = ArrayOf<vtkDoubleArray>(output, "share")->GetValue(i);
      const auto both = static_cast<double>(ArrayOf<vtkLongLongArray>(output, "both")->GetValue(i));
      ASSERT_NEAR(both / std::ldexp(1.0, 63), share, 1e-12);
    }
  }
}

// Quadratic cells are beyond the values of their points in between.
TEST(LongIntegers, BeyondTheirTypeAreItsEnds)
{
  const GridPointer mesh = MakeGrid(CurvedBlock(VTK_QUADRATIC_HEXAHEDRON, 1));
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(0, ids);
  const auto isCorner = [&](vtkIdType point) { return ids->IsId(point) < 8; };
  AddPointArray<vtkLongLongArray>(
    mesh, "high", [&](vtkIdType i) { return isCorner(i) ? Lowest : Largest; });
  AddPointArray<vtkLongLongArray>(
    mesh, "low", [&](vtkIdType i) { return isCorner(i) ? Largest : Lowest; });
  AddPointArray<vtkUnsignedLongLongArray>(
    mesh, "unsigned", [&](vtkIdType i) { return isCorner(i) ? 0 : LargestUnsigned; });
  Bounds box;
  mesh->GetBounds(box.data());
  const auto probe = MakeProbe(MakeQueries({ Center(box) }), mesh);
  probe->Update();
  vtkDataObject* output = probe->GetOutputDataObject(0);
  EXPECT_EQ(ArrayOf<vtkLongLongArray>(output, "high")->GetValue(0), Largest);
  EXPECT_EQ(ArrayOf<vtkLongLongArray>(output, "low")->GetValue(0), Lowest);
  EXPECT_EQ(ArrayOf<vtkUnsignedLongLongArray>(output, "unsigned")->GetValue(0), LargestUnsigned);
}

// The first block decides what the results are.
TEST(LongIntegers, OfBlocksOfOtherTypesAreExact)
{
  const GridPointer first = MakeCells();
  const GridPointer second = MakeGrid(Transformed(Hexahedra(2), 0.7, { 5, 5, 5 }));
  AddPointArray<vtkLongLongArray>(first, "f", [](vtkIdType) { return Odd; });
  AddPointArray<vtkUnsignedLongLongArray>(
    second, "f", [](vtkIdType) { return static_cast<Unsigned>(Odd); });
  AddPointArray<vtkLongLongArray>(first, "g", [](vtkIdType) { return Odd; });
  AddPointArray<vtkUnsignedLongLongArray>(second, "g", [](vtkIdType) { return LargestUnsigned; });
  AddPointArray<vtkUnsignedLongLongArray>(
    first, "h", [](vtkIdType) { return static_cast<Unsigned>(Odd); });
  AddPointArray<vtkLongLongArray>(second, "h", [](vtkIdType) { return -7; });
  AddPointArray<vtkLongLongArray>(first, "i", [](vtkIdType) { return Odd; });
  AddPointArray<vtkDoubleArray>(second, "i", [](vtkIdType) { return 1e30; });
  for (const auto& output : Interpolated(MakeBlocks({ first, second }), second))
  {
    for (vtkIdType i = 0; i < 60; ++i)
    {
      ASSERT_EQ(ArrayOf<vtkLongLongArray>(output, "f")->GetValue(i), Odd);
      ASSERT_EQ(ArrayOf<vtkLongLongArray>(output, "g")->GetValue(i), Largest);
      ASSERT_EQ(ArrayOf<vtkUnsignedLongLongArray>(output, "h")->GetValue(i), 0u);
      ASSERT_EQ(ArrayOf<vtkLongLongArray>(output, "i")->GetValue(i), Largest);
    }
  }
}

TEST(LongIntegers, OfPointsOutsideMayBeTheEnds)
{
  const GridPointer mesh = MakeCells();
  AddPointArray<vtkLongLongArray>(mesh, "f", [](vtkIdType) { return Odd; });
  for (const double fill : { 1e30, -1e30 })
  {
    const auto probe = MakeProbe(MakeQueries({ { 50, 50, 50 } }), mesh);
    probe->UseFillValueOn();
    probe->SetFillValue(fill);
    probe->Update();
    EXPECT_EQ(ArrayOf<vtkLongLongArray>(probe->GetOutputDataObject(0), "f")->GetValue(0),
      fill > 0.0 ? Largest : Lowest);
  }
}
