// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeAttach
 * @brief   gives a mesh a vtkSkdTreeCellLocator, for the filter that comes next
 *
 * Passes its input (any vtkDataSet, or composite of them) and sets a vtkSkdTreeCellLocator on each
 * vtkPointSet in it (vtkPointSet::SetCellLocator). Filters that use the cell locator of their input
 * then search with the skD-tree: up to VTK 9.6 ParaView's Stream Tracer with *Interpolator with
 * Cell Locator* and whatever else uses vtkCellLocatorStrategy, since VTK 9.7 vtkProbeFilter and
 * vtkPointSet::FindCell.
 *
 * @warning It does not reach the Stream Tracer of VTK 9.7, nor what traces particles there: these
 * put a locator of their own class in the place of the attached one. Their own property *Cell
 * Locator* (SetCellLocator) takes a vtkSkdTreeCellLocator.
 *
 * A locator goes to the very next filter only: no data set passes it on in a copy of itself. Images
 * and rectilinear grids have no locator and are passed as they are.
 *
 * The tree is kept while the input's points, cells and ghost marks are the same: further time steps
 * build nothing.
 *
 * Bad input: nothing is refused. A mesh without cells has a locator that finds nothing. After an
 * execution that is aborted the blocks that it did not get to have no locator.
 *
 * @sa
 * vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeAttach_h
#define vtkSkdTreeAttach_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeAttach : public vtkPassInputTypeAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeAttach, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeAttach* New();

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetLazyBuild. Default off.
   */
  vtkSetMacro(LazyBuild, bool);
  vtkGetMacro(LazyBuild, bool);
  vtkBooleanMacro(LazyBuild, bool);
  ///@}

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetSkipGhostCells. Default on.
   */
  vtkSetMacro(SkipGhostCells, bool);
  vtkGetMacro(SkipGhostCells, bool);
  vtkBooleanMacro(SkipGhostCells, bool);
  ///@}

  /**
   * How many trees the last execution had to build; the others were kept.
   */
  int GetTreesBuilt() const;

  /**
   * Passes the inputs on without broken cells: see "Bad input" in vtkSkdTreeCellLocator.
   */
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkSkdTreeAttach();
  ~vtkSkdTreeAttach() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Epsilon = 1e-9;
  bool LazyBuild = false;
  bool SkipGhostCells = true;

private:
  vtkSkdTreeAttach(const vtkSkdTreeAttach&) = delete;
  void operator=(const vtkSkdTreeAttach&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the trees, kept while their meshes are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
