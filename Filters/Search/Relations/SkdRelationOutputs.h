// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRelationOutputs.h
 * @brief The cells found by a search, as meshes, as a selection and as a table.
 */

#ifndef SkdRelationOutputs_h
#define SkdRelationOutputs_h

#include "Search/Relations/SkdQueryList.h"
#include "Search/Relations/SkdSpatialSearch.h"

class vtkSelection;
class vtkTable;
class vtkUnstructuredGrid;

namespace skdtree
{
/// What the outputs contain.
struct SkdRelationRows
{
  const SkdRelatedCells& Pairs;
  const SkdQueryList& Queries;
  std::vector<int> BlockIndices; ///< one a part of the mesh
  bool IsExact;
  bool IsMeshComposite;
  bool IsSourceComposite;
  std::vector<std::vector<vtkIdType>> JoinedIds; ///< by part: see SkdJoinedIdOf
};

/// The id of a cell of a part in the joined pieces of all processes, if there are several: of
/// `ids`, by cell; the same where it is empty.
inline vtkIdType SkdJoinedIdOf(const std::vector<vtkIdType>& ids, vtkIdType cell)
{
  return ids.empty() ? cell : ids[static_cast<std::size_t>(cell)];
}

/// A cell that was found, once.
struct SkdChosenCell
{
  vtkIdType CellId;
  vtkIdType QueryCount; ///< by how many
  double Distance;      ///< the least
};

/// By part and cell id; one list a part.
std::vector<std::vector<SkdChosenCell>> SkdChooseCells(
  const SkdRelatedCells& pairs, std::size_t parts);

/// The chosen cells of a mesh with all its data. Their ids are joined ones.
void SkdExtractCells(vtkDataSet* mesh, const std::vector<SkdChosenCell>& chosen,
  const std::vector<vtkIdType>& joined, vtkUnstructuredGrid* output);

/// A node a part that has chosen cells, by their ids in the piece of the process that gives them;
/// `process` is -1 where there is only one.
void SkdFillSelection(const std::vector<std::vector<SkdChosenCell>>& chosen,
  const SkdRelationRows& answers, int process, vtkSelection* selection);

void SkdFillPairs(const SkdRelationRows& answers, vtkTable* table);
}

#endif
