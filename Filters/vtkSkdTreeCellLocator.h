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
 *   Of a curved cell it is the first of all its hits. Where the line runs along the cell, within
 *   rounding, it may be one that is later, of a straight edge any point of it, and of cells of an
 *   order above 10, and of rational cells with weights that are not positive, a later one or none.
 * - IntersectWithLine, all hits: each hit cell once, sorted by (t, cell id). A crossing of a shared
 *   edge or vertex is so reported once for each incident cell; FindCrossings merges these.
 * - FindClosestPoint and related methods: the exact nearest point; ties go to the lowest cell id.
 *   Of a curved cell it is the nearest of all its points, to within rounding. Where a whole line of
 *   them is as near, the distance may be too large by some 1e-7 of the cell's size, and of volume
 *   cells of more than 512 points (order 8) it may be that of a local minimum.
 * - FindCell: the cell that contains the point (to within rounding: 8 units in the last place of
 *   the largest coordinate), the lowest id if there are several; otherwise, with a tolerance, the
 *   *nearest* cell within it. pcoords and weights are those of the point of the cell nearest to x.
 * - A polygon is treated as planar, with a plane through the mean of its points, and may be
 *   concave. A face of a polyhedron is the fan of triangles around the mean of its points, whatever
 *   its orientation. Both interpolate by mean value coordinates, which are exact for linear fields.
 * - FindCellsWithinBounds: exactly the cells whose bounds overlap the box, including its boundary.
 *
 * vtkSkdTreeAbstractCellLocator has what concerns the tree: settings, when it is built, memory, bad
 * input, and the paper's queries without exact tests. vtkSkdTreeBatchCellLocator has many queries
 * in one call.
 *
 * Threads: after BuildLocator() every query is thread-safe, including the short forms, and
 * allocates no memory, except that output lists grow and that LazyBuild builds nodes.
 *
 * @sa
 * vtkSkdTreeAbstractCellLocator vtkSkdTreeBatchCellLocator vtkAbstractCellLocator
 * vtkStaticCellLocator vtkSkdTreeClosestPoint
 */

#ifndef vtkSkdTreeCellLocator_h
#define vtkSkdTreeCellLocator_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeBatchCellLocator.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkUnsignedCharArray;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCellLocator : public vtkSkdTreeBatchCellLocator
{
public:
  vtkTypeMacro(vtkSkdTreeCellLocator, vtkSkdTreeBatchCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeCellLocator* New();

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

protected:
  vtkSkdTreeCellLocator();
  ~vtkSkdTreeCellLocator() override;

private:
  vtkSkdTreeCellLocator(const vtkSkdTreeCellLocator&) = delete;
  void operator=(const vtkSkdTreeCellLocator&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
