// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCellLocator
 * @brief   cell locator based on the spatial kD-tree (skD-tree) of Khamayseh and Hansen
 *
 * vtkSkdTreeCellLocator implements all of vtkAbstractCellLocator, and the queries of
 *
 *   A. Khamayseh, G. Hansen, "Use of the Spatial kD-Tree in Computational Physics Applications",
 *   Commun. Comput. Phys. 2 (2007) 545-576,
 *
 * whose section and algorithm numbers are cited below. The tree is a balanced hierarchy of
 * axis-aligned "safety boxes", split at the median of the longest axis. A safety box is a cell's
 * bounding box inflated by 2 epsilon, which makes the search conservative. An exact test on the
 * cell, in double precision, decides each answer.
 *
 * It supports any vtkDataSet with any cell type. Vertices, lines, triangles, pixels, quads,
 * tetrahedra, voxels, hexahedra, wedges, pyramids, and cells with any number of points
 * (polyvertices, polylines, strips, polygons, polyhedra) have specialized kernels. Every other cell
 * is read by vtkGenericCell; curved cells (quadratic, Lagrange, Bezier) are then searched on their
 * own parametric map.
 *
 * Answers are defined as follows:
 * - IntersectWithLine, first hit: the nearest along the line; of cells hit at the same parameter
 *   the lowest id. A line through a shared edge or vertex of a closed surface of triangles or quads
 *   is always found (the test is watertight, by exact signs). A cell seen exactly edge-on is not
 *   hit. A line of zero length has no hits.
 * - IntersectWithLine, all hits: each hit cell once, sorted by (t, cell id). A crossing of a shared
 *   edge or vertex is so reported once for each incident cell; FindCrossings merges these.
 * - FindClosestPoint and related methods: the exact nearest point; ties go to the lowest cell id.
 * - FindCell: the cell that contains the point (to within rounding: 8 units in the last place of
 *   the largest coordinate), the lowest id if there are several; otherwise, with a tolerance, the
 *   *nearest* cell within it. pcoords and weights are those of the point of the cell nearest to x.
 * - A polygon is treated as planar, with a plane through the mean of its points, and may be
 *   concave. A face of a polyhedron is the fan of triangles around the mean of its points, whatever
 *   its orientation. Both interpolate by mean value coordinates, which are exact for linear fields.
 * - FindCellsWithinBounds: exactly the cells whose bounds overlap the box, including its boundary.
 *
 * Threads: after BuildLocator() every query is thread-safe, including the short forms, and
 * allocates no memory, except that output lists grow and that LazyBuild builds nodes.
 *
 * Batches: many queries in one call, processed in parallel by vtkSMPTools. Query i is tuple i of
 * the first argument (of rays, of the first two), a numeric array, and its answer is tuple i of the
 * outputs. Answers are identical to those of single queries, including ties and rounding, for any
 * number of threads. Outputs are resized and named; any may be nullptr. Queries that are not finite
 * or find nothing have the id -1 and NaN values, or an empty list. Queries are processed along a
 * space-filling curve, so their order in the array does not affect speed. Temporary memory: 8 bytes
 * a query, and a second copy of lists. Lists are stored as in vtkCellArray: `offsets` has one tuple
 * more than there are queries, and the values of query i are those from offsets[i] to
 * offsets[i + 1] of the other arrays. Batches return the number of queries with an answer, or the
 * number of values in all lists. After an error (no queries, wrong number of components, the same
 * array passed twice) they return -1 and leave the outputs unchanged.
 *
 * Cost: build O(N log N) time; queries O(log N + k) typical for k results. Memory: about 36 bytes a
 * cell for the tree, a copy of the connectivity (4 bytes a cell point) and, unless they are doubles
 * in a vtkPointSet, which are shared, of the points (24 bytes each): 48 bytes a cell of triangles,
 * 52 of tetrahedra, and up to twice that during the build. Unless LazyBuild is on, leaf filters add
 * 24 bytes a triangle, 32 a tetrahedron, 48 a hexahedron. If all cells are triangles, a copy of
 * their corners is kept for lines: 15 bytes a triangle if points are in single precision, else 30.
 * GetMemorySize() and GetBytesPerCell() give the totals.
 *
 * Inherited settings: it uses NumberOfCellsPerNode (clamped to 1..8, default 8), CacheCellBounds
 * (default off: bounds are taken from the points when asked) and UseExistingSearchStructure. It
 * does not use Automatic, MaxLevel, RetainCellLists and Tolerance (each query has its own
 * tolerance; Epsilon determines the size of the safety boxes).
 *
 * Bad input: without a data set or cells, queries find nothing and report no error. Broken cells
 * are ignored, with one warning that counts them and describes the first. A cell is broken if it
 * uses a point id out of range, if its offsets decrease or exceed the connectivity array, if it has
 * fewer points than its type needs (a line of 1, a polygon or strip of 2, a quad of 3, a quadratic
 * tetrahedron of 9) or more than its type has, or if it is a polyhedron whose faces are not
 * polygons of its points. All filters do the same: they read and pass on broken cells as empty
 * cells; other cells keep their ids. The check is part of the build and takes at most 2 % of it.
 * Cells with points that are NaN, infinite or beyond 1e50 are not in the tree, nor are cells of a
 * mesh whose largest absolute coordinate is not 0 but less than 1e-50, because products of these
 * coordinates overflow or underflow. One warning counts them. Empty cells are ignored without a
 * warning; those of types that VTK has no class for are broken cells. Query points that are NaN or
 * beyond 1e152, and a NaN or negative radius, find nothing; a negative tolerance counts as zero.
 *
 * @sa
 * vtkAbstractCellLocator vtkStaticCellLocator vtkSkdTreeClosestPoint
 */

