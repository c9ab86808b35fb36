// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdNearbyInput.h"

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdVisitPoints.h"
#include "Exchange/SkdDirectionBoxes.h"
#include "Exchange/SkdMessage.h"
#include "Exchange/SkdPieceArrays.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdJoinedShape.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// Where a process has something that the cells of another mesh may be near; boxes of cells are so
/// much larger, in parts of their diagonals.
std::vector<skd::Box3> BoxesOf(vtkDataObject* object, double ofDiagonal)
{
  std::vector<skd::Box3> boxes;
  for (const SkdBlock& block : SkdBlocksOf(object))
  {
    const std::vector<skd::Box3> cells = SkdBoxesOfCells(block.Mesh, false);
    const bool haveAll = !SkdHasFreePoints(block.Mesh) &&
      std::none_of(cells.begin(), cells.end(), [](const skd::Box3& box) { return box.IsEmpty(); });
    const std::vector<skd::Box3> points =
      haveAll ? std::vector<skd::Box3>() : SkdBoxesOfPoints(block.Mesh);
    boxes.insert(boxes.end(), points.begin(), points.end());
    for (const skd::Box3& box : cells)
    {
      boxes.push_back(box.Inflated(ofDiagonal * box.Diagonal()));
    }
  }
  return boxes;
}

/// The same of directions.
std::vector<skd::Box3> DirectionBoxesOf(vtkDataObject* object, bool inDegrees)
{
  std::vector<skd::Box3> boxes;
  for (const SkdBlock& block : SkdBlocksOf(object))
  {
    for (const std::vector<skd::Box3>& some : { SkdDirectionBoxesOfPoints(block.Mesh, inDegrees),
           SkdDirectionBoxesOfCells(block.Mesh, inDegrees) })
    {
      boxes.insert(boxes.end(), some.begin(), some.end());
    }
  }
  return boxes;
}

/// The largest distance between points of two boxes.
double FarthestBetween(const skd::Box3& a, const skd::Box3& b)
{
  skd::Vector3 shift;
  for (int axis = 0; axis < 3; ++axis)
  {
    shift[axis] = std::max(a.Max[axis] - b.Min[axis], b.Max[axis] - a.Min[axis]);
  }
  return Norm(shift);
}

/// A few boxes around those of `own`, so large that what of the mesh is nearest to a point in one
/// of `own` is in them: no farther than any one of the boxes, in each of which there is something.
std::vector<skd::Box3> WithNearest(std::vector<skd::Box3> own, const SkdCut& mesh)
{
  constexpr double rounding = 1.0 + 1e-9;
  std::vector<skd::Box3> cover = SkdCoverOf(std::move(own));
  for (skd::Box3& box : cover)
  {
    double nearest = std::numeric_limits<double>::max();
    for (const skd::Box3& other : mesh.GetBoxes())
    {
      nearest = std::min(nearest, FarthestBetween(box, other));
    }
    box = mesh.GetBoxes().empty() ? box : box.Inflated(rounding * nearest);
  }
  return cover;
}

/// The structure of the object, with examples in the place of its meshes.
vtkSmartPointer<vtkDataObject> ExampleOf(vtkDataObject* object)
{
  vtkSmartPointer<vtkDataObject> example = SkdStructureOf(object);
  for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(object))
  {
    const vtkSmartPointer<vtkDataSet> mesh = SkdSpreadBlock::MakeExample(leaf.Mesh);
    if (example && !leaf.Path.empty())
    {
      SkdSetBlock(example, leaf.Path, mesh);
    }
    else
    {
      example = mesh;
    }
  }
  return example;
}

/// Whether there are values that are not finite.
bool HasGaps(vtkDataSetAttributes* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const bool isReal =
      array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
    const vtkIdType values = isReal ? array->GetNumberOfValues() : 0;
    const int components = isReal ? array->GetNumberOfComponents() : 1;
    for (vtkIdType at = 0; at < values; ++at)
    {
      if (!std::isfinite(array->GetComponent(at / components, static_cast<int>(at % components))))
      {
        return true;
      }
    }
  }
  return false;
}

