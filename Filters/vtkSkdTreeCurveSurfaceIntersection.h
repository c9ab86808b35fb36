// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCurveSurfaceIntersection
 * @brief   where curves cross surfaces, on the native form of both
 *
 * Every point in which a curve of Input (port 0) meets a surface of Source (port 1), each any
 * vtkDataSet or composite, by the skD-tree (section 6.2 of Khamayseh and Hansen, Commun. Comput.
 * Phys. 2 (2007) 545-576): curves are cut to a chord tolerance, the boxes of the parts are asked
 * for in the tree of the surfaces' boxes, and what is left is solved for on the curves and surfaces
 * themselves.
 *
 * Curves are lines, polylines (by choice as the splines through their points), quadratic and cubic
 * lines, Lagrange and rational Bezier curves. Surfaces are triangles, quads (bilinear when they are
 * not flat), pixels, polygons, strips, quadratic, Lagrange and rational Bezier triangles and
 * quadrilaterals, and the outer faces of volume cells. Degrees go up to 10.
 *
 * Answers are defined as follows:
 * - Each place is one point, however many cells meet there on an edge or a vertex; it bears the
 *   lowest of their ids. The same place of two parts of the Source (see Parts) is two. Where cells
 *   of the Input go on as each other (their ends are the same, to within rounding; of more than
 *   two, those that turn least), what is in the joint is one point, too, of the cell that was read
 *   first; its sense is along that cell. Ends of stretches are told of each cell.
 * - Straight curves and triangles (flat quads, polygons and strips, too) are decided by exact
 * signs: a closed polyline goes through a closed surface an even number of times, whatever edges
 * and vertices of it, and however far from the origin. A vertex of the curve on the surface counts
 * as moved by less than any number, the same for all that meets there.
 * - Elsewhere all roots are found by bisection that excludes with certainty, simple ones to within
 *   rounding. What misses an edge by no more than rounding may explain, meets it. A root of higher
 *   order is one point, and so are roots between which the curve stays within rounding of the
 *   surface: a crossing where it changes sides, else a touch, also where pieces are joined.
 * - Of a curve that nearly runs within a surface, apart by less than about 1e-10 of its length,
 *   what 20000 halvings of two pieces have not decided is looked at in up to 256 places along it:
 *   there, two crossings between two of these may be missed.
 * - Where a curve runs within a surface for a stretch, both ends of the stretch are told.
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
 * | SkdKind            | int    | 1          | 0 crossing, 1 touching, 2 end of a common stretch  |
 * | SkdGap | double | 1 | distance left between curve and surface | and by choice the point and
 * cell data of both sides there (see InterpolateData). SkdSense is the active scalars. Field data,
 * one value each: SkdReportCurves, SkdReportCurvePieces, SkdReportSurfaceElements, SkdReportHits,
 * SkdReportTreesBuilt (0 if the tree was reused), SkdReportEpsilon and SkdReportRounding (world
 * units), SkdReportBuildSeconds, SkdReportQuerySeconds.
 *
 * Output port 1: by choice (see CutCurves) vtkPolyData with the curves cut at these points.
 *
 * Output port 2: the Input with the cell array SkdNumberOfHits (idtype; 0 for other cells).
 *
 * The tree is reused while the Source's points, cells and ghost marks keep their values. The answer
 * does not depend on the number of threads or processes (each needs the whole Source).
 *
 * Bad input: cells that are no curves in Input or no surfaces in Source, curves without length or
 * with one beyond 1e-140 to 1e140, coordinates that are not finite, Bezier weights that are not
 * positive and degrees above 10 are left out, with one warning of each that counts them; the rest
 * is answered. A ChordTolerance of 0 gives a warning, and the default is used. Without curves or
 * surfaces there is a warning and no point.
 *
 * Cost: O(n log m) for n parts of curves and m surface cells, and some microseconds a candidate.
 *
 * @sa
 * vtkSkdTreeCurveIntersection vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeCurveSurfaceIntersection_h
