// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSpreadSource.h
 * @brief A Source that stays in the pieces that processes have of it, for filters that send
 * questions to them.
 */

#ifndef SkdSpreadSource_h
#define SkdSpreadSource_h

#include "Core/Geometry/Vector.h"
#include "Exchange/SkdCut.h"
#include "Exchange/SkdNearbyInput.h"
#include "Exchange/SkdNearestExchange.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdSourceTrees.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

namespace skdtree
{
class SkdSpreadSource
{
public:
  /// Finds the cells of this process's piece that count, and tells the others where it has any.
  /// Returns them: see SkdSpreadBlock. All processes must call it together. Nothing is done if no
  /// piece has changed.
  vtkDataObject* Update(std::unique_ptr<SkdTransport> transport, vtkDataObject* piece);

  SkdTransport& GetTransport() const { return *this->Transport; }

  /// What Update() returned: another object on all processes once any piece has changed.
  vtkDataObject* GetOwn() const { return this->Own; }

  /// The blocks of that list, each with all cells of the whole that touch the own ones, which are
  /// marked (SkdOwnCellsOf). All processes must call it together.
  std::vector<SkdBlock> BringTouching() const;

  SkdRepeatedId FindRepeatedId() const { return this->Pieces.FindRepeatedId(); }

  /// The blocks of the whole that have cells, on all processes the same; Mesh is the own part.
  const std::vector<SkdBlock>& GetBlocks() const { return this->Blocks; }

  /// Calls visit(block) for each of them, as it lies in pieces.
  template <class Visit>
  void VisitBlocks(const Visit& visit) const
  {
    this->Pieces.VisitBlocks(
      [&visit](const SkdSpreadBlock& block)
      {
        if (block.GetNumberOfCells() > 0)
        {
          visit(block);
        }
      });
  }

  /// The index of a block in that list, by its flat index.
  int BlockSlotOf(int blockIndex) const;

  /// The id in the whole of a cell of the own part of a block of that list.
  vtkIdType IdOf(int block, vtkIdType cell) const
  {
    return this->Ids[static_cast<std::size_t>(block)].Of(cell);
  }

  /// What all processes' trees are together, of the own ones. All must call it together.
  SkdTreeCounts CountAll(const SkdTreeCounts& own) const;

  /// The other processes that have a box within a distance of a point. For any thread.
  void ListNear(const skd::Vector3& x, double radius, std::vector<SkdNearProcess>& near) const;

  /// The same of a line from x along a direction of length 1, from -back to `maxDistance` along it;
  /// the distance is that along it, forwards or backwards, where the line is within `margin` of a
  /// box.
  void ListAlong(const skd::Vector3& x, const skd::Vector3& direction, double back,
    double maxDistance, double margin, std::vector<SkdNearProcess>& near) const;

private:
  void ListBlocks();
  template <class GapOf>
  void List(double limit2, const GapOf& gapOf, std::vector<SkdNearProcess>& near) const;

  std::unique_ptr<SkdTransport> Transport;
  SkdNearbyInput Pieces;
  vtkSmartPointer<vtkDataObject> Own;
  std::vector<SkdBlock> Blocks;
  std::vector<SkdJoinedIds> Ids; // by block
  std::unique_ptr<SkdCut> Cut;
  vtkIdType NumberOfCells = 0; // of the whole
};
}

#endif
