// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeSpatialQuery.h"

#include "Bodies/SkdParts.h"
#include "Cells/Search/SkdLocatorState.h"
#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "Search/Relations/SkdRelationOutputs.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkSelection.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeSpatialQuery);

class vtkSkdTreeSpatialQuery::Internals
{
public:
  std::vector<SkdBlock> Blocks; // of the input, those with cells
  SkdParts Mesh;
  SkdParts SourceCells; // if they are the queries
  SkdQueryList Queries;
  SkdRelatedCells Pairs;
  int Built = 0;

  // Of inputs in pieces.
  SkdParts::Wholes WholeMesh;
  SkdParts::Wholes WholeSource;
  std::map<int, std::vector<vtkIdType>> JoinedIds; // of the input's cells, by block index

  /// By block in use; empty where they are those of the mesh. They are not kept.
  std::vector<std::vector<vtkIdType>> TakeJoinedIds()
  {
    std::vector<std::vector<vtkIdType>> ids;
    for (const SkdBlock& block : this->Blocks)
    {
      ids.push_back(std::move(this->JoinedIds[block.BlockIndex]));
    }
    this->JoinedIds.clear();
    return ids;
  }

  /// Of a shape of its own.
  static SkdQueryShape MakeShape(vtkSkdTreeSpatialQuery* self);

  void FindPairs(const SkdSearchRules& rules, vtkAlgorithm* owner)
  {
    const SkdSpatialSearch search(this->Mesh, rules);
    this->Pairs = search.Find(
      this->Queries.GetSize(), [this](vtkIdType i) { return this->Queries.Make(i); }, owner);
  }
};

namespace
{
/// Bounds scaled, rotated and moved, as vtkPVBox has it.
SkdQueryShape BoxOf(const double bounds[6], const double position[3], const double rotation[3],
  const double length[3])
{
  vtkNew<vtkTransform> transform;
  transform->RotateZ(rotation[2]);
  transform->RotateX(rotation[0]);
  transform->RotateY(rotation[1]);
  skd::Vector3 corner = SkdVector(position);
  skd::Vector3 edges[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    skd::Vector3 along{ { 0.0, 0.0, 0.0 } };
    along[axis] = length[axis];
    transform->TransformVector(along.X, along.X);
    corner = corner + bounds[2 * axis] * along;
    edges[axis] = (bounds[2 * axis + 1] - bounds[2 * axis]) * along;
  }
  return SkdQueryShape::MakeBox(corner, edges);
}

/// Which of several processes this is, -1 if there is but one.
int PieceOf(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const bool isOneOfMany = output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
    output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
  return isOneOfMany ? output->Get(Pipeline::UPDATE_PIECE_NUMBER()) : -1;
}

/// What extracts chosen cells: the meshes of the parts in turn.
class Extraction
{
public:
  Extraction(const std::vector<SkdBlock>& blocks,
    const std::vector<std::vector<SkdChosenCell>>& chosen,
    const std::vector<std::vector<vtkIdType>>& joinedIds)
    : Blocks(blocks)
    , Chosen(chosen)
    , JoinedIds(joinedIds)
  {
  }

  void Extract(vtkDataSet* mesh, vtkUnstructuredGrid* output)
  {
    const auto found = std::find_if(this->Blocks.begin(), this->Blocks.end(),
      [mesh](const SkdBlock& block) { return block.Mesh == mesh; });
    if (found == this->Blocks.end())
    {
      SkdExtractCells(mesh, {}, {}, output);
      return;
    }
    const auto part = static_cast<std::size_t>(found - this->Blocks.begin());
    SkdExtractCells(mesh, this->Chosen[part], this->JoinedIds[part], output);
  }

