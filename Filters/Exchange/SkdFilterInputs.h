// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFilterInputs.h
 * @brief What the base classes of filters do with inputs in each request of the pipeline: which
 * times and pieces are requested, and what RequestData gets.
 */

#ifndef SkdFilterInputs_h
#define SkdFilterInputs_h

#include "Exchange/SkdCountedCells.h"
#include "Exchange/SkdInputAround.h"
#include "Exchange/SkdJoinedExtents.h"
#include "Exchange/SkdNearbyInput.h"
#include "Exchange/SkdSpreadSource.h"
#include "Exchange/SkdWholeInput.h"

#include <functional>
#include <map>
#include <utility>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

namespace skdtree
{
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

  /// How an input that is needed as a whole is distributed over processes: see
  /// vtkSkdTreeSourceAlgorithm::SetSourceDistribution.
  enum class Distribution
  {
    Automatic,
    Replicated,
    Exchanged
  };

  /// Whether of an input that is needed as a whole each process needs no more than the cells that
  /// are near its own part of port 0, and then how near.
  using FindSearchRange = std::function<bool(int port, SkdSearchRange& range)>;

  void SetDistribution(Distribution distribution, FindSearchRange find)
  {
    this->Wanted = distribution;
    this->Find = std::move(find);
  }

  /// For filters whose answers are not where port 0 is: what the cells in range are to be near, of
  /// this process; nullptr where nothing is exchanged. The same object as long as it does not
  /// change.
  using FindOwn = std::function<vtkDataObject*(vtkInformationVector* outputs)>;

  void SetOwn(FindOwn find) { this->Own = std::move(find); }

  /// For filters that need of both inputs, each near what a process has of the other, the cells in
  /// a range (SkdSearchRange::IsMutual), as long as `find` says so: both are distributed alike.
  void SetMutual(std::function<bool(SkdSearchRange& range)> find)
  {
    this->FindMutual = std::move(find);
  }

  /// Where nothing is connected to a port that is needed as a whole, it gets what another port has,
  /// of which the filter may need more than each process's piece; -1: nothing.
  void SetStandIn(int port, int other) { this->StandIns[port] = other; }

  /// Of which inputs that are needed as a whole the filter asks the processes that have the pieces:
  /// each process gets the cells of its own piece.
  void SetAsks(IsWhole asks) { this->Asks = std::move(asks); }

  /// Whether the filter can use points of any finite coordinates: see SkdValidInput.
  void SetAnyMagnitude(bool any) { this->AnyMagnitude = any; }

  /// Whether the filter lists what it finds by the cells of port 0: where that stays in its pieces,
  /// cells that several processes have are ghosts but for one of them.
  void SetListsByCells(bool lists) { this->ListsByCells = lists; }

  /// For ProcessRequest: calls `process` with the inputs that the filter is to have.
  /// - REQUEST_INFORMATION: the outputs get the times of all inputs (SkdUniteTimes).
  /// - REQUEST_DATA: inputs without broken cells (SkdValidInput), and whole where they are needed
  ///   whole: gathered from all processes (SkdWholeInput), or what is near (SkdNearbyInput), which
  ///   the report says. The outputs get the requested time, and in the report the names of arrays
  ///   that are not complete (SkdPartialArrays).
  int Process(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs,
    const std::function<int(vtkInformationVector** inputs)>& process);

