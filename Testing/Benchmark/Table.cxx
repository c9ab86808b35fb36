// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include "System.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace skdbench
{
namespace
{

/// The structure that others are compared with: the first of ours, else the first of all.
std::size_t BaseOf(const std::vector<Kind>& kinds)
{
  const auto ours = std::find_if(
    kinds.begin(), kinds.end(), [](const Kind& kind) { return kind.Of == Family::Ours; });
  return ours == kinds.end() ? 0 : ours - kinds.begin();
}

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), value < 9.95 ? "%.2f" : value < 99.5 ? "%.1f" : "%.0f", value);
  return text;
}

std::string WithErrors(std::string text, const Cost& cost)
{
  return cost.Wrong == 0
    ? text
    : text + " (" + std::to_string(cost.Wrong) + "/" + std::to_string(cost.Compared) + " wrong)";
}

/// The least cost of VTK's locators, as a multiple of the base's; none when there is none.
std::optional<double> BestOfVtk(const Row& row, const std::vector<Kind>& kinds)
{
  const Cost& base = row.Costs[BaseOf(kinds)];
  std::optional<double> best;
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    const auto& value = row.Costs[i].Value;
    if (kinds[i].Of == Family::Vtk && value && base.Value)
    {
      best = std::min(best.value_or(INFINITY), *value / *base.Value);
    }
  }
  return best;
}

std::string BaseCell(const Row& row, std::size_t base)
{
  const Cost& cost = row.Costs[base];
  return cost.Value ? WithErrors(Number(*cost.Value) + " " + row.Unit, cost) : "-";
}

std::string OtherCell(const Row& row, std::size_t i, std::size_t base)
{
  const Cost& cost = row.Costs[i];
  const auto& unit = row.Costs[base].Value;
  return cost.Value && unit ? WithErrors(Number(*cost.Value / *unit), cost)
    : cost.Value            ? WithErrors(Number(*cost.Value) + " " + row.Unit, cost)
                            : "-";
}

void PrintRule(std::ostream& out, std::size_t columns)
{
  out << "| --- |";
  for (std::size_t i = 1; i < columns; ++i)
  {
    out << " ---: |";
  }
  out << "\n";
}

void PrintSlower(std::ostream& out, const Results& results)
{
  out << "\n## Where the best of VTK is faster than " << results.Kinds[BaseOf(results.Kinds)].Name
      << "\n\n";
  bool any = false;
  for (const SceneResult& result : results.Scenes)
  {
    for (const Row& row : result.Rows)
    {
      const auto best = BestOfVtk(row, results.Kinds);
      if (best && *best < 1.0)
      {
        out << "- " << result.Name << ", " << row.Work << ": " << Number(*best) << "\n";
        any = true;
      }
    }
  }
  out << (any ? "" : "Nowhere.\n");
}

void PrintErrors(std::ostream& out, const Results& results)
{
  out << "\n## Wrong answers, of all that were compared\n\n| structure | wrong | compared |\n";
  PrintRule(out, 3);
  for (std::size_t i = 0; i < results.Kinds.size(); ++i)
  {
    int wrong = 0;
    int compared = 0;
    for (const SceneResult& result : results.Scenes)
    {
      for (const Row& row : result.Rows)
      {
        wrong += row.Costs[i].Wrong;
        compared += row.Costs[i].Compared;
      }
    }
    out << "| " << results.Kinds[i].Name << " | " << wrong << " | " << compared << " |\n";
  }
}

void PrintGrowthRow(std::ostream& out, const SceneResult& result, std::size_t kind)
{
  const double log2n = std::log2(static_cast<double>(result.NumberOfCells));
  out << "| " << result.NumberOfCells;
  for (const Row& row : result.Rows)
  {
    const auto& value = row.Costs[kind].Value;
    out << " | " << (value ? Number(*value) : "-");
    if (row.Work == "build")
    {
      out << " | " << (value ? Number(*value / log2n) : "-");
    }
  }
  out << " |\n";
}

