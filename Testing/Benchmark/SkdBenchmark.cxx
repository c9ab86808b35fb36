// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBenchmark.cxx
 * @brief one command that prints what searches cost: see README.md in this folder
 */
#include "Batches.h"
#include "Growth.h"
#include "Measure.h"
#include "Pairs.h"
#include "Table.h"
#include "Timing.h"
#include "Works.h"

#include "Support/Folders.h"

#include "vtkLogger.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

namespace
{

using namespace skdbench;

std::vector<Kind> ChosenKinds(const Options& options)
{
  std::vector<Kind> kinds = AllKinds();
  kinds.erase(std::remove_if(kinds.begin(), kinds.end(),
                [&](const Kind& kind) { return !Passes(kind.Name, options.OnlyKind); }),
    kinds.end());
  for (Kind& kind : kinds)
  {
    if (options.LoadCells)
    {
      kind.Make = [make = kind.Make]
      {
        auto structure = make();
        structure->LoadCells();
        return structure;
      };
    }
  }
  return kinds;
}

std::vector<Scene> ChosenScenes(const Options& options)
{
  std::vector<Scene> scenes;
  const auto append = [&](const std::vector<Scene>& more)
  {
    std::copy_if(more.begin(), more.end(), std::back_inserter(scenes),
      [&](const Scene& scene) { return Passes(scene.Name, options.OnlyScene); });
  };
  append(options.DataScenes ? FolderScenes(skdtest::DataFolder()) : std::vector<Scene>());
  for (const std::string& file : options.Files)
  {
    append({ FileScene(file) });
  }
  append(options.MadeScenes ? MadeScenes(options.Scenes) : std::vector<Scene>());
  return scenes;
}

/// The console, and the file if one is given.
void Show(const Options& options, const std::string& text, bool first = false)
{
  std::cout << text << std::flush;
  if (!options.MarkdownFile.empty())
  {
    std::ofstream(options.MarkdownFile, first ? std::ios::trunc : std::ios::app) << text;
  }
}

template <class Print>
std::string Text(const Print& print)
{
  std::ostringstream out;
  print(out);
  return out.str();
}

/// None when a file cannot be read.
vtkSmartPointer<vtkDataSet> Load(const Scene& scene)
{
  vtkSmartPointer<vtkDataSet> data = scene.Make();
  if (!data || data->GetNumberOfCells() == 0)
  {
    std::cerr << "There are no cells in " << scene.Name << ".\n";
    return nullptr;
  }
  Touch(data);
  return data;
}

Results RunTables(const Options& options, const std::vector<Kind>& kinds, bool& allRead)
{
  Results results{ kinds, {} };
  for (const Scene& scene : ChosenScenes(options))
  {
    const auto data = Load(scene);
    allRead = allRead && data;
    const std::vector<Work> works = data ? MakeWorks(data, options.Queries) : std::vector<Work>();
    if (data && options.Profile > 0)
    {
      RunForProfiler(data, works, kinds, options);
    }
    else if (data)
    {
      results.Scenes.push_back(Measure(scene.Name, data, works, kinds, options));
      Show(
        options, Text([&](std::ostream& out) { PrintScene(out, results.Scenes.back(), kinds); }));
    }
  }
  if (!results.Scenes.empty())
  {
    Show(options, Text([&](std::ostream& out) { PrintSummary(out, results); }));
  }
  return results;
}

void ShowScenes(const Options& options, const Results& results)
{
  for (const SceneResult& scene : results.Scenes)
  {
    Show(options, Text([&](std::ostream& out) { PrintScene(out, scene, results.Kinds); }));
  }
}

std::vector<Results> RunGrowth(const Options& options, const std::vector<Kind>& kinds)
{
  const std::vector<Results> growths = MeasureGrowth(kinds, options);
  for (const Results& growth : growths)
  {
    Show(options, Text([&](std::ostream& out) { PrintGrowth(out, growth); }));
  }
  return growths;
}

void WriteCsv(const Options& options, const std::vector<Results>& all)
{
  if (!options.CsvFile.empty())
  {
    std::ofstream out(options.CsvFile);
    PrintCsv(out, all);
  }
}

}

int main(int argc, char* argv[])
{
  const std::optional<Options> options = ParseOptions(argc, argv);
  if (!options)
  {
    return 2;
  }
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_ERROR); // degenerate cells make VTK warn
  vtkSMPTools::Initialize(options->Threads);
  StartTiming();
  const std::vector<Kind> kinds = ChosenKinds(*options);
  Show(*options, Text([&](std::ostream& out) { PrintHeader(out, *options); }), true);
  bool allRead = true;
  std::vector<Results> all = { RunTables(*options, kinds, allRead) };
  if (options->Pairs && options->Profile == 0)
  {
    all.push_back(MeasurePairs(*options));
    ShowScenes(*options, all.back());
  }
  if (options->Batches && options->Profile == 0)
  {
    all.push_back(MeasureBatches(*options));
    ShowScenes(*options, all.back());
  }
  if (options->Growth && options->Profile == 0)
  {
    const std::vector<Results> growths = RunGrowth(*options, kinds);
    all.insert(all.end(), growths.begin(), growths.end());
  }
  WriteCsv(*options, all);
  int errors = 0;
  for (const Results& results : all)
  {
    errors += CountOurErrors(results);
  }
  std::cerr << errors << " wrong answers of the skD-tree\n";
  return errors > 0 || !allRead ? 1 : 0;
}
