// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeMeshRefinement
 * @brief   refines the cells of a mesh where a geometry or a field asks for it
 *
 * The cells of Input (port 0: any vtkDataSet, or composite data) are cut into smaller ones, level
 * by level, where parts of a geometry (port 1) meet them or come near, inside of the parts, or
 * where a field (port 2) varies: h-refinement of a given mesh, as in section 6.5 and Fig. 1 of
 * Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576. Refined are lines, triangles
 * (strips, too), quads, polygons, tetrahedra, pyramids, wedges, hexahedra, pixels and voxels; other
 * cells stay as they are. A part meets a cell if both have a point in common, exactly (Test); a
 * curved mesh and a part that lies beside it are a case for AddDistanceBand. Growing layers are
 * made of cells that share a point with those that are refined and are not finer, at each cut.
 *
 * Two methods:
 * - BISECTION (default) leaves no hanging node. Lines, triangles and tetrahedra are bisected at the
 *   middle of their longest edge, and so is, as often as it takes, all that has the edge (Rivara,
 *   1984). Other cells become simplices first, those beside that do, too, where they must: polygons
 *   n triangles from their middle (a concave one by cutting off ears), hexahedra and wedges
 * pyramids and tetrahedra from their middle, pyramids two tetrahedra. No angle of a triangle gets
 * below half of the smallest one of the triangles that were first (Rosenberg and Stenger, 1975), on
 *   flat cells; in three dimensions no bound is known.
 * - REGULAR cuts each cell for itself into parts like itself: 2 lines, 4 triangles or quads, n
 * quads of a polygon, 8 tetrahedra, wedges or hexahedra, 6 pyramids and 4 tetrahedra. Points hang
 * then where cells of two levels meet; Balance bounds by how many levels they differ. A level
 * halves the size of a cell: it takes one bisection of a line, two of a triangle, three of a
 * tetrahedron. What is cut along with others for their sake may get above MaximumLevel.
 *
 * Points of equal coordinates count as one in deciding on cuts, so blocks, and the sides of seams,
 * fit together afterwards; they stay as many points as they were. The result depends on neither the
 * number of threads nor the numbering of cells and points.
 *
 * Output: vtkPolyData of the same, vtkUnstructuredGrid of all others, composite data of composite
 * data (of what is no tree of blocks, AMR say, a vtkMultiBlockDataSet). Cells are in the order of
 * those that they are parts of; points keep their ids, new ones come after. Point data are
 * interpolated, exactly for linear fields (ids are dropped), cell data passed on. Arrays:
 * | name            | of     | type   | meaning                                              |
 * | --------------- | ------ | ------ | ---------------------------------------------------- |
 * | SkdParentCellId | cells  | idtype | the cell of Input that it is part of                 |
 * | SkdLevel        | cells  | uchar  | how often its size was halved                        |
 * | SkdHanging      | points | uchar  | 1: on an edge or face of a cell without a corner there |
 *
 * Field data: SkdReportCells, SkdReportPoints (of equal coordinates one), SkdReportCellsBefore,
 * SkdReportCellsAtLevel (a value a level), SkdReportHangingPoints, SkdReportRounds,
 * SkdReportStoppedAtLevel (-1: nothing was left out, see CellLimit), SkdReportEstimatedCells (if
 * nothing had been), SkdReportMemoryBytes (what it took), SkdReportMinimumAngleBefore and
 * SkdReportMinimumAngle (of triangles and other surface cells at corners, of tetrahedra at edges,
 * in degrees; none without such cells), SkdReportCellsNotRefinable, SkdReportParts,
 * SkdReportPartCells, SkdReportPartCellsLeftOut, SkdReportTreesBuilt (trees are kept while parts do
 * not change), SkdReportEpsilon, SkdReportBuildSeconds, SkdReportRefineSeconds, and
 * SkdReportOpenEdges where inside is asked.
 *
 * Cost: a microsecond or two a cell, and what the parts and the field are asked; about 300 bytes a
 * triangle and 400 a tetrahedron beside the output. How many cells and how much memory it will be
 * is told by the progress text, from the first round on, by how the mesh has grown so far.
 *
 * Processes: each refines its own piece of Input, around all of the parts. They tell each other, by
 * the global controller, what is cut and wanted where their pieces meet, until nothing changes: so
 * together the pieces are what one process makes of the whole, cell for cell, by either Method and
 * with all of its options, in places, levels and marks (SkdHanging); CellLimit counts the cells of
 * all. Pieces must meet at points of equal coordinates. Ghost cells are left out: others have them.
 * All processes must update. Reports are of a process's own piece. Without port 2 the field is the
 * piece itself: cells of others that meet its border do not count. Parts, field and surface must
 * not come from the source of Input: that would give the whole to all of them, as VTK's pipeline
 * asks a source once.
 *
 * Where nothing is told that could ask for cells (no Parts, no arrays of a field, no MinimumLevel)
 * all of them are refined once.
 *
 * Bad input, each with one warning or error that says so: Parts without cells or that miss the
 * mesh, if nothing else asks, pass the mesh on as it is; so does an Input without cells. Cells of
 * other types, of points that are not finite, that use a point twice, or (wedges, hexahedra) whose
 * middle does not see all faces are kept whole and counted; points may hang on them. So are cells
 * about as small as the resolution of their coordinates, far from the origin. Parts' cells that are
 * not finite are left out and counted, values that are not finite do not count.
 *
 * @sa
 * vtkSkdTreeAMR vtkSkdTreeClosestPoint
 */

