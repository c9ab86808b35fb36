// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeRepresentation
 * @brief   boxes of a level of a mesh's skD-tree, and statistics of the tree
 *
 * Shows the tree of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576, section 3, on any
 * vtkDataSet or composite of them: one tree a block.
 *
 * Output port 0, vtkPolyData: the safety boxes of one level of the paper's binary tree, as quads.
 * Cell arrays Level, CellId (of leaves the cell, else -1) and, of a composite input, BlockIndex.
 *
 * Output port 1, vtkTable, one row a block: BlockIndex, Cells (in the tree), CellsLeftOut (see
 * vtkSkdTreeCellLocator), Nodes and Depth (of the eight-wide tree used in queries), PaperNodes and
 * PaperDepth (of the binary tree), Overlap (surface area of the intersection of the two children's
 * boxes relative to that of the node's box, mean over all nodes), Cost (expected number of boxes of
 * the binary tree that a random line through the root box intersects: the sum of their surface
 * areas divided by that of the root), Bytes, BuildSeconds.
 *
 * Bad input: a mesh without cells has a row of zeros and no boxes. An aborted execution omits
 * blocks that were not processed.
 *
 * @sa
 * vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeRepresentation_h
#define vtkSkdTreeRepresentation_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeRepresentation : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeRepresentation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeRepresentation* New();

  //@{
  /**
   * The level whose boxes are output: 0 is the root. -1, and levels below the deepest, are the
   * leaves. Range -1 to 64, default 4.
   */
  vtkSkdTreeChoiceMacro(Level, -1, 64);
  //@}

  //@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Epsilon, double, 0.0, 1.0);
  //@}

  /**
   * Passes the inputs on without broken cells: see "Bad input" in vtkSkdTreeCellLocator.
   */
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkSkdTreeRepresentation();
  ~vtkSkdTreeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Level = 4;
  double Epsilon = 1e-9;

private:
  vtkSkdTreeRepresentation(const vtkSkdTreeRepresentation&) = delete;
  void operator=(const vtkSkdTreeRepresentation&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
