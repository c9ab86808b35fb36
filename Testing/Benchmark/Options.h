// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Options.h
 * @brief the options of the command line
 */
#ifndef skdbench_Options_h
#define skdbench_Options_h

#include "Scenes.h"

#include <optional>
#include <string>
#include <vector>

namespace skdbench
{

struct Options
{
  Size Scenes = Size::Usual;
  bool MadeScenes = true;
  bool DataScenes = true;
  bool Pairs = true;
  bool Growth = true;
  bool Batches = true;
  int GrowthUntil = 10000000; // cells
  int Repetitions = 5;
  double Seconds = 0.05; // a repetition lasts at least
  int Queries = 4096;
  int Checks = 300;          // results compared for each kind of work
  double CheckSeconds = 2.0; // for each kind of work at most
  double SlowBuild = 4.0;    // seconds: a build that takes longer is timed once
  int Threads = 1;
  std::string OnlyScene; // parts of names; empty: all
  std::string OnlyWork;
  std::string OnlyKind;
  std::string MarkdownFile;
  std::string CsvFile;
  bool LoadCells = false;
  int Profile = 0; // queries to run untimed, for a profiler
  std::vector<std::string> Files;
};

/// None when the command line is wrong or requests help: both are printed on the console.
std::optional<Options> ParseOptions(int argc, char* argv[]);

/// Whether a name passes a filter.
bool Passes(const std::string& name, const std::string& only);

}

#endif
