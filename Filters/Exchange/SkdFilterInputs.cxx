// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdFilterInputs.h"

#include "Exchange/SkdCompositePieces.h"
#include "Exchange/SkdSharedMessages.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPartialArrays.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdTimes.h"
#include "Pipeline/SkdValidInput.h"
#include "Pipeline/SkdVolumeCells.h"
#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

namespace skdtree
{
namespace
{
/// In units of 1024 bytes.
constexpr unsigned long LargestReplicated = 64 * 1024;

/// Whether all points that processes have of two inputs have one coordinate in common.
bool AreFlat(vtkDataObject* piece, vtkDataObject* own, vtkMultiProcessController* controller)
{
  skd::Box3 box = SkdBoundsOfPoints(piece);
  box.Add(own ? SkdBoundsOfPoints(own) : skd::Box3());
  double here[6];
  double anywhere[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    here[axis] = box.Min[axis];
    here[3 + axis] = -box.Max[axis];
  }
  controller->AllReduce(here, anywhere, 6, vtkCommunicator::MIN_OP);
  return anywhere[0] == -anywhere[3] || anywhere[1] == -anywhere[4] || anywhere[2] == -anywhere[5];
}

/// Whether voxels that processes have in partitions differ in size, so that several of them cover
/// faces of another. The same on all processes.
bool HaveCoveredFaces(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  constexpr double none = std::numeric_limits<double>::max();
  std::array<double, 6> here{ none, none, none, none, none, none }; // least, and minus the largest
  for (const SkdBlock& block : SkdBlocksOf(piece))
  {
    const auto lattice = block.FirstPiece >= 0 ? SkdVoxelLatticeOf(block.Mesh) : std::nullopt;
    for (int axis = 0; lattice && axis < 3; ++axis)
    {
      here[axis] = std::min(here[axis], lattice->Least[axis]);
      here[3 + axis] = std::min(here[3 + axis], -lattice->Most[axis]);
    }
  }
  std::array<double, 6> all{};
  controller->AllReduce(here.data(), all.data(), 6, vtkCommunicator::MIN_OP);
  return SkdVoxelLattice{
    {}, { { all[0], all[1], all[2] } }, { { -all[3], -all[4], -all[5] } }
  }.HasSeveralSizes();
}

/// Whether the reach does for what all processes have; what of it depends on that is decided.
bool Fit(vtkDataObject* piece, vtkDataObject* own, vtkMultiProcessController* controller,
  SkdSearchRange& range)
{
  const bool mayBeOnSphere = range.Directions == SkdByDirections::OnSpheres ||
    range.IsNotForSpheres || range.IsOfNearSurfaces;
  const bool isUnfit =
    SkdIsUnfit(piece, range) || (range.IsMutual && own && SkdIsUnfit(own, range));
  const int here[] = { isUnfit ? 1 : 0, mayBeOnSphere && own && SkdIsOnSphere(own) ? 1 : 0,
    range.IsOfNearSurfaces && own && SkdHasVolumeCells(SkdBlocksOf(own)) ? 1 : 0 };
  int anywhere[] = { 0, 0, 0 };
  controller->AllReduce(here, anywhere, 3, vtkCommunicator::MAX_OP);
  const bool isOnSphere = anywhere[1] != 0;
  if (range.Directions == SkdByDirections::OnSpheres)
  {
    range.Directions = isOnSphere ? SkdByDirections::Always : SkdByDirections::Never;
  }
  if (range.IsOfNearSurfaces && !isOnSphere && anywhere[2] == 0 &&
    !(range.IsUnlessFlat && AreFlat(piece, own, controller)))
  {
    range.OfDiagonal = range.OfOwnDiagonal = 1.0;
    range.WithNearest = true;
  }
  return anywhere[0] == 0 && !(isOnSphere && range.IsNotForSpheres);
}

/// What kind of data a piece is, of those that can be joined: a mesh, one kind of composite data,
/// none, or something else.
int KindOf(vtkDataObject* piece)
{
  constexpr int ofOthers = -3;
  constexpr int ofNone = -2;
  constexpr int ofMeshes = -1;
  return !piece                       ? ofNone
    : SkdIsComposite(piece)           ? piece->GetDataObjectType()
    : vtkDataSet::SafeDownCast(piece) ? ofMeshes
                                      : ofOthers;
}

/// Where the whole of an input is of another class than a process's piece, which its outputs that
/// are to be like the input were made for.
void ProvideLike(
  vtkAlgorithm* filter, vtkDataObject* piece, vtkDataObject* whole, vtkInformationVector* outputs)
{
  const int type = piece->GetDataObjectType();
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    const char* const fixed =
      filter->GetOutputPortInformation(port)->Get(vtkDataObject::DATA_TYPE_NAME());
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    if (std::string(fixed ? fixed : "") == "vtkDataObject" && output &&
      output->GetDataObjectType() == type)
    {
      SkdProvideOutput(outputs->GetInformationObject(port), whole->GetDataObjectType());
    }
  }
}

/// An error on one process ends the request on all.
void Empty(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      output->Initialize();
    }
  }
}

