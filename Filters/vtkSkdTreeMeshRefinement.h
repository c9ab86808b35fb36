// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeMeshRefinement
 * @brief   refine the cells of a mesh near a geometry or where a field varies
 *
 * The cells of Input (port 0: any vtkDataSet, or composite data) are divided level by level where
 * parts of a geometry (port 1) intersect them or come near, inside the parts, or where a field
 * (port 2) varies: h-refinement of a given mesh, as in section 6.5 and Fig. 1 of Khamayseh and
 * Hansen, Commun. Comput. Phys. 2 (2007) 545-576. Lines, triangles, strips, quads, polygons,
 * tetrahedra, pyramids, wedges, hexahedra, pixels and voxels are refined; other cells are kept as
 * they are. A part intersects a cell if they have a point in common, by an exact test
 * (SetOverlapTest). If a curved mesh only approximates the parts, use AddDistanceBand. Growing
 * layers consist of cells that share a point with refined ones and are not finer, in each round.
 *
 * Two methods:
 * - BISECTION (default) leaves no hanging nodes. Lines, triangles and tetrahedra are bisected at
 *   the midpoint of their longest edge, together with all cells that share this edge, repeatedly if
 *   needed (Rivara, 1984). Other cells, and their neighbours where necessary, are first divided
 *   into simplices: polygons into n triangles around their centre (concave ones by ear clipping),
 *   hexahedra and wedges into pyramids and tetrahedra around their centre, pyramids into two
 *   tetrahedra. In planar meshes no angle of a triangle gets below half of the smallest initial one
 *   (Rosenberg and Stenger, 1975); in three dimensions no bound is known.
 * - REGULAR divides each cell independently: 2 lines, 4 triangles or quads, n quads of a polygon, 8
 *   tetrahedra, wedges or hexahedra, 6 pyramids and 4 tetrahedra of a pyramid. Nodes hang where
 *   cells of two levels meet; Balance limits the difference of levels. A level halves the size of a
 *   cell: one bisection of a line, two of a triangle, three of a tetrahedron. Cells that are
 *   bisected for the sake of neighbours may exceed MaximumLevel.
 *
 * Points of equal coordinates are treated as one, so blocks and the sides of seams still match
 * afterwards; the points themselves are not merged. The result depends neither on the number of
 * threads nor on the numbering of cells and points.
 *
 * Output: vtkPolyData for vtkPolyData, vtkUnstructuredGrid for other data sets, composite data for
 * composite data (vtkMultiBlockDataSet for AMR data sets). Cells are in the order of their parent
 * cells; points keep their ids and new ones follow. Point data are interpolated, exactly for linear
 * fields (ids are dropped); cell data are copied. Arrays:
 * | name            | of     | type   | meaning                                              |
 * | --------------- | ------ | ------ | ---------------------------------------------------- |
 * | SkdParentCellId | cells  | idtype | the cell of Input that it is part of (in the piece   |
 * |                 |        |        | of this process)                                     |
 * | SkdLevel        | cells  | uchar  | how often its size was halved                        |
 * | SkdHanging      | points | uchar  | 1: on an edge or face of a cell without a corner there |
 *
 * Field data: SkdReportCells, SkdReportPoints (equal coordinates counted once),
 * SkdReportCellsBefore, SkdReportCellsAtLevel (one value a level), SkdReportHangingPoints,
 * SkdReportRounds, SkdReportStoppedAtLevel (-1 unless CellLimit stopped the refinement),
 * SkdReportEstimatedCells (without CellLimit), SkdReportMemoryBytes (memory used),
 * SkdReportMinimumAngleBefore and SkdReportMinimumAngle (angles of surface cells at corners and of
 * tetrahedra at edges, in degrees; none without such cells), SkdReportCellsNotRefinable,
 * SkdReportParts, SkdReportPartCells, SkdReportPartCellsLeftOut, SkdReportTreesBuilt (trees are
 * reused while parts do not change), SkdReportEpsilon, SkdReportBuildSeconds,
 * SkdReportRefineSeconds, and SkdReportOpenEdges if InsideLevel is in use.
 *
 * Cost: one or two microseconds a cell in addition to the queries of parts and field; about 300
 * bytes a triangle and 400 a tetrahedron in addition to the output. From the first round on, the
 * progress text shows the expected number of cells and memory, extrapolated from the growth so far.
 *
 * Processes: each refines its own piece of Input, around all of the parts, or those near it (see
 * SetSourceDistribution). They exchange the cuts
 * and criteria on common boundaries of pieces through the global controller until nothing changes.
 * Together the pieces are identical to the result of one process, cell for cell, in coordinates,
 * levels and SkdHanging, for both methods and all options; CellLimit counts the cells of all
 * processes. Pieces must match at points of equal coordinates. Ghost cells are ignored, and of
 * cells that several processes have one refines each, the others leave it out. All processes must
 * update. Reports describe a process's own piece. Without port 2 the field is the Input, also its
 * adjacent cells of other pieces. Parts, field and surface must not come from the same
 * source as Input, because VTK's pipeline would then request the whole of it for all ports.
 *
 * Without any criterion (no Parts, no field arrays, no MinimumLevel) all cells are refined once.
 *
 * Bad input, each with one warning or error: if Parts have no cells or do not intersect the mesh,
 * and there is no other criterion, the mesh is passed on unchanged; so is an Input without cells.
 * Cells of other types, with points that are not finite, that use a point twice, or (wedges,
 * hexahedra) that are not star-shaped about their centre are not refined and are counted; nodes may
 * hang on them. The same holds for cells about as small as the resolution of their coordinates.
 * Cells of parts that are not finite are ignored and counted; field values that are not finite are
 * ignored. A mesh that has hanging nodes already, in the middle of edges of other cells, is warned
 * of before a bisection, which keeps those on edges that it does not cut.
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

  //@{
  /**
   * The parts (port 1, optional) that cells are refined around: any data set, or composite data.
   */
  void SetPartsConnection(vtkAlgorithmOutput* algOutput);
  void SetPartsData(vtkDataObject* parts);
  //@}

  //@{
  /**
   * The surface that new points are put on (port 3, optional). See PointPlacement.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* algOutput);
  void SetSurfaceData(vtkDataObject* surface);
  //@}

  enum SourceDistributions
  {
    SOURCE_AUTOMATIC = 0,
    SOURCE_REPLICATED = 1,
    SOURCE_EXCHANGED = 2
  };

  //@{
  /**
   * What each process gets of Parts and Field that lie in pieces on several: see
   * vtkSkdTreeSourceAlgorithm. SOURCE_EXCHANGED: those of their cells that are near its piece of
   * Input, as far as distance bands go. They are gathered with another PointPlacement than FLAT,
   * Parts also with InsideLevel, RefineByNormalDeviation or BLIND; so is Surface always.
   */
  vtkSkdTreeChoiceMacro(SourceDistribution, SOURCE_AUTOMATIC, SOURCE_EXCHANGED);
  //@}

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

  //@{
  /**
   * The subdivision: BISECTION (default), without hanging nodes, or REGULAR.
   */
  vtkSkdTreeChoiceMacro(Method, BISECTION, REGULAR);
  //@}

  //@{
  /**
   * The level to which all cells are refined, at most MaximumLevel. Default 0, or 1 without any
   * other criterion.
   */
  vtkSkdTreeChoiceMacro(MinimumLevel, 0, 30);
  //@}

  //@{
  /**
   * The position of new points: FLAT (default): the midpoints of edges, faces and cells, which
   * preserves areas and volumes; SPHERE: moved radially from SphereCenter to the distance of the
   * adjacent points, so that a mesh of a sphere stays on it; or SURFACE: the nearest point of the
   * surface (port 3), of volume cells only for points on the boundary of the mesh. Cuts are decided
   * by the FLAT positions.
   */
  vtkSkdTreeChoiceMacro(PointPlacement, FLAT, SURFACE);
  //@}

  //@{
  /**
   * See PointPlacement. Default (0, 0, 0).
   */
  vtkSkdTreeFinite3Macro(SphereCenter);
  //@}

  //@{
  /**
   * The type of the output's points: vtkAlgorithm::DEFAULT_PRECISION (that of the Input's;
   * default), SINGLE_PRECISION or DOUBLE_PRECISION. New points are rounded to it; areas are
   * preserved to 1e-12 in double precision only.
   */
  vtkSkdTreeChoiceMacro(OutputPointsPrecision, SINGLE_PRECISION, DEFAULT_PRECISION);
  //@}

protected:
  vtkSkdTreeMeshRefinement();
  ~vtkSkdTreeMeshRefinement() override;

  void SetUpInputs(skdtree::SkdFilterInputs& inputs) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SourceDistribution = SOURCE_AUTOMATIC;
  int Method = BISECTION;
  int MinimumLevel = 0;
  int PointPlacement = FLAT;
  double SphereCenter[3] = { 0.0, 0.0, 0.0 };
  int OutputPointsPrecision = DEFAULT_PRECISION;

private:
  bool FindRange(int port, skdtree::SkdSearchRange& range) const;

  vtkSkdTreeMeshRefinement(const vtkSkdTreeMeshRefinement&) = delete;
  void operator=(const vtkSkdTreeMeshRefinement&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the surface's trees, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
