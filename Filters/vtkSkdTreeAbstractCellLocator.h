// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeAbstractCellLocator
 * @brief   the tree of a cell locator: settings, life, statistics, and the paper's raw queries
 *
 * The base class of vtkSkdTreeCellLocator, which answers queries by exact tests of the cells that
 * this class's tree finds. The paper is
 *
 *   A. Khamayseh, G. Hansen, "Use of the Spatial kD-Tree in Computational Physics Applications",
 *   Commun. Comput. Phys. 2 (2007) 545-576.
 *
 * Cost: build O(N log N) time; queries O(log N + k) typical for k results. Memory: about 36 bytes a
 * cell for the tree, a copy of the connectivity (4 bytes a cell point) and, unless they are doubles
 * in a vtkPointSet, which are shared, of the points (24 bytes each): 48 bytes a cell of triangles,
 * 52 of tetrahedra, and up to twice that during the build. Unless LazyBuild is on, leaf filters add
 * 24 bytes a triangle, 32 a tetrahedron, 48 a hexahedron. If all cells are triangles, a copy of
 * their corners is kept for lines: 15 bytes a triangle if points are in single precision, else 30.
 * If all are triangles, or all linear volume cells, most leaves are not stored: 28 bytes less a
 * triangle, 14 a volume cell.
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
 * vtkSkdTreeCellLocator vtkSkdTreeBatchCellLocator
 */

#ifndef vtkSkdTreeAbstractCellLocator_h
#define vtkSkdTreeAbstractCellLocator_h

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
class vtkDoubleArray;
class vtkIdTypeArray;
class vtkMatrix4x4;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeAbstractCellLocator : public vtkAbstractCellLocator
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeAbstractCellLocator, vtkAbstractCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
   * on, queries after it use the tree unchecked until the next BuildLocator. Queries notice when
   * the data set, its points, its cells or its ghosts were Modified(), or arrays of data were added
   * or removed; BuildLocator also notices modified values of any array. To notice changes, the
   * locator holds references to the arrays of points and cells.
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

  // --- The paper's queries, whose answers are candidates -----------------------------------------

  //@{
  /**
   * Queries without exact tests, as in the paper: the ids of the candidate cells, whose *safety
   * boxes* satisfy the query, in the order of the tree, those about a point ascending.
   * FindClosestCandidates is Algorithm 5.1 (at least one of the candidates contains the nearest
   * point), optionally with a reference point: one on or near a cell accelerates the search, any
   * other one does no harm. The others are Algorithms 5.2 (segment), 5.3 (box), the sphere of 4.2
   * and a plane.
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
    vtkSkdTreeAbstractCellLocator* other, vtkIdList* cellIds, vtkIdList* otherCellIds);

protected:
  vtkSkdTreeAbstractCellLocator();
  ~vtkSkdTreeAbstractCellLocator() override;

  void BuildLocatorInternal() VTK_SKD_OVERRIDE_SINCE_92;

  /**
   * The tree, which is built first unless it is up to date.
   */
  const skdtree::SkdCellTree& GetTree();

  double Epsilon = 1e-9;
  bool LazyBuild = false;
  int SplitRule = SPLIT_AUTOMATICALLY;
  bool SkipGhostCells = true;
  std::unique_ptr<skdtree::SkdLocatorState> Impl;

private:
  vtkSkdTreeAbstractCellLocator(const vtkSkdTreeAbstractCellLocator&) = delete;
  void operator=(const vtkSkdTreeAbstractCellLocator&) = delete;

  bool HasValidTree();
  bool IsUpToDate();
  bool IsNewerThanData(vtkMTimeType time);
  bool HasTreeOf(vtkDataSet* data);
  void CacheBounds();
};

VTK_ABI_NAMESPACE_END
#endif
