// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdFieldCriterion.h"

#include "Cells/Search/SkdVisitCandidates.h"
#include "Meshing/Refine/SkdSecondDifference.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// NaN of what is hidden.
std::vector<double> ValuesOf(vtkDataArray* array, vtkDataSet* mesh, int type)
{
  const std::vector<unsigned char> shown = SkdFindShown(mesh, type);
  const int components = array->GetNumberOfComponents();
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    double sum2 = 0.0;
    for (int k = 0; k < components; ++k)
    {
      const double value = array->GetComponent(static_cast<vtkIdType>(i), k);
      values[i] = value;
      sum2 += value * value;
    }
    values[i] = shown[i] == 0 ? vtkMath::Nan() : components == 1 ? values[i] : std::sqrt(sum2);
  }
  return values;
}
}

/// The values seen so far in a box, until the test is passed.
class SkdFieldCriterion::Look
{
public:
  Look(SkdFieldTest test, const Column& column)
    : Test(test)
    , Limits(column)
  {
  }

  void Add(double value)
  {
    if (!std::isfinite(value))
    {
      return;
    }
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
    this->Passes = this->Passes || this->IsEnough(value);
  }

  bool Passes = false;

private:
  bool IsEnough(double value) const
  {
    const Column& limits = this->Limits;
    return this->Test == SkdFieldTest::Value
      ? limits.Range[0] <= value && value <= limits.Range[1]
      : (this->Test == SkdFieldTest::Gradient ? value : this->High - this->Low) > limits.Threshold;
  }

  SkdFieldTest Test;
  const Column& Limits;
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
};

//------------------------------------------------------------------------------
void SkdFieldCriterion::TakeArray(std::uint32_t part, vtkDataSet* mesh, const std::string& name)
{
  vtkDataArray* ofPoints = mesh->GetPointData()->GetArray(name.c_str());
  vtkDataArray* ofCells = mesh->GetCellData()->GetArray(name.c_str());
  const bool isGradient = this->Settings.Test == SkdFieldTest::Gradient;
  if (ofPoints && isGradient)
  {
    this->Columns.push_back(
      { part, name, false, ValuesOf(ofPoints, mesh, vtkDataObject::POINT), 0.0, {} });
  }
  else if (ofPoints)
  {
    this->Columns.push_back(
      { part, name, true, ValuesOf(ofPoints, mesh, vtkDataObject::POINT), 0.0, {} });
  }
  else if (ofCells && !isGradient)
  {
    this->Columns.push_back(
      { part, name, false, ValuesOf(ofCells, mesh, vtkDataObject::CELL), 0.0, {} });
  }
  else
  {
    return;
  }
  this->Missing.erase(name);
}

/// Of each cell the largest difference of values at two of its points by their distance, 0 of cells
/// that are not in the tree.
std::vector<double> SkdFieldCriterion::FindGradients(
  std::uint32_t part, const std::vector<double>& values) const
{
  const SkdCellStore& cells = this->Meshes.GetTree(part).Cells();
  const auto number =
    static_cast<std::size_t>(this->Meshes.GetSource(part).Data->GetNumberOfCells());
  std::vector<double> gradients(number, 0.0);
  for (std::uint32_t cell = 0; cell < cells.NumberOfCells(); ++cell)
  {
    const std::uint32_t* ids = cells.PointIdsOf(cell);
    double& gradient = gradients[static_cast<std::size_t>(cells.IdOf(cell))];
    for (std::uint32_t i = 0; i < cells.SizeOf(cell); ++i)
    {
      for (std::uint32_t k = 0; k < i; ++k)
      {
        const double difference = std::abs(values[ids[i]] - values[ids[k]]);
        const double here = difference / skd::Norm(cells.Point(ids[i]) - cells.Point(ids[k]));
        gradient = here > gradient && std::isfinite(here) ? here : gradient;
      }
    }
  }
  return gradients;
}

//------------------------------------------------------------------------------
void SkdFieldCriterion::Update(
  const std::vector<SkdBlock>& blocks, const SkdFieldSettings& settings, double epsilon)
{
  this->Settings = settings;
  this->Missing = settings.Arrays;
  this->Columns.clear();
  this->Meshes.Update(blocks, epsilon, SkdComparable);
  std::uint32_t part = 0;
  for (const SkdBlock& block : SkdBlocksWithCells(blocks))
  {
    for (const std::string& name : settings.Arrays)
    {
      this->TakeArray(part, block.Mesh, name);
    }
    ++part;
  }
  this->FindRanges();
  this->SetLimits();
  if (settings.Test == SkdFieldTest::Gradient)
  {
    for (Column& column : this->Columns)
    {
      column.Values = this->FindGradients(column.Part, column.Values);
    }
  }
}

bool SkdFieldCriterion::IsRelative() const
{
  return this->Settings.IsRelative && this->Settings.Test != SkdFieldTest::SecondDifference;
}

/// Of the finite values of each array in all blocks.
void SkdFieldCriterion::FindRanges()
{
  this->Ranges.clear();
  for (const Column& column : this->Columns)
  {
    ValueRange& range = this->Ranges[column.Name];
    for (std::size_t i = 0; this->IsRelative() && i < column.Values.size(); ++i)
    {
      if (std::isfinite(column.Values[i]))
      {
        range.Add(column.Values[i]);
      }
    }
  }
}

