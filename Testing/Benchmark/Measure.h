// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measure.h
 * @brief times and checks all structures on one data set
 */
#ifndef skdbench_Measure_h
#define skdbench_Measure_h

#include "Options.h"
#include "Structure.h"

#include "vtkDataSet.h"

#include <optional>
#include <string>
#include <vector>

namespace skdbench
{

/// What one structure did at one kind of work.
struct Cost
{
  std::optional<double> Value; // median, in the row's unit; none: it cannot do this work
  int Compared = 0;            // results that the referee saw
  int Wrong = 0;
};

/// One row of the table: the costs in the order of the kinds.
struct Row
{
  std::string Work;
  std::string Unit;
  std::vector<Cost> Costs;
};

struct SceneResult
{
  std::string Name;
  vtkIdType NumberOfCells = 0;
  std::vector<Row> Rows;
};

/// Results whose costs are all in the order of the same kinds.
struct Results
{
  std::vector<Kind> Kinds;
  std::vector<SceneResult> Scenes;
};

/// Builds each kind, and times and checks it at the works whose names pass options.OnlyWork.
SceneResult Measure(const std::string& name, vtkDataSet* data, const std::vector<Work>& works,
  const std::vector<Kind>& kinds, const Options& options);

/// Runs the works that pass options.OnlyWork, options.Profile queries each, untimed.
void RunForProfiler(vtkDataSet* data, const std::vector<Work>& works,
  const std::vector<Kind>& kinds, const Options& options);

}

#endif