#ifndef vtkSkdTreeMeshRefinement_h
#define vtkSkdTreeMeshRefinement_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeRefineAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeMeshRefinement : public vtkSkdTreeRefineAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeMeshRefinement, vtkSkdTreeRefineAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeMeshRefinement* New();

  enum Methods
  {
    BISECTION = 0,
    REGULAR = 1
  };
  enum PointPlacements
  {
    FLAT = 0,
    SPHERE = 1,
    SURFACE = 2
  };

  ///@{
  /**
   * The parts (port 1, optional) that cells are refined around: any data set, or composite data.
   */
  void SetPartsConnection(vtkAlgorithmOutput* algOutput);
  void SetPartsData(vtkDataObject* parts);
  ///@}

  ///@{
  /**
   * The surface that new points are put on (port 3, optional). See PointPlacement.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* algOutput);
  void SetSurfaceData(vtkDataObject* surface);
  ///@}

  ///@{
  /**
   * How cells are cut: BISECTION (default), without hanging points, or REGULAR.
   */
  vtkSetClampMacro(Method, int, BISECTION, REGULAR);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * The level that all cells are refined to, whatever asks for them, at most MaximumLevel. Default
   * 0; where nothing else is told that could ask for cells, 1.
   */
  vtkSetClampMacro(MinimumLevel, int, 0, 30);
  vtkGetMacro(MinimumLevel, int);
  ///@}

  ///@{
  /**
   * Where new points go: FLAT (default), where they are made, in the middle of edges, faces and
   * cells, so areas and volumes are kept; SPHERE, in that direction from SphereCenter as far as the
   * points around are, so a mesh of a sphere stays on it; or SURFACE, the point of the surface
   * (port 3) that is nearest, of volume cells for points on the border of the mesh only. Cuts are
   * decided on where points would be flat.
   */
  vtkSetClampMacro(PointPlacement, int, FLAT, SURFACE);
  vtkGetMacro(PointPlacement, int);
  ///@}

  ///@{
  /**
   * See PointPlacement. Default (0, 0, 0).
   */
  vtkSkdTreeSetFinite3Macro(SphereCenter);
  vtkGetVector3Macro(SphereCenter, double);
  ///@}

  ///@{
  /**
   * The type of the output's points: vtkAlgorithm::DEFAULT_PRECISION (that of the Input's;
   * default), SINGLE_PRECISION or DOUBLE_PRECISION. New points are rounded to it: areas are kept to
   * 1e-12 by double precision only.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkSkdTreeMeshRefinement();
  ~vtkSkdTreeMeshRefinement() override;

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Method = BISECTION;
  int MinimumLevel = 0;
  int PointPlacement = FLAT;
  double SphereCenter[3] = { 0.0, 0.0, 0.0 };
  int OutputPointsPrecision = DEFAULT_PRECISION;

private:
  vtkSkdTreeMeshRefinement(const vtkSkdTreeMeshRefinement&) = delete;
  void operator=(const vtkSkdTreeMeshRefinement&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the surface's trees, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
