// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdComparison.h"

#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdPointsOfBlocks.h"
#include "Search/Compare/SkdSpreadSides.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
constexpr const char* DistanceName = "SkdDistance";

void AddDistances(vtkDataSet* mesh, const SkdComparedInput& to, SkdLoop& loop)
{
  const vtkIdType n = mesh->GetNumberOfPoints();
  const auto distances = SkdMakeArray<vtkDoubleArray>(DistanceName, 1, n, vtkMath::Nan());
  const auto points = SkdMakeArray<vtkDoubleArray>("SkdClosestPoint", 3, n, vtkMath::Nan());
  const auto cells = SkdMakeArray<vtkIdTypeArray>("SkdClosestCellId", 1, n, -1);
  std::vector<int> blocks(static_cast<std::size_t>(n), -1);
  loop.For(to.Set.IsEmpty() ? 0 : n,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        skd::Vector3 x;
        mesh->GetPoint(i, x.X);
        if (const auto nearest = to.Set.FindNearest(x, std::numeric_limits<double>::max()))
        {
          const SkdComparedSet::Origin& origin = to.Set.GetOrigin(nearest->CellId);
          const double distance = std::sqrt(nearest->Distance2);
          distances->SetValue(i, to.Set.IsInside(x) ? -distance : distance);
          std::copy_n(nearest->Point, 3, points->GetPointer(3 * i));
          cells->SetValue(i, origin.CellId);
          blocks[i] = origin.Block;
        }
      }
    });
  vtkPointData* data = mesh->GetPointData();
  data->AddArray(points);
  data->AddArray(distances);
  data->AddArray(cells);
  data->SetActiveScalars(DistanceName);
  if (to.IsComposite)
  {
    data->AddArray(SkdMakeBlockIndices("SkdClosestBlockIndex", blocks, to.Blocks));
  }
}

bool AddSides(const std::vector<SkdBlock>& outputs, SkdSpreadSides& sides, SkdLoop& loop)
{
  const SkdPointsOfBlocks points(outputs);
  std::vector<vtkDoubleArray*> distances;
  for (const SkdBlock& output : outputs)
  {
    distances.push_back(
      vtkDoubleArray::SafeDownCast(output.Mesh->GetPointData()->GetArray(DistanceName)));
  }
  return sides.Find(
    points.GetNumber(), [&](std::size_t i) { return points.Get(i); },
    [&](std::size_t i, bool isInside)
    {
      points.Visit(i,
        [&](std::size_t block, vtkIdType point)
        {
          double* const distance = distances[block]->GetPointer(point);
          *distance = isInside ? -*distance : *distance;
        });
    },
    loop);
}

/// The columns of the table, one row after the other.
class Rows
{
public:
  explicit Rows(const SkdReduction& all)
    : All(all)
  {
  }

  void Add(const char* direction, const SkdComparison& comparison, const SkdHausdorff& bounds,
    const SkdDistanceSamples& samples);
  void MoveTo(vtkTable* table);

private:
  template <class Array>
  Array* Get(const char* name, int components = 1);
  void AddNumber(const char* name, double number)
  {
    this->Get<vtkDoubleArray>(name)->InsertNextValue(number);
  }
  void AddStatistic(const std::string& name, const SkdDistanceStatistic& statistic)
  {
    this->AddNumber(name.c_str(), statistic.Value);
    this->AddNumber((name + "Error").c_str(), statistic.Error);
  }
  void AddLocation(const std::string& name, const SkdComparedInput& input, const skd::Vector3& x,
    const SkdComparedSet::Origin& origin);
  void AddStatistics(const SkdDistanceSamples& samples, bool isSigned);

  const SkdReduction& All;
  vtkNew<vtkFieldData> Columns; // of a table, which would want all to be as long
};

template <class Array>
Array* Rows::Get(const char* name, int components)
{
  if (!this->Columns->HasArray(name))
  {
    this->Columns->AddArray(SkdMakeArray<Array>(name, components, 0));
  }
  return Array::SafeDownCast(this->Columns->GetAbstractArray(name));
}

