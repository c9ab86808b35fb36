// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCurveIntersection
 * @brief   where curves cross curves, on their native form
 *
 * Every point in which a curve of Input (port 0) meets a curve of Source (port 1), each any
 * vtkDataSet or composite, by the skD-tree (section 6.1 of Khamayseh and Hansen, Commun. Comput.
 * Phys. 2 (2007) 545-576). Without a Source the Input's curves are compared with each other, and
 * each with itself.
 *
 * The steps are the paper's: curves are cut to a chord tolerance; the safety box of each part is
 * asked for in the tree of the other curves' parts; safety cylinders around the chords tell most of
 * the rest apart; what is left is solved for on the curves themselves. "No crossing" is certain:
 * whatever is left out has been proved to be apart.
 *
 * Curves are lines, polylines (by choice as the splines through their points), quadratic and cubic
 * lines, Lagrange and rational Bezier curves, of degrees up to 10. Two-dimensional data are an
 * ordinary case.
 *
 * Answers are defined as follows:
 * - Straight pieces, as polylines are made of, are decided by exact signs: those that meet in exact
 *   arithmetic are told to, at whatever angle, in vertices or not; those of one line have a stretch
 *   in common, or an end, or nothing.
 * - Other pieces, and straight ones that do not meet exactly, meet where the distance between them
 *   is 0 to within rounding: 8 units in the last place of the largest coordinate. Straight pieces
 *   that are as near, or twice as far, all along where they pass by each other have that stretch in
 *   common. See SetClearance for curves that only come near.
 * - Each place of two curves is one point, also at the joints of a polyline or a spline, and of
 *   cells that go on as each other (see SetIgnoreJoints), which tell it of the lowest numbers.
 * - All roots are found by bisection that excludes with certainty, simple ones to within rounding.
 *   A root of higher order is one point, and so are roots between which curves stay within rounding
 *   of each other: a crossing where the curves change sides, else a touch.
 * - Of curves that nearly run along each other, apart by less than about 1e-10 of their length,
 *   what 20000 halvings of two pieces have not decided is looked at in up to 256 places along it:
 *   there, two crossings between two of these may be missed.
 * - Where two curves run along each other for a stretch, both ends of the stretch are told.
 * - Of a curve against itself, parts that follow each other are left out.
 *
 * Output port 0: vtkPolyData, a vertex for each point (in the middle of what gap there is), by
 * curve and other curve, then along them, with
 * | name                    | type   | meaning                                                    |
 * | ----------------------- | ------ | ---------------------------------------------------------- |
 * | SkdCurveId              | idtype | number of the curve among all that were read               |
 * | SkdCurveCellId          | idtype | its cell                                                   |
 * | SkdCurveBlockIndex      | int    | flat index of its block (of a composite Input)             |
 * | SkdCurveParameter       | double | 0 to 1 along the cell; of a polyline by its points         |
 * | SkdArcLength            | double | length of the curve from its start                         |
 * | SkdOtherCurveId         | idtype | the same of the other curve, which is of the Source or,    |
 * | SkdOtherCurveCellId     | idtype | without one, of the Input                                  |
 * | SkdOtherCurveBlockIndex | int    |                                                            |
 * | SkdOtherCurveParameter  | double |                                                            |
 * | SkdOtherArcLength       | double |                                                            |
 * | SkdGap                  | double | distance left between both                                 |
 * | SkdAngle                | double | between both, 0 to 90 degrees                              |
 * | SkdKind                 | int    | 0 crossing, 1 touching (along each other, or end to end in |
 * |                         |        | line), 2 end of a common stretch, 3 near                   |
 * and by choice the point and cell data of both there (see InterpolateData). SkdKind is the active
 * scalars. Field data, one value each: SkdReportCurves, SkdReportOtherCurves, SkdReportParts (into
 * which the curves of the Input are cut), SkdReportHits, SkdReportTreesBuilt (0 when it was kept),
 * SkdReportEpsilon and SkdReportRounding (world units), SkdReportBuildSeconds,
 * SkdReportQuerySeconds.
 *
 * Output port 1: vtkPolyData with a polyline for each stretch that two curves have in common, along
 * the first, to the chord tolerance; cell data SkdCurveId, SkdCurveCellId, SkdOtherCurveId and
 * SkdOtherCurveCellId.
 *
 * Output port 2: with CandidateRegions a vtkUnstructuredGrid, the paper's R(x, y, z): for each two
 * parts of curves whose safety cylinders (of radius delta + epsilon, and half the Clearance)
 * overlap a box, along the axes, around what both cylinders have in common; cell data SkdCurveId,
 * SkdCurveCellId, SkdCurveParameterRange (two components: the part), the same of the other curve,
 * and SkdNumberOfHits (int), how many places the two parts have in common, which all are in the
 * box. Parts without any share none: that is certain. Elsewhere curves do not meet.
 *
 * The tree is kept while the curves in it have the same points and cells. The answer does not
 * depend on the number of threads or processes (each asks for the whole of both inputs).
 *
 * Bad input: cells that are no curves, curves without length or with one beyond 1e-140 to 1e140,
 * coordinates that are not finite, Bezier weights that are not positive and degrees above 10 are
 * left out, with one warning of each that counts them; the rest is answered. A ChordTolerance of 0
 * gives a warning, and the default is used. Without curves there is a warning and no point.
 *
 * Cost: O(n log m) for n and m parts of curves, and some microseconds a candidate.
 *
 * @sa
 * vtkSkdTreeCurveSurfaceIntersection
 */

