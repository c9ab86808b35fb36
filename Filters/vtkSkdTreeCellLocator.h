// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCellLocator
 * @brief   find cells by the spatial kD-tree (skD-tree) of Khamayseh and Hansen
 *
 * vtkSkdTreeCellLocator answers the whole contract of vtkAbstractCellLocator, and the queries of
 *
 *   A. Khamayseh, G. Hansen, "Use of the Spatial kD-Tree in Computational Physics Applications",
 *   Commun. Comput. Phys. 2 (2007) 545-576,
 *
 * whose section and algorithm numbers are cited below. The tree is a balanced hierarchy of
 * axis-aligned "safety boxes", split at the median of the longest axis. A safety box is a cell's
 * bounding box inflated by 2 epsilon: it makes the search conservative. What is returned is always
 * decided by an exact test on the cell, in double precision.
 *
 * It takes any vtkDataSet with any cell type. Vertices, lines, triangles, pixels, quads,
 * tetrahedra, voxels, hexahedra, wedges, pyramids, and cells of any number of points (polyvertices,
 * polylines, strips, polygons, polyhedra) have kernels of their own that read raw points. Every
 * other cell is read by vtkGenericCell; curved ones (quadratic, Lagrange, Bezier) are then searched
 * on their own parametric map.
 *
 * How its answers are defined:
 * - IntersectWithLine, first hit: the nearest along the line; of cells hit at the same parameter
 *   the lowest id. A line through a shared edge or vertex of a closed surface of triangles or quads
 *   is never lost (the test is watertight, exact signs decide). A cell seen exactly edge-on is not
 *   hit. A line of zero length hits nothing.
 * - IntersectWithLine, all hits: each hit cell once, by (t, cell id). A crossing of a shared edge
 * or vertex is so reported once for each incident cell; FindCrossings merges these.
 * - FindClosestPoint and its kin: the true nearest point, ties to the lowest cell id.
 * - FindCell: the cell that contains the point (to within rounding: 8 units in the last place of
 *   the largest coordinate), of several the lowest id; with a tolerance else the *nearest* cell
 *   within it. pcoords and weights are those of the point of the cell nearest to x.
 * - A polygon is flat, or taken for flat: its plane goes through the mean of its points. It may be
 *   concave. A face of a polyhedron is the fan of triangles around the mean of its points, however
 *   it is oriented. Both interpolate by mean value coordinates, which are exact for linear fields.
 * - FindCellsWithinBounds: exactly the cells whose bounds overlap the box, bounds included.
 *
 * Threads: after BuildLocator() every query is thread-safe, the short forms included, and
 * allocates nothing (lists handed in grow as VTK's lists do), but where LazyBuild must build.
 *
 * Cost: build O(N log N) time; queries O(log N + k) typical for k results. Memory: about 36 bytes a
 * cell for the tree, a copy of the connectivity (4 bytes a cell point) and, unless they are doubles
 * in a vtkPointSet, which are shared, of the points (24 bytes each): 48 bytes a cell of triangles,
 * 52 of tetrahedra, and up to twice that while it is built. What spares exact tests comes on top,
 * unless LazyBuild: 24 bytes a triangle, 32 a tetrahedron, 48 a hexahedron. If all cells are
 * triangles, a copy of their corners is kept for lines: 15 bytes a triangle where points are in
 * single precision, else 30. GetMemorySize() and GetBytesPerCell() count it all.
 *
 * Inherited settings: it utilizes NumberOfCellsPerNode (clamped to 1..8, default 8),
 * CacheCellBounds (default off: bounds are taken from the points when asked) and
 * UseExistingSearchStructure. It does not utilize Automatic, MaxLevel, RetainCellLists and
 * Tolerance (each query has a tolerance of its own; Epsilon sizes the safety boxes).
 *
 * Bad input: no data set or no cells: every query finds nothing, with no error. Broken cells are
 * left out, with one warning that counts them and names the first and what is wrong with it. A cell
 * is broken if it names a point that there is not, if its offsets decrease or end beyond the list
 * of points, if it has too few points for its type (a line of 1, a polygon or strip of 2, a quad of
 * 3, a quadratic tetrahedron of 9) or more than its type has, or if it is a polyhedron whose faces
 * are not polygons of its points. The same holds for all filters: an input with broken cells is
 * read, and passed on, as if these were empty; other cells keep their ids. All are looked at when
 * the tree is built: at most 2 % of the build. Cells with points that are NaN, infinite or beyond
 * 1e50 are left out of the tree, as are all cells of a mesh whose largest coordinate, without its
 * sign, is not 0 but less than 1e-50: products of these are no numbers. One warning counts them.
 * Empty cells and cells of unknown type are left out, without one. NaN or infinite query points
 * find nothing; a NaN or negative radius finds nothing; a negative tolerance counts as zero.
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

class SkdCellTree;
class SkdLocatorState;

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

  ///@{
  /**
   * The half width that safety boxes are inflated by, twice (section 3.1), relative to the diagonal
   * of the data set's bounding box. The width in use is never below 8 units in the last place of
   * the largest coordinate. It widens the search only, never an answer. Range [0, 1], default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

  /**
   * Epsilon as used by the built tree, in world units. 0 before the tree is built.
   */
  double GetAbsoluteEpsilon();

  ///@{
  /**
   * Build-on-query (Algorithm 3.2): BuildLocator sorts cells coarsely at most, and a node is split
   * when the first query reaches it. Answers are the same; safe when many threads query at once.
   * Default off.
   */
  vtkSetMacro(LazyBuild, bool);
  vtkGetMacro(LazyBuild, bool);
  vtkBooleanMacro(LazyBuild, bool);
  ///@}

  /**
   * See SetSplitRule.
   */
  enum SplitRules
  {
    SPLIT_AUTOMATICALLY = 0,
    SPLIT_AT_MEDIAN = 1,
    SPLIT_BY_SURFACE_AREA = 2
  };

  ///@{
  /**
   * Where the cells of a node are divided. At the median: half of them on either side of the
   * longest axis (Algorithm 3.1). By surface area: where the boxes of both sides, times the number
   * of cells in them, are least; the build takes about half as long again, and on cells that
   * overlap and differ much in size FindCell takes 0.7 to 0.8 of the time. Automatically: by
   * surface area where that pays: where a place is in the boxes of 0.25 cells or more, on the
   * average, and the mean of the squared areas of the boxes is at least 1.2 times the square of the
   * mean (tetrahedra of Delaunay's, graded meshes); else at the median. Answers are the same. With
   * LazyBuild it is the median always. Default SPLIT_AUTOMATICALLY.
   */
  vtkSetClampMacro(SplitRule, int, SPLIT_AUTOMATICALLY, SPLIT_BY_SURFACE_AREA);
  vtkGetMacro(SplitRule, int);
  void SetSplitRuleToAutomatic() { this->SetSplitRule(SPLIT_AUTOMATICALLY); }
  void SetSplitRuleToMedian() { this->SetSplitRule(SPLIT_AT_MEDIAN); }
  void SetSplitRuleToSurfaceArea() { this->SetSplitRule(SPLIT_BY_SURFACE_AREA); }
  ///@}

  /**
   * The rule that divided the built tree, SPLIT_AT_MEDIAN or SPLIT_BY_SURFACE_AREA.
   * SPLIT_AUTOMATICALLY before it is built.
   */
  int GetSplitRuleInUse();

  ///@{
  /**
   * Leave out cells that vtkGhostType marks as duplicate or refined. Blanked cells (hidden, or of
   * structured grids with a hidden point) are left out whatever this says. Default on.
   */
  vtkSetMacro(SkipGhostCells, bool);
  vtkGetMacro(SkipGhostCells, bool);
  vtkBooleanMacro(SkipGhostCells, bool);
  ///@}

  ///@{
  /**
   * A rigid motion of the whole set (section 2): every query is answered as if the data set had
   * been moved by this matrix, without a rebuild. Cells handed out are moved too. nullptr (default)
   * leaves the set where it is. The matrix must keep distances (orthonormal to 1e-9, no
   * perspective): any other is refused with an error and the former stays. The values are copied.
   */
  void SetTransform(vtkMatrix4x4* motion);
  vtkMatrix4x4* GetTransform();
  ///@}

  // Short forms that are not overridden here.
  using vtkAbstractCellLocator::FindClosestPoint;
  using vtkAbstractCellLocator::FindClosestPointWithinRadius;

  ///@{
  /**
   * First hit of the segment p1 p2, see vtkAbstractCellLocator. `t` in [0, 1] from p1 to p2; `tol`
   * is an absolute distance by which a line may miss a cell of dimension 0 to 2. Returns 1 or 0;
   * cellId is -1 when nothing is hit. `cell` may be nullptr.
   */
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId) override;
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId) override;
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell) override;
  ///@}

  ///@{
  /**
   * All hits of the segment p1 p2, each cell once, sorted by (t, cell id). Lists may be nullptr.
   * With the six-argument form `cell` = nullptr asks for hits of the cells' bounds instead: the
   * cells whose bounds (grown by tol) the segment meets, and the points where it enters them.
   * Returns 1 if there is a hit, else 0.
   */
  int IntersectWithLine(
    const double p1[3], const double p2[3], vtkPoints* points, vtkIdList* cellIds) override;
  int IntersectWithLine(const double p1[3], const double p2[3], const double tol, vtkPoints* points,
    vtkIdList* cellIds) VTK_SKD_OVERRIDE_SINCE_92;
  int IntersectWithLine(const double p1[3], const double p2[3], const double tol, vtkPoints* points,
    vtkIdList* cellIds, vtkGenericCell* cell) VTK_SKD_OVERRIDE_SINCE_92;
  ///@}

  /**
   * All crossings of the segment p1 p2 with a surface: hits on a shared edge or vertex count as one
   * crossing, and all its incident cells are known. For crossing i: tuple i of `parameters` (t in
   * [0, 1]), point i of `points`, cell i of `incidentCells` (ids of the cells hit there, ascending)
   * and tuple i of `kinds`: 1 where the line passes through to the other side, 0 where it only
   * touches. Of a closed surface of triangles and quads, however it is oriented, the number of
   * crossings of kind 1 is odd exactly when one end is inside and the other outside. Any output may
   * be nullptr. Returns the number of crossings.
   */
  vtkIdType FindCrossings(const double p1[3], const double p2[3], vtkDoubleArray* parameters,
    vtkPoints* points, vtkCellArray* incidentCells, vtkIdTypeArray* kinds);

  /**
   * The number of times that the segment p1 p2 passes through a surface (crossings of kind 1 of
   * FindCrossings), without collecting them: parity for an in/out test (section 6.3).
   */
  vtkIdType CountCrossings(const double p1[3], const double p2[3]);

  /**
   * All facets that the segment p1 p2 passes through, by ascending (parameter, cell id), those that
   * meet at one point each for itself: the parameter, the cell, and in `ways` 1 where it leaves
   * through the front (along the normal), -1 where it enters. Non-linear cells have the way 0. The
   * sum of the ways over a closed surface whose cells are turned alike is, exactly, the winding
   * number around p1 less that around p2. Any output may be nullptr. Returns the number of facets.
   */
  vtkIdType FindPasses(const double p1[3], const double p2[3], vtkDoubleArray* parameters,
    vtkIdTypeArray* cellIds, vtkIdTypeArray* ways);

  /**
   * The number of facets of FindPasses, and the sum of their ways, those of cells turned around
   * whose tuple in `turned` (or nullptr: none) is not 0.
   */
  vtkIdType CountPasses(
    const double p1[3], const double p2[3], vtkUnsignedCharArray* turned, vtkIdType& sum);

  ///@{
  /**
   * Nearest point, see vtkAbstractCellLocator. cellId is -1 when there is no cell. `cell` may be
   * nullptr, else it holds the nearest cell on return.
   */
  void FindClosestPoint(const double x[3], double closestPoint[3], vtkIdType& cellId, int& subId,
    double& dist2) override;
  void FindClosestPoint(const double x[3], double closestPoint[3], vtkGenericCell* cell,
    vtkIdType& cellId, int& subId, double& dist2) override;
  ///@}

  ///@{
  /**
   * Nearest point at a distance of at most `radius` (infinity allowed). Returns 1 or 0. `inside` is
   * 1 when x projects into the cell or lies in it, as EvaluatePosition would tell. `cell` may be
   * nullptr.
   */
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkIdType& cellId, int& subId, double& dist2) override;
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2) override;
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2, int& inside) override;
  ///@}

  /**
   * The k nearest cells by exact distance, nearest first, ties by id. `distances` (one component,
   * world units) may be nullptr. Returns how many were found: min(k, number of cells).
   */
  vtkIdType FindClosestCells(
    const double x[3], int k, vtkIdList* cellIds, vtkDoubleArray* distances);

  /**
   * All cells at a distance of at most `radius`: those that overlap the sphere (4.2, exact),
   * ascending by id. `distances` may be nullptr. Returns their number.
   */
  vtkIdType FindCellsWithinRadius(
    const double x[3], double radius, vtkIdList* cellIds, vtkDoubleArray* distances);

  ///@{
  /**
   * The cell that contains x, or with a tolerance (tol2, squared distance) the nearest cell within
   * it; -1 if there is none. `cell`, `weights` may be nullptr here.
   */
  vtkIdType FindCell(double x[3]) VTK_SKD_OVERRIDE_UNTIL_97;
  vtkIdType FindCell(double x[3], double tol2);
  vtkIdType FindCell(double x[3], double tol2, vtkGenericCell* cell, double pcoords[3],
    double* weights) VTK_SKD_OVERRIDE_UNTIL_97;
  vtkIdType FindCell(double x[3], double tol2, vtkGenericCell* cell, int& subId, double pcoords[3],
    double* weights) VTK_SKD_OVERRIDE_SINCE_92;
  ///@}

  /**
   * The same after a look into the cell `hint` (the last answer, say; -1 for none): a coherent
   * sequence of points costs less. In overlapping meshes the hinted cell wins over a lower id.
   */
  vtkIdType FindCellWithHint(double x[3], double tol2, vtkIdType hint, vtkGenericCell* cell,
    int& subId, double pcoords[3], double* weights);