  vtkSmartPointer<vtkUnstructuredGrid> Extract(vtkDataSet* mesh)
  {
    auto output = vtkSmartPointer<vtkUnstructuredGrid>::New();
    this->Extract(mesh, output);
    return output;
  }

private:
  const std::vector<SkdBlock>& Blocks;
  const std::vector<std::vector<SkdChosenCell>>& Chosen;
  const std::vector<std::vector<vtkIdType>>& JoinedIds;
};

/// The input's structure or, if that cannot hold unstructured grids, its leaves by their
/// numbers.
void ExtractTo(vtkDataObject* output, vtkDataObject* input, Extraction& extraction)
{
  output->GetFieldData()->PassData(input->GetFieldData());
  if (auto* mesh = vtkDataSet::SafeDownCast(input))
  {
    extraction.Extract(mesh, vtkUnstructuredGrid::SafeDownCast(output));
    return;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree)
  {
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
    std::size_t next = 0;
    const SkdLeafNumbers leaves = SkdLeafNumbersOf(input);
    blocks->SetNumberOfBlocks(leaves.Count);
    for (const SkdBlock& block : SkdBlocksOf(input))
    {
      blocks->SetBlock(leaves.Of[next++], extraction.Extract(block.Mesh));
    }
    return;
  }
  auto* target = vtkDataObjectTree::SafeDownCast(output);
  target->CopyStructure(tree);
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto* mesh = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      target->SetDataSet(iterator, extraction.Extract(mesh));
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSkdTreeSpatialQuery::vtkSkdTreeSpatialQuery()
  : vtkSkdTreeSearchAlgorithm(SourceUse::Optional, { LIKE_INPUT, VTK_SELECTION, VTK_TABLE })
  , Impl(new Internals)
{
}

vtkSkdTreeSpatialQuery::~vtkSkdTreeSpatialQuery() = default;

//------------------------------------------------------------------------------
int vtkSkdTreeSpatialQuery::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  const int type = vtkDataSet::SafeDownCast(input) ? VTK_UNSTRUCTURED_GRID
    : vtkDataObjectTree::SafeDownCast(input)       ? input->GetDataObjectType()
                                                   : VTK_MULTIBLOCK_DATA_SET;
  SkdProvideOutput(outputVector->GetInformationObject(0), type);
  SkdProvideOutput(outputVector->GetInformationObject(1), VTK_SELECTION);
  SkdProvideOutput(outputVector->GetInformationObject(2), VTK_TABLE);
  return 1;
}

//------------------------------------------------------------------------------
// Each process answers for its own piece, but which cells are the nearest depends on all of them.
bool vtkSkdTreeSpatialQuery::NeedsWhole(int port)
{
  return port > 0 || this->Relation == NEAREST;
}

//------------------------------------------------------------------------------
// Boxes of candidates are larger than cells, and points need not be of cells.
bool vtkSkdTreeSpatialQuery::NeedsNearbySource(SkdSearchRange& range)
{
  range.Distance = this->Tolerance;
  range.OfDiagonal = 1e-3; // more than any rounding
  return this->Shape == SOURCE_CELLS && this->Exact;
}

//------------------------------------------------------------------------------
// All processes exchange before anything can fail on one of them.
void vtkSkdTreeSpatialQuery::FindJoined(vtkInformation* output)
{
  Internals& internals = *this->Impl;
  internals.WholeMesh.clear();
  internals.WholeSource.clear();
  internals.JoinedIds.clear();
  const std::unique_ptr<SkdTransport> transport = SkdMakeTransport(SkdControllerOf(output));
  if (!transport)
  {
    return;
  }
  internals.WholeMesh = this->Inputs->FindExtents(0, *transport, SkdMeasurable);
  if (this->Shape == SOURCE_CELLS)
  {
    internals.WholeSource = this->Inputs->FindExtents(1, *transport, SkdMeasurable);
  }
  if (!this->Inputs->GetWhole(0))
  {
    const std::vector<SkdBlock> blocks = SkdBlocksOf(this->Inputs->GetPiece(0));
    std::vector<std::vector<vtkIdType>> ids = this->Inputs->FindIds(output, transport.get());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      internals.JoinedIds[blocks[i].BlockIndex] = std::move(ids[i]);
    }
  }
  this->Inputs->AddTraffic(transport->GetTraffic());
}

//------------------------------------------------------------------------------
void vtkSkdTreeSpatialQuery::UpdateTrees(vtkDataObject* input, vtkDataObject* source)
{
  Internals& internals = *this->Impl;
  internals.Blocks = SkdBlocksWithCells(SkdBlocksOf(input));
  const bool isOfOne =
    this->Shape != SOURCE_POINTS && this->Shape != SOURCE_CELLS && this->Relation != NEAREST;
  internals.Built = internals.Mesh.Update(internals.Blocks, this->Epsilon, SkdMeasurable,
    isOfOne ? SkdTreeWanted::IfUsedBefore : SkdTreeWanted::AtOnce, internals.WholeMesh);
  const bool needsCells = source && this->Shape == SOURCE_CELLS;
  const std::vector<SkdBlock> sourceBlocks =
    needsCells ? SkdBlocksWithCells(SkdBlocksOf(source)) : std::vector<SkdBlock>();
  internals.Built += internals.SourceCells.Update(
    sourceBlocks, this->Epsilon, SkdMeasurable, SkdTreeWanted::AtOnce, internals.WholeSource);
}