#ifndef vtkSkdTreeCellLocator_h
#define vtkSkdTreeCellLocator_h

#include "vtkAbstractCellLocator.h"
#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeVersion.h"       // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

namespace skdtree
{
class SkdCellTree;
class SkdLocatorState;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataArray;
class vtkDoubleArray;
class vtkIdTypeArray;
class vtkMatrix4x4;
class vtkUnsignedCharArray;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCellLocator : public vtkAbstractCellLocator
{
public:
  vtkTypeMacro(vtkSkdTreeCellLocator, vtkAbstractCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeCellLocator* New();

  // --- Settings ----------------------------------------------------------------------------------

  //@{
  /**
   * Safety boxes are inflated by twice this value on each side (section 3.1), relative to the
   * diagonal of the data set's bounding box, and by at least 8 units in the last place of the
   * largest coordinate. It affects the search only, never an answer. Range [0, 1], default 1e-9.
   */
  vtkSkdTreeWithinMacro(Epsilon, double, 0.0, 1.0);
  //@}

  /**
   * The epsilon of the built tree in world units, 0 before the tree is built.
   */
  double GetAbsoluteEpsilon();

  //@{
  /**
   * Build-on-query (Algorithm 3.2): BuildLocator at most sorts cells coarsely, and a node is split
   * when the first query visits it. Answers are the same, and queries remain thread-safe. Default
   * off.
   */
  vtkSkdTreeSwitchMacro(LazyBuild);
  //@}

  /**
   * See SetSplitRule.
   */
  enum SplitRules
  {
    SPLIT_AUTOMATICALLY = 0,
    SPLIT_AT_MEDIAN = 1,
    SPLIT_BY_SURFACE_AREA = 2
  };

  //@{
  /**
   * How the cells of a node are divided. Median: half of them on either side along the longest axis
   * (Algorithm 3.1). Surface area heuristic: the split with the least sum of box areas times
   * numbers of cells; the build takes about 1.5 times as long, and on cells that overlap and differ
   * much in size FindCell takes 0.7 to 0.8 of the time. Automatic: surface area if a point of the
   * bounds is in 0.25 or more boxes of cells on average, and the mean squared area of the boxes is
   * at least 1.2 times the square of the mean area (Delaunay tetrahedra, graded meshes); else
   * median. Answers are the same. LazyBuild always uses the median. Default SPLIT_AUTOMATICALLY.
   */
  vtkSkdTreeChoiceMacro(SplitRule, SPLIT_AUTOMATICALLY, SPLIT_BY_SURFACE_AREA);
  void SetSplitRuleToAutomatic() { this->SetSplitRule(SPLIT_AUTOMATICALLY); }
  void SetSplitRuleToMedian() { this->SetSplitRule(SPLIT_AT_MEDIAN); }
  void SetSplitRuleToSurfaceArea() { this->SetSplitRule(SPLIT_BY_SURFACE_AREA); }
  //@}

  /**
   * The rule used for the built tree, SPLIT_AT_MEDIAN or SPLIT_BY_SURFACE_AREA, or
   * SPLIT_AUTOMATICALLY before it is built.
   */
  int GetSplitRuleInUse();

  //@{
  /**
   * Ignore cells that vtkGhostType marks as duplicate or refined. Blanked cells (hidden cells, and
   * cells of structured grids with a hidden point) are always ignored. Default on.
   */
  vtkSkdTreeSwitchMacro(SkipGhostCells);
  //@}

  //@{
  /**
   * A rigid motion of the data set (section 2): queries are answered as if the data set had been
   * transformed by this matrix, without a rebuild. Returned cells are transformed too. Default
   * nullptr: no motion. The matrix must be rigid (orthonormal to 1e-9, no perspective); any other
   * is ignored with an error and the previous one is kept. The values are copied.
   */
  void SetTransform(vtkMatrix4x4* motion);
  vtkMatrix4x4* GetTransform();
  //@}

  // --- Lines -------------------------------------------------------------------------------------

  // Short forms of VTK that are not overridden here.
  using vtkAbstractCellLocator::FindClosestPoint;
  using vtkAbstractCellLocator::FindClosestPointWithinRadius;

  //@{
  /**
   * First hit of the segment p1 p2, see vtkAbstractCellLocator. `t` in [0, 1] from p1 to p2; `tol`
   * is an absolute distance: cells of dimension 0 to 2 within it of the line count as hit. Returns
   * 1 or 0; cellId is -1 if there is no hit. `cell` may be nullptr.
   */
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId) override;
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId) override;
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell) override;
  //@}

  //@{
  /**
   * All hits of the segment p1 p2, each cell once, sorted by (t, cell id). Lists may be nullptr. In
   * the six-argument form, `cell` = nullptr returns the cells whose bounds, inflated by tol, the
   * segment intersects, and the points where it enters these bounds. Returns 1 if there is a hit,
   * else 0.
   */
  int IntersectWithLine(
    const double p1[3], const double p2[3], vtkPoints* points, vtkIdList* cellIds) override;
  int IntersectWithLine(const double p1[3], const double p2[3], const double tol, vtkPoints* points,
    vtkIdList* cellIds) VTK_SKD_OVERRIDE_SINCE_92;
  int IntersectWithLine(const double p1[3], const double p2[3], const double tol, vtkPoints* points,
    vtkIdList* cellIds, vtkGenericCell* cell) VTK_SKD_OVERRIDE_SINCE_92;
  //@}

  /**
   * All crossings of the segment p1 p2 with a surface: hits on a shared edge or vertex count as one
   * crossing with several incident cells. For crossing i: tuple i of `parameters` (t in [0, 1]),
   * point i of `points`, cell i of `incidentCells` (ids of the cells hit there, ascending) and
   * tuple i of `kinds`: 1 if the line passes to the other side, 0 if it only touches. For a closed
   * surface of triangles and quads, whatever their orientation, the number of crossings of kind 1
   * is odd exactly if one end is inside and the other outside. Any output may be nullptr. Returns
   * the number of crossings.
   */
  vtkIdType FindCrossings(const double p1[3], const double p2[3], vtkDoubleArray* parameters,
    vtkPoints* points, vtkCellArray* incidentCells, vtkIdTypeArray* kinds);

  /**
   * The number of times that the segment p1 p2 passes through a surface (crossings of kind 1 of
   * FindCrossings), without collecting them: parity for an in/out test (section 6.3).
   */
  vtkIdType CountCrossings(const double p1[3], const double p2[3]);

  /**
   * All facets that the segment p1 p2 passes through, by ascending (parameter, cell id), each facet
   * separately if several share the point: the parameter, the cell, and in `ways` 1 if it leaves
   * through the front (along the normal), -1 if it enters. Non-linear cells have the value 0. The
   * sum over a closed, consistently oriented surface is exactly the winding number around p1 minus
   * that around p2. Any output may be nullptr. Returns the number of facets.
   */
  vtkIdType FindPasses(const double p1[3], const double p2[3], vtkDoubleArray* parameters,
    vtkIdTypeArray* cellIds, vtkIdTypeArray* ways);

  /**
   * The number of facets of FindPasses, and the sum of their `ways`, with the sign reversed for
   * cells whose tuple in `reversed` (may be nullptr) is not 0.
   */
  vtkIdType CountPasses(
    const double p1[3], const double p2[3], vtkUnsignedCharArray* reversed, vtkIdType& sum);

  // --- Nearest points and cells ------------------------------------------------------------------

  //@{
  /**
   * Nearest point, see vtkAbstractCellLocator. cellId is -1 if there is no cell. `cell`, unless
   * nullptr, is set to the nearest cell.
   */
  void FindClosestPoint(const double x[3], double closestPoint[3], vtkIdType& cellId, int& subId,
    double& dist2) override;
  void FindClosestPoint(const double x[3], double closestPoint[3], vtkGenericCell* cell,
    vtkIdType& cellId, int& subId, double& dist2) override;
  //@}

  //@{
  /**
   * Nearest point at a distance of at most `radius` (infinity allowed). Returns 1 or 0. `inside` is
   * 1 if x lies in the cell or projects into it, as in vtkCell::EvaluatePosition. `cell` may be
   * nullptr.
   */
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkIdType& cellId, int& subId, double& dist2) override;
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2) override;
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2, int& inside) override;
  //@}

  /**
   * The k nearest cells by exact distance, nearest first, ties by id. `distances` (one component,
   * world units) may be nullptr. Returns the number found: min(k, number of cells).
   */
  vtkIdType FindClosestCells(
    const double x[3], int k, vtkIdList* cellIds, vtkDoubleArray* distances);

  /**
   * All cells at a distance of at most `radius`: those that overlap the sphere (4.2, exact),
   * ascending by id. `distances` may be nullptr. Returns their number.
   */
  vtkIdType FindCellsWithinRadius(
    const double x[3], double radius, vtkIdList* cellIds, vtkDoubleArray* distances);

  // --- Cells that contain points -----------------------------------------------------------------

  //@{
  /**
   * The cell that contains x or, with a tolerance (tol2, squared distance), the nearest cell within
   * it; -1 if there is none. `cell` and `weights` may be nullptr.
   */
  vtkIdType FindCell(double x[3]) VTK_SKD_OVERRIDE_UNTIL_97;
  vtkIdType FindCell(double x[3], double tol2);
  vtkIdType FindCell(double x[3], double tol2, vtkGenericCell* cell, double pcoords[3],
    double* weights) VTK_SKD_OVERRIDE_UNTIL_97;
  vtkIdType FindCell(double x[3], double tol2, vtkGenericCell* cell, int& subId, double pcoords[3],
    double* weights) VTK_SKD_OVERRIDE_SINCE_92;
  //@}

  /**
   * The same, trying the cell `hint` first (for example the last answer; -1 for none), which is
   * faster for coherent sequences of points. In overlapping meshes the hinted cell is preferred to
   * a lower id.
   */
  vtkIdType FindCellWithHint(double x[3], double tol2, vtkIdType hint, vtkGenericCell* cell,
    int& subId, double pcoords[3], double* weights);
