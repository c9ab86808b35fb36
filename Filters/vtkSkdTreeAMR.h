// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeAMR
 * @brief   adaptive Cartesian grid, refined around the parts of a geometry
 *
 * Makes an adaptive Cartesian grid around Input (port 0: any vtkDataSet, or composite data of
 * several parts, with cells of any type), following section 6.5 of Khamayseh and Hansen, Commun.
 * Comput. Phys. 2 (2007) 545-576: cells of a base grid that intersect a part are refined, then
 * those of their children that do, until the maximum level is reached. Each cell passes the
 * candidates found in the parts' skD-trees on to its children, so that these are not searched from
 * the root again.
 *
 * Cells are closed sets: a part that touches a cell intersects it, so a plane along cell faces cuts
 * the cells on both sides. By default the test is exact for the parts' own cells: triangles, quads
 * (as two triangles), polygons (as planar), strips, lines and points, and volume cells including
 * their interior. The paper's "blind" test, by safety boxes alone, is optional and refines more
 * cells (see SetOverlapTest).
 *
 * The base grid is one of: BaseMesh (port 1, optional: vtkImageData without a direction matrix, or
 * vtkRectilinearGrid; its cells are the base cells), given bounds, or the bounds of the parts with
 * a margin. The grid is flat along axes on which its bounds have no length, so grids have one, two
 * or three dimensions.
 *
 * Output: vtkHyperTreeGrid; or vtkUnstructuredGrid of the leaves (cells that are not refined) as
 * voxels, pixels or lines, with the point array SkdHanging (unsigned char), 1 at hanging nodes; or
 * vtkOverlappingAMR, whose first level is one block of the base cells and each further level
 * rectangular blocks of the children of refined cells; refined cells are marked in vtkGhostType.
 *
 * Cell arrays:
 * | name              | type   | meaning                                                        |
 * | ----------------- | ------ | -------------------------------------------------------------- |
 * | SkdLevel          | uchar  | 0 for base cells                                               |
 * | SkdCut            | uchar  | 1 if a part meets the cell                                     |
 * | SkdPartIndex      | int    | flat block index of the first part that does, -1: none does    |
 * | SkdCandidates     | int    | how many cells of parts meet it by the test; -1 in refined ones|
 * | SkdInside         | uchar  | by choice, see ComputeInside                                   |
 * | SkdVolumeFraction | double | by choice, see ComputeVolumeFraction                           |
 * | SkdDistance       | double | by choice, see ComputeDistance                                 |
 * | SkdCoverage       | double | by choice, see ComputeField: the share that the field covers   |
 * (The flat block index is 0 where Input is not composite.)
 *
 * Field data: SkdReportCells (leaves), SkdReportCutCells (cut leaves), SkdReportAllCells (including
 * refined ones), SkdReportLeavesAtLevel and SkdReportCutAtLevel (one value a level; cut cells
 * include refined ones), SkdReportStoppedAtLevel (-1 unless CellLimit stopped the refinement),
 * SkdReportEstimatedCells, SkdReportEstimatedBytes and SkdReportEstimatedSeconds (number of cells
 * without CellLimit, and the memory and time that they need; estimated beforehand and shown in the
 * progress text), SkdReportParts, SkdReportPartCells, SkdReportPartCellsLeftOut,
 * SkdReportTreesBuilt (trees are reused while the parts do not change), SkdReportEpsilon,
 * SkdReportBuildSeconds, SkdReportRefineSeconds; SkdReportOpenEdges if ComputeInside or InsideLevel
 * is in use.
 *
 * The estimate is made by refining a sample of the cells and is accurate to a few percent, or to a
 * factor of two if Balance or GrowingLayers add cells. Estimates of memory (grid and output) and
 * time (without the optional arrays) are accurate to a factor of two.
 *
 * Cost: about a microsecond for each cut cell, less for others; memory about 25 bytes a cell in
 * addition to the output. The result does not depend on the number of threads.
 *
 * Several processes divide the base cells among themselves, in order, and each outputs its own with
 * all their descendants (of an overlapping AMR data set, every n-th block); together the result is
 * that of one process, including CellLimit. Without Balance and GrowingLayers each refines only its
 * own base cells (of an unstructured grid also the adjacent ones, for hanging nodes), and all
 * processes must update, because they count their cells together.
 * With these, and for overlapping AMR data sets, each refines all. Of parts and field each gets
 * all, or what is near its own base cells: see SetSourceDistribution. Reports count a process's own
 * cells.
 *
 * Bad input, each with one warning or error: an Input without cells gives the base grid unrefined
 * if it is set, else an empty output. A base grid that no part intersects is not refined. A base
 * grid that cannot be made (lengths of its bounds that are not finite, an image with a direction
 * matrix, or for a hyper tree grid a single point) gives an empty output. Cells about as small as
 * the resolution of their coordinates are not refined. Cells of parts with points that are not
 * finite or beyond 1e152, and meshes within 1e-152 of the origin, are ignored and counted.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkHyperTreeGrid
 */

