// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCurveAlgorithm
 * @brief   base class of filters that intersect curves
 *
 * Properties of the Input's curves (see vtkSkdTreeSourceAlgorithm for the ports): their
 * representation, the chord tolerance of the search, and whether data are added to intersections.
 */

#ifndef vtkSkdTreeCurveAlgorithm_h
#define vtkSkdTreeCurveAlgorithm_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSearchAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <string> // For std::string
#include <vector> // For std::vector

namespace skdtree
{
struct SkdPolylineForm;
}

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCurveAlgorithm : public vtkSkdTreeSearchAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeCurveAlgorithm, vtkSkdTreeSearchAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the points of a polyline are joined.
   */
  enum PolylineForms
  {
    STRAIGHT = 0,
    CARDINAL_SPLINE = 1,
    KOCHANEK_SPLINE = 2
  };

  //@{
  /**
   * The curve that a polyline represents: straight lines between its points, or the
   * vtkCardinalSpline or vtkKochanekSpline through them, parametrized by chord length; closed if
   * the last point is the first. Default STRAIGHT.
   */
  vtkSkdTreeChoiceMacro(PolylineForm, STRAIGHT, KOCHANEK_SPLINE);
  //@}

  //@{
  /**
   * Tension, bias and continuity of Kochanek splines, each from -1 to 1, default 0. Tension 1:
   * straight between points; bias: towards the line before (1) or after (-1) a point; continuity:
   * the farther from 0, the sharper the corner at a point.
   */
  vtkSkdTreeWithinMacro(Tension, double, -1.0, 1.0);
  vtkSkdTreeWithinMacro(Bias, double, -1.0, 1.0);
  vtkSkdTreeWithinMacro(Continuity, double, -1.0, 1.0);
  //@}

  //@{
  /**
   * Add the point data of both inputs, interpolated, and the data of both cells, under their own
   * names; without a Source those of the first curve. An array whose name is already in use is not
   * added, with a warning: the Input takes precedence over the Source, and point data over cell
   * data. Along a polyline data are linear between its points, whatever its form. Default on.
   */
  vtkSkdTreeSwitchMacro(InterpolateData);
  //@}

  //@{
  /**
   * The paper's delta, relative to the diagonal of the curves' bounds: the largest distance of a
   * piece of a curve from its chord in the search. It affects the cost, never an answer. Default
   * 1e-3.
   */
  vtkSkdTreeWithinMacro(ChordTolerance, double, 0.0, 1.0);
  //@}

protected:
  using vtkSkdTreeSearchAlgorithm::vtkSkdTreeSearchAlgorithm;

  skdtree::SkdPolylineForm FindPolylineForm() const;

  /// The ChordTolerance or, if it is 0, the default, with a warning.
  double FindChordTolerance();

  /// Warns about cells of a port that could not be read, and if there are no others.
  void WarnAboutInput(const char* port, const std::vector<std::string>& faults, bool isEmpty,
    const char* whatItLacks);

  int PolylineForm = STRAIGHT;
  double Tension = 0.0;
  double Bias = 0.0;
  double Continuity = 0.0;
  bool InterpolateData = true;
  double ChordTolerance = 1e-3;

private:
  vtkSkdTreeCurveAlgorithm(const vtkSkdTreeCurveAlgorithm&) = delete;
  void operator=(const vtkSkdTreeCurveAlgorithm&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
