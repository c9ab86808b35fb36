// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays that only one block of a composite has: every filter that brings data of blocks together
// keeps them, marks where they have values, and lists them in its report.

#include "Support/FilterRun.h"
#include "Support/FilterZoo.h"
#include "Support/QuietWindow.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeProbe.h"
#include "vtkSkdTreeRemap.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// Arrays "Both" of the points, "BothOfCells" of the cells, and by choice others of the same
/// values, of double and int.
DataSetPointer WithArrays(DataSetPointer mesh, bool hasAll)
{
  const auto atPoint = [&](vtkIdType i)
  {
    Point p;
    mesh->GetPoint(i, p.data());
    return std::round(Linear(p) + 100.0);
  };
  const auto atCell = [](vtkIdType i) { return 100.0 + double(i % 7); };
  const auto add = [hasAll](vtkDataSetAttributes* data, const std::string& suffix, vtkIdType n,
                     const std::function<double(vtkIdType)>& value)
  {
    data->AddArray(MakeArray(("Both" + suffix).c_str(), n, value));
    if (hasAll)
    {
      data->AddArray(MakeArray(("Some" + suffix).c_str(), n, value));
      data->AddArray(MakeArray<vtkIntArray>(("Ints" + suffix).c_str(), n, value));
    }
  };
  add(mesh->GetPointData(), "", mesh->GetNumberOfPoints(), atPoint);
  add(mesh->GetCellData(), "OfCells", mesh->GetNumberOfCells(), atCell);
  return mesh;
}

/// Two blocks, and one of nothing, that say nothing of arrays.
vtkSmartPointer<vtkMultiBlockDataSet> TwoBlocks(
  const Mesh& mesh, const Point& first, const Point& second, bool isFirst, bool isPolyData)
{
  const auto make = [&](const Point& shift, bool hasAll) -> DataSetPointer
  {
    const Mesh placed = Transformed(mesh, 1.0, shift);
    return WithArrays(
      isPolyData ? DataSetPointer(MakePolyData(placed)) : DataSetPointer(MakeGrid(placed)), hasAll);
  };
  return MakeBlocks(
    { make(first, isFirst), vtkSmartPointer<vtkPolyData>::New(), make(second, !isFirst) });
}

vtkSmartPointer<vtkMultiBlockDataSet> Spheres(bool isFirst)
{
  return TwoBlocks(Transformed(SphereTriangles(4), 0.6, { 0, 0, 0 }), { 0.8, 1.2, 1.2 },
    { 1.9, 1.2, 1.2 }, isFirst, true);
}

vtkSmartPointer<vtkMultiBlockDataSet> Volumes(bool isFirst)
{
  Mesh half = Hexahedra(2);
  half.Map([](const Point& p) { return Point{ 0.6 * p[0], 1.2 * p[1], 1.2 * p[2] }; });
  return TwoBlocks(half, { 0, 0.02, 0.03 }, { 1.2, 0.02, 0.03 }, isFirst, false);
}

Ids NamedIn(vtkDataObject* output, const std::vector<std::string>& names)
{
  auto* list = vtkStringArray::SafeDownCast(
    output->GetFieldData()->GetAbstractArray("SkdReportPartialArrays"));
  Ids found;
  for (const std::string& name : names)
  {
    found.push_back(list ? list->LookupValue(name) : -1);
  }
  return found;
}

struct Counts
{
  int Marked = 0;
  int Other = 0;
};

void CheckValues(vtkDataSetAttributes* data, const std::string& suffix, Counts& counts)
{
  vtkDataArray* both = data->GetArray(("Both" + suffix).c_str());
  vtkDataArray* some = data->GetArray(("Some" + suffix).c_str());
  vtkDataArray* ints = data->GetArray(("Ints" + suffix).c_str());
  vtkDataArray* marks = data->GetArray(("SkdValid_Some" + suffix).c_str());
  ASSERT_TRUE(both && some && ints && marks) << suffix;
  ASSERT_TRUE(data->GetArray(("SkdValid_Ints" + suffix).c_str()));
  EXPECT_EQ(ints->GetDataType(), VTK_INT);
  for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
  {
    if (marks->GetTuple1(i) == 1.0)
    {
      ++counts.Marked;
      EXPECT_EQ(some->GetTuple1(i), both->GetTuple1(i));
      EXPECT_NEAR(ints->GetTuple1(i), both->GetTuple1(i), 0.5 + 1e-9);
    }
    else
    {
      ++counts.Other;
      EXPECT_TRUE(std::isnan(some->GetTuple1(i)));
      EXPECT_EQ(ints->GetTuple1(i), 0.0);
    }
  }
}

/// Whether a data set has them: one that passes its own does not gather any.
bool HasThem(vtkDataSetAttributes* data, const std::string& suffix)
{
  return data->HasArray(("Both" + suffix).c_str()) && data->GetNumberOfTuples() > 0;
}

