// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCut.h
 * @brief What each process knows of where the others have something: a few boxes of each.
 *
 * One box a process would not do where pieces lie among each other; the boxes of the top of a tree
 * do. All together form a small tree that every process has.
 */

#ifndef SkdCut_h
#define SkdCut_h

#include "Core/Geometry/Box.h"
#include "Exchange/SkdTransport.h"
#include "vtkType.h"

#include <memory>
#include <vector>

class vtkDataSet;

namespace skd
{
class PackedRTree;
}

namespace skdtree
{
/// The boxes of a mesh's cells, one for each, with all of curved cells. Empty ones of cells that
/// cannot be searched, and with `skipGhosts` of ghost cells.
std::vector<skd::Box3> SkdBoxesOfCells(vtkDataSet* mesh, bool skipGhosts);

///@{
/// The same of its points.
std::vector<skd::Box3> SkdBoxesOfPoints(vtkDataSet* mesh);
skd::Box3 SkdBoxOfPoint(vtkDataSet* mesh, vtkIdType point);
///@}

/// At most 2^levels boxes that cover many.
std::vector<skd::Box3> SkdCoverOf(std::vector<skd::Box3> boxes, int levels = 6);

class SkdCut
{
public:
  /// From the boxes of what each process has: they are reduced to a few, and sent to all. These are
  /// 64 of up to 8 processes, and half as many whenever the processes are doubled, but at least 4:
  /// what a process sends and keeps is then the same for 8 to 128. All processes must call it
  /// together. O(n).
  SkdCut(SkdTransport& transport, std::vector<skd::Box3> own);

  int GetNumberOfProcesses() const { return static_cast<int>(this->Bounds.size()); }

  /// All that a process has is in this; empty if it has nothing.
  const skd::Box3& GetBounds(int process) const
  {
    return this->Bounds[static_cast<std::size_t>(process)];
  }

  ///@{
  /// All boxes; those of a process follow each other, from its first to before the next one's.
  const std::vector<skd::Box3>& GetBoxes() const { return this->Boxes; }
  std::size_t GetFirst(int process) const
  {
    return this->Firsts[static_cast<std::size_t>(process)];
  }
  ///@}

  /// The processes that have a box which overlaps this one, ascending, each once.
  void FindOverlapping(const skd::Box3& box, std::vector<int>& processes) const;

private:
  std::vector<skd::Box3> Boxes;
  std::vector<int> Owners;
  std::vector<skd::Box3> Bounds;   // by process
  std::vector<std::size_t> Firsts; // by process, and where the last ends
  std::shared_ptr<const skd::PackedRTree> Tree;
};
}

#endif