#if VTK_SKD_LOCATOR_97
  vtkIdType FindCell(double x[3], vtkCell* cell, vtkGenericCell* genericCell, vtkIdType cellId,
    double tol2, int& subId, double pcoords[3], double* weights) override;
#endif

  //@{
  /**
   * An exact vtkCell::EvaluatePosition: the point of the cell nearest to x, its sub-id, parametric
   * coordinates, squared distance and, unless nullptr, interpolation weights. EvaluateCell returns
   * false, and sets nothing, if the cell is not in the tree or x is not finite. FindClosestLocation
   * finds the nearest cell within the radius, too, and evaluates it only once: it returns the
   * cell's id or, if there is none, -1 and sets nothing.
   */
  vtkIdType FindClosestLocation(const double x[3], double radius, double closestPoint[3],
    int& subId, double pcoords[3], double& dist2, double* weights);
  bool EvaluateCell(vtkIdType cellId, const double x[3], double closestPoint[3], int& subId,
    double pcoords[3], double& dist2, double* weights);
  //@}

  // --- Cells along lines and planes, and within boxes --------------------------------------------

  /**
   * The parameters (ascending, t in [0, 1] along p1 p2, including 0 and 1) at which the segment may
   * enter or leave a cell; between two of them it stays in the same cells. These are the crossings
   * of faces of volume cells, and of edges of surface cells and ends of curves within `tolerance`.
   * For curved cells they are accurate to rounding, but intervals shorter than 1/32 of the cell's
   * bounds may be missed. To get the cell of an interval, call FindCell with its middle. Returns
   * their number, 0 if the segment has zero length or is not finite.
   */
  vtkIdType FindCellBorders(
    const double p1[3], const double p2[3], double tolerance, vtkDoubleArray* parameters);

  /**
   * The cells whose bounds overlap the box (xmin, xmax, ymin, ymax, zmin, zmax), including its
   * boundary, in the order of the tree, which is reproducible.
   */
  void FindCellsWithinBounds(double* bbox, vtkIdList* cells) override;

  /**
   * The cells whose bounds, inflated by `tolerance`, the segment p1 p2 intersects, sorted by (t,
   * id).
   */
  void FindCellsAlongLine(const double p1[3], const double p2[3], double tolerance,
    vtkIdList* cells) VTK_SKD_OVERRIDE_UNTIL_97;

  /**
   * The cells whose bounds are within the distance `tolerance` of the plane (origin o, normal n of
   * any length), in the order of the tree.
   */
  void FindCellsAlongPlane(const double o[3], const double n[3], double tolerance, vtkIdList* cells)
    VTK_SKD_OVERRIDE_SINCE_92;

  //@{
  /**
   * Whether x lies within the bounds of a cell inflated by tol. False if the id is out of range.
   */