#if VTK_SKD_LOCATOR_97
  vtkIdType FindCell(double x[3], vtkCell* cell, vtkGenericCell* genericCell, vtkIdType cellId,
    double tol2, int& subId, double pcoords[3], double* weights) override;
#endif

  /**
   * What one cell says of x, as vtkCell::EvaluatePosition but exactly: the cell's nearest point,
   * its sub-id, parametric coordinates and (unless nullptr) weights there, and its squared
   * distance. Returns false, and sets nothing, for a cell that is not in the tree or an x that is
   * not finite.
   */
  bool EvaluateCell(vtkIdType cellId, const double x[3], double closestPoint[3], int& subId,
    double pcoords[3], double& dist2, double* weights);

  /**
   * The parameters (ascending, t in [0, 1] along p1 p2, 0 and 1 among them) between which the
   * segment stays in the same cells: it may enter or leave a cell only there. These are the
   * crossings of faces of volume cells, and of the edges of surface cells and the ends of curves
   * that it passes at `tolerance` or less; of a curved cell they are found to rounding, but what is
   * in it or out for less than a part in 32 of its bounds may be missed. Between two of them ask
   * FindCell for the middle. Returns their number, 0 for a segment of no length or not finite.
   */
  vtkIdType FindCellBorders(
    const double p1[3], const double p2[3], double tolerance, vtkDoubleArray* parameters);

  /**
   * The cells whose bounds overlap the box (xmin, xmax, ymin, ymax, zmin, zmax), bounds included,
   * in the order of the tree: the same every time.
   */
  void FindCellsWithinBounds(double* bbox, vtkIdList* cells) override;

  /**
   * The cells whose bounds, grown by `tolerance`, the segment p1 p2 meets, sorted by (t, id).
   */
  void FindCellsAlongLine(const double p1[3], const double p2[3], double tolerance,
    vtkIdList* cells) VTK_SKD_OVERRIDE_UNTIL_97;

  /**
   * The cells whose bounds come within the distance `tolerance` of the plane (origin o, normal n of
   * any length), in the order of the tree.
   */
  void FindCellsAlongPlane(const double o[3], const double n[3], double tolerance, vtkIdList* cells)
    VTK_SKD_OVERRIDE_SINCE_92;

  ///@{
  /**
   * Whether x lies within the bounds of a cell, grown by tol. False for an id out of range.
   */