/// An abort on one process ends the request on all, whose outputs are then not up to date, for it
/// is executed again by all or by none. Who aborted it also takes that back, where it was aborted.
void Abort(vtkAlgorithm* filter, vtkInformationVector* outputs)
{
  const vtkTypeBool isAborted = filter->GetAbortExecute();
  filter->SetAbortExecute(1);
  SkdIsAborted(filter);
  filter->SetAbortExecute(isAborted);
  Empty(outputs);
}
}

int SkdFilterInputs::Process(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, const std::function<int(vtkInformationVector** inputs)>& process)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    SkdUniteTimes(inputs, this->Filter->GetNumberOfInputPorts(), outputs);
  }
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return process(inputs);
  }
  const int result = this->ProcessData(request, inputs, outputs, process);
  SkdMarkRequestedTime(outputs);
  SkdReportPartialArrays(outputs);
  return result;
}

int SkdFilterInputs::ProcessData(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, const std::function<int(vtkInformationVector** inputs)>& process)
{
  SkdSharedMessages messages(this->Filter, outputs);
  const SkdValidInput valid(this->Filter, request, inputs, this->AnyMagnitude);
  this->Pieces.clear();
  this->OfFilter = {};
  for (int port = 0; port < this->Filter->GetNumberOfInputPorts(); ++port)
  {
    this->Pieces.emplace_back(vtkDataObject::GetData(valid.Get()[port]));
  }
  std::vector<vtkSmartPointer<vtkInformationVector>> retained;
  std::vector<vtkInformationVector*> whole;
  const bool areAlike = this->CheckKinds(outputs);
  const bool isRefused = areAlike &&
    SkdRefuseOthers(this->Filter, inputs, SkdControllerOf(outputs->GetInformationObject(0)));
  if (areAlike && !isRefused)
  {
    this->GatherAll(valid.Get(), outputs, retained, whole);
  }
  const bool isFit = areAlike && !isRefused && this->CheckGlobalIds(this->FindRepeatedId());
  const bool isCounted = isFit && this->CountCells(whole);
  int result = isFit ? process(whole.data()) : 0;
  this->Pieces.clear(); // or their data would stay
  if (isCounted)
  {
    this->Counted.Restore(outputs);
  }
  const bool isTogether = !areAlike || isRefused || isCounted || !this->Whole.empty() ||
    !this->Nearby.empty() || !this->Spread.empty();
  const SkdSharedMessages::Outcome outcome =
    isTogether ? messages.SayOnce(!this->NeedsWhole(0)) : SkdSharedMessages::Outcome();
  if (outcome.IsAbortedAnywhere && !isRefused)
  {
    Abort(this->Filter, outputs);
    result = 1;
  }
  else if (isRefused || (outcome.IsErrorAnywhere && (!outcome.IsErrorHere || result == 0)))
  {
    Empty(outputs);
    result = 1; // or each executive has a message of its own
  }
  else if (isFit)
  {
    valid.Report(outputs);
    this->Report(outputs);
  }
  return result;
}

