// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeFacetAlgorithm
 * @brief   base class of filters that use flat facets instead of curved faces
 *
 * What is inside a surface, and distances to it that have a sign, are found for facets. See
 * vtkSkdTreeSourceAlgorithm for the ports.
 */

#ifndef vtkSkdTreeFacetAlgorithm_h
#define vtkSkdTreeFacetAlgorithm_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSearchAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeFacetAlgorithm : public vtkSkdTreeSearchAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeFacetAlgorithm, vtkSkdTreeSearchAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The largest distance of facets from a curved face, relative to the diagonal of the bounds of
   * the whole Source (of that input, where both are surfaces). Faces of quadratic, Lagrange and
   * Bezier cells are approximated by flat facets without gaps, at most 128 along a side, and the
   * filter is exact for these; a warning counts the faces that need more. A face that is flat
   * within the deviation is one polygon. It has no effect on linear cells, nor on distances without
   * a sign of vtkSkdTreeClosestPoint. The number of facets is inversely proportional to the
   * deviation: about 10^4 for a sphere by default. If there are curved cells,
   * SkdReportChordalLength is the deviation as a length. Range [1e-7, 1], default 1e-4.
   */
  vtkSkdTreeWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  //@}

protected:
  using vtkSkdTreeSearchAlgorithm::vtkSkdTreeSearchAlgorithm;

  double ChordalDeviation = 1e-4;

private:
  vtkSkdTreeFacetAlgorithm(const vtkSkdTreeFacetAlgorithm&) = delete;
  void operator=(const vtkSkdTreeFacetAlgorithm&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
