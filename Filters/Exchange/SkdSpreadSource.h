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
#include "Exchange/SkdNearestExchange.h"
#include "Exchange/SkdOwnCells.h"
#include "Exchange/SkdWholeInput.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdSourceTrees.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkMultiProcessController;

class SkdSpreadSource
{
public:
  /// Numbers the cells of this process's piece, and tells the others where it has any. All
  /// processes must call it together. Nothing is done if no piece has changed. Returns false, and
  /// has nothing, if there is no transport.
  bool Update(vtkDataObject* piece, vtkMultiProcessController* controller);

  SkdTransport& GetTransport() const { return *this->Transport; }

  /// The own cells, with the type and structure of the whole.
  vtkDataObject* GetOwn() const { return this->Own; }

  /// The blocks of the whole that have cells, on all processes the same; Mesh is the own part.
  const std::vector<SkdBlock>& GetBlocks() const { return this->Blocks; }

  /// The index of a block in that list, by its flat index.
  int PlaceOf(int blockIndex) const;

  /// The id in the whole of an own cell of a block of that list.
  vtkIdType IdOf(int block, vtkIdType cell) const
  {
    return this->Ids[static_cast<std::size_t>(block)][static_cast<std::size_t>(cell)];
  }

  /// What all processes' trees are together, of the own ones. All must call it together.
  SkdTreeCounts CountAll(const SkdTreeCounts& own) const;

  /// The other processes that have a box within a distance of a point. For any thread.
  void ListNear(const skd::Vector3& x, double radius, std::vector<SkdNearProcess>& near) const;

private:
  void Number(vtkDataObject* piece, vtkMultiProcessController* controller);

  SkdWholeInput::Stamp Known;           // what the own piece was
  vtkSmartPointer<vtkDataObject> Piece; // kept, so that its address is not used again
  std::shared_ptr<SkdTransport> Transport;
  vtkSmartPointer<vtkDataObject> Own;
  std::vector<SkdBlock> Blocks;
  std::vector<std::vector<vtkIdType>> Ids; // by block
  std::shared_ptr<SkdCut> Cut;
};

#endif
