// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeAttach
 * @brief   attach a vtkSkdTreeCellLocator to a mesh for the next filter
 *
 * Passes on its input (any vtkDataSet, or composite of them) and sets a vtkSkdTreeCellLocator on
 * each vtkPointSet in it (vtkPointSet::SetCellLocator). Filters that use the cell locator of their
 * input then search with the skD-tree: up to VTK 9.6 ParaView's Stream Tracer with *Interpolator
 * with Cell Locator* and other users of vtkCellLocatorStrategy, since VTK 9.7 vtkProbeFilter and
 * vtkPointSet::FindCell.
 *
 * @warning It has no effect on the Stream Tracer and particle tracers of VTK 9.7, which replace the
 * attached locator by one of their own class. Set their own property *Cell Locator*
 * (SetCellLocator) to a vtkSkdTreeCellLocator.
 *
 * Only the next filter gets the locator, because data sets do not copy it. Images and rectilinear
 * grids have no locator and are passed on unchanged.
 *
 * The tree is reused while the input's points, cells and ghost marks keep their values: no build in
 * further time steps. Where they are modified in place, by a source that reuses its output say, the
 * attached locator builds a tree of its own at the next query: see
 * vtkSkdTreeCellLocator::BuildLocator.
 *
 * Bad input: none is rejected. The locator of a mesh without cells finds nothing. After an aborted
 * execution, blocks that were not processed have no locator.
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

  //@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Epsilon, double, 0.0, 1.0);
  //@}

  //@{
  /**
   * See vtkSkdTreeCellLocator::SetLazyBuild. Default off.
   */
  vtkSkdTreeSwitchMacro(LazyBuild);
  //@}

  //@{
  /**
   * See vtkSkdTreeCellLocator::SetSkipGhostCells. Default on.
   */
  vtkSkdTreeSwitchMacro(SkipGhostCells);
  //@}

  /**
   * The number of trees built in the last execution; the others were reused.
   */
  int GetTreesBuilt() const;

  /**
   * Passes the inputs on without broken cells: see "Bad input" in vtkSkdTreeCellLocator.
   */
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkSkdTreeAttach();
  ~vtkSkdTreeAttach() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

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
