// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batches.h"

#include "Timing.h"
#include "Works.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeCellLocator.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace skdbench
{
namespace
{

using Locator = vtkSkdTreeCellLocator;
using Numbers = vtkSmartPointer<vtkDoubleArray>;

/// The arrays that results go to; each batch fills those that it has.
struct Answers
{
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Ids;
  vtkNew<vtkDoubleArray> Parameters;
  vtkNew<vtkDoubleArray> Points;
};

/// The tuple of a query.
std::vector<double> PointOf(const Query& query)
{
  return { query.From.begin(), query.From.end() };
}

std::vector<double> LineOf(const Query& query)
{
  std::vector<double> line = PointOf(query);
  line.insert(line.end(), query.To.begin(), query.To.end());
  return line;
}

std::vector<double> BoxOf(const Query& query)
{
  return { query.Box.begin(), query.Box.end() };
}

Numbers Tuples(const Work& work, std::vector<double> (*tuple)(const Query&))
{
  auto array = Numbers::New();
  array->SetNumberOfComponents(static_cast<int>(tuple(work.Queries.front()).size()));
  for (const Query& query : work.Queries)
  {
    array->InsertNextTuple(tuple(query).data());
  }
  return array;
}

/// A kind of work, and its batch.
struct Batch
{
  const char* Work;
  std::vector<double> (*Tuple)(const Query&);
  void (*Run)(Locator*, vtkDoubleArray* queries, Answers& answers);
};

void ClosestPoints(Locator* tree, vtkDoubleArray* queries, Answers& a)
{
  tree->FindClosestPoints(queries, a.Ids, a.Points, a.Parameters);
}

void Cells(Locator* tree, vtkDoubleArray* queries, Answers& a)
{
  tree->FindCells(queries, a.Ids, a.Points);
}

void FirstHits(Locator* tree, vtkDoubleArray* queries, Answers& a)
{
  tree->IntersectWithLines(queries, a.Ids, a.Parameters, a.Points);
}

void AllHits(Locator* tree, vtkDoubleArray* queries, Answers& a)
{
  tree->FindAllHits(queries, a.Offsets, a.Ids, a.Parameters, a.Points);
}

void Boxes(Locator* tree, vtkDoubleArray* queries, Answers& a)
{
  tree->FindCellsWithinBoxes(queries, a.Offsets, a.Ids);
}

const Batch All[] = { { "closest point, near", PointOf, ClosestPoints },
  { "first hit, across the box", LineOf, FirstHits },
  { "all hits, across the box", LineOf, AllHits },
  { "find cell, random in the box", PointOf, Cells }, { "cells in a small box", BoxOf, Boxes } };

/// The columns: what the first of them gains over the others.
std::vector<Kind> Ways(int threads)
{
  return { { std::to_string(threads) + " threads", Family::Ours, {} },
    { "1 thread", Family::Peer, {} }, { "a loop", Family::Peer, {} } };
}

template <class Body>
std::function<void()> ByThreads(int threads, const Body& body)
{
  return [threads, body] { vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, body); };
}

Row Time(const std::string& name, const std::vector<Task>& tasks, Options options)
{
  options.Threads = std::max(options.Threads, 2); // the wall's clock
  Row row{ name, "ms", std::vector<Cost>(Ways(2).size()) };
  const std::vector<double> medians = MedianNanoseconds(tasks, options);
  for (std::size_t i = 0; i < medians.size(); ++i)
  {
    row.Costs[i].Value = 1e-6 * medians[i];
  }
  return row;
}

/// A task for all threads and one for a single one.
template <class Body>
std::vector<Task> Both(const Body& body, const Options& options)
{
  return { { ByThreads(std::max(options.Threads, 2), body), {}, options.Repetitions },
    { ByThreads(1, body), {}, options.Repetitions } };
}

Row BuildRow(vtkDataSet* data, const Options& options)
{
  const auto build = [data]
  {
    vtkNew<Locator> tree;
    tree->SetDataSet(data);
    tree->BuildLocator();
  };
  return Time("build", Both(build, options), options);
}

Row PairsRow(Locator* tree, const Options& options)
{
  Answers answers;
  const auto find = [&] { tree->FindPairs(tree, answers.Offsets, answers.Ids); };
  return Time("pairs of boxes, each with its neighbours", Both(find, options), options);
}

Row BatchRow(
  Locator* tree, Structure& single, const Batch& batch, const Work& work, const Options& options)
{
  const Numbers queries = Tuples(work, batch.Tuple);
  Answers answers;
  std::vector<Task> tasks = Both([&] { batch.Run(tree, queries, answers); }, options);
  const auto loop = [&]
  {
    Answer answer;
    for (const Query& query : work.Queries)
    {
      single.Ask(work.Requested, query, answer);
    }
  };
  tasks.push_back({ loop, {}, options.Repetitions });
  return Time(batch.Work, tasks, options);
}

SceneResult MeasureOne(const std::string& name, vtkDataSet* data, const Options& options)
{
  Touch(data);
  SceneResult result{ name, data->GetNumberOfCells(), { BuildRow(data, options) } };
  vtkNew<Locator> tree;
  tree->SetDataSet(data);
  tree->BuildLocator();
  const auto single = SkdKinds().front().Make();
  single->Build(data);
  const int queries = options.Scenes == Size::Tiny ? options.Queries : 12 * options.Queries;
  for (const Work& work : MakeWorks(data, queries))
  {
    for (const Batch& batch : All)
    {
      if (work.Name == batch.Work && Passes(work.Name, options.OnlyWork))
      {
        std::cerr << "  " << work.Name << ", " << queries << " queries\n";
        result.Rows.push_back(BatchRow(tree, *single, batch, work, options));
      }
    }
  }
  result.Rows.push_back(PairsRow(tree, options));
  return result;
}

}

Results MeasureBatches(const Options& options)
{
  const int n = options.Scenes == Size::Tiny ? 9 : 289;
  const double cells = 12.0 * n * n;
  const Scene scenes[] = { { "a noisy sphere, in batches", [=] { return NoisySphere(n); } },
    { "structured tetrahedra, in batches",
      [=] { return TurnedTetrahedra(static_cast<int>(std::cbrt(cells / 6.0))); } } };
  Results results{ Ways(std::max(options.Threads, 2)), {} };
  for (const Scene& scene : scenes)
  {
    if (Passes(scene.Name, options.OnlyScene))
    {
      std::cerr << scene.Name << "\n";
      results.Scenes.push_back(MeasureOne(scene.Name, scene.Make(), options));
    }
  }
  return results;
}

}