#if VTK_SKD_LOCATOR_97
  bool InsideCellBounds(double x[3], vtkIdType cellId, double tol = 0.0) override;
#else
  bool InsideCellBounds(double x[3], vtkIdType cellId) override;
#endif
  ///@}

  ///@{
  /**
   * Raw queries: the ids of the candidate cells, in the order of the tree, as the paper's
   * algorithms give them: cells whose *safety box* passes; no exact test is made.
   * FindClosestCandidates is Algorithm 5.1 (at least one of the candidates holds the nearest
   * point), by choice with a reference point: one on or near a cell only speeds the search up, any
   * other is harmless. The others are Algorithms 5.2 (segment), 5.3 (box), the sphere of 4.2 and a
   * plane.
   */
  void FindClosestCandidates(const double x[3], vtkIdList* cellIds);
  void FindClosestCandidates(const double x[3], const double reference[3], vtkIdList* cellIds);
  void FindCandidatesAlongLine(const double p1[3], const double p2[3], vtkIdList* cellIds);
  void FindCandidatesWithinBounds(const double bounds[6], vtkIdList* cellIds);
  void FindCandidatesWithinRadius(const double x[3], double radius, vtkIdList* cellIds);
  void FindCandidatesAlongPlane(const double o[3], const double n[3], vtkIdList* cellIds);
  ///@}

  /**
   * Algorithm 5.4: all pairs (a cell of this tree, a cell of the other) whose safety boxes overlap,
   * sorted by (this id, other id). Transforms of both locators are taken into account. Pass the
   * locator itself to find the pairs within one set, (i, i) among them. Returns the number of
   * pairs.
   */
  vtkIdType FindOverlappingPairs(
    vtkSkdTreeCellLocator* other, vtkIdList* cellIds, vtkIdList* otherCellIds);

  ///@{
  /**
   * Batches: many queries in one call, asked in parallel by vtkSMPTools, answered into flat arrays.
   * Query i is tuple i of the first argument, an array of any numbers with 3 components (points) or
   * 6 (lines: x, y, z of both ends; boxes: xmin, xmax, ymin, ymax, zmin, zmax), and its answer is
   * in slot i of the outputs. Answers are those of the query of the same arguments for one, ties
   * and roundings too, whatever the number of threads. Outputs are sized and named here; any may be
   * nullptr. Queries that are not finite, and those that find nothing, have the id -1 and NaN as
   * numbers, or an empty list. Inside they are asked along a space-filling curve, so their order in
   * the array does not matter. 8 bytes a query on top of the outputs, and the lists once more.
   *
   * - FindClosestPoints: the nearest cell at a distance of at most `radius`, the nearest point
   *   (3 components) and its distance.
   * - FindCells: the cell that contains the point, or with a tolerance (tol2, squared distance) the
   *   nearest within it, and the parametric coordinates (3 components) as of FindCell.
   * - IntersectWithLines: first hit of each line, its parameter t in [0, 1] and its point.
   * - FindAllHits: all hits of each line, each cell once, by (t, cell id).
   * - FindCellsWithinBoxes: the cells whose bounds overlap each box, in the order of the tree.
   * - FindPairs: for each cell of this locator's data set the cells of the other's whose bounds
   *   overlap its own, by id; both as moved by the locators' transforms. Of the locator itself:
   *   (i, i) too.
   *
   * Lists come as vtkCellArray has them: `offsets` has a tuple more than there are queries, and the
   * values of query i are those from offsets[i] to offsets[i + 1] of the others.
   *
   * Returns how many queries found something, or the number of values in all lists. After an error
   * (no queries, a wrong number of components, an array handed in twice) it is -1, and the outputs
   * are as they were.
   */
  vtkIdType FindClosestPoints(vtkDataArray* points, vtkIdTypeArray* cellIds,
    vtkDoubleArray* closestPoints, vtkDoubleArray* distances, double radius = VTK_DOUBLE_MAX);
  vtkIdType FindCells(
    vtkDataArray* points, vtkIdTypeArray* cellIds, vtkDoubleArray* pcoords, double tol2 = 0.0);
  vtkIdType IntersectWithLines(vtkDataArray* lines, vtkIdTypeArray* cellIds,
    vtkDoubleArray* parameters, vtkDoubleArray* points, double tol = 0.0);
  vtkIdType FindAllHits(vtkDataArray* lines, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds,
    vtkDoubleArray* parameters, vtkDoubleArray* points, double tol = 0.0);
  vtkIdType FindCellsWithinBoxes(
    vtkDataArray* boxes, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds);
  vtkIdType FindPairs(
    vtkSkdTreeCellLocator* other, vtkIdTypeArray* offsets, vtkIdTypeArray* otherCellIds);
  ///@}

  ///@{
  /**
   * The paper's own arrays (Algorithm 3.1), 2N-1 tuples each: S, the safety box of node i as
   * (xmin, xmax, ymin, ymax, zmin, zmax), and L, its link. Node 0 is the root (the paper counts
   * from 1): L > 0 is the first of two adjacent children, L <= 0 the negated id of the leaf's cell.
   * (The root is no one's child, so 0 always means cell 0.) Computed on each call: O(N log N).
   */
  void GetSafetyBoxes(vtkDoubleArray* S);
  void GetLinks(vtkIdTypeArray* L);
  ///@}

  ///@{
  /**
   * Statistics of the built tree: cells in it; cells left out (ghost, blanked, empty, not finite or
   * of unknown type); nodes of the query layout; its depth in node visits; its bytes, all told, and
   * for each cell in it; seconds that the last build took. 0 before it is built.
   */
  vtkIdType GetNumberOfCellsInTree();
  vtkIdType GetNumberOfCellsLeftOut();
  vtkIdType GetNumberOfNodes();
  int GetDepth();
  vtkIdType GetMemorySize();
  double GetBytesPerCell();
  double GetBuildSeconds();
  ///@}

  ///@{
  /**
   * See vtkLocator. BuildLocator builds when there is no tree, or the data set or this object's
   * settings changed after the last build; with UseExistingSearchStructure on only when there is
   * no tree. ForceBuildLocator always builds.
   */
  void BuildLocator() override;
  void ForceBuildLocator() VTK_SKD_OVERRIDE_SINCE_92;
  void FreeSearchStructure() override;
  ///@}

  /**
   * The safety boxes of a level of the paper's binary tree as quads: level 0 the root's, -1 or a
   * level below the deepest the leaves'. Cell array "Level" and, for leaves, "CellId" (-1 inside).
   */
  void GenerateRepresentation(int level, vtkPolyData* pd) override;

  /**
   * Share the tree and copy the settings of another vtkSkdTreeCellLocator, in O(1). The data set is
   * taken over only when this locator has none. A tree that is outdated, or older than the last
   * change of this locator's own data set, is not shared: one is built when it is asked for, for
   * the answers are those of the own data set, as with VTK's own locators.
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

  bool IsUpToDate();
  bool IsOlderThanTreeOf(vtkSkdTreeCellLocator* other);
  void CacheBounds();
  const SkdCellTree& GetTree();

  std::unique_ptr<SkdLocatorState> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