// The same on all processes.
bool SkdFilterInputs::CheckKinds(vtkInformationVector* outputs) const
{
  vtkMultiProcessController* controller = SkdControllerOf(outputs->GetInformationObject(0));
  if (!controller)
  {
    return true;
  }
  const std::size_t ports = this->Pieces.size();
  std::vector<int> kinds;
  std::transform(this->Pieces.begin(), this->Pieces.end(), std::back_inserter(kinds), KindOf);
  std::vector<int> all(ports * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(kinds.data(), all.data(), static_cast<vtkIdType>(ports));
  for (std::size_t at = ports; at < all.size(); ++at)
  {
    if (all[at] != all[at % ports])
    {
      vtkErrorWithObjectMacro(this->Filter,
        "Pieces of one input must be of one kind: those of input port "
          << at % ports
          << " are not all meshes, or not all composite data of one class, on process "
          << "0 and process " << at / ports << ".");
      return false;
    }
  }
  return this->CheckNesting(controller);
}

bool SkdFilterInputs::CheckNesting(vtkMultiProcessController* controller) const
{
  for (std::size_t port = 0; port < this->Pieces.size(); ++port)
  {
    const auto transport =
      SkdIsComposite(this->Pieces[port]) ? SkdMakeTransport(controller) : nullptr;
    if (transport && !SkdAreNestedAlike(*transport, this->Pieces[port]))
    {
      vtkErrorWithObjectMacro(this->Filter,
        "Blocks must be nested in the same way on all processes: of input port "
          << port << " one process has a mesh where another has blocks.");
      return false;
    }
  }
  return true;
}

// Whether processes have compared their cells.
bool SkdFilterInputs::CountCells(std::vector<vtkInformationVector*>& whole)
{
  vtkInformation* input = whole.front()->GetNumberOfInformationObjects() == 1
    ? whole.front()->GetInformationObject(0)
    : nullptr;
  vtkDataObject* piece = input ? vtkDataObject::GetData(input) : nullptr;
  vtkMultiProcessController* controller =
    piece && this->ListsByCells && !this->NeedsWhole(0) ? SkdControllerOf(input) : nullptr;
  if (!controller)
  {
    return false;
  }
  vtkNew<vtkInformation> counted;
  counted->Copy(input);
  counted->Set(vtkDataObject::DATA_OBJECT(), this->Counted.Update(piece, controller));
  whole.front()->SetInformationObject(0, counted);
  return true;
}

// What is brought is near what the filter says, or near the other input, or near what is there of
// the first, which may be the whole of it.
void SkdFilterInputs::GatherAll(vtkInformationVector** inputs, vtkInformationVector* outputs,
  std::vector<vtkSmartPointer<vtkInformationVector>>& retained,
  std::vector<vtkInformationVector*>& whole)
{
  vtkDataObject* const own = this->Own ? this->Own(outputs) : nullptr;
  for (int port = 0; port < this->Filter->GetNumberOfInputPorts(); ++port)
  {
    retained.push_back(vtkSmartPointer<vtkInformationVector>::New());
    retained.back()->Copy(inputs[port]);
    this->AddStandIn(inputs, port, retained.back());
    vtkDataObject* near = own;
    if (!this->Own)
    {
      near = this->FindMutual ? this->GetPiece(1 - port) : vtkDataObject::GetData(retained.front());
    }
    this->GatherInto(retained.back(), port, near);
    whole.push_back(retained.back());
  }
  vtkDataObject* const first = vtkDataObject::GetData(whole.front());
  if (first && this->GetPiece(0) && this->NeedsWhole(0))
  {
    ProvideLike(this->Filter, this->GetPiece(0), first, outputs);
  }
}

void SkdFilterInputs::AddStandIn(
  vtkInformationVector** all, int port, vtkInformationVector* inputs) const
{
  const auto standIn = this->StandIns.find(port);
  if (standIn != this->StandIns.end() && standIn->second >= 0 &&
    inputs->GetNumberOfInformationObjects() == 0)
  {
    inputs->Append(all[standIn->second]->GetInformationObject(0));
  }
}

// What was requested of the input says whether it is this process's piece.
void SkdFilterInputs::GatherInto(vtkInformationVector* inputs, int port, vtkDataObject* own)
{
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* input = inputs->GetInformationObject(i);
    vtkDataObject* piece = vtkDataObject::GetData(input);
    vtkMultiProcessController* controller =
      piece && this->NeedsWhole(port) ? SkdControllerOf(input) : nullptr;
    if (!controller)
    {
      this->Whole.erase({ port, i });
      this->Nearby.erase({ port, i });
      this->Spread.erase({ port, i });
      continue;
    }
    vtkNew<vtkInformation> gathered;
    gathered->Copy(input);
    gathered->Set(vtkDataObject::DATA_OBJECT(), this->Gather(piece, { port, i }, own, controller));
    inputs->SetInformationObject(i, gathered);
  }
}

