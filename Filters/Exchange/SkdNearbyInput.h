// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdNearbyInput.h
 * @brief Of a filter's input of which each process has a piece, what this process needs.
 */

#ifndef SkdNearbyInput_h
#define SkdNearbyInput_h

#include "Exchange/SkdCompositePieces.h"
#include "Exchange/SkdSpreadBlock.h"
#include "Exchange/SkdStamp.h"

#include <functional>
#include <map>
#include <memory>

namespace skdtree
{
class SkdNearbyInput
{
public:
  /// The cells of all processes' pieces that are near a cell or point of `own` (see
  /// SkdSpreadBlock); of composite data those of each block, at its path. All processes must call
  /// it together. The same object again, without an exchange of data, if nothing has changed on any
  /// of them.
  vtkDataObject* Update(
    SkdTransport& transport, vtkDataObject* piece, vtkDataObject* own, const SkdSearchRange& range);

  /// The cells of this process's own piece that count, in the same way.
  vtkDataObject* UpdateOwn(SkdTransport& transport, vtkDataObject* piece);

  /// Calls visit(block) for each block, in the order of their paths.
  template <class Visit>
  void VisitBlocks(const Visit& visit) const
  {
    for (const auto& [path, block] : this->Blocks)
    {
      visit(*block);
    }
  }

  /// Global ids with which pieces cannot be joined, on all processes the same.
  SkdRepeatedId FindRepeatedId() const
  {
    SkdRepeatedId first;
    this->VisitBlocks(
      [&first](const SkdSpreadBlock& block) { first = first.Or(block.GetRepeatedId()); });
    return first;
  }

  /// What this process has sent in the last Update().
  const SkdTraffic& GetTraffic() const { return this->Traffic; }

private:
  void UpdateBlocks(SkdTransport& transport, vtkDataObject* piece);
  void BringNear(
    SkdTransport& transport, vtkDataObject* piece, vtkDataObject* own, const SkdSearchRange& range);
  void Bring(const std::function<vtkSmartPointer<vtkDataSet>(const SkdSpreadBlock&)>& bring,
    vtkDataObject* piece);

  SkdStamp KnownPiece;
  SkdStamp KnownOwn;
  SkdSearchRange KnownRange;
  SkdTraffic Traffic;
  std::map<SkdBlockPath, std::unique_ptr<SkdSpreadBlock>> Blocks;
  vtkSmartPointer<vtkDataObject> Structure; // of composite data
  vtkSmartPointer<vtkDataObject> Nearby;
};

/// By block of this process's own piece (SkdBlocksOf), whether it counts each cell (SkdFindCounted)
/// or point (vtkDataObject's type). All processes must call it together.
std::vector<std::vector<unsigned char>> SkdFindCountedElements(
  SkdTransport& transport, vtkDataObject* piece, int type);

/// In the same way the joined ids of cells, -1 of those that do not count; `counted` says which do,
/// an empty list: all.
std::vector<std::vector<vtkIdType>> SkdNumberCountedCells(SkdTransport& transport,
  vtkDataObject* piece, const std::vector<std::vector<unsigned char>>& counted);

/// Whether data of this type can be brought: all but AMR data, whose blocks have no paths.
bool SkdCanBring(vtkDataObject* object);

/// Whether a piece has something for which the reach does not do: that is not near, and matters.
/// O(size).
bool SkdIsUnfit(vtkDataObject* piece, const SkdSearchRange& range);

/// Of the points of all its meshes that are finite.
skd::Box3 SkdBoundsOfPoints(vtkDataObject* object);

/// Whether there is a mesh whose points are all on a sphere about the origin.
bool SkdIsOnSphere(vtkDataObject* object);
}

#endif