/// Looks at all outputs that are data sets. Returns how many have the arrays.
int CheckOutputs(vtkAlgorithm* filter)
{
  int outputs = 0;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    auto* mesh = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    Counts counts;
    for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      for (const std::string suffix : { "", "OfCells" })
      {
        if (mesh && HasThem(mesh->GetAttributes(type), suffix))
        {
          CheckValues(mesh->GetAttributes(type), suffix, counts);
          for (const vtkIdType at : NamedIn(mesh, { "Some" + suffix, "Ints" + suffix }))
          {
            EXPECT_GE(at, 0) << port;
          }
        }
      }
    }
    if (counts.Marked + counts.Other > 0)
    {
      ++outputs;
      EXPECT_GT(counts.Marked, 0) << port;
      EXPECT_GT(counts.Other, 0) << port;
    }
  }
  return outputs;
}

const FilterSetup& SetupNamed(const std::string& name)
{
  const auto& all = AllFilterSetups();
  return *std::find_if(
    all.begin(), all.end(), [&](const FilterSetup& setup) { return setup.Name == name; });
}

TEST(PartialArrays, AreKeptAndMarked)
{
  QuietWindow quiet;
  const std::pair<const char*, int> outputsOf[] = { { "ClosestPointOn", 2 }, { "RaysOn", 1 },
    { "RaysFrom", 1 }, { "CurveOnSurface", 1 }, { "SurfaceIntersection", 1 },
    { "SurfaceWithItself", 1 }, { "BooleanDifference", 1 }, { "BooleanCut", 1 } };
  for (const bool isFirst : { true, false })
  {
    for (const auto& [name, outputs] : outputsOf)
    {
      SCOPED_TRACE(std::string(name) + (isFirst ? ", first block" : ", second block"));
      const auto filter = SetupNamed(name).Make(Spheres(isFirst));
      filter->Update();
      EXPECT_GE(CheckOutputs(filter), outputs);
    }
    SCOPED_TRACE(isFirst ? "first block" : "second block");
    const auto probe = SetupNamed("ProbeOf").Make(Volumes(isFirst));
    probe->Update();
    EXPECT_GE(CheckOutputs(probe), 1);
  }
}

TEST(PartialArrays, AreAlsoThoseOfCurves)
{
  for (const bool isFirst : { true, false })
  {
    Mesh line;
    line.Add(VTK_POLY_LINE, { line.Add({ 0, -1, 0 }), line.Add({ 0, 1, 0 }) });
    Mesh across;
    across.Add(VTK_POLY_LINE, { across.Add({ -2, 0.1, 0 }), across.Add({ 5, 0.1, 0 }) });
    vtkNew<vtkSkdTreeCurveIntersection> filter;
    filter->SetInputDataObject(TwoBlocks(line, { 0, 0, 0 }, { 1, 0, 0 }, isFirst, true));
    filter->SetSourceData(MakePolyData(across));
    filter->InterpolateDataOn();
    filter->Update();
    EXPECT_EQ(CheckOutputs(filter), 1);
  }
}

std::vector<double> RemappedFrom(vtkDataObject* source, const char* name, int method)
{
  const auto filter = SetupNamed("RemapOf").Make(source);
  vtkSkdTreeRemap::SafeDownCast(filter)->SetMethod(method);
  filter->Update();
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(NamedIn(output, { "SomeOfCells" })[0] >= 0, source->IsA("vtkMultiBlockDataSet") != 0);
  EXPECT_EQ(NamedIn(output, { "BothOfCells" })[0], -1);
  vtkDataArray* array = output->GetCellData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}

TEST(PartialArrays, OfADonorAreAsIfTheOtherBlocksWereNotThere)
{
  QuietWindow quiet;
  for (const bool isFirst : { true, false })
  {
    const auto blocks = Volumes(isFirst);
    vtkDataObject* alone = blocks->GetBlock(isFirst ? 0 : 2);
    for (const int method : { vtkSkdTreeRemap::CONSERVATIVE_FIRST_ORDER,
           vtkSkdTreeRemap::CONSERVATIVE_SECOND_ORDER, vtkSkdTreeRemap::CONTAINED })
    {
      for (const char* name : { "SomeOfCells", "IntsOfCells" })
      {
        const std::vector<double> values = RemappedFrom(blocks, name, method);
        const std::vector<double> expected = RemappedFrom(alone, name, method);
        ASSERT_EQ(values.size(), expected.size());
        ASSERT_EQ(values.size(), 8u);
        for (std::size_t i = 0; i < values.size(); ++i)
        {
          EXPECT_EQ(std::isnan(values[i]), std::isnan(expected[i])) << method;
          EXPECT_FALSE(std::abs(values[i] - expected[i]) > 1e-12) << method << " " << name;
        }
      }
    }
  }
}

TEST(PartialArrays, AreNoneWhereAllBlocksHaveThem)
{
  QuietWindow quiet;
  const auto blocks = Spheres(true);
  WithArrays(vtkDataSet::SafeDownCast(blocks->GetBlock(2)), true);
  const auto filter = SetupNamed("ClosestPointOn").Make(blocks);
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  EXPECT_FALSE(output->GetFieldData()->HasArray("SkdReportPartialArrays"));
  EXPECT_TRUE(vtkDataSet::SafeDownCast(output)->GetPointData()->HasArray("Some"));
  EXPECT_FALSE(vtkDataSet::SafeDownCast(output)->GetPointData()->HasArray("SkdValid_Some"));
}

}
