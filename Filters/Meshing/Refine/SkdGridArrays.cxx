// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridArrays.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

namespace skdtree
{
namespace
{
constexpr const char* CutName = "SkdCut";
constexpr const char* PartName = "SkdPartIndex";
constexpr const char* CandidatesName = "SkdCandidates";
constexpr const char* InsideName = "SkdInside";
constexpr const char* DistanceName = "SkdDistance";
constexpr const char* FractionName = "SkdVolumeFraction";

template <typename Array, typename Value>
vtkSmartPointer<vtkDataArray> MakeArray(
  const char* name, const std::vector<SkdGridCell>& cells, const Value& value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(cells.size()));
  SkdForEach(array->GetNumberOfTuples(),
    [&](vtkIdType i)
    {
      const SkdGridCell& at = cells[static_cast<std::size_t>(i)];
      array->SetValue(i, value(at.Level, at.Index));
    });
  return array;
}

vtkSmartPointer<vtkDataArray> MakeFieldArray(
  const SkdGridField& field, const std::vector<SkdGridCell>& cells)
{
  const auto components = static_cast<std::size_t>(field.Components);
  const auto array = SkdMakeArray<vtkDoubleArray>(
    field.Name.c_str(), field.Components, static_cast<vtkIdType>(cells.size()));
  SkdForEach(array->GetNumberOfTuples(),
    [&](vtkIdType i)
    {
      const SkdGridCell& at = cells[static_cast<std::size_t>(i)];
      array->SetTypedTuple(
        i, field.Values[static_cast<std::size_t>(at.Level)].data() + at.Index * components);
    });
  return array;
}
}

std::vector<vtkSmartPointer<vtkDataArray>> SkdGridArrays::Make(const SkdGrid& grid,
  const SkdGridExtras& extras, const std::vector<int>& blockIndices,
  const std::vector<SkdGridCell>& cells)
{
  using Index = std::uint32_t;
  const auto& levels = grid.Levels;
  const auto blockOf = [&](int level, Index cell)
  {
    const std::int32_t part = levels[level].Part[cell];
    return part < 0 ? -1 : blockIndices[static_cast<std::size_t>(part)];
  };
  std::vector<vtkSmartPointer<vtkDataArray>> arrays{
    MakeArray<vtkUnsignedCharArray>(
      LevelName, cells, [](int level, Index) { return static_cast<unsigned char>(level); }),
    MakeArray<vtkUnsignedCharArray>(
      CutName, cells, [&](int level, Index cell) { return levels[level].Cut[cell]; }),
    MakeArray<vtkIntArray>(PartName, cells, blockOf),
    MakeArray<vtkIntArray>(
      CandidatesName, cells, [&](int level, Index cell) { return levels[level].Candidates[cell]; })
  };
  if (!extras.Inside.empty())
  {
    arrays.push_back(MakeArray<vtkUnsignedCharArray>(
      InsideName, cells, [&](int level, Index cell) { return extras.Inside[level][cell]; }));
  }
  if (!extras.Fractions.empty())
  {
    arrays.push_back(MakeArray<vtkDoubleArray>(
      FractionName, cells, [&](int level, Index cell) { return extras.Fractions[level][cell]; }));
  }
  if (!extras.Distances.empty())
  {
    arrays.push_back(MakeArray<vtkDoubleArray>(
      DistanceName, cells, [&](int level, Index cell) { return extras.Distances[level][cell]; }));
  }
  for (const SkdGridField& field : extras.Fields)
  {
    arrays.push_back(MakeFieldArray(field, cells));
  }
  return arrays;
}
}