#define vtkSkdTreeCurveSurfaceIntersection_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class SkdCurveSet;
class SkdSurfaceSet;
struct SkdSurfaceHitTable;

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCurveSurfaceIntersection : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeCurveSurfaceIntersection, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeCurveSurfaceIntersection* New();

  /**
   * How the points of a polyline are joined.
   */
  enum PolylineForms
  {
    STRAIGHT = 0,
    CARDINAL_SPLINE = 1,
    KOCHANEK_SPLINE = 2
  };

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
   * Which points of each curve are told.
   */
  enum HitSelections
  {
    ALL_HITS = 0,
    FIRST_HIT = 1,
    NTH_HIT = 2
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
   * Whether the faces of volume cells that no other cell of their data set has are surfaces, too,
   * with normals outward. Default on.
   */
  vtkSetMacro(VolumeFaces, bool);
  vtkGetMacro(VolumeFaces, bool);
  vtkBooleanMacro(VolumeFaces, bool);
  ///@}

  ///@{
  /**
   * What a part is: each block of a composite Source, its flat index the id, any other Source as a
   * whole with id 0 (BLOCKS, default); the cells of one value of PartArray, rounded, the id
   * (CELL_ARRAY); cells that share points, ids 0, 1, ... by their first cell (CONNECTED_PIECES).
   * Where two parts meet, each is a point of its own. Without the array in all blocks: an error,
   * and blocks.
   */
  vtkSetClampMacro(Parts, int, BLOCKS, CONNECTED_PIECES);
  vtkGetMacro(Parts, int);
  ///@}

  ///@{
  /**
   * The cell array of Parts = CELL_ARRAY: numbers, in all blocks. Default "".
   */
  void SetPartArray(const char* name);
  const char* GetPartArray() const { return this->PartArray.c_str(); }
  ///@}

  ///@{
  /**
   * Tell all points of a curve, the first, or the one whose number is HitNumber. Default ALL_HITS.
   */
  vtkSetClampMacro(HitSelection, int, ALL_HITS, NTH_HIT);
  vtkGetMacro(HitSelection, int);
  ///@}

  ///@{
  /**
   * Which point NTH_HIT tells: 1 is the first along the curve. Default 1.
   */
  vtkSetClampMacro(HitNumber, int, 1, VTK_INT_MAX);
  vtkGetMacro(HitNumber, int);
  ///@}

  ///@{
  /**
   * Add the point data of curve and surface, interpolated, and the data of both cells, under their
   * own names. An array whose name is already in use is not added, with a warning: the Input goes
   * before the Source, points before cells. Along a polyline data are linear between its points,
   * whatever its form. Default on.
   */
  vtkSetMacro(InterpolateData, bool);
  vtkGetMacro(InterpolateData, bool);
  vtkBooleanMacro(InterpolateData, bool);
  ///@}

  ///@{
  /**
   * Fill output port 1 with the curves cut at all their points, whichever are told. Curved ones
   * become polylines to the chord tolerance. Cell data: SkdCurveId, SkdCurveCellId,
   * SkdCurveBlockIndex (of a composite Input), SkdPieceNumber (0, 1, ... along each curve),
   * SkdPartsInside, how many parts of the Source hold the piece, and SkdPartId, the one of them
   * that was entered last (-1: none). A part (see Parts) holds something if it is a closed surface.
   * Default off.
   */
  vtkSetMacro(CutCurves, bool);
  vtkGetMacro(CutCurves, bool);
  vtkBooleanMacro(CutCurves, bool);
  ///@}

  ///@{
  /**
   * The paper's delta, relative to the diagonal of the curves' bounds: how far a part of a curve
   * may be from its chord when it asks the tree. It changes what the search costs, never an answer.
   * Default 1e-3.
   */
  vtkSkdTreeSetWithinMacro(ChordTolerance, double, 0.0, 1.0);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /**
   * Safety boxes are inflated by twice this value on each side, relative to the diagonal of the
   * surfaces' bounds. It affects the search only, never an answer. Default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

protected:
  vtkSkdTreeCurveSurfaceIntersection();
  ~vtkSkdTreeCurveSurfaceIntersection() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int PolylineForm = STRAIGHT;
  double Tension = 0.0;
  double Bias = 0.0;
  double Continuity = 0.0;
  bool VolumeFaces = true;
  int Parts = BLOCKS;
  std::string PartArray;
  int HitSelection = ALL_HITS;
  int HitNumber = 1;
  bool InterpolateData = true;
  bool CutCurves = false;
  double ChordTolerance = 1e-3;
  double Epsilon = 1e-9;

private:
  vtkSkdTreeCurveSurfaceIntersection(const vtkSkdTreeCurveSurfaceIntersection&) = delete;
  void operator=(const vtkSkdTreeCurveSurfaceIntersection&) = delete;

  bool UpdateSurfaces(vtkDataObject* source);
  void WarnAboutInputs(const SkdCurveSet& curves, const SkdSurfaceSet& surfaces);
  void StoreHits(const SkdSurfaceHitTable& table, bool hasCurveBlocks, bool hasSurfaceBlocks,
    vtkPolyData* output);

  class Internals;
  std::unique_ptr<Internals> Impl; // the Source's tree, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