/// Whether points or cells may be hidden.
bool HasMarks(vtkDataSetAttributes* data, int marks)
{
  auto* ghosts =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const unsigned char* const first = ghosts ? ghosts->GetPointer(0) : nullptr;
  return ghosts &&
    std::any_of(first, first + ghosts->GetNumberOfValues(),
      [marks](unsigned char mark) { return (mark & marks) != 0; });
}

/// Whether there are points or middles of cells that are samples but of no cell that counts, or,
/// `withValues`, without a value.
bool IsIncomplete(vtkDataObject* piece, bool withValues)
{
  constexpr int hidden = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  const std::vector<SkdBlock> blocks = SkdBlocksOf(piece);
  return std::any_of(blocks.begin(), blocks.end(),
    [withValues](const SkdBlock& block)
    {
      vtkPointData* ofPoints = block.Mesh->GetPointData();
      vtkCellData* ofCells = block.Mesh->GetCellData();
      return SkdHasFreePoints(block.Mesh) || HasMarks(ofCells, hidden) ||
        (withValues &&
          (HasMarks(ofPoints, vtkDataSetAttributes::HIDDENPOINT) || HasGaps(ofPoints) ||
            HasGaps(ofCells)));
    });
}

/// Whether cells have three corners that differ; those of a strip all do.
bool IsFace(const SkdCellReader& reader, vtkIdType cell, vtkIdList* list)
{
  std::size_t number = 0;
  std::size_t different = 0;
  reader.VisitPoints(cell, list,
    [&](const auto* ids, std::size_t size)
    {
      number = size;
      for (std::size_t i = 0; i < size; ++i)
      {
        different += std::find(ids, ids + i, ids[i]) == ids + i ? 1 : 0;
      }
    });
  return different > 2 && (different == number || reader.TypeOf(cell) != VTK_TRIANGLE_STRIP);
}

/// Whether a piece has something besides faces, all of which count.
bool HasOtherThanFaces(vtkDataSet* mesh)
{
  constexpr int hidden = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  if ((mesh->GetNumberOfCells() == 0 && mesh->GetNumberOfPoints() > 0) ||
    HasMarks(mesh->GetCellData(), hidden))
  {
    return true;
  }
  const SkdCellReader reader(mesh);
  vtkNew<vtkIdList> list;
  vtkNew<vtkGenericCell> cell;
  int known = VTK_EMPTY_CELL;
  bool areFaces = true;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells() && areFaces; ++i)
  {
    const int type = reader.TypeOf(i);
    if (type != known)
    {
      cell->SetCellType(type);
      known = type;
      areFaces = type == VTK_EMPTY_CELL || cell->GetCellDimension() == 2;
    }
    areFaces = areFaces && (type == VTK_EMPTY_CELL || IsFace(reader, i, list));
  }
  return !areFaces;
}

bool AreOtherThanFaces(vtkDataObject* piece)
{
  const std::vector<SkdBlock> blocks = SkdBlocksOf(piece);
  return std::any_of(blocks.begin(), blocks.end(),
    [](const SkdBlock& block) { return HasOtherThanFaces(block.Mesh); });
}

/// A piece's blocks beside those that other processes have.
struct BlocksOfAll
{
  std::map<SkdBlockPath, SkdPieces> Examples; // by process
  std::map<SkdBlockPath, vtkSmartPointer<vtkDataSet>> Own;
  vtkSmartPointer<vtkDataObject> Structure;

