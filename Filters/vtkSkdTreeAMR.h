// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeAMR
 * @brief   a grid of trees of cells, refined around the parts of a geometry
 *
 * Makes an adaptive Cartesian grid around Input (port 0: any vtkDataSet, or composite data of
 * several parts, with cells of any type), as section 6.5 of Khamayseh and Hansen, Commun. Comput.
 * Phys. 2 (2007) 545-576 has it: the cells of a base grid that a part meets are refined, and those
 * of their children that a part meets, until the maximum level is reached. One walk of the parts'
 * skD-trees serves a whole family of cells: what may meet a cell is passed on to its children,
 * and none is searched from the root again.
 *
 * Cells are closed: a part that touches a cell meets it, so a plane on the faces of cells cuts
 * those of both sides. By default the parts' own cells decide, exactly: triangles, quads (as two
 * triangles), polygons (taken for flat), strips, lines and points; a volume cell meets all that its
 * inside or its faces do. Curved cells count by their boxes. The paper's "blind" refinement, by
 * safety boxes alone, is there by choice; it refines more (see Test).
 *
 * The base grid is, by choice: what BaseMesh is (port 1, optional: vtkImageData that is not turned,
 * or vtkRectilinearGrid; its cells are the base cells), given bounds, or the bounds of the parts
 * with a margin. Along an axis on which its bounds have no length the grid is flat: so there are
 * grids of one, two and three dimensions.
 *
 * Output: vtkHyperTreeGrid or, by choice, vtkUnstructuredGrid of the leaves (cells that are not
 * refined) as voxels, pixels or lines, in which the point array SkdHanging (unsigned char) is 1 at
 * points that are not corners of all the cells that they are on; or vtkOverlappingAMR, whose first
 * level is one block of the base cells and each other level blocks of the children of refined
 * cells, joined to larger ones; refined cells are marked in vtkGhostType.
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
 * (The flat block index is 0 where Input is not composite.)
 *
 * Field data: SkdReportCells (leaves), SkdReportCutCells (cut leaves), SkdReportAllCells (with
 * refined ones), SkdReportLeavesAtLevel and SkdReportCutAtLevel (a value a level; of cut cells
 * refined ones, too), SkdReportStoppedAtLevel (-1: nothing was left out, see CellLimit),
 * SkdReportEstimatedCells, SkdReportEstimatedBytes and SkdReportEstimatedSeconds (how many cells
 * there would be if CellLimit left none out, and the memory and time that they take; known
 * beforehand, and told by the progress text), SkdReportParts, SkdReportPartCells,
 * SkdReportPartCellsLeftOut, SkdReportTreesBuilt (trees are kept while parts do not change),
 * SkdReportEpsilon, SkdReportBuildSeconds, SkdReportRefineSeconds; SkdReportOpenEdges where inside
 * is asked.
 *
 * The estimate is made by refining a sample of the cells. It is right to a few percent; where
 * Balance or GrowingLayers add cells, to within a factor of two, as it is of memory, which counts
 * the grid and the output, and of seconds, which leave out what is computed by choice.
 *
 * Cost: about a microsecond a cell that is cut, less for others; memory about 25 bytes a cell
 * beside the output. The result is the same whatever the number of threads.
 *
 * Several processes share the base cells out, in their order, and each gives its own with all below
 * them (an overlapping AMR data set: every so-manieth block); together it is what one process
 * gives, CellLimit included. Each needs all of the parts. Without Balance and GrowingLayers each
 * refines its own base cells only (of an unstructured grid those next to them, too, for what hangs
 * on them), and all processes must update: they count their cells together. With these, and for
 * overlapping AMR data sets, each refines all. Reports are of a process's own cells.
 *
 * Bad input, each with one warning or error that says so: an Input without cells gives the base
 * grid unrefined if that is given, else nothing. A base grid that the parts miss stays as it is. A
 * base grid that cannot be made (of bounds whose lengths are not finite, an image that is turned,
 * or for a hyper tree grid a single point) gives an empty output. Cells about as small as the
 * resolution of their coordinates, far from the origin, are not refined. Parts' cells with points
 * that are not finite, or beyond 1e152, are left out and counted; so are all within 1e-152 of the
 * origin.
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

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeAMR : public vtkSkdTreeRefineAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeAMR, vtkSkdTreeRefineAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeAMR* New();

  enum OutputTypes
  {
    HYPER_TREE_GRID = 0,
    UNSTRUCTURED_GRID = 1,
    OVERLAPPING_AMR = 2
  };
  ///@{
  /**
   * The base grid (port 1, optional). It takes the place of the bounds, dimensions and cell size.
   */
  void SetBaseMeshConnection(vtkAlgorithmOutput* algOutput);
  void SetBaseMeshData(vtkDataObject* mesh);
  ///@}

  ///@{
  /**
   * Put the base grid around the parts, with a margin; else use BaseBounds. Default on.
   */
  vtkSetMacro(AutomaticBounds, bool);
  vtkGetMacro(AutomaticBounds, bool);
  vtkBooleanMacro(AutomaticBounds, bool);
  ///@}

  ///@{
  /**
   * The margin on each side of the parts, relative to the longest side of their bounds. Sides
   * without length get none: parts in a plane have a grid in that plane. Default 0.1.
   */
  vtkSkdTreeSetWithinMacro(BoundsMargin, double, 0.0, 1e6);
  vtkGetMacro(BoundsMargin, double);
  ///@}

  ///@{
  /**
   * The bounds of the base grid (xmin, xmax, ymin, ymax, zmin, zmax) where they are not automatic.
   * Default: the unit cube.
   */
  vtkSkdTreeSetFinite6Macro(BaseBounds);
  vtkGetVector6Macro(BaseBounds, double);
  ///@}

  ///@{
  /**
   * Base cells along each axis. 0: as many cubes, about as long as the shortest side of the bounds
   * (or a 64th of the longest), as hold them; the bounds grow to whole cells along such an axis.
   * Default (0, 0, 0).
   */
  vtkSetVector3Macro(BaseDimensions, int);
  vtkGetVector3Macro(BaseDimensions, int);
  ///@}

  ///@{
  /**
   * The side of base cells, which are cubes then; the bounds grow to whole cells. 0, the default:
   * BaseDimensions say how many cells there are.
   */
  vtkSkdTreeSetWithinMacro(BaseCellSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BaseCellSize, double);
  ///@}

  ///@{
  /**
   * The number of cells along each axis that a refined cell is cut into: 2 (default) or 3.
   */
  vtkSetClampMacro(BranchFactor, int, 2, 3);
  vtkGetMacro(BranchFactor, int);
  ///@}

  ///@{
  /**
   * Tell by SkdInside which cells have their centre inside of the closed surface that Input is or
   * that bounds it, exactly, bodies that overlap included; of a surface with open edges, which a
   * warning counts, by the generalised winding number (its triangles turned so that they agree). Of
   * a refined cell: whether more than half of its children are. Default off.
   */
  vtkSetMacro(ComputeInside, bool);
  vtkGetMacro(ComputeInside, bool);
  vtkBooleanMacro(ComputeInside, bool);
  ///@}

  ///@{
  /**
   * Tell by SkdVolumeFraction how much of each cell is inside, from 0 to 1, as ComputeInside has
   * the inside: by exact clipping, so the sum over cells is the volume of the geometry but for
   * rounding (of a surface of triangles; others are cut into triangles first). A surface may be
   * turned in any way, but where bodies overlap the fractions are not exact. Of a surface with open
   * edges 4 samples along each axis count. On flat grids it is the fraction of the area or length.
   * Default off.
   */
  vtkSetMacro(ComputeVolumeFraction, bool);
  vtkGetMacro(ComputeVolumeFraction, bool);
  vtkBooleanMacro(ComputeVolumeFraction, bool);
  ///@}

  ///@{
  /**
   * Tell by SkdDistance how far the centre of each cell is from the nearest part. With
   * ComputeInside it is negative inside. Default off.
   */
  vtkSetMacro(ComputeDistance, bool);
  vtkGetMacro(ComputeDistance, bool);
  vtkBooleanMacro(ComputeDistance, bool);
  ///@}

  ///@{
  /**
   * What the output is: HYPER_TREE_GRID (default), UNSTRUCTURED_GRID or OVERLAPPING_AMR, which
   * needs base cells of one size along two axes or three.
   */
  vtkSetClampMacro(OutputType, int, HYPER_TREE_GRID, OVERLAPPING_AMR);
  vtkGetMacro(OutputType, int);
  ///@}

  ///@{
  /**
   * Make an unstructured grid of two dimensions conform: no point hangs, as a leaf with points
   * between its corners becomes triangles around its middle, each with the leaf's data. With
   * Balance no angle of square cells is below 45 degrees. Default off. Of other grids points hang
   * still, and a warning says so.
   */
  vtkSetMacro(Conforming, bool);
  vtkGetMacro(Conforming, bool);
  vtkBooleanMacro(Conforming, bool);
  ///@}

protected:
  vtkSkdTreeAMR();
  ~vtkSkdTreeAMR() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool AutomaticBounds = true;
  double BoundsMargin = 0.1;
  double BaseBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  int BaseDimensions[3] = { 0, 0, 0 };
  double BaseCellSize = 0.0;
  int BranchFactor = 2;
  bool ComputeInside = false;
  bool ComputeVolumeFraction = false;
  bool ComputeDistance = false;
  int OutputType = HYPER_TREE_GRID;
  bool Conforming = false;

private:
  vtkSkdTreeAMR(const vtkSkdTreeAMR&) = delete;
  void operator=(const vtkSkdTreeAMR&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