void SkdFieldCriterion::ShareRanges(const skd::Processes& processes)
{
  if (!this->IsRelative() || this->Settings.Arrays.empty())
  {
    return;
  }
  std::vector<double> own;
  for (const std::string& name : this->Settings.Arrays)
  {
    const ValueRange& range = this->Ranges[name];
    own.insert(own.end(), { range.Least, range.Most });
  }
  for (const std::vector<double>& told : processes.GatherFromOthers(own))
  {
    std::size_t i = 0;
    for (const std::string& name : this->Settings.Arrays)
    {
      ValueRange& range = this->Ranges[name];
      range.Least = std::min(range.Least, told[i++]);
      range.Most = std::max(range.Most, told[i++]);
    }
  }
  this->SetLimits();
}

/// The thresholds of each array.
void SkdFieldCriterion::SetLimits()
{
  const SkdFieldSettings& settings = this->Settings;
  const bool isGradient = settings.Test == SkdFieldTest::Gradient;
  const double diagonal = this->Meshes.GetBounds().Diagonal();
  const bool isRelative = this->IsRelative();
  for (Column& column : this->Columns)
  {
    const ValueRange range = isRelative ? this->Ranges[column.Name] : ValueRange{ 0.0, 1.0 };
    const double unit = range.Most - range.Least;
    column.Threshold = settings.Threshold * (isRelative && isGradient ? unit / diagonal : unit);
    column.Range[0] = range.Least + settings.Range[0] * unit;
    column.Range[1] = range.Least + settings.Range[1] * unit;
  }
}

//------------------------------------------------------------------------------
/// Every point in the region is one of a cell whose safety box meets the region's box.
void SkdFieldCriterion::AddListed(const Column& column, const SkdRegion& region, Look& look) const
{
  const SkdCellTree& tree = this->Meshes.GetTree(column.Part);
  const SkdCellStore& cells = tree.Cells();
  const skd::CandidateLanes all = skd::AllCandidates().front();
  tree.VisitCandidates({ &all, &all + 1 }, region.GetBox(),
    [&](std::uint32_t cell)
    {
      if (look.Passes)
      {
        return;
      }
      bool isThere = !column.IsOfPoints && region.Meets(tree, cell, SkdOverlapTest::Exact);
      const std::uint32_t* ids = cells.PointIdsOf(cell);
      for (std::uint32_t i = 0; i < cells.SizeOf(cell) && !isThere; ++i)
      {
        const bool isPointThere = region.Contains(cells.Point(ids[i]));
        if (isPointThere && column.IsOfPoints)
        {
          look.Add(column.Values[ids[i]]);
        }
        isThere = isPointThere && !column.IsOfPoints;
      }
      if (isThere)
      {
        look.Add(column.Values[static_cast<std::size_t>(cells.IdOf(cell))]);
      }
    });
}

/// The cell that holds x, or without one the nearest within the search radius.
SkdFoundCell SkdFieldCriterion::FindAt(
  const Column& column, const skd::Vector3& x, double maxDistance) const
{
  const SkdCellTree& tree = this->Meshes.GetTree(column.Part);
  const SkdCellSource source = this->Meshes.GetSource(column.Part);
  return maxDistance > 0.0 ? tree.FindNearest(x, maxDistance * maxDistance, source)
                           : tree.FindContaining(x, 0.0, -1, source);
}

/// Where a cell holds the sample, or is near to it.
void SkdFieldCriterion::AddSamples(const Column& column, const SkdRegion& region, Look& look) const
{
  for (int sample = 0; sample < region.GetNumberOfSamples() && !look.Passes; ++sample)
  {
    look.Add(this->InterpolateAt(column, region.GetSample(sample), region.GetSampleRadius()));
  }
}

/// NaN where no cell is.
double SkdFieldCriterion::InterpolateAt(
  const Column& column, const skd::Vector3& x, double maxDistance) const
{
  thread_local std::vector<double> weights;
  SkdFoundCell found = this->FindAt(column, x, maxDistance);
  if (found.Id < 0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!column.IsOfPoints)
  {
    return column.Values[static_cast<std::size_t>(found.Id)];
  }
  const SkdCellTree& tree = this->Meshes.GetTree(column.Part);
  const auto cell = static_cast<std::uint32_t>(tree.Cells().CellOfId(found.Id));
  const std::uint32_t size = tree.Cells().SizeOf(cell);
  weights.assign(size, 0.0);
  tree.Interpolate(found, weights.data(), this->Meshes.GetSource(column.Part));
  double value = 0.0;
  for (std::uint32_t i = 0; i < size; ++i)
  {
    value += weights[i] * column.Values[tree.Cells().PointIdsOf(cell)[i]];
  }
  return value;
}

/// A cell of the field that contains a sample intersects the region, unless it is only near.
bool SkdFieldCriterion::IsWanted(const SkdRegion& region) const
{
  return std::any_of(this->Columns.begin(), this->Columns.end(),
    [&](const Column& column) { return this->IsWanted(column, region); });
}

bool SkdFieldCriterion::IsWanted(const Column& column, const SkdRegion& region) const
{
  if (this->Settings.Test == SkdFieldTest::SecondDifference)
  {
    const auto valueAt = [&](const skd::Vector3& x)
    { return this->InterpolateAt(column, x, region.GetSampleRadius()); };
    return SkdSecondDifference(region.GetBox(), valueAt).Find() > column.Threshold;
  }
  Look look(this->Settings.Test, column);
  if (column.IsOfPoints || region.GetSampleRadius() > 0.0)
  {
    this->AddSamples(column, region, look);
  }
  if (!look.Passes)
  {
    this->AddListed(column, region, look);
  }
  return look.Passes;
}
}
