// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Adaptation/SkdFieldSamples.h"

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace skdtree
{
namespace
{
/// The named array, or else the first of numbers, that is no mark of ghosts.
vtkDataArray* FindArray(vtkDataSetAttributes* data, const std::string& name)
{
  if (!name.empty())
  {
    return data->GetArray(name.c_str());
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const char* itsName = array ? array->GetName() : nullptr;
    if (itsName && itsName != std::string(vtkDataSetAttributes::GhostArrayName()))
    {
      return array;
    }
  }
  return nullptr;
}

double MagnitudeOf(vtkDataArray* array, vtkIdType i)
{
  if (array->GetNumberOfComponents() == 1)
  {
    return array->GetComponent(i, 0);
  }
  double sum = 0.0;
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    sum += array->GetComponent(i, k) * array->GetComponent(i, k);
  }
  return std::sqrt(sum);
}

skd::Vector3 MiddleOf(vtkDataSet* mesh, vtkIdType cell, vtkGenericCell* scratch)
{
  SkdLoadCell(mesh, cell, scratch);
  skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
  const vtkIdType n = scratch->GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i)
  {
    skd::Vector3 x;
    scratch->GetPoints()->GetPoint(i, x.X);
    sum = sum + x;
  }
  return n > 0 ? (1.0 / static_cast<double>(n)) * sum : sum;
}

struct Sample
{
  skd::Vector3 Position;
  double Value;

  /// Row by row, as structured grids have their points.
  auto AsRow() const
  {
    const skd::Vector3& x = this->Position;
    return std::make_tuple(x[2], x[1], x[0], this->Value);
  }
  bool operator<(const Sample& other) const { return this->AsRow() < other.AsRow(); }
  bool operator==(const Sample& other) const { return this->AsRow() == other.AsRow(); }
};
}

void SkdFieldSamples::AddAll(
  vtkDataSet* mesh, int type, vtkDataArray* array, const std::string& where)
{
  const vtkUnsignedCharArray* none = nullptr;
  vtkUnsignedCharArray* ghosts =
    type == vtkDataObject::POINT ? mesh->GetPointGhostArray() : mesh->GetCellGhostArray();
  const std::vector<unsigned char> shown = SkdFindShown(mesh, type);
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    skd::Vector3 x;
    if (type == vtkDataObject::POINT)
    {
      mesh->GetPoint(i, x.X);
    }
    else
    {
      x = MiddleOf(mesh, i, cell);
    }
    const bool counts =
      shown[static_cast<std::size_t>(i)] != 0 && (ghosts == none || ghosts->GetValue(i) == 0);
    const double value = counts ? MagnitudeOf(array, i) : vtkMath::Nan();
    const bool isTooLarge = std::abs(value) > SkdComparable.Largest;
    if (isTooLarge && skd::IsFinite(x) && this->TooLarge.insert(x).second &&
      this->TooLarge.size() == 1)
    {
      const char* what = type == vtkDataObject::POINT ? "point " : "cell ";
      this->FirstTooLarge = what + std::to_string(i) + where;
    }
    this->Positions.push_back(x);
    this->Values.push_back(isTooLarge ? vtkMath::Nan() : value);
  }
  this->IsStructured = this->IsStructured || SkdIsStructured(mesh);
}

SkdFieldSamples SkdFieldSamples::Read(vtkDataObject* source, const std::string& name)
{
  SkdFieldSamples samples;
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    for (const SkdBlock& block : SkdBlocksOf(source))
    {
      vtkDataArray* array = FindArray(block.Mesh->GetAttributes(type), name);
      if (array)
      {
        const std::string where = " of block " + std::to_string(block.BlockIndex);
        samples.AddAll(block.Mesh, type, array, SkdIsComposite(source) ? where : "");
      }
    }
    if (!samples.Positions.empty())
    {
      samples.AreOfPoints = type == vtkDataObject::POINT;
      break;
    }
  }
  return samples;
}

SkdFieldSamples SkdFieldSamples::Distinct() const
{
  std::vector<Sample> all;
  all.reserve(this->Values.size());
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    if (skd::IsFinite(this->Positions[i]) && !std::isnan(this->Values[i]))
    {
      all.push_back({ this->Positions[i], this->Values[i] });
    }
  }
  if (!std::is_sorted(all.begin(), all.end()))
  {
    std::sort(all.begin(), all.end());
  }
  all.erase(std::unique(all.begin(), all.end()), all.end());
  SkdFieldSamples distinct;
  distinct.AreOfPoints = this->AreOfPoints;
  distinct.IsStructured = this->IsStructured;
  distinct.Positions.reserve(all.size());
  distinct.Values.reserve(all.size());
  for (const Sample& sample : all)
  {
    distinct.Positions.push_back(sample.Position);
    distinct.Values.push_back(sample.Value);
  }
  return distinct;
}

bool SkdFieldSamples::HasAny() const
{
  return std::any_of(
    this->Values.begin(), this->Values.end(), [](double value) { return std::isfinite(value); });
}
}