  /// For RequestUpdateExtent. Inputs that are needed whole: each process's own piece, to be
  /// gathered; where the output's pieces are not those of the processes, the whole.
  void RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) const;

  /// In this REQUEST_DATA, what this process has of an input: what `process` gets if it is not
  /// needed as a whole.
  vtkDataObject* GetPiece(int port) const { return this->Pieces[static_cast<std::size_t>(port)]; }

  /// How an input was gathered in this REQUEST_DATA; nullptr if it was not.
  const SkdWholeInput* GetWhole(int port) const;

  /// Whom to ask about an input in this REQUEST_DATA; nullptr if it was gathered.
  const SkdSpreadSource* GetSpread(int port) const;

  /// Of an input of port 0 that stays in its pieces, which of its cells this process counts, by
  /// block: see SkdCountedCells. Nothing if it does not, or of one process. All must call it
  /// together.
  std::vector<std::vector<unsigned char>> FindCounted(vtkInformation* output);

  /// The same of points.
  std::vector<std::vector<unsigned char>> FindCountedPoints(vtkInformation* output);

  /// The ids of its cells in the joined mesh, by block, -1 of those that it does not count; nothing
  /// of data that cannot be brought, or without a transport. All must call it together.
  std::vector<std::vector<vtkIdType>> FindIds(vtkInformation* output, SkdTransport* transport);

  /// Of an input that is in pieces, or of which there is what is near: of all pieces, by block
  /// index. Nothing of one that was gathered. All must call it together.
  std::map<int, SkdMeshExtent> FindExtents(
    int port, SkdTransport& transport, const SkdMagnitudes& magnitudes);

  /// An input of port 0 that stays in its pieces, with the cells of other processes that its own
  /// may touch: see SkdInputAround. nullptr, with an error, if global ids cannot join them. All
  /// must call it together.
  vtkDataObject* BringAround(SkdTransport& transport);
  const SkdInputAround& GetAround() const { return this->Around; }

  /// All of such an input, where its pieces turn out not to do: from now on it was gathered. All
  /// processes must call it together.
  vtkDataObject* GatherSpread(int port);

  /// The same of an input of which there is what is near.
  vtkDataObject* GatherNearby(int port);

  /// To be reported, too, of this REQUEST_DATA: what the filter has sent itself.
  void AddTraffic(const SkdTraffic& traffic) { this->OfFilter.Add(traffic); }

private:
  /// An input whose processes are asked.
  struct SpreadInput
  {
    SkdSpreadSource Source;
    vtkSmartPointer<vtkDataObject> Piece;
    vtkMultiProcessController* Controller = nullptr;
  };

  int ProcessData(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs,
    const std::function<int(vtkInformationVector** inputs)>& process);
  void GatherAll(vtkInformationVector** inputs, vtkInformationVector* outputs,
    std::vector<vtkSmartPointer<vtkInformationVector>>& retained,
    std::vector<vtkInformationVector*>& whole);
  bool CountCells(std::vector<vtkInformationVector*>& whole);
  vtkMultiProcessController* FindCounting(vtkInformation* output) const;
  void AddStandIn(vtkInformationVector** all, int port, vtkInformationVector* inputs) const;
  void GatherInto(vtkInformationVector* inputs, int port, vtkDataObject* own);
  vtkDataObject* Gather(vtkDataObject* piece, std::pair<int, int> slot, vtkDataObject* own,
    vtkMultiProcessController* controller);
  bool FindRange(int port, SkdSearchRange& range) const;
  bool IsExchanged(vtkDataObject* piece, vtkDataObject* own, int port, SkdTransport* transport,
    SkdSearchRange& range, vtkMultiProcessController* controller) const;
  SkdRepeatedId FindRepeatedId() const;
  bool CheckGlobalIds(const SkdRepeatedId& repeated) const;
  bool CheckKinds(vtkInformationVector* outputs) const;
  bool CheckNesting(vtkMultiProcessController* controller) const;
  void Report(vtkInformationVector* outputs) const;

  vtkAlgorithm* Filter;
  IsWhole NeedsWhole;
  bool AnyMagnitude = false;
  bool ListsByCells = false;
  Distribution Wanted = Distribution::Replicated;
  FindSearchRange Find;
  std::function<bool(SkdSearchRange& range)> FindMutual;
  FindOwn Own;
  IsWhole Asks;
  std::map<int, int> StandIns;                          // by port
  SkdTraffic OfFilter;                                  // during a REQUEST_DATA
  std::vector<vtkSmartPointer<vtkDataObject>> Pieces;   // by port, during a REQUEST_DATA
  std::map<std::pair<int, int>, SkdWholeInput> Whole;   // by port and connection
  std::map<std::pair<int, int>, SkdNearbyInput> Nearby; // the same
  std::map<std::pair<int, int>, SpreadInput> Spread;
  std::map<int, SkdJoinedExtents> Extents; // by port
  SkdCountedInput Counted;                 // port 0
  SkdInputAround Around;                   // likewise
  SkdCountedCells CountedPoints{ vtkDataObject::POINT };
};
}

#endif