#if VTK_SKD_LOCATOR_97
  bool InsideCellBounds(double x[3], vtkIdType cellId, double tol = 0.0) override;
#else
  bool InsideCellBounds(double x[3], vtkIdType cellId) override;
#endif
  //@}

  // --- The paper's queries, whose answers are candidates -----------------------------------------

  //@{
  /**
   * Queries without exact tests, as in the paper: the ids of the candidate cells, whose *safety
   * boxes* satisfy the query, in the order of the tree. FindClosestCandidates is Algorithm 5.1 (at
   * least one of the candidates contains the nearest point), optionally with a reference point: one
   * on or near a cell accelerates the search, any other one does no harm. The others are Algorithms
   * 5.2 (segment), 5.3 (box), the sphere of 4.2 and a plane.
   */
  void FindClosestCandidates(const double x[3], vtkIdList* cellIds);
  void FindClosestCandidates(const double x[3], const double reference[3], vtkIdList* cellIds);
  void FindCandidatesAlongLine(const double p1[3], const double p2[3], vtkIdList* cellIds);
  void FindCandidatesWithinBounds(const double bounds[6], vtkIdList* cellIds);
  void FindCandidatesWithinRadius(const double x[3], double radius, vtkIdList* cellIds);
  void FindCandidatesAlongPlane(const double o[3], const double n[3], vtkIdList* cellIds);
  //@}

  /**
   * Algorithm 5.4: all pairs (a cell of this tree, a cell of the other) whose safety boxes overlap,
   * sorted by (this id, other id). Transforms of both locators are taken into account. Pass the
   * locator itself to find the pairs within one set, including (i, i). Returns the number of pairs.
   */
  vtkIdType FindOverlappingPairs(
    vtkSkdTreeCellLocator* other, vtkIdList* cellIds, vtkIdList* otherCellIds);

  // --- Batches -----------------------------------------------------------------------------------

  /**
   * Batch (see "Batches" in the description of the class): the nearest cell to each of `points` (3
   * components) at a distance of at most `radius`, the nearest point (3 components) and its
   * distance.
   */
  vtkIdType FindClosestPoints(vtkDataArray* points, vtkIdTypeArray* cellIds,
    vtkDoubleArray* closestPoints, vtkDoubleArray* distances, double radius = VTK_DOUBLE_MAX);

  /**
   * Batch of FindClosestCells: the n nearest cells to each of `points` (3 components) at a distance
   * of at most `radius`, nearest first, ties by id, and their distances. Outputs have n components;
   * those that are not used are -1 and NaN. It is an error if n is less than 1.
   */
  vtkIdType FindClosestNCells(vtkDataArray* points, int n, vtkIdTypeArray* cellIds,
    vtkDoubleArray* distances, double radius = VTK_DOUBLE_MAX);

  //@{
  /**
   * Batches of FindCell: the cell that contains each of `points` (3 components) or, with a
   * tolerance (tol2, squared distance), the nearest cell within it, and the parametric coordinates
   * (3 components). FindCellsAndWeights has the ids of the cell's points and the interpolation
   * weights, too: both have as many components as the largest cell of the data set has points; for
   * a smaller cell the remaining ones are -1 and 0.
   */
  vtkIdType FindCells(
    vtkDataArray* points, vtkIdTypeArray* cellIds, vtkDoubleArray* pcoords, double tol2 = 0.0);
  vtkIdType FindCellsAndWeights(vtkDataArray* points, vtkIdTypeArray* cellIds,
    vtkDoubleArray* pcoords, vtkIdTypeArray* pointIds, vtkDoubleArray* weights, double tol2 = 0.0);
  //@}

  //@{
  /**
   * Batches of first hits: the first cell hit, the parameter t in [0, 1] and the point (3
   * components) for each of `lines` (6 components: x, y, z of both ends), or of the segments
   * between `starts` and `ends` (3 components each), or of the rays from `origins` along
   * `directions` (3 components each; of any length but 0). For rays there are distances from the
   * origins in world units instead of parameters, and only hits at a distance of at most `maximum`
   * count: a negative or NaN maximum and a direction of length 0 have none. `tol` is that of
   * IntersectWithLine.
   */
  vtkIdType IntersectWithLines(vtkDataArray* lines, vtkIdTypeArray* cellIds,
    vtkDoubleArray* parameters, vtkDoubleArray* points, double tol = 0.0);
  vtkIdType IntersectWithSegments(vtkDataArray* starts, vtkDataArray* ends, vtkIdTypeArray* cellIds,
    vtkDoubleArray* parameters, vtkDoubleArray* points, double tol = 0.0);
  vtkIdType IntersectWithRays(vtkDataArray* origins, vtkDataArray* directions,
    vtkIdTypeArray* cellIds, vtkDoubleArray* distances, vtkDoubleArray* points,
    double maximum = VTK_DOUBLE_MAX, double tol = 0.0);
  //@}

  //@{
  /**
   * Batches of all hits, of what the batches of first hits take: a list of the cells hit, each
   * once, sorted by (t, cell id), with the parameters, or distances, and the points. `tol` is that
   * of IntersectWithLine.
   */
  vtkIdType FindAllHits(vtkDataArray* lines, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds,
    vtkDoubleArray* parameters, vtkDoubleArray* points, double tol = 0.0);
  vtkIdType FindAllSegmentHits(vtkDataArray* starts, vtkDataArray* ends, vtkIdTypeArray* offsets,
    vtkIdTypeArray* cellIds, vtkDoubleArray* parameters, vtkDoubleArray* points, double tol = 0.0);
  vtkIdType FindAllRayHits(vtkDataArray* origins, vtkDataArray* directions, vtkIdTypeArray* offsets,
    vtkIdTypeArray* cellIds, vtkDoubleArray* distances, vtkDoubleArray* points,
    double maximum = VTK_DOUBLE_MAX, double tol = 0.0);
  //@}

  /**
   * Batch of FindCellsWithinBounds: for each of `boxes` (6 components: xmin, xmax, ymin, ymax,
   * zmin, zmax) a list of the cells whose bounds overlap it, in the order of the tree.
   */
  vtkIdType FindCellsWithinBoxes(
    vtkDataArray* boxes, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds);

  /**
   * Batch of FindCellsWithinRadius: for each of `spheres` (4 components: x, y, z, radius) a list of
   * the cells at a distance of at most the radius from the center, sorted by id, and these
   * distances.
   */
  vtkIdType FindCellsWithinSpheres(vtkDataArray* spheres, vtkIdTypeArray* offsets,
    vtkIdTypeArray* cellIds, vtkDoubleArray* distances);

  /**
   * Batch of pairs: for each cell of this locator's data set, a list of the cells of the other's
   * whose bounds overlap its own, sorted by id; both with the locators' transforms. Within one
   * locator, (i, i) is included.
   */
  vtkIdType FindPairs(
    vtkSkdTreeCellLocator* other, vtkIdTypeArray* offsets, vtkIdTypeArray* otherCellIds);

  // --- The tree: what it holds, and its life -----------------------------------------------------

  //@{
  /**
   * The paper's own arrays (Algorithm 3.1), 2N-1 tuples each: S, the safety box of node i as (xmin,
   * xmax, ymin, ymax, zmin, zmax), and L, its link. Node 0 is the root (the paper counts from 1): L
   * > 0 is the first of two adjacent children, L <= 0 the negated id of the leaf's cell. (The root
   * is never a child, so 0 always means cell 0.) Computed on each call: O(N log N).
   */
  void GetSafetyBoxes(vtkDoubleArray* S);
  void GetLinks(vtkIdTypeArray* L);
  //@}

  //@{
  /**
   * Statistics of the built tree: cells in it; cells ignored (ghost, blanked, empty, not finite or
   * of unknown type); nodes of the eight-wide tree; its depth; its size in bytes, in total and for
   * each cell; seconds of the last build. 0 before it is built.
   */
  vtkIdType GetNumberOfCellsInTree();
  vtkIdType GetNumberOfCellsLeftOut();
  vtkIdType GetNumberOfNodes();
  int GetDepth();
  vtkIdType GetMemorySize();
  double GetBytesPerCell();
  double GetBuildSeconds();
  //@}

  //@{
  /**
   * See vtkLocator. BuildLocator builds if there is no tree, or if the data set or this object's
   * settings changed after the last build. With UseExistingSearchStructure on, it builds only if
   * there is no tree, or if the points or cells are others than those of the tree, or were modified
   * in place: changes of data arrays and settings, and data sets with equal points and cells, are
   * served by the existing tree. ForceBuildLocator always builds; with UseExistingSearchStructure
   * on, queries after it use the tree unchecked until the next BuildLocator. Queries notice what
   * BuildLocator does, but for arrays of cells whose data set was not Modified(). To notice
   * changes, the locator holds references to the arrays of points and cells.
   */
  void BuildLocator() override;
  void ForceBuildLocator() VTK_SKD_OVERRIDE_SINCE_92;
  void FreeSearchStructure() override;
  //@}

  /**
   * The safety boxes of a level of the paper's binary tree as quads: level 0 the root's, -1 or a
   * level below the deepest the leaves'. Cell array "Level" and, for leaves, "CellId" (-1 inside).
   */
  void GenerateRepresentation(int level, vtkPolyData* pd) override;

  /**
   * Share the tree and copy the settings of another vtkSkdTreeCellLocator. The data set is
   * copied only if this locator has none. A tree that is outdated, or whose points or cells are not
   * those of this locator's own data set, is not shared; a new one is built when needed, because
   * answers refer to this locator's data set, as in VTK's own locators. O(n) if the arrays of the
   * two data sets are not the same and must be compared.
   */
  void ShallowCopy(vtkAbstractCellLocator* locator) VTK_SKD_OVERRIDE_SINCE_92;

protected:
  vtkSkdTreeCellLocator();
  ~vtkSkdTreeCellLocator() override;

  void BuildLocatorInternal() VTK_SKD_OVERRIDE_SINCE_92;

  double Epsilon = 1e-9;
  bool LazyBuild = false;
  int SplitRule = SPLIT_AUTOMATICALLY;
  bool SkipGhostCells = true;

private:
  vtkSkdTreeCellLocator(const vtkSkdTreeCellLocator&) = delete;
  void operator=(const vtkSkdTreeCellLocator&) = delete;

  bool HasValidTree();
  bool IsUpToDate();
  bool IsNewerThanData();
  bool HasTreeOf(vtkDataSet* data);
  void CacheBounds();
  const skdtree::SkdCellTree& GetTree();

  std::unique_ptr<skdtree::SkdLocatorState> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