void PrintCsvRow(
  std::ostream& out, const SceneResult& result, const Row& row, const std::vector<Kind>& kinds)
{
  const auto& base = row.Costs[BaseOf(kinds)].Value;
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    const Cost& cost = row.Costs[i];
    out << '"' << result.Name << "\"," << result.NumberOfCells << ",\"" << row.Work << "\",\""
        << row.Unit << "\",\"" << kinds[i].Name << "\",";
    out << (cost.Value ? std::to_string(*cost.Value) : "") << ",";
    out << (cost.Value && base ? std::to_string(*cost.Value / *base) : "") << "," << cost.Compared
        << "," << cost.Wrong << "\n";
  }
}

}

void PrintHeader(std::ostream& out, const Options& options)
{
  out << "# What searches cost\n\n"
      << "- " << DescribeVtk() << "\n"
      << "- " << DescribeBuild() << "\n"
      << "- " << DescribeMachine() << "; " << options.Threads
      << " thread(s) in builds, 1 in queries\n"
      << "- Medians of " << options.Repetitions << " repetitions of at least " << options.Seconds
      << " s each that take turns; every structure with its default settings, on the same data and "
         "the same queries, asked by the same short forms of vtkAbstractCellLocator.\n"
      << "- The first column is absolute, the others are multiples of it: above 1 the skD-tree is "
         "faster (or smaller). A dash: the structure does not support such queries in this VTK. "
         "\"wrong\": answers that a referee refuted, who trusts only VTK's test of single cells.\n";
}

void PrintScene(std::ostream& out, const SceneResult& result, const std::vector<Kind>& kinds)
{
  const std::size_t base = BaseOf(kinds);
  out << "\n## " << result.Name << " (" << result.NumberOfCells << " cells)\n\n";
  out << "| work | " << kinds[base].Name << " |";
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    out << (i == base ? "" : " " + kinds[i].Name + " |");
  }
  out << " best of VTK |\n";
  PrintRule(out, kinds.size() + 2);
  for (const Row& row : result.Rows)
  {
    out << "| " << row.Work << " | " << BaseCell(row, base) << " |";
    for (std::size_t i = 0; i < kinds.size(); ++i)
    {
      out << (i == base ? "" : " " + OtherCell(row, i, base) + " |");
    }
    const auto best = BestOfVtk(row, kinds);
    out << (best ? " **" + Number(*best) + "** |\n" : " - |\n");
  }
  out.flush();
}

void PrintSummary(std::ostream& out, const Results& results)
{
  PrintSlower(out, results);
  PrintErrors(out, results);
}

void PrintGrowth(std::ostream& out, const Results& growth)
{
  for (std::size_t kind = 0; kind < growth.Kinds.size(); ++kind)
  {
    const std::vector<Row>& rows = growth.Scenes.front().Rows;
    out << "\n## Growth: " << growth.Kinds[kind].Name << ", " << growth.Scenes.front().Name
        << "\n\n| cells |";
    for (const Row& row : rows)
    {
      out << " " << row.Work << ", " << row.Unit << " |"
          << (row.Work == "build" ? " the same / log2 N |" : "");
    }
    out << "\n";
    PrintRule(out, rows.size() + 2);
    for (const SceneResult& result : growth.Scenes)
    {
      PrintGrowthRow(out, result, kind);
    }
  }
}

void PrintCsv(std::ostream& out, const std::vector<Results>& all)
{
  out << "scene,cells,work,unit,structure,value,ratio,compared,wrong\n";
  for (const Results& results : all)
  {
    for (const SceneResult& result : results.Scenes)
    {
      for (const Row& row : result.Rows)
      {
        PrintCsvRow(out, result, row, results.Kinds);
      }
    }
  }
}

int CountOurErrors(const Results& results)
{
  int wrong = 0;
  for (const SceneResult& result : results.Scenes)
  {
    for (const Row& row : result.Rows)
    {
      for (std::size_t i = 0; i < row.Costs.size(); ++i)
      {
        wrong += results.Kinds[i].Of == Family::Ours ? row.Costs[i].Wrong : 0;
      }
    }
  }
  return wrong;
}

}