vtkDataObject* SkdFilterInputs::Gather(vtkDataObject* piece, std::pair<int, int> slot,
  vtkDataObject* own, vtkMultiProcessController* controller)
{
  std::unique_ptr<SkdTransport> transport = SkdMakeTransport(controller);
  SkdSearchRange range;
  if (!this->IsExchanged(piece, own, slot.first, transport.get(), range, controller))
  {
    this->Nearby.erase(slot);
    this->Spread.erase(slot);
    return this->Whole[slot].Update(piece, controller);
  }
  this->Whole.erase(slot);
  if (this->Asks && this->Asks(slot.first))
  {
    this->Nearby.erase(slot);
    SpreadInput& spread = this->Spread[slot];
    spread.Piece = piece;
    spread.Controller = controller;
    return spread.Source.Update(std::move(transport), piece);
  }
  this->Spread.erase(slot);
  return this->Nearby[slot].Update(*transport, piece, own, range);
}

bool SkdFilterInputs::FindRange(int port, SkdSearchRange& range) const
{
  return this->FindMutual ? this->FindMutual(range) : this->Find && this->Find(port, range);
}

// The same on all processes.
bool SkdFilterInputs::IsExchanged(vtkDataObject* piece, vtkDataObject* own, int port,
  SkdTransport* transport, SkdSearchRange& range, vtkMultiProcessController* controller) const
{
  const bool asks = this->Asks && this->Asks(port);
  const bool hasRange = (!asks || this->FindMutual) && this->FindRange(port, range);
  const bool canExchange = asks || hasRange;
  if (this->Wanted == Distribution::Replicated || !canExchange || !SkdCanBring(piece) ||
    (range.IsMutual && !(own && SkdCanBring(own))))
  {
    return false;
  }
  if (!Fit(piece, own, controller, range) ||
    ((asks || range.IsOfOuterFaces) && SkdIsComposite(piece) &&
      HaveCoveredFaces(piece, controller)))
  {
    return false;
  }
  if (!transport)
  {
    if (this->Wanted == Distribution::Exchanged)
    {
      vtkWarningWithObjectMacro(this->Filter,
        "The Source was gathered on each process: to exchange it VTK must be built with MPI and "
        "its module ParallelDIY. Set SourceDistribution to Replicate or Automatic.");
    }
    return false;
  }
  const unsigned long size = piece->GetActualMemorySize() +
    (range.IsMutual ? own->GetActualMemorySize() : 0); // in units of 1024 bytes
  unsigned long all = 0;
  controller->AllReduce(&size, &all, 1, vtkCommunicator::SUM_OP);
  return this->Wanted == Distribution::Exchanged || all > LargestReplicated;
}

SkdRepeatedId SkdFilterInputs::FindRepeatedId() const
{
  SkdRepeatedId first;
  for (const auto& [slot, input] : this->Whole)
  {
    first = first.Or(input.GetRepeatedId());
  }
  for (const auto& [slot, input] : this->Nearby)
  {
    first = first.Or(input.FindRepeatedId());
  }
  for (const auto& [slot, input] : this->Spread)
  {
    first = first.Or(input.Source.FindRepeatedId());
  }
  return first;
}

// The same on all processes.
bool SkdFilterInputs::CheckGlobalIds(const SkdRepeatedId& repeated) const
{
  if (repeated.IsThere)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "Global ids must be of one cell and one point each: "
        << repeated.Describe()
        << " Correct them, or remove them: what several pieces have in common is then found by "
           "coordinates.");
  }
  return !repeated.IsThere;
}