//------------------------------------------------------------------------------
void vtkSkdTreeSpatialQuery::WarnAboutCells()
{
  for (const auto& [parts, name] :
    { std::pair(&this->Impl->Mesh, "Input"), std::pair(&this->Impl->SourceCells, "Source") })
  {
    const SkdTreeCounts counts = parts->GetCounts();
    if (counts.Cells == 0 && counts.CellsLeftOut > 0)
    {
      vtkWarningMacro(<< name << " has no valid cells: they are hidden, or "
                      << SkdWhyCellsAreLeftOut());
    }
  }
}

//------------------------------------------------------------------------------
SkdQueryShape vtkSkdTreeSpatialQuery::Internals::MakeShape(vtkSkdTreeSpatialQuery* self)
{
  const double unit[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  switch (self->Shape)
  {
    case SPHERE:
      return SkdQueryShape::MakeBall(SkdVector(self->SphereCenter), self->SphereRadius);
    case PLANE:
      return SkdQueryShape::MakePlane(SkdVector(self->PlaneOrigin), SkdVector(self->PlaneNormal));
    case LINE:
      return SkdQueryShape::MakeLine(SkdVector(self->LinePoint1), SkdVector(self->LinePoint2));
    default:
      return BoxOf(self->UseReferenceBounds ? self->ReferenceBounds : unit, self->BoxPosition,
        self->BoxRotation, self->BoxLength);
  }
}

//------------------------------------------------------------------------------
bool vtkSkdTreeSpatialQuery::MakeQueries(vtkDataObject* source)
{
  SkdQueryList& queries = this->Impl->Queries;
  if (this->Relation == NEAREST && this->NumberOfNearestCells < 1)
  {
    vtkErrorMacro("NumberOfNearestCells is 0 but must be at least 1; nothing is found.");
    return false;
  }
  if (this->Shape == SOURCE_POINTS || this->Shape == SOURCE_CELLS)
  {
    if (!source)
    {
      vtkErrorMacro("Source is not set, but Shape needs its "
        << (this->Shape == SOURCE_POINTS ? "points." : "cells."));
      return false;
    }
    if (this->Shape == SOURCE_POINTS)
    {
      queries.SetPoints(SkdBlocksOf(source));
    }
    else
    {
      queries.SetCells(this->Impl->SourceCells, SkdBlocksWithCells(SkdBlocksOf(source)),
        this->Relation == ADJACENCY);
    }
    return true;
  }
  const SkdQueryShape shape = Internals::MakeShape(this);
  if (!shape.IsUsable())
  {
    vtkWarningMacro("The shape is invalid: it is not finite, extends beyond "
      << SkdMeasurable.Largest << ", has a negative radius or no normal. Nothing is found.");
  }
  queries.SetShape(shape);
  return true;
}

//------------------------------------------------------------------------------
// Each process has found the nearest cells of all pieces; it gives those of its own piece.
vtkDataObject* vtkSkdTreeSpatialQuery::KeepOwn(const SkdWholeInput& whole)
{
  Internals& internals = *this->Impl;
  const int process = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
  SkdRelatedCells own;
  for (SkdRelatedCell pair : internals.Pairs)
  {
    const int block = internals.Blocks[pair.Part].BlockIndex;
    const SkdPieceCell& origin = whole.GetOrigins(block)[static_cast<std::size_t>(pair.CellId)];
    if (origin.Piece == process)
    {
      std::vector<vtkIdType>& ids = internals.JoinedIds[block];
      ids.resize(std::max(ids.size(), static_cast<std::size_t>(origin.CellId) + 1), -1);
      ids[static_cast<std::size_t>(origin.CellId)] = pair.CellId;
      pair.CellId = origin.CellId;
      own.push_back(pair);
    }
  }
  internals.Pairs = std::move(own);
  const std::vector<SkdBlock> pieces = SkdBlocksOf(whole.GetPiece());
  for (SkdBlock& block : internals.Blocks)
  {
    const auto found = std::find_if(pieces.begin(), pieces.end(),
      [&](const SkdBlock& piece) { return piece.BlockIndex == block.BlockIndex; });
    block.Mesh = found == pieces.end() ? nullptr : found->Mesh;
  }
  return whole.GetPiece();
}

//------------------------------------------------------------------------------
int vtkSkdTreeSpatialQuery::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& internals = *this->Impl;
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  SkdStopwatch watch;
  this->FindJoined(outputVector->GetInformationObject(0));
  try
  {
    this->UpdateTrees(input, source);
  }
  catch (const std::length_error& error)
  {
    vtkErrorMacro("Input or Source cannot be searched: " << error.what());
    return 1;
  }
  this->WarnAboutCells();
  const double buildSeconds = watch.Lap();

  internals.Pairs.clear();
  if (this->MakeQueries(source))
  {
    this->FindPairs();
  }
  if (const SkdWholeInput* whole = this->Inputs->GetWhole(0))
  {
    input = this->KeepOwn(*whole);
  }
  const double querySeconds = watch.Lap();

  this->FillOutputs(input, source, outputVector);
  this->Report(vtkDataObject::GetData(outputVector, 0), buildSeconds, querySeconds);
  internals.Blocks.clear();
  internals.Queries = SkdQueryList();
  return 1;
}

