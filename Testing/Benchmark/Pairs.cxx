// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pairs.h"

#include "Timing.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkSkdTreeSurfaceIntersection.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <functional>
#include <iostream>

namespace skdbench
{
namespace
{

class SkdPairs : public PairFinder
{
public:
  bool Build(vtkDataSet* first, vtkDataSet* second) override
  {
    this->First->SetDataSet(first);
    this->Second->SetDataSet(second);
    this->First->ForceBuildLocator();
    this->Second->ForceBuildLocator();
    return true;
  }

  bool FindBoxes() override
  {
    this->First->FindPairs(this->Second, this->Found);
    return true;
  }

  PairList BoxPairs() const override
  {
    PairList pairs;
    for (vtkIdType i = 0; i < this->Found->GetNumberOfTuples(); ++i)
    {
      pairs.emplace_back(this->Found->GetValue(2 * i), this->Found->GetValue(2 * i + 1));
    }
    return pairs;
  }

  bool FindTriangles(vtkDataSet* first, vtkDataSet* second) override
  {
    this->Filter = vtkSmartPointer<vtkSkdTreeSurfaceIntersection>::New();
    this->Filter->SetInputData(first);
    this->Filter->SetSourceData(second);
    this->Filter->JoinCurvesOff();
    this->Filter->Update();
    return true;
  }

  PairList TrianglePairs() const override
  {
    auto* table = vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2));
    const auto column = [table](const char* name)
    { return vtkIdTypeArray::SafeDownCast(table->GetColumnByName(name)); };
    PairList pairs;
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      pairs.emplace_back(
        column("SkdFirstCellId")->GetValue(row), column("SkdSecondCellId")->GetValue(row));
    }
    return pairs;
  }

private:
  vtkNew<vtkSkdTreeCellLocator> First;
  vtkNew<vtkSkdTreeCellLocator> Second;
  vtkNew<vtkIdTypeArray> Found;
  vtkSmartPointer<vtkSkdTreeSurfaceIntersection> Filter;
};

std::vector<PairKind> AllPairFinders()
{
  std::vector<PairKind> kinds = { { "skD-tree", Family::Ours,
    []() -> std::unique_ptr<PairFinder> { return std::make_unique<SkdPairs>(); } } };
#ifdef SKDBENCH_HAS_EMBREE
  kinds.push_back(EmbreePairKind());
#endif
#ifdef SKDBENCH_HAS_CGAL
  kinds.push_back(CgalPairKind());
#endif
  return kinds;
}

using Find = std::function<bool(PairFinder&)>;
using Found = std::function<PairList(const PairFinder&)>;

/// Who misses a pair that another names is wrong: no one is known to name one that is none.
void Compare(std::vector<PairList>& found, const std::vector<std::size_t>& owners, Row& row)
{
  PairList all;
  for (PairList& pairs : found)
  {
    std::sort(pairs.begin(), pairs.end());
    PairList both;
    std::set_union(all.begin(), all.end(), pairs.begin(), pairs.end(), std::back_inserter(both));
    all.swap(both);
  }
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    row.Costs[owners[k]].Compared = static_cast<int>(all.size());
    row.Costs[owners[k]].Wrong = static_cast<int>(all.size() - found[k].size());
  }
  row.Work += ": " + std::to_string(all.size());
}

Row PairRow(const std::string& work, const std::vector<std::unique_ptr<PairFinder>>& finders,
  const Find& find, const Found& pairsOf, const Options& options)
{
  Row row{ work, "ms", std::vector<Cost>(finders.size()) };
  std::vector<PairList> found;
  std::vector<std::size_t> owners;
  for (std::size_t i = 0; i < finders.size(); ++i)
  {
    if (find(*finders[i]))
    {
      found.push_back(pairsOf(*finders[i]));
      owners.push_back(i);
    }
  }
  Compare(found, owners, row);
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < owners.size(); ++k)
  {
    tasks.push_back({ [&, k] { find(*finders[owners[k]]); }, {}, options.Repetitions });
  }
  const std::vector<double> medians = MedianNanoseconds(tasks, options);
  for (std::size_t k = 0; k < owners.size(); ++k)
  {
    row.Costs[owners[k]].Value = 1e-6 * medians[k];
  }
  return row;
}

SceneResult MeasureOne(
  const std::string& name, int n, double shift, std::vector<PairKind> kinds, const Options& options)
{
  const auto first = NoisySphere(n);
  const auto second = NoisySphere(n);
  vtkPoints* points = vtkPointSet::SafeDownCast(second)->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* x = points->GetPoint(i);
    points->SetPoint(i, x[0] + shift, x[1] + 0.31 * shift, x[2] + 0.17 * shift);
  }
  Touch(first);
  Touch(second);
  std::cerr << name << ": " << first->GetNumberOfCells() << " cells each\n";
  std::vector<std::unique_ptr<PairFinder>> finders;
  for (const PairKind& kind : kinds)
  {
    finders.push_back(kind.Make());
    finders.back()->Build(first, second);
  }
  SceneResult result{ name, first->GetNumberOfCells(), {} };
  const auto boxes = [](const PairFinder& finder) { return finder.BoxPairs(); };
  const auto triangles = [](const PairFinder& finder) { return finder.TrianglePairs(); };
  result.Rows.push_back(PairRow(
    "boxes that overlap", finders, [](PairFinder& finder) { return finder.FindBoxes(); }, boxes,
    options));
  result.Rows.push_back(PairRow(
    "boxes that overlap, trees and all", finders,
    [&](PairFinder& finder) { return finder.Build(first, second) && finder.FindBoxes(); }, boxes,
    options));
  result.Rows.push_back(PairRow(
    "triangles that meet, trees and all", finders,
    [&](PairFinder& finder) { return finder.FindTriangles(first, second); }, triangles, options));
  return result;
}

}

Results MeasurePairs(const Options& options)
{
  struct Place
  {
    const char* Name;
    int Size;
    double Shift;
  };
  const int usual = options.Scenes == Size::Tiny ? 9 : 76;
  std::vector<Place> positions = { { "two spheres that cross", usual, 0.9 },
    { "two spheres, nearly one", usual, 1e-3 } };
  if (options.Scenes != Size::Tiny)
  {
    positions.push_back({ "two spheres that cross, out of cache", 289, 0.9 });
  }
  Results results;
  const std::vector<PairKind> kinds = AllPairFinders();
  for (const PairKind& kind : kinds)
  {
    results.Kinds.push_back({ kind.Name, kind.Of, {} });
  }
  for (const Place& position : positions)
  {
    if (Passes(position.Name, options.OnlyScene))
    {
      results.Scenes.push_back(
        MeasureOne(position.Name, position.Size, position.Shift, kinds, options));
    }
  }
  return results;
}

}