  // Of composite data, processes may have different blocks.
  BlocksOfAll(SkdTransport& transport, vtkDataObject* piece)
    : Structure(SkdStructureOf(piece))
  {
    const std::vector<SkdBytes> all = transport.GatherAll(SkdPackObject(ExampleOf(piece)));
    for (std::size_t process = 0; process < all.size(); ++process)
    {
      const vtkSmartPointer<vtkDataObject> example = SkdUnpackObject(all[process]);
      SkdUniteStructures(this->Structure, example);
      for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(example))
      {
        this->Examples[leaf.Path].resize(all.size());
        this->Examples[leaf.Path][process] = leaf.Mesh;
      }
    }
    for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(piece))
    {
      this->Own[leaf.Path] = leaf.Mesh;
    }
    for (const auto& [path, some] : this->Examples)
    {
      vtkSmartPointer<vtkDataSet>& mesh = this->Own[path];
      mesh = mesh ? mesh : vtkSmartPointer<vtkDataSet>(vtkSmartPointer<vtkUnstructuredGrid>::New());
    }
  }
};
}

bool SkdCanBring(vtkDataObject* object)
{
  return !SkdIsComposite(object) || vtkDataObjectTree::SafeDownCast(object) != nullptr;
}

bool SkdIsUnfit(vtkDataObject* piece, const SkdSearchRange& range)
{
  return (range.IsOfOneMesh && SkdIsComposite(piece)) ||
    (range.IsOfFaces && AreOtherThanFaces(piece)) ||
    (range.IsOfSamples && IsIncomplete(piece, range.WithNearest));
}

skd::Box3 SkdBoundsOfPoints(vtkDataObject* object)
{
  skd::Box3 bounds;
  for (const SkdBlock& block : SkdBlocksOf(object))
  {
    SkdVisitPoints(block.Mesh,
      [&bounds](vtkIdType, const skd::Vector3& x)
      {
        if (IsFinite(x))
        {
          bounds.Add(x);
        }
      });
  }
  return bounds;
}

bool SkdIsOnSphere(vtkDataObject* object)
{
  const std::vector<SkdBlock> blocks = SkdBlocksOf(object);
  return std::any_of(blocks.begin(), blocks.end(),
    [](const SkdBlock& block) { return SkdRadiusOf(block.Mesh).has_value(); });
}

vtkDataObject* SkdNearbyInput::Update(
  SkdTransport& transport, vtkDataObject* piece, vtkDataObject* own, const SkdSearchRange& range)
{
  SkdStamp newPiece(piece);
  SkdStamp newOwn(own);
  const bool isNewPiece = SkdIsAny(transport, newPiece != this->KnownPiece);
  const bool isNewOwn =
    SkdIsAny(transport, !this->Nearby || newOwn != this->KnownOwn || range != this->KnownRange);
  if (isNewPiece)
  {
    this->UpdateBlocks(transport, piece);
  }
  if (isNewPiece || isNewOwn)
  {
    this->BringNear(transport, piece, own, range);
  }
  this->KnownPiece = std::move(newPiece);
  this->KnownOwn = std::move(newOwn);
  this->KnownRange = range;
  this->Traffic = transport.GetTraffic();
  return this->Nearby;
}

void SkdNearbyInput::BringNear(
  SkdTransport& transport, vtkDataObject* piece, vtkDataObject* own, const SkdSearchRange& range)
{
  const auto cutOf = [&](std::vector<skd::Box3> boxes, const auto& boxesOfBlock)
  {
    if (range.WithNearest)
    {
      std::vector<skd::Box3> searched;
      this->VisitBlocks(
        [&](const SkdSpreadBlock& block)
        {
          const std::vector<skd::Box3> some = boxesOfBlock(block);
          searched.insert(searched.end(), some.begin(), some.end());
        });
      boxes = WithNearest(std::move(boxes), SkdCut(transport, std::move(searched)));
    }
    return std::make_unique<SkdCut>(transport, std::move(boxes));
  };
  const std::unique_ptr<SkdCut> cut = cutOf(BoxesOf(own, range.OfOwnDiagonal),
    [](const SkdSpreadBlock& block) { return block.GetBoxes(); });
  const std::unique_ptr<SkdCut> directions = range.Directions == SkdByDirections::Always
    ? cutOf(DirectionBoxesOf(own, range.IsOwnInDegrees),
        [&](const SkdSpreadBlock& block)
        { return block.FindDirections(range.IsSearchedInDegrees); })
    : nullptr;
  this->Bring([&](const SkdSpreadBlock& block)
    { return block.Bring(transport, *cut, directions.get(), range); },
    piece);
}