//------------------------------------------------------------------------------
void vtkSkdTreeSpatialQuery::FindPairs()
{
  SkdSearchRules rules;
  rules.Relation = static_cast<SkdRelation>(this->Relation);
  rules.SharedPart = static_cast<SkdSharedPart>(this->SharedPart);
  rules.Tolerance = this->Tolerance;
  rules.IsExact = this->Exact;
  rules.Number = static_cast<std::size_t>(this->NumberOfNearestCells);
  rules.HasTies = this->AllTies;
  this->Impl->FindPairs(rules, this);
}

//------------------------------------------------------------------------------
void vtkSkdTreeSpatialQuery::FillOutputs(
  vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputVector)
{
  Internals& internals = *this->Impl;
  const SkdRelationRows answers{ internals.Pairs, internals.Queries,
    internals.Mesh.GetBlockIndices(), this->Exact, SkdIsComposite(input), SkdIsComposite(source),
    internals.TakeJoinedIds() };
  const auto chosen = SkdChooseCells(internals.Pairs, internals.Blocks.size());
  vtkIdType found = 0;
  for (const std::vector<SkdChosenCell>& cells : chosen)
  {
    found += static_cast<vtkIdType>(cells.size());
  }
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  Extraction extraction(internals.Blocks, chosen, answers.JoinedIds);
  ExtractTo(output, input, extraction);
  SkdFillSelection(chosen, answers, PieceOf(outputVector->GetInformationObject(1)),
    vtkSelection::GetData(outputVector, 1));
  SkdFillPairs(answers, vtkTable::GetData(outputVector, 2));
  SkdReport(output).AddCount("CellsFound", found);
}

//------------------------------------------------------------------------------
void vtkSkdTreeSpatialQuery::Report(vtkDataObject* output, double buildSeconds, double querySeconds)
{
  const Internals& internals = *this->Impl;
  const SkdTreeCounts counts = internals.Mesh.GetCounts();
  SkdReport report(output);
  report.AddCount("Queries", internals.Queries.GetSize());
  report.AddCount("Pairs", static_cast<vtkIdType>(internals.Pairs.size()));
  report.AddCount("Cells", counts.Cells);
  report.AddCount("CellsLeftOut", counts.CellsLeftOut);
  report.AddCount("TreesBuilt", internals.Built);
  report.AddMeasure("Epsilon", counts.Tolerance);
  report.AddMeasure("BuildSeconds", buildSeconds);
  report.AddMeasure("QuerySeconds", querySeconds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeSpatialQuery::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Relation", this->Relation, "Shape", this->Shape, "Exact", this->Exact,
    "NumberOfNearestCells", this->NumberOfNearestCells, "AllTies", this->AllTies, "SharedPart",
    this->SharedPart, "BoxPosition", this->BoxPosition, "BoxLength", this->BoxLength, "BoxRotation",
    this->BoxRotation, "UseReferenceBounds", this->UseReferenceBounds, "ReferenceBounds",
    this->ReferenceBounds, "SphereCenter", this->SphereCenter, "SphereRadius", this->SphereRadius,
    "PlaneOrigin", this->PlaneOrigin, "PlaneNormal", this->PlaneNormal, "LinePoint1",
    this->LinePoint1, "LinePoint2", this->LinePoint2, "Tolerance", this->Tolerance);
}
VTK_ABI_NAMESPACE_END
