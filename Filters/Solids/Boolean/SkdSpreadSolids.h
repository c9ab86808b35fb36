// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSpreadSolids.h
 * @brief Surfaces of which each process has a piece, dealt out anew for operations on solids.
 *
 * What an operation computes is where triangles meet. Those cells come together: cells that meet
 * others that are not their neighbours are sent to one process, all that hang together by boxes to
 * the same one. All other cells stay where they are, and meet nothing but neighbours in edges and
 * corners. So each process finds all intersections of the cells that it has then, and splits them
 * as one that has all cells does.
 */

#ifndef SkdSpreadSolids_h
#define SkdSpreadSolids_h

#include "Exchange/SkdSpreadSource.h"
#include "Solids/Boolean/SkdSolids.h"

#include <array>
#include <vector>

class vtkAlgorithm;

namespace skdtree
{
/// What came of the dealing, the same on all processes.
enum class SkdDealt
{
  Done = 0,
  Unfit, // the inputs must be gathered
  Aborted
};

/// All processes must call Update together.
class SkdSpreadSolids
{
public:
  /// Deals out the cells of two closed surfaces, unless they are those of the last time. Unfit are
  /// surfaces that are not closed, or one without cells; with curved cells, faces that are left
  /// out, triangles without area or SkdFaceId; with very many equal triangles, or coordinates for
  /// which exact signs need a scale. Memory follows a process's own cells and those that meet
  /// others.
  SkdDealt Update(const SkdSpreadSource& input, const SkdSpreadSource& source,
    double chordalDeviation, vtkAlgorithm* filter);

  /// The cells that this process has now, of both inputs; in each the order is that of the whole.
  const SkdBooleanBlocks& GetBlocks() const { return this->Blocks; }

  /// The triangles of a set of these blocks that may meet others, ascending.
  std::vector<std::uint32_t> ListInContact(const SkdTriangleSet& set) const;

  /// Cells of all processes that were sent to another one, or could have been.
  vtkIdType GetNumberInContact() const { return this->NumberInContact; }

  /// The middle of the bounds of all.
  const skd::Vector3& GetCenter() const { return this->Center; }

  /// Of each input, the least of all processes: see SkdAlignFaces.
  const std::vector<int>& GetCoordinateBits() const { return this->CoordinateBits; }

  /// The cells of the whole of each input.
  const std::array<vtkIdType, 2>& GetNumbersOfCells() const { return this->NumbersOfCells; }

private:
  std::array<vtkSmartPointer<vtkDataObject>, 2> Known; // what was dealt out
  double KnownDeviation = -1.0;
  SkdDealt Result = SkdDealt::Unfit;
  SkdBooleanBlocks Blocks{ {}, 0, false };
  std::array<vtkSmartPointer<vtkDataSet>, 2> Meshes;
  std::array<std::vector<vtkIdType>, 2> InContact; // ids in the whole, ascending
  std::array<vtkIdType, 2> NumbersOfCells{ { 0, 0 } };
  vtkIdType NumberInContact = 0;
  std::vector<int> CoordinateBits;
  skd::Vector3 Center{};
};
}

#endif
