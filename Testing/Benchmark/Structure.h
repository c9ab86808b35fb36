// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Structure.h
 * @brief the one face that every search structure shows to the benchmark
 *
 * To add a peer: derive from Structure in a file of its own, override what the peer can answer, and
 * append its kinds in AllKinds (Kinds.cxx) when CMake has found it.
 */
#ifndef skdbench_Structure_h
#define skdbench_Structure_h

#include "QueryKind.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

namespace skdbench
{

class Structure
{
public:
  virtual ~Structure() = default;

  /// Builds anew. False when the structure cannot take this data set.
  virtual bool Build(vtkDataSet* data) = 0;

  /// Answers into `answer`. False if the structure does not support this kind of query.
  virtual bool Ask(QueryKind queryKind, const Query& query, Answer& answer) = 0;

  /// From now on the cell of each answer is loaded, too, where the structure can.
  virtual void LoadCells() {}

  /// Bytes that the structure itself says it keeps.
  virtual std::optional<double> BytesBySelf() const { return std::nullopt; }

  /// What rounding its distances may suffer, relative to the size of the scene.
  virtual double Precision() const { return 1e-9; }
};

enum class Family
{
  Ours,
  Vtk,
  Peer
};

struct Kind
{
  std::string Name;
  Family Of;
  std::function<std::unique_ptr<Structure>()> Make;
  bool ForMillions = true;  // ten million cells are built in seconds
  double MostCells = 1e300; // at most, where sizes grow: its memory per cell is large
};

/// The skD-tree first, then VTK's locators, then whatever else was found at configure time.
std::vector<Kind> AllKinds();

std::vector<Kind> SkdKinds();
std::vector<Kind> VtkKinds();
std::vector<Kind> EmbreeKinds(); // where CMake found it; likewise:
std::vector<Kind> CgalKinds();
std::vector<Kind> BoostKinds();

/// The absolute distance by which a line may miss: rounding, seen from the size of the scene.
double LineTolerance(vtkDataSet* data);

}

#endif
