// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCurveSurfaceIntersection
 * @brief   intersections of curves with surfaces in their native representation
 *
 * Finds every intersection of a curve of Input (port 0) with a surface of Source (port 1), each any
 * vtkDataSet or composite, by the skD-tree (section 6.2 of Khamayseh and Hansen, Commun. Comput.
 * Phys. 2 (2007) 545-576): curves are divided until they are within a tolerance of their chords,
 * the boxes of the pieces are searched in the tree of the surfaces' boxes, and the remaining pairs
 * are solved on the curves and surfaces themselves.
 *
 * Curves are lines, polylines (optionally as splines through their points), quadratic and cubic
 * lines, Lagrange and rational Bezier curves. Surfaces are triangles, quads (bilinear when they are
 * not flat), pixels, polygons, strips, quadratic, Lagrange and rational Bezier triangles and
 * quadrilaterals, and the outer faces of volume cells. Degrees go up to 10.
 *
 * Answers are defined as follows:
 * - Each intersection is one point, however many cells share the edge or vertex; it has the lowest
 *   of their ids. Two parts of the Source (see Parts) give two points. Where cells of the Input
 *   continue each other (they share an end, to within rounding; of more than two, those with the
 *   smallest angle), an intersection at the joint is also one point, of the cell read first, with
 *   the sense along that cell. Ends of common intervals are reported for each cell.
 * - Intersections of straight curves with triangles (also planar quads, polygons and strips) use
 *   exact signs: a closed polyline passes through a closed surface an even number of times, also
 *   through edges and vertices, and however far from the origin. Vertices of the curve on the
 *   surface are treated by symbolic perturbation, consistently for all adjacent cells.
 * - Otherwise all roots are found, by bisection with certain exclusion, simple ones to within
 *   rounding. A curve that misses an edge by no more than rounding error intersects it. A root of
 *   higher order is one point, as are roots between which the curve stays within rounding of the
 *   surface: a crossing if it changes sides, else a tangency, also at joints.
 * - Limit: where a curve runs along a surface at less than about 1e-10 of its length, intervals
 *   that remain undecided after 20000 bisections of two pieces are sampled at up to 256 points; two
 *   crossings between adjacent samples may be missed there.
 * - Where a curve lies in a surface on an interval, both its ends are reported.
 *
 * Output port 0: vtkPolyData, a vertex for each point, by curve and then along it, with
 * | name               | type   | components | meaning                                            |
 * | ------------------ | ------ | ---------- | -------------------------------------------------- |
 * | SkdCurveId         | idtype | 1          | number of the curve among all that were read       |
 * | SkdCurveCellId     | idtype | 1          | its cell                                           |
 * | SkdCurveBlockIndex | int    | 1          | flat index of its block (of a composite Input)     |
 * | SkdCurveParameter  | double | 1          | 0 to 1 along the cell; of a polyline by points     |
 * | SkdArcLength       | double | 1          | length of the curve from its start                 |
 * | SkdHitNumber       | idtype | 1          | 1, 2, ... along each curve                         |
 * | SkdCellId          | idtype | 1          | the surface's cell                                 |
 * | SkdBlockIndex      | int    | 1          | flat index of its block (of a composite Source)    |
 * | SkdPartId          | int    | 1          | the part of the Source that it is of (see Parts)   |
 * | SkdPCoords         | double | 3          | parameters in that cell                            |
 * | SkdNormal          | double | 3          | the surface's unit normal                          |
 * | SkdAngle           | double | 1          | between curve and surface: 0 along it, 90 across   |
 * | SkdSense           | int    | 1          | 1: goes in, against the normal; -1: out; 0 neither |
 * | SkdKind            | int    | 1          | 0 crossing, 1 touching, 2 end of a common interval |
 * | SkdGap             | double | 1          | distance left between curve and surface            |
 * and optionally the point and cell data of both sides there (see InterpolateData). SkdSense is the
 * active scalars. Field data, one value each: SkdReportCurves, SkdReportCurvePieces,
 * SkdReportSurfaceElements, SkdReportHits, SkdReportTreesBuilt (0 if the tree was reused),
 * SkdReportEpsilon and SkdReportRounding (world units), SkdReportBuildSeconds,
 * SkdReportQuerySeconds.
 *
 * Output port 1: optional (see CutCurves), vtkPolyData with the curves cut at these points.
 *
 * Output port 2: the Input with the cell array SkdNumberOfHits (idtype; 0 for other cells).
 *
 * The tree is reused while the Source's points, cells and ghost marks keep their values. The answer
 * does not depend on the number of threads. Each of several processes gathers the whole Source, or
 * the cells near its own curves (see SetSourceDistribution) if these are straight or VTK's curved
 * cells, CutCurves is off and Parts is not CONNECTED_PIECES. It has its own cells of the Input and
 * gets those of other processes that may touch them, so that they continue each other: each
 * intersection is output by one process, and SkdCurveId, SkdCurveCellId (the id in the joined
 * pieces) and SkdHitNumber are those of all. Ties go to the lowest id there. SkdNumberOfHits is so
 * of each cell that a process has, but 0 of ghosts, and of one that differs by rounding alone from
 * the same cell of another process that counts it. An Input in AMR form, and without VTK's module
 * ParallelDIY any, is gathered, and the first process outputs all. Equal curve cells of two
 * processes count once; points of two processes at one place are one, with the data of the first.
 *
 * Bad input: cells that are not curves in Input or not surfaces in Source, curves with zero length
 * or a length outside 1e-140 to 1e140, coordinates that are not finite, Bezier weights that are not
 * positive and degrees above 10 are ignored, with one warning for each kind that counts them. A
 * ChordTolerance of 0 gives a warning and the default is used. Without curves or surfaces there is
 * a warning and no output.
 *
 * Cost: O(n log m) for n pieces of curves and m surface cells, and some microseconds a candidate.
 *
 * @sa
 * vtkSkdTreeCurveIntersection vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeCurveSurfaceIntersection_h
#define vtkSkdTreeCurveSurfaceIntersection_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeCurveAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace skdtree
{
struct SkdSurfaceHitTable;
class SkdTransport;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCurveSurfaceIntersection : public vtkSkdTreeCurveAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeCurveSurfaceIntersection, vtkSkdTreeCurveAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeCurveSurfaceIntersection* New();

  /**
   * What a part of the Source is.
   */
  enum PartsType
  {
    BLOCKS = 0,
    CELL_ARRAY = 1,
    CONNECTED_PIECES = 2
  };

  /**
   * The intersections of each curve to output.
   */
  enum HitSelections
  {
    ALL_HITS = 0,
    FIRST_HIT = 1,
    NTH_HIT = 2
  };

  //@{
  /**
   * Use the outer faces of volume cells as surfaces, with outward normals: the faces that no other
   * cell of their mesh shares. AMR data, and the pieces of a vtkPartitionedDataSet, are one mesh,
   * which has no outer faces between blocks or pieces, be these of the same level or not; every
   * other block is one by itself. Default on.
   */
  vtkSkdTreeSwitchMacro(VolumeFaces);
  //@}

  //@{
  /**
   * The parts of the Source: its blocks, with their flat index as id, or 0 if it is not composite
   * (BLOCKS, default; AMR data, and the pieces of a vtkPartitionedDataSet, are one part with the
   * flat index of the first block or piece); the cells with one value of PartArray, rounded, which
   * is the id (CELL_ARRAY); or connected components, with ids 0, 1, ... by their first cell
   * (CONNECTED_PIECES). Where two parts coincide, each has its own intersection point. If a block
   * lacks the array there is an error and BLOCKS is used.
   */
  vtkSkdTreeChoiceMacro(Parts, BLOCKS, CONNECTED_PIECES);
  //@}

  //@{
  /**
   * The cell array for CELL_ARRAY: numeric and present in all blocks. Default "".
   */
  void SetPartArray(const char* name);
  const char* GetPartArray() const { return this->PartArray.c_str(); }
  //@}

  //@{
  /**
   * Output all intersections of a curve, the first, or the one with number HitNumber. Default
   * ALL_HITS.
   */
  vtkSkdTreeChoiceMacro(HitSelection, ALL_HITS, NTH_HIT);
  //@}

  //@{
  /**
   * The intersection that NTH_HIT outputs: 1 is the first along the curve. Default 1.
   */
  vtkSkdTreeChoiceMacro(HitNumber, 1, VTK_INT_MAX);
  //@}

  //@{
  /**
   * Fill output port 1 with the curves cut at all their intersections, whatever the value of Hits.
   * Curved ones become polylines within the chord tolerance. Cell data: SkdCurveId, SkdCurveCellId,
   * SkdCurveBlockIndex (of a composite Input), SkdPieceNumber (0, 1, ... along each curve),
   * SkdPartsInside, the number of parts of the Source that contain the piece, and SkdPartId, the
   * one of them that was entered last (-1: none). Only closed parts (see Parts) contain anything.
   * Default off.
   */
  vtkSkdTreeSwitchMacro(CutCurves);
  //@}

  /**
   * Finds out whether pieces of the Input can be exchanged: it is gathered if not.
   */
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkSkdTreeCurveSurfaceIntersection();
  ~vtkSkdTreeCurveSurfaceIntersection() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool NeedsWhole(int port) override;
  bool NeedsNearbySource(skdtree::SkdSearchRange& range) override;

  bool VolumeFaces = true;
  int Parts = BLOCKS;
  std::string PartArray;
  int HitSelection = ALL_HITS;
  int HitNumber = 1;
  bool CutCurves = false;

private:
  vtkSkdTreeCurveSurfaceIntersection(const vtkSkdTreeCurveSurfaceIntersection&) = delete;
  void operator=(const vtkSkdTreeCurveSurfaceIntersection&) = delete;

  bool UpdateSurfaces(vtkDataObject* source);
  void StoreCountsOf(const skdtree::SkdSurfaceHitTable& table, vtkDataObject* input,
    skdtree::SkdTransport* transport, vtkInformationVector* outputs);
  void StoreHits(const skdtree::SkdSurfaceHitTable& table, bool hasCurveBlocks,
    bool hasSurfaceBlocks, vtkPolyData* output);

  class Internals;
  std::unique_ptr<Internals> Impl; // the Source's tree, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
