// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFilterInputs.h
 * @brief What the base classes of filters do with inputs in each request of the pipeline: which
 * times and pieces are requested, and what RequestData gets.
 */

#ifndef SkdFilterInputs_h
#define SkdFilterInputs_h

#include "Exchange/SkdSpreadSource.h"
#include "Exchange/SkdWholeInput.h"

#include <functional>
#include <map>
#include <utility>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

class SkdFilterInputs
{
public:
  /// Which input ports a filter needs as a whole, whatever piece of the output is requested.
  using IsWhole = std::function<bool(int port)>;

  SkdFilterInputs(vtkAlgorithm* filter, IsWhole isWhole)
    : Filter(filter)
    , NeedsWhole(std::move(isWhole))
  {
  }

  /// Whether the filter can use points of any finite coordinates: see SkdValidInput.
  void SetAnyMagnitude(bool any) { this->AnyMagnitude = any; }

  /// Which of these stay in their pieces where each process has one, if there is the transport for
  /// it: the filter sends questions to the other processes.
  void SetStaysSpread(IsWhole stays) { this->StaysSpread = std::move(stays); }

  /// For ProcessRequest: calls `process` with the inputs that the filter is to have.
  /// - REQUEST_INFORMATION: the outputs get the times of all inputs (SkdUniteTimes).
  /// - REQUEST_DATA: inputs without broken cells (SkdValidInput), and whole where they are needed
  ///   whole: gathered from all processes (SkdWholeInput). The outputs get the requested
  ///   time, and in the report the names of arrays that are not complete (SkdPartialArrays).
  int Process(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs,
    const std::function<int(vtkInformationVector** inputs)>& process);

  /// For RequestUpdateExtent. Inputs that are needed whole: each process's own piece, to be
  /// gathered; where the output's pieces are not those of the processes, the whole.
  void RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) const;

  /// How an input was gathered in this REQUEST_DATA; nullptr if it was not.
  const SkdWholeInput* GetWhole(int port) const;

  /// The input if it stayed in its pieces in this REQUEST_DATA; nullptr if it did not.
  const SkdSpreadSource* GetSpread(int port) const;

private:
  int ProcessData(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs,
    const std::function<int(vtkInformationVector** inputs)>& process);
  void GatherInto(vtkInformationVector* inputs, int port);

  vtkAlgorithm* Filter;
  IsWhole NeedsWhole;
  IsWhole StaysSpread;
  bool AnyMagnitude = false;
  std::map<std::pair<int, int>, SkdWholeInput> Whole; // by port and connection
  std::map<std::pair<int, int>, SkdSpreadSource> Spread;
};

#endif
