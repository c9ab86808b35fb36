// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "Referee.h"
#include "Timing.h"

#include "Support/CountInstructions.h"

#include <algorithm>
#include <chrono>
#include <iostream>

namespace skdbench
{
namespace
{

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A structure built on the data, or none, and what that took.
struct Built
{
  std::unique_ptr<Structure> Tree;
  double Seconds = 0.0;
  std::optional<double> Bytes;
};

Built BuildOne(const Kind& kind, vtkDataSet* data)
{
  Built built;
  const auto before = BytesOnHeap();
  const auto start = Clock::now();
  built.Tree = kind.Make();
  const bool good = built.Tree->Build(data);
  built.Seconds = SecondsSince(start);
  if (!good)
  {
    built.Tree.reset();
  }
  else if (before)
  {
    built.Bytes = *BytesOnHeap() - *before;
  }
  return built;
}

Row BuildRow(vtkDataSet* data, const std::vector<Kind>& kinds, const std::vector<Built>& built,
  const Options& options)
{
  Row row{ "build", "ns a cell", std::vector<Cost>(kinds.size()) };
  std::vector<Task> tasks;
  std::vector<std::size_t> owners;
  std::vector<std::unique_ptr<Structure>> fresh(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    if (built[i].Tree)
    {
      const auto build = [&, i]
      {
        fresh[i] = kinds[i].Make();
        fresh[i]->Build(data);
      };
      const int repetitions = built[i].Seconds > options.SlowBuild ? 1 : options.Repetitions;
      tasks.push_back({ build, [&fresh, i] { fresh[i].reset(); }, repetitions });
      owners.push_back(i);
    }
  }
  const std::vector<double> medians = MedianNanoseconds(tasks, options);
  for (std::size_t k = 0; k < owners.size(); ++k)
  {
    row.Costs[owners[k]].Value = medians[k] / data->GetNumberOfCells();
  }
  return row;
}

void AppendMemoryRows(vtkDataSet* data, const std::vector<Built>& built, std::vector<Row>& rows)
{
  Row heap{ "memory kept, on the heap", "bytes a cell", std::vector<Cost>(built.size()) };
  Row told{ "memory kept, by its own account", "bytes a cell", std::vector<Cost>(built.size()) };
  for (std::size_t i = 0; i < built.size(); ++i)
  {
    const auto bytes = built[i].Tree ? built[i].Tree->BytesBySelf() : std::nullopt;
    if (built[i].Tree && built[i].Bytes)
    {
      heap.Costs[i].Value = *built[i].Bytes / data->GetNumberOfCells();
    }
    if (bytes)
    {
      told.Costs[i].Value = *bytes / data->GetNumberOfCells();
    }
  }
  rows.push_back(heap);
  rows.push_back(told);
}

/// Whether the structure supports such queries, by trying a few of them.
bool CanDo(Structure& tree, const Work& work)
{
  Answer answer;
  const std::size_t few = std::min<std::size_t>(3, work.Queries.size());
  return std::all_of(work.Queries.begin(), work.Queries.begin() + few,
    [&](const Query& query) { return tree.Ask(work.Requested, query, answer); });
}

Task QueryTask(Structure& tree, const Work& work, const Options& options)
{
  const auto run = [&tree, &work, answer = Answer(), next = std::size_t(0)]() mutable
  {
    tree.Ask(work.Requested, work.Queries[next], answer);
    next = next + 1 == work.Queries.size() ? 0 : next + 1;
  };
  return { run, {}, options.Repetitions };
}

void Tell(const Work& work, const Query& query, const std::vector<Record>& records,
  const std::vector<std::string>& names, const std::vector<bool>& wrong)
{
  std::cerr.precision(17);
  std::cerr << "wrong answer: " << work.Name << ": from " << query.From[0] << " " << query.From[1]
            << " " << query.From[2] << " to " << query.To[0] << " " << query.To[1] << " "
            << query.To[2] << " radius " << query.Radius << "\n";
  for (std::size_t k = 0; k < records.size(); ++k)
  {
    const Record& record = records[k];
    std::cerr << "  " << names[k] << (wrong[k] ? " (wrong)" : "") << ": cell " << record.Cell
              << " value " << record.Value << " at " << record.Where[0] << " " << record.Where[1]
              << " " << record.Where[2] << ", " << record.Cells.size() << " cells\n";
  }
}

/// Asks everyone the same and lets the referee decide.
class Comparison
{
public:
  Comparison(vtkDataSet* data, const Work& work)
    : Judge(data)
    , Requested(work)
  {
  }

