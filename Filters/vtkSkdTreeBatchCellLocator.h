// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeBatchCellLocator
 * @brief   many queries of a cell locator in one call, in parallel
 *
 * The base class of vtkSkdTreeCellLocator that answers queries given as arrays.
 *
 * Many queries in one call, processed in parallel by vtkSMPTools. Query i is tuple i of
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
 * @sa
 * vtkSkdTreeCellLocator vtkSkdTreeAbstractCellLocator
 */

#ifndef vtkSkdTreeBatchCellLocator_h
#define vtkSkdTreeBatchCellLocator_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeAbstractCellLocator.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeBatchCellLocator : public vtkSkdTreeAbstractCellLocator
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeBatchCellLocator, vtkSkdTreeAbstractCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Batch of FindClosestPointWithinRadius: the nearest cell to each of `points` (3
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

  //@{
  /**
   * Batch of pairs: for each cell of this locator's data set, a list of the cells of the other's
   * whose bounds overlap its own, sorted by id; both with the locators' transforms. Within one
   * locator, (i, i) is included.
   *
   * Or the same pairs as tuples of two ids, in an order that does not depend on threads: the cost
   * then follows the number of pairs alone, as no list is begun for each cell.
   */
  vtkIdType FindPairs(
    vtkSkdTreeBatchCellLocator* other, vtkIdTypeArray* offsets, vtkIdTypeArray* otherCellIds);
  vtkIdType FindPairs(vtkSkdTreeBatchCellLocator* other, vtkIdTypeArray* pairs);
  //@}

protected:
  vtkSkdTreeBatchCellLocator();
  ~vtkSkdTreeBatchCellLocator() override;

private:
  vtkSkdTreeBatchCellLocator(const vtkSkdTreeBatchCellLocator&) = delete;
  void operator=(const vtkSkdTreeBatchCellLocator&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
