// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

namespace skdbench
{
namespace
{

const char* const Help = R"(usage: skdtree_benchmark [options] [files]
Prints tables of what searches cost, as Markdown. Files: vtp, vtu, vtk, ply.

  --table              the whole table (the default)
  --smoke              tiny data, milliseconds: do all answers agree?
  --large              a million cells each
  --only-files         the given files only: no growth, pairs and batches
  --no-growth          without the growth over 10^4 .. 10^7 cells
  --only-growth        nothing else
  --no-pairs           without tree against tree
  --only-pairs         nothing else
  --no-batches         without threads and batches
  --only-batches       nothing else; the machine must be at rest
  --growth-until N     up to so many cells (10000000)
  --repetitions N      interleaved; medians are shown (5)
  --seconds S          a repetition lasts at least (0.05)
  --checks N           answers compared for each kind of work (300)
  --threads N          of vtkSMPTools, for builds (1) and batches (2)
  --scene TEXT         only data sets whose name holds TEXT; likewise:
  --work TEXT
  --structure TEXT
  --load-cells         VTK's full calls, which load the cell of each answer
  --markdown FILE      write the tables to a file, too
  --csv FILE           write every number to a file
  --profile N          run N queries of the chosen work untimed, to be watched by a profiler
)";

void Smoke(Options& options)
{
  options.Scenes = Size::Tiny;
  options.Repetitions = 1;
  options.Seconds = 1e-4;
  options.Checks = 200;
  options.Queries = 200;
  options.GrowthUntil = 10000;
}

void OnlyFiles(Options& options)
{
  options.MadeScenes = false;
  options.DataScenes = false;
  options.Growth = false;
  options.Pairs = false;
  options.Batches = false;
}

void OnlyGrowth(Options& options)
{
  OnlyFiles(options);
  options.Growth = true;
}

void OnlyPairs(Options& options)
{
  OnlyFiles(options);
  options.Pairs = true;
}

void OnlyBatches(Options& options)
{
  OnlyFiles(options);
  options.Batches = true;
}

using Flag = std::function<void(Options&)>;
using Setting = std::function<void(Options&, const std::string&)>;

const std::map<std::string, Flag>& Flags()
{
  static const std::map<std::string, Flag> flags = {
    { "--table", [](Options&) {} },
    { "--smoke", Smoke },
    { "--large", [](Options& o) { o.Scenes = Size::Large; } },
    { "--only-files", OnlyFiles },
    { "--no-growth", [](Options& o) { o.Growth = false; } },
    { "--only-growth", OnlyGrowth },
    { "--no-pairs", [](Options& o) { o.Pairs = false; } },
    { "--only-pairs", OnlyPairs },
    { "--no-batches", [](Options& o) { o.Batches = false; } },
    { "--only-batches", OnlyBatches },
    { "--load-cells", [](Options& o) { o.LoadCells = true; } },
  };
  return flags;
}

const std::map<std::string, Setting>& Settings()
{
  using S = const std::string&;
  static const std::map<std::string, Setting> settings = {
    { "--growth-until", [](Options& o, S value) { o.GrowthUntil = std::stoi(value); } },
    { "--repetitions", [](Options& o, S value) { o.Repetitions = std::stoi(value); } },
    { "--seconds", [](Options& o, S value) { o.Seconds = std::stod(value); } },
    { "--checks", [](Options& o, S value) { o.Checks = std::stoi(value); } },
    { "--threads", [](Options& o, S value) { o.Threads = std::stoi(value); } },
    { "--scene", [](Options& o, S value) { o.OnlyScene = value; } },
    { "--work", [](Options& o, S value) { o.OnlyWork = value; } },
    { "--structure", [](Options& o, S value) { o.OnlyKind = value; } },
    { "--markdown", [](Options& o, S value) { o.MarkdownFile = value; } },
    { "--csv", [](Options& o, S value) { o.CsvFile = value; } },
    { "--profile", [](Options& o, S value) { o.Profile = std::stoi(value); } },
  };
  return settings;
}

/// Takes the argument at `i` and, of a setting, its value. False when nobody knows it.
bool Take(Options& options, const std::vector<std::string>& arguments, std::size_t& i)
{
  const std::string& argument = arguments[i];
  const auto flag = Flags().find(argument);
  const auto setting = Settings().find(argument);
  if (flag != Flags().end())
  {
    flag->second(options);
  }
  else if (setting != Settings().end() && i + 1 < arguments.size())
  {
    setting->second(options, arguments[++i]);
  }
  else if (argument.rfind("--", 0) != 0)
  {
    options.Files.push_back(argument);
  }
  else
  {
    return false;
  }
  return true;
}

}

std::optional<Options> ParseOptions(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  Options options;
  try
  {
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
      if (!Take(options, arguments, i))
      {
        std::cerr << Help;
        return std::nullopt;
      }
    }
  }
  catch (const std::exception&)
  {
    std::cerr << "A number is expected there.\n" << Help;
    return std::nullopt;
  }
  return options;
}

bool Passes(const std::string& name, const std::string& only)
{
  return name.find(only) != std::string::npos;
}

}
