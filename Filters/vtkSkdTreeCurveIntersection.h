// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCurveIntersection
 * @brief   intersections of curves with curves in their native representation
 *
 * Finds every intersection of a curve of Input (port 0) with a curve of Source (port 1), each any
 * vtkDataSet or composite, by the skD-tree (section 6.1 of Khamayseh and Hansen, Commun. Comput.
 * Phys. 2 (2007) 545-576). Without a Source the Input's curves are compared with each other, and
 * each with itself.
 *
 * The algorithm is that of the paper: curves are divided until they are within a tolerance of their
 * chords; the safety box of each piece is searched in the tree of the other curves' pieces; safety
 * cylinders around the chords exclude most of the remaining pairs; the rest is solved on the curves
 * themselves. A result without intersections is certain: every excluded pair has been proved
 * disjoint.
 *
 * Curves are lines, polylines (optionally as splines through their points), quadratic and cubic
 * lines, Lagrange and rational Bezier curves, of degrees up to 10. Two-dimensional data need no
 * special treatment.
 *
 * Answers are defined as follows:
 * - Straight segments, as in polylines, intersect by exact signs, at any angle, in vertices or
 *   elsewhere; collinear ones have an interval, an end or nothing in common.
 * - Other pieces, and straight ones that do not intersect exactly, intersect where their distance
 *   is 0 to within rounding: 8 units in the last place of the largest coordinate. Straight segments
 *   that stay within twice this distance of each other have this interval in common. See
 *   SetClearance for curves that only come near.
 * - Each intersection of two curves is one point, also at the vertices of a polyline or spline, and
 *   where cells continue each other (see SetIgnoreJoints); it then has the lowest ids.
 * - All roots are found, by bisection with certain exclusion, simple ones to within rounding. A
 *   root of higher order is one point, as are roots between which the curves stay within rounding
 *   of each other: a crossing if the curves change sides, else a tangency.
 * - Limit: where curves run along each other at less than about 1e-10 of their length, intervals
 *   that remain undecided after 20000 bisections of two pieces are sampled at up to 256 points; two
 *   crossings between adjacent samples may be missed there.
 * - Where two curves coincide on an interval, both its ends are reported.
 * - In self-intersections, consecutive pieces of a curve are not compared.
 *
 * Output port 0: vtkPolyData, a vertex for each point (in the middle of the gap, if any), sorted by
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
 * |                         |        | line), 2 end of a common interval, 3 near                  |
 * and optionally the point and cell data of both there (see InterpolateData). SkdKind is the active
 * scalars. Field data, one value each: SkdReportCurves, SkdReportOtherCurves, SkdReportParts
 * (pieces of the Input's curves), SkdReportHits, SkdReportTreesBuilt (0 if it was reused),
 * SkdReportEpsilon and SkdReportRounding (world units), SkdReportBuildSeconds,
 * SkdReportQuerySeconds.
 *
 * Output port 1: vtkPolyData with a polyline for each interval that two curves have in common,
 * along the first, to the chord tolerance; cell data SkdCurveId, SkdCurveCellId, SkdOtherCurveId
 * and SkdOtherCurveCellId.
 *
 * Output port 2: with CandidateRegions a vtkUnstructuredGrid, the paper's R(x, y, z): for each two
 * pieces of curves whose safety cylinders (of radius delta + epsilon, plus half the Clearance)
 * overlap, an axis-aligned box around their intersection; cell data SkdCurveId, SkdCurveCellId,
 * SkdCurveParameterRange (two components: the piece), the same for the other curve, and
 * SkdNumberOfHits (int), the number of intersections of the two pieces, all of which are in the
 * box. If it is 0 the pieces certainly do not intersect. There are no intersections outside these
 * boxes.
 *
 * The tree is reused while the points and cells of its curves keep their values. The answer does
 * not depend on the number of threads. Of several processes the first has all.
 *
 * Bad input: cells that are not curves, curves with zero length or a length outside 1e-140 to
 * 1e140, coordinates that are not finite, Bezier weights that are not positive and degrees above 10
 * are ignored, with one warning for each kind that counts them. A ChordTolerance of 0 gives a
 * warning and the default is used. Without curves there is a warning and no output.
 *
 * Cost: O(n log m) for n and m pieces of curves, and some microseconds a candidate.
 *
 * @sa
 * vtkSkdTreeCurveSurfaceIntersection
 */

#ifndef vtkSkdTreeCurveIntersection_h
#define vtkSkdTreeCurveIntersection_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeCurveAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

namespace skdtree
{
struct SkdCurveHitTable;
}

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCurveIntersection : public vtkSkdTreeCurveAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeCurveIntersection, vtkSkdTreeCurveAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeCurveIntersection* New();

  //@{
  /**
   * A distance in world units. For two curves that do not intersect but come within this distance,
   * their nearest approach is output as a point of kind 3: one for each pair of curves. See
   * CandidateRegions for all regions in which they do. Default 0: none.
   */
  vtkSkdTreeWithinMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * Treat cells that share an end, to within rounding, as one continuous curve: the shared end is
   * not an intersection of the two, and the intersection with another curve there is reported once
   * instead of once a cell. If more than two cells end at a point, those with the smallest angle,
   * less than a right angle, continue each other; without a Source the others that only end there
   * do not intersect each other either. Ends of common intervals are reported for each cell. Off:
   * each cell is a curve of its own. Default on.
   */
  vtkSkdTreeSwitchMacro(IgnoreJoints);
  //@}

  //@{
  /**
   * Fill output port 2 with the regions in which curves may intersect. Default off.
   */
  vtkSkdTreeSwitchMacro(CandidateRegions);
  //@}

protected:
  vtkSkdTreeCurveIntersection();
  ~vtkSkdTreeCurveIntersection() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Clearance = 0.0;
  bool IgnoreJoints = true;
  bool CandidateRegions = false;

private:
  vtkSkdTreeCurveIntersection(const vtkSkdTreeCurveIntersection&) = delete;
  void operator=(const vtkSkdTreeCurveIntersection&) = delete;

  void StoreIntersections(const skdtree::SkdCurveHitTable& table, vtkInformationVector* outputs);

  class Internals;
  std::unique_ptr<Internals> Impl; // the trees, kept while their curves are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