void Rows::MoveTo(vtkTable* table)
{
  for (int i = 0; i < this->Columns->GetNumberOfArrays(); ++i)
  {
    table->AddColumn(this->Columns->GetAbstractArray(i));
  }
}

void Rows::AddLocation(const std::string& name, const SkdComparedInput& input,
  const skd::Vector3& x, const SkdComparedSet::Origin& origin)
{
  const double nan = vtkMath::Nan();
  const skd::Vector3 none{ { nan, nan, nan } };
  const bool isLocated = origin.Block >= 0;
  this->Get<vtkDoubleArray>(name.c_str(), 3)->InsertNextTuple(isLocated ? x.X : none.X);
  this->Get<vtkIdTypeArray>((name + "CellId").c_str())->InsertNextValue(origin.CellId);
  this->Get<vtkIntArray>((name + "BlockIndex").c_str())
    ->InsertNextValue(isLocated ? input.Blocks[origin.Block].BlockIndex : -1);
}

void Rows::AddStatistics(const SkdDistanceSamples& samples, bool isSigned)
{
  const SkdDistanceStatistics& statistics = samples.GetStatistics();
  this->AddStatistic("Mean", statistics.Mean);
  this->AddStatistic("RootMeanSquare", statistics.RootMeanSquare);
  this->AddStatistic("SignedMean", isSigned ? statistics.SignedMean : SkdDistanceStatistic());
  constexpr const char* names[] = { "Median", "Quantile90", "Quantile95", "Quantile99" };
  for (std::size_t i = 0; i < SkdQuantileShares.size(); ++i)
  {
    this->AddStatistic(names[i], statistics.Quantiles[i]);
  }
  this->AddNumber("Area", statistics.Measure);
  this->Get<vtkIdTypeArray>("Samples")->InsertNextValue(
    static_cast<vtkIdType>(this->All.Sum(static_cast<long long>(samples.GetNumberOfSamples()))));
}

void Rows::Add(const char* direction, const SkdComparison& comparison, const SkdHausdorff& bounds,
  const SkdDistanceSamples& samples)
{
  this->Get<vtkStringArray>("Direction")->InsertNextValue(direction);
  this->AddNumber("HausdorffDistance", bounds.Distance);
  this->AddNumber("HausdorffUpperBound", bounds.UpperBound);
  this->AddLocation("From", *comparison.From, bounds.From, bounds.FromOrigin);
  this->AddLocation("To", *comparison.To, bounds.To, bounds.ToOrigin);
  this->AddStatistics(samples, comparison.To->Set.HasSides());
}
}

bool SkdAddDistances(
  const std::vector<SkdBlock>& outputs, const SkdComparedInput& to, SkdLoop& loop)
{
  for (const SkdBlock& output : outputs)
  {
    AddDistances(output.Mesh, to, loop);
  }
  SkdSpreadSides* const sides = to.Set.GetSpreadSides();
  return !sides || AddSides(outputs, *sides, loop);
}

void SkdFillComparison(
  const std::array<SkdComparison, 2>& comparisons, const SkdReduction& all, vtkTable* table)
{
  const auto& [forth, back] = comparisons;
  Rows rows(all);
  rows.Add("Input to Source", forth, forth.Hausdorff, forth.Samples);
  rows.Add("Source to Input", back, back.Hausdorff, back.Samples);

  const SkdComparison& farther = back.Hausdorff.Distance > forth.Hausdorff.Distance ? back : forth;
  SkdHausdorff bounds = farther.Hausdorff;
  bounds.UpperBound = std::max(forth.Hausdorff.UpperBound, back.Hausdorff.UpperBound);
  SkdDistanceSamples samples = forth.Samples;
  samples.Add(back.Samples, all);
  rows.Add("Both", farther, bounds, samples);
  if (all.GetRank() == 0)
  {
    rows.MoveTo(table);
  }
}
}