#ifndef vtkSkdTreeCurveIntersection_h
#define vtkSkdTreeCurveIntersection_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

class SkdCurveSet;
struct SkdCurveHitTable;
struct SkdCurveSettings;

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCurveIntersection : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeCurveIntersection, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeCurveIntersection* New();

  /**
   * How the points of a polyline are joined.
   */
  enum PolylineForms
  {
    STRAIGHT = 0,
    CARDINAL_SPLINE = 1,
    KOCHANEK_SPLINE = 2
  };

  ///@{
  /**
   * What a polyline is: straight lines between its points, or the vtkCardinalSpline or
   * vtkKochanekSpline through them, over chord lengths; closed when the last point is the first.
   * Default STRAIGHT.
   */
  vtkSetClampMacro(PolylineForm, int, STRAIGHT, KOCHANEK_SPLINE);
  vtkGetMacro(PolylineForm, int);
  ///@}

  ///@{
  /**
   * How a Kochanek spline bends at its points, each from -1 to 1, 0 by default: how tightly (1:
   * straight between points), towards the line before (1) or after (-1) the point, and with what
   * corner (the farther from 0).
   */
  vtkSkdTreeSetWithinMacro(Tension, double, -1.0, 1.0);
  vtkGetMacro(Tension, double);
  vtkSkdTreeSetWithinMacro(Bias, double, -1.0, 1.0);
  vtkGetMacro(Bias, double);
  vtkSkdTreeSetWithinMacro(Continuity, double, -1.0, 1.0);
  vtkGetMacro(Continuity, double);
  ///@}

  ///@{
  /**
   * A distance in world units. Of two curves that do not meet but come as near, the nearest
   * approach is told as a point of kind 3: one of each pair of curves, however often they come
   * near. See CandidateRegions for all places that are. Default 0: none.
   */
  vtkSkdTreeSetWithinMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * Take cells that go on as each other, the end of one being an end of the other to within
   * rounding, as one curve: they do not meet there, and what another curve meets there is told once
   * instead of once a cell. Where more than two end in a place, those go on as each other that turn
   * least, by less than a right angle; without a Source the others that only end there do not meet
   * each other, either. Ends of stretches are told of each cell. Off: each cell is a curve of its
   * own. Default on.
   */
  vtkSetMacro(IgnoreJoints, bool);
  vtkGetMacro(IgnoreJoints, bool);
  vtkBooleanMacro(IgnoreJoints, bool);
  ///@}

  ///@{
  /**
   * Add the point data of both curves, interpolated, and the data of both cells, under their own
   * names; without a Source those of the first curve. An array whose name is already in use is not
   * added, with a warning: the Input goes before the Source, points before cells. Along a polyline
   * data are linear between its points, whatever its form. Default on.
   */
  vtkSetMacro(InterpolateData, bool);
  vtkGetMacro(InterpolateData, bool);
  vtkBooleanMacro(InterpolateData, bool);
  ///@}

  ///@{
  /**
   * Fill output port 2 with the regions in which curves may meet. Default off.
   */
  vtkSetMacro(CandidateRegions, bool);
  vtkGetMacro(CandidateRegions, bool);
  vtkBooleanMacro(CandidateRegions, bool);
  ///@}

  ///@{
  /**
   * The paper's delta, relative to the diagonal of the curves' bounds: how far a part of a curve
   * may be from its chord. It changes what the search costs, never where curves meet. Default 1e-3.
   */
  vtkSkdTreeSetWithinMacro(ChordTolerance, double, 0.0, 1.0);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /**
   * Safety boxes are inflated by twice this value on each side, relative to the diagonal of the
   * curves' bounds. It affects the search only, never an answer. Default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

protected:
  vtkSkdTreeCurveIntersection();
  ~vtkSkdTreeCurveIntersection() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int PolylineForm = STRAIGHT;
  double Tension = 0.0;
  double Bias = 0.0;
  double Continuity = 0.0;
  double Clearance = 0.0;
  bool IgnoreJoints = true;
  bool InterpolateData = true;
  bool CandidateRegions = false;
  double ChordTolerance = 1e-3;
  double Epsilon = 1e-9;

private:
  vtkSkdTreeCurveIntersection(const vtkSkdTreeCurveIntersection&) = delete;
  void operator=(const vtkSkdTreeCurveIntersection&) = delete;

  SkdCurveSettings FindSettings();
  void StoreIntersections(const SkdCurveHitTable& table, vtkInformationVector* outputs);
  void WarnAboutCurves(const char* port, const SkdCurveSet& curves);

  class Internals;
  std::unique_ptr<Internals> Impl; // the trees, kept while their curves are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