void SkdNearbyInput::UpdateBlocks(SkdTransport& transport, vtkDataObject* piece)
{
  BlocksOfAll all(transport, piece);
  this->Structure = all.Structure;
  this->Blocks.clear();
  for (auto& [path, examples] : all.Examples)
  {
    this->Blocks[path] =
      std::make_unique<SkdSpreadBlock>(transport, all.Own.at(path), std::move(examples));
  }
}

std::vector<std::vector<unsigned char>> SkdFindCountedElements(
  SkdTransport& transport, vtkDataObject* piece, int type)
{
  BlocksOfAll all(transport, piece);
  std::map<SkdBlockPath, std::vector<unsigned char>> ofPaths;
  for (const auto& [path, examples] : all.Examples)
  {
    vtkDataSet* const mesh = all.Own.at(path);
    const SkdAllFacts facts(transport, mesh);
    ofPaths[path] = type == vtkDataObject::POINT ? SkdFindCountedPoints(transport, mesh, facts)
                                                 : SkdFindCounted(transport, mesh, facts);
  }
  std::vector<std::vector<unsigned char>> counted;
  for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(piece))
  {
    counted.push_back(ofPaths.at(leaf.Path));
  }
  return counted;
}

std::vector<std::vector<vtkIdType>> SkdNumberCountedCells(SkdTransport& transport,
  vtkDataObject* piece, const std::vector<std::vector<unsigned char>>& counted)
{
  const std::vector<SkdLeafBlock> leaves = SkdLeafBlocksOf(piece);
  std::map<SkdBlockPath, std::vector<unsigned char>> ofPaths;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    ofPaths[leaves[i].Path] = counted[i];
  }
  BlocksOfAll all(transport, piece);
  std::map<SkdBlockPath, std::vector<vtkIdType>> ids;
  for (const auto& [path, examples] : all.Examples)
  {
    vtkDataSet* const mesh = all.Own.at(path);
    std::vector<unsigned char>& count = ofPaths[path];
    if (count.empty())
    {
      count.assign(static_cast<std::size_t>(mesh->GetNumberOfCells()), 1);
    }
    ids[path] = SkdNumberCounted(transport, mesh, SkdAllFacts(transport, mesh), count);
  }
  std::vector<std::vector<vtkIdType>> numbers;
  for (const SkdLeafBlock& leaf : leaves)
  {
    numbers.push_back(std::move(ids.at(leaf.Path)));
  }
  return numbers;
}

vtkDataObject* SkdNearbyInput::UpdateOwn(SkdTransport& transport, vtkDataObject* piece)
{
  SkdStamp newPiece(piece);
  if (SkdIsAny(transport, !this->Nearby || newPiece != this->KnownPiece))
  {
    this->UpdateBlocks(transport, piece);
    this->Bring([&](const SkdSpreadBlock& block) { return block.BringOwn(transport); }, piece);
  }
  this->KnownPiece = std::move(newPiece);
  this->Traffic = transport.GetTraffic();
  return this->Nearby;
}

void SkdNearbyInput::Bring(
  const std::function<vtkSmartPointer<vtkDataSet>(const SkdSpreadBlock&)>& bring,
  vtkDataObject* piece)
{
  if (this->Structure)
  {
    this->Nearby = SkdStructureOf(this->Structure);
  }
  for (const auto& [path, block] : this->Blocks)
  {
    const vtkSmartPointer<vtkDataSet> mesh = bring(*block);
    if (this->Structure && !path.empty())
    {
      SkdSetBlock(this->Nearby, path, mesh);
    }
    else
    {
      this->Nearby = mesh;
    }
  }
  if (this->Structure)
  {
    this->Nearby->GetFieldData()->PassData(piece->GetFieldData());
  }
}
}