  void Add(const Kind& kind, Structure& tree, Cost& cost)
  {
    this->Names.push_back(kind.Name);
    this->Trees.push_back(&tree);
    this->Costs.push_back(&cost);
    this->IsOurs.push_back(kind.Of == Family::Ours);
  }

  void Run(const Options& options)
  {
    std::vector<Answer> answers(this->Trees.size());
    const auto start = Clock::now();
    for (int i = 0; i < options.Checks && i < static_cast<int>(this->Requested.Queries.size()); ++i)
    {
      if (i > 10 && SecondsSince(start) > options.CheckSeconds)
      {
        return;
      }
      this->Compare(this->Requested.Queries[i], answers);
    }
  }

private:
  void Compare(const Query& query, std::vector<Answer>& answers)
  {
    std::vector<Record> records;
    for (std::size_t k = 0; k < this->Trees.size(); ++k)
    {
      this->Trees[k]->Ask(this->Requested.Requested, query, answers[k]);
      records.emplace_back(answers[k], this->Trees[k]->Precision());
    }
    const std::vector<bool> wrong = this->Judge.Judge(this->Requested.Requested, query, records);
    for (std::size_t k = 0; k < records.size(); ++k)
    {
      this->Costs[k]->Compared += 1;
      this->Costs[k]->Wrong += wrong[k];
      if (wrong[k] && this->IsOurs[k] && this->Costs[k]->Wrong <= 3)
      {
        Tell(this->Requested, query, records, this->Names, wrong);
      }
    }
  }

  Referee Judge;
  const Work& Requested;
  std::vector<std::string> Names;
  std::vector<Structure*> Trees;
  std::vector<Cost*> Costs;
  std::vector<bool> IsOurs;
};

Row WorkRow(vtkDataSet* data, const Work& work, const std::vector<Kind>& kinds,
  const std::vector<Built>& built, const Options& options)
{
  Row row{ work.Name, "ns a query", std::vector<Cost>(kinds.size()) };
  Comparison comparison(data, work);
  std::vector<Task> tasks;
  std::vector<std::size_t> owners;
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    if (built[i].Tree && CanDo(*built[i].Tree, work))
    {
      comparison.Add(kinds[i], *built[i].Tree, row.Costs[i]);
      tasks.push_back(QueryTask(*built[i].Tree, work, options));
      owners.push_back(i);
    }
  }
  comparison.Run(options);
  const std::vector<double> medians = MedianNanoseconds(tasks, options);
  for (std::size_t k = 0; k < owners.size(); ++k)
  {
    row.Costs[owners[k]].Value = medians[k];
  }
  return row;
}

std::vector<Built> BuildAll(vtkDataSet* data, const std::vector<Kind>& kinds)
{
  std::vector<Built> built;
  for (const Kind& kind : kinds)
  {
    built.push_back(BuildOne(kind, data));
    std::cerr << "  built " << kind.Name << " in " << built.back().Seconds << " s\n";
  }
  return built;
}

}

SceneResult Measure(const std::string& name, vtkDataSet* data, const std::vector<Work>& works,
  const std::vector<Kind>& kinds, const Options& options)
{
  SceneResult result{ name, data->GetNumberOfCells(), {} };
  std::cerr << name << ": " << result.NumberOfCells << " cells\n";
  const std::vector<Built> built = BuildAll(data, kinds);
  if (Passes("build", options.OnlyWork))
  {
    result.Rows.push_back(BuildRow(data, kinds, built, options));
    AppendMemoryRows(data, built, result.Rows);
  }
  for (const Work& work : works)
  {
    if (Passes(work.Name, options.OnlyWork))
    {
      std::cerr << "  " << work.Name << "\n";
      result.Rows.push_back(WorkRow(data, work, kinds, built, options));
    }
  }
  return result;
}

void RunForProfiler(vtkDataSet* data, const std::vector<Work>& works,
  const std::vector<Kind>& kinds, const Options& options)
{
  const std::vector<Built> built = BuildAll(data, kinds);
  for (const Work& work : works)
  {
    for (std::size_t i = 0; i < kinds.size(); ++i)
    {
      if (Passes(work.Name, options.OnlyWork) && built[i].Tree && CanDo(*built[i].Tree, work))
      {
        const Task task = QueryTask(*built[i].Tree, work, options);
        const auto run = [&]
        {
          for (int query = 0; query < options.Profile; ++query)
          {
            task.Run();
          }
        };
        skdtest::CountInstructions((work.Name + ": " + kinds[i].Name).c_str(), run);
      }
    }
  }
}

}