#ifndef vtkSkdTreeAMR_h
#define vtkSkdTreeAMR_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeRefineAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

namespace skdtree
{
struct SkdSearchRange;
}

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeAMR : public vtkSkdTreeRefineAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeAMR, vtkSkdTreeRefineAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeAMR* New();

  //@{
  /**
   * The base grid (port 1, optional). It replaces the bounds, dimensions and cell size.
   */
  void SetBaseMeshConnection(vtkAlgorithmOutput* algOutput);
  void SetBaseMeshData(vtkDataObject* mesh);
  //@}

  enum OutputTypes
  {
    HYPER_TREE_GRID = 0,
    UNSTRUCTURED_GRID = 1,
    OVERLAPPING_AMR = 2
  };

  enum SourceDistributions
  {
    SOURCE_AUTOMATIC = 0,
    SOURCE_REPLICATED = 1,
    SOURCE_EXCHANGED = 2
  };

  //@{
  /**
   * What each process gets of parts and Field that lie in pieces on several: see
   * vtkSkdTreeSourceAlgorithm. SOURCE_EXCHANGED: those of their cells that are near its own base
   * cells, of parts as far as distance bands go, or with ComputeDistance what is nearest. They are
   * gathered where a process refines all of the grid (Balance, GrowingLayers, OVERLAPPING_AMR) and
   * with a BaseMesh; parts also with InsideLevel, ComputeInside, ComputeVolumeFraction,
   * RefineByNormalDeviation or BLIND, and a Field of several blocks with ComputeField.
   */
  vtkSkdTreeChoiceMacro(SourceDistribution, SOURCE_AUTOMATIC, SOURCE_EXCHANGED);
  //@}

  //@{
  /**
   * Put the base grid around the parts, with a margin; else use BaseBounds. Default on.
   */
  vtkSkdTreeSwitchMacro(AutomaticBounds);
  //@}

  //@{
  /**
   * The margin on each side of the parts, relative to the longest side of their bounds. Sides of
   * zero length get none: parts in a plane have a grid in that plane. Default 0.1.
   */
  vtkSkdTreeWithinMacro(BoundsMargin, double, 0.0, 1e6);
  //@}

  //@{
  /**
   * The bounds of the base grid (xmin, xmax, ymin, ymax, zmin, zmax) if AutomaticBounds is off.
   * Default: the unit cube.
   */
  vtkSkdTreeFinite6Macro(BaseBounds);
  //@}

  //@{
  /**
   * Numbers of base cells along each axis. 0: cubes with sides about as long as the shortest side
   * of the bounds (or 1/64 of the longest); the bounds are extended to whole cells along such an
   * axis. Default (0, 0, 0).
   */
  vtkSetVector3Macro(BaseDimensions, int);
  vtkGetVector3Macro(BaseDimensions, int);
  //@}

  //@{
  /**
   * The side of cubic base cells; the bounds are extended to whole cells. Default 0: BaseDimensions
   * determine the cells.
   */
  vtkSkdTreeWithinMacro(BaseCellSize, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * The number of cells along each axis that a refined cell is cut into: 2 (default) or 3.
   */
  vtkSkdTreeChoiceMacro(BranchFactor, 2, 3);
  //@}

  //@{
  /**
   * Compute SkdInside: 1 for cells whose centre is inside the closed surface that Input is, or that
   * bounds it. This is exact, including overlapping bodies. For a surface with open edges, which a
   * warning counts, the answer is that of the method AUTOMATIC of vtkSkdTreePointInOut. For a
   * refined cell: whether more than half of its children are inside. Default off.
   */
  vtkSkdTreeSwitchMacro(ComputeInside);
  //@}

  //@{
  /**
   * Compute SkdVolumeFraction: the fraction of each cell that is inside, from 0 to 1, with inside
   * as in ComputeInside. It uses exact clipping, so the sum over cells is the volume of the
   * geometry to rounding (of a triangulated surface; other faces are triangulated first). The
   * orientation of the surface does not matter, but where bodies overlap the fractions are not
   * exact. For a surface with open edges, 4 samples along each axis are used. On flat grids it is
   * the fraction of the area or length. Default off.
   */
  vtkSkdTreeSwitchMacro(ComputeVolumeFraction);
  //@}

  //@{
  /**
   * Give cells the arrays of the field (all of them, points' and cells', but strings) as arrays of
   * doubles: their means over the part of the cell that the field covers, conservative of second
   * order with limited gradients, as by vtkSkdTreeRemap. Integrals over the grid, times
   * SkdCoverage, are those over the field where the grid is, to rounding; refined cells have the
   * means of their children. The field must have cells of the grid's dimension. Default off.
   */
  vtkSkdTreeSwitchMacro(ComputeField);
  //@}

  //@{
  /**
   * Compute SkdDistance: the distance of the centre of each cell from the nearest part. With
   * ComputeInside it is negative inside. Default off.
   */
  vtkSkdTreeSwitchMacro(ComputeDistance);
  //@}

  //@{
  /**
   * The type of the output: HYPER_TREE_GRID (default), UNSTRUCTURED_GRID or OVERLAPPING_AMR, which
   * needs base cells of equal size in two or three dimensions.
   */
  vtkSkdTreeChoiceMacro(OutputType, HYPER_TREE_GRID, OVERLAPPING_AMR);
  //@}

  //@{
  /**
   * Make a two-dimensional unstructured grid conforming: a leaf with hanging nodes is divided into
   * triangles around its centre, each with the leaf's data. With Balance no angle of square cells
   * is below 45 degrees. Default off. Other grids keep their hanging nodes, with a warning.
   */
  vtkSkdTreeSwitchMacro(Conforming);
  //@}

protected:
  vtkSkdTreeAMR();
  ~vtkSkdTreeAMR() override;

  void SetUpInputs(skdtree::SkdFilterInputs& inputs) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SourceDistribution = SOURCE_AUTOMATIC;
  bool AutomaticBounds = true;
  double BoundsMargin = 0.1;
  double BaseBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  int BaseDimensions[3] = { 0, 0, 0 };
  double BaseCellSize = 0.0;
  int BranchFactor = 2;
  bool ComputeInside = false;
  bool ComputeVolumeFraction = false;
  bool ComputeDistance = false;
  bool ComputeField = false;
  int OutputType = HYPER_TREE_GRID;
  bool Conforming = false;

private:
  /// Whether a process refines only its own part of the grid.
  bool RefinesOwn() const;
  bool FindRange(int port, skdtree::SkdSearchRange& range) const;
  bool FindRangeOfField(skdtree::SkdSearchRange& range) const;

  /// Whether a process may need no more than what is near its own part.
  bool CanExchange();

  vtkSkdTreeAMR(const vtkSkdTreeAMR&) = delete;
  void operator=(const vtkSkdTreeAMR&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
