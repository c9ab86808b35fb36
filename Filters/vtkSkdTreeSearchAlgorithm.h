// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSearchAlgorithm
 * @brief   base class of filters whose trees have safety boxes of a chosen size
 *
 * See vtkSkdTreeSourceAlgorithm for the ports.
 */

#ifndef vtkSkdTreeSearchAlgorithm_h
#define vtkSkdTreeSearchAlgorithm_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeSearchAlgorithm : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeSearchAlgorithm, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Safety boxes are inflated by twice this value on each side, relative to the diagonal of the
   * bounds of what is searched: see vtkSkdTreeCellLocator::SetEpsilon. It affects the search only,
   * never an answer. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Epsilon, double, 0.0, 1.0);
  //@}

protected:
  using vtkSkdTreeSourceAlgorithm::vtkSkdTreeSourceAlgorithm;

  double Epsilon = 1e-9;

private:
  vtkSkdTreeSearchAlgorithm(const vtkSkdTreeSearchAlgorithm&) = delete;
  void operator=(const vtkSkdTreeSearchAlgorithm&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