void SkdFilterInputs::Report(vtkInformationVector* outputs) const
{
  vtkDataObject* output = vtkDataObject::GetData(outputs, 0);
  const bool isExchanged = !this->Nearby.empty() || !this->Spread.empty();
  if (!output || (!isExchanged && this->Whole.empty()))
  {
    return;
  }
  SkdReport report(output);
  report.AddCount("SourceExchanged", isExchanged ? 1 : 0);
  if (isExchanged)
  {
    SkdTraffic sent = this->OfFilter;
    for (const auto& [slot, nearby] : this->Nearby)
    {
      sent.Add(nearby.GetTraffic());
    }
    for (const auto& [slot, spread] : this->Spread)
    {
      sent.Add(spread.Source.GetTransport().GetTraffic());
    }
    report.AddCount("MessagesSent", static_cast<vtkIdType>(sent.Messages));
    report.AddCount("BytesSent", static_cast<vtkIdType>(sent.Bytes));
  }
}

void SkdFilterInputs::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) const
{
  const int from = request->Has(vtkExecutive::FROM_OUTPUT_PORT())
    ? request->Get(vtkExecutive::FROM_OUTPUT_PORT())
    : 0;
  vtkInformation* output = outputs->GetInformationObject(std::max(from, 0));
  const bool isOwnPiece = SkdControllerOf(output) != nullptr;
  for (int port = 0; port < this->Filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      if (this->NeedsWhole(port) && !isOwnPiece)
      {
        SkdRequestWhole(input);
      }
      else if (port > 0)
      {
        SkdRequestSamePiece(output, input);
      }
    }
  }
}

const SkdWholeInput* SkdFilterInputs::GetWhole(int port) const
{
  const auto found = this->Whole.find({ port, 0 });
  return found == this->Whole.end() ? nullptr : &found->second;
}

const SkdSpreadSource* SkdFilterInputs::GetSpread(int port) const
{
  const auto found = this->Spread.find({ port, 0 });
  return found == this->Spread.end() ? nullptr : &found->second.Source;
}

std::vector<std::vector<unsigned char>> SkdFilterInputs::FindCounted(vtkInformation* output)
{
  vtkMultiProcessController* controller = this->FindCounting(output);
  return controller ? this->Counted.Find(this->GetPiece(0), controller)
                    : std::vector<std::vector<unsigned char>>();
}

std::vector<std::vector<unsigned char>> SkdFilterInputs::FindCountedPoints(vtkInformation* output)
{
  vtkMultiProcessController* controller = this->FindCounting(output);
  return controller ? this->CountedPoints.Update(this->GetPiece(0), controller)
                    : std::vector<std::vector<unsigned char>>();
}

// Of an input of port 0 that stays in its pieces; else nullptr.
vtkMultiProcessController* SkdFilterInputs::FindCounting(vtkInformation* output) const
{
  return this->GetPiece(0) && !this->NeedsWhole(0) ? SkdControllerOf(output) : nullptr;
}

std::vector<std::vector<vtkIdType>> SkdFilterInputs::FindIds(
  vtkInformation* output, SkdTransport* transport)
{
  return transport && SkdCanBring(this->GetPiece(0))
    ? this->Counted.FindIds(this->GetPiece(0), SkdControllerOf(output), *transport)
    : std::vector<std::vector<vtkIdType>>();
}

std::map<int, SkdMeshExtent> SkdFilterInputs::FindExtents(
  int port, SkdTransport& transport, const SkdMagnitudes& magnitudes)
{
  return this->GetPiece(port) && !this->GetWhole(port)
    ? this->Extents[port].Update(transport, this->GetPiece(port), magnitudes)
    : std::map<int, SkdMeshExtent>();
}

vtkDataObject* SkdFilterInputs::BringAround(SkdTransport& transport)
{
  vtkDataObject* around = this->Around.Update(transport, this->GetPiece(0));
  return this->CheckGlobalIds(this->Around.FindRepeatedId()) ? around : nullptr;
}

vtkDataObject* SkdFilterInputs::GatherSpread(int port)
{
  const std::pair<int, int> slot{ port, 0 };
  const SpreadInput& spread = this->Spread.at(slot);
  vtkDataObject* whole = this->Whole[slot].Update(spread.Piece, spread.Controller);
  this->Spread.erase(slot);
  return whole;
}

vtkDataObject* SkdFilterInputs::GatherNearby(int port)
{
  const std::pair<int, int> slot{ port, 0 };
  this->Nearby.erase(slot);
  return this->Whole[slot].Update(
    this->GetPiece(port), vtkMultiProcessController::GetGlobalController());
}
}
