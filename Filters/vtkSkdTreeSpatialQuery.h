// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSpatialQuery
 * @brief   find cells by their spatial relation to a shape, points or cells
 *
 * The spatial queries of section 3 of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576,
 * by the skD-tree. The geometric objects are the cells of Input (port 0, any vtkDataSet or
 * composite of them); the target query object q is a box, a sphere, a plane, a line, or each point
 * or each cell of Source (port 1, optional, any vtkDataSet or composite). The kinds of query in the
 * words of the paper:
 * - EXACT_MATCH: "Find all geometric objects that have the same spatial extent as the target query
 *   object q."
 * - OVERLAP: "Find all geometric objects that have at least one point in common with the object q."
 * - ENCLOSURE: "Find all geometric objects that enclose an object q."
 * - CONTAINMENT: "Find all geometric objects that are enclosed by an object q."
 * - ADJACENCY: "Find all geometric objects that have common boundaries with an object q."
 * - NEAREST: "Find all geometric objects that have a minimum distance from an object q."
 *
 * Cells and queries are closed sets: touching is overlapping. Spheres and boxes are solid. Lengths
 * of 0 give flat boxes, and a sphere of radius 0 is a point. A plane is infinite, so no cell
 * encloses or matches it; it encloses the cells that lie in it. Cells with the same points match
 * whatever their order. See SetRelation for what adjacency and nearest mean here, and SetExact for
 * boxes instead of cells.
 *
 * Geometry of cells: for spheres and points as in vtkSkdTreeCellLocator. For other shapes a quad is
 * two triangles, a polygon is planar, a volume cell is the region enclosed by its faces, and a
 * curved cell is approximated by 8 straight pieces along each parameter. Distances count as 0 up to
 * the larger of Tolerance and 8 units in the last place of the largest coordinate.
 *
 * Trees are reused while the points, cells and ghost marks of Input and Source keep their values:
 * another query, or another time step of the same mesh, costs the query only, O(log N + k) for k
 * cells that are found or near the query's boundary. The first query of an Input by one shape,
 * except NEAREST, builds no tree: it tests all cells, O(N), in a fraction of the time of a build.
 * Answers are the same with and without a tree, and do not depend on the number of threads or
 * processes. Each gathers the whole Source, or for exact tests with SOURCE_CELLS the cells near its
 * own part of the Input (see SetSourceDistribution); for NEAREST also the whole Input, of whose
 * result it outputs what is of its own piece. Ghost and blanked cells are ignored.
 *
 * Output port 0: the cells found, by ascending id, with all data of the Input; a
 * vtkUnstructuredGrid, for a composite Input composite data of the same structure (for AMR data a
 * vtkMultiBlockDataSet of its blocks). Cell arrays
 * | name          | type   | meaning                                                          |
 * | ------------- | ------ | ---------------------------------------------------------------- |
 * | SkdCellId     | idtype | the cell in the Input; of one in pieces in the joined pieces     |
 * | SkdQueryCount | idtype | the number of queries that it answers: of points or cells, maybe |
 * |               |        | more than one                                                    |
 * | SkdDistance   | double | the least distance to these                                      |
 *
 * Output port 1: the same cells as a vtkSelection of cell indices, in the piece of the process that
 * the node names, a node for each block that has any.
 *
 * Output port 2: a vtkTable with a row for each pair of a query and a cell, by ascending (query,
 * block, cell id); for NEAREST by distance. Columns
 * | name                   | type   | meaning                                                 |
 * | ---------------------- | ------ | ------------------------------------------------------- |
 * | SkdQueryId             | idtype | the point or cell of the Source; 0 for other shapes     |
 * | SkdQueryBlockIndex     | int    | its block, of a composite Source                        |
 * | SkdCellId              | idtype | the cell, as in output port 0                           |
 * | SkdBlockIndex          | int    | its block, of a composite Input                         |
 * | SkdOptimisticDistance  | double | section 4: of the nearest points of the query and of the|
 * |                        |        | cell's safety box; if the query is a cell, of its box   |
 * | SkdPessimisticDistance | double | section 4: of their farthest points                     |
 * | SkdMinimumDistance     | double | of the nearest points of the query and the cell         |
 * | SkdMaximumDistance     | double | of their farthest points                                |
 * (the last two if Exact). For a plane the maximum is that of the farthest point of the cell, or
 * box.
 *
 * Field data of output port 0, one value each: SkdReportQueries, SkdReportPairs,
 * SkdReportCellsFound, SkdReportCells (that were searched), SkdReportCellsLeftOut (see
 * vtkSkdTreeCellLocator), SkdReportTreesBuilt (0 if all were reused, or none was needed),
 * SkdReportEpsilon (the largest in use, in world units, by the size of all pieces),
 * SkdReportBuildSeconds and SkdReportQuerySeconds.
 *
 * Bad input: a Shape that needs a Source if there is none, and 0 nearest cells, are errors, and
 * nothing is found. A shape that is not finite or extends beyond 1e50, a negative radius and a
 * normal of length 0 give a warning, and nothing is found. Points and cells of Source like these
 * find nothing; cells of Input like these, or of a mesh within 1e-50 of the origin, are ignored,
 * with a warning if there are no others. An Input without cells gives outputs without cells. An
 * aborted execution gives the cells found until then; VTK 9.3 and later then empties the output.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkSkdTreeProbe vtkExtractGeometry vtkExtractSelection
 */

#ifndef vtkSkdTreeSpatialQuery_h
#define vtkSkdTreeSpatialQuery_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSearchAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

namespace skdtree
{
class SkdWholeInput;
}

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeSpatialQuery : public vtkSkdTreeSearchAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeSpatialQuery, vtkSkdTreeSearchAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeSpatialQuery* New();

  enum RelationType
  {
    EXACT_MATCH = 0,
    OVERLAP = 1,
    ENCLOSURE = 2,
    CONTAINMENT = 3,
    ADJACENCY = 4,
    NEAREST = 5
  };

  //@{
  /**
   * The kind of query, see above; default OVERLAP.
   *
   * ADJACENCY: for a cell of the Source, cells that share a point, an edge or a face with it (see
   * SetSharedPart). For a box, line or point, cells that touch it: they have a point in common, but
   * their interiors do not. For a sphere, cells that it touches from outside; for a plane, cells
   * that touch it and lie on one side of it. The interior of a surface is without its boundary,
   * that of a curve without its ends.
   *
   * NEAREST: the NumberOfNearestCells cells nearest to the query, or to each point or cell of the
   * Source; ties go to the lowest (block, cell id), or all are included (see SetAllTies).
   */
  vtkSkdTreeChoiceMacro(Relation, EXACT_MATCH, NEAREST);
  //@}

  enum ShapeType
  {
    BOX = 0,
    SPHERE = 1,
    PLANE = 2,
    LINE = 3,
    SOURCE_POINTS = 4,
    SOURCE_CELLS = 5
  };

  //@{
  /**
   * The query object; default BOX.
   */
  vtkSkdTreeChoiceMacro(Shape, BOX, SOURCE_CELLS);
  //@}

  //@{
  /**
   * Use exact tests on cells (default), or their boxes: then the results are candidates, which
   * include all exact results and are found faster. In OVERLAP and ADJACENCY, boxes are the safety
   * boxes of cells, also of the Source. For the other relations the bounding box of the cell must,
   * to within 2 epsilon (see SetEpsilon), also enclose, be in, or equal that of the query. NEAREST
   * gives the candidates of Algorithm 5.1: cells whose optimistic distance is at most the
   * NumberOfNearestCells-th least pessimistic distance.
   */
  vtkSkdTreeSwitchMacro(Exact);
  //@}

  //@{
  /**
   * See NEAREST. Default 1. If there are fewer cells all are found; 0 is an error.
   */
  vtkSkdTreeChoiceMacro(NumberOfNearestCells, 0, VTK_INT_MAX);
  //@}

  //@{
  /**
   * Whether NEAREST includes all cells as near as the last of the NumberOfNearestCells, as in
   * section 3: for example, all cells that share a nearest vertex. Distances count as equal within
   * Tolerance or rounding. Candidates by boxes (see SetExact) always include them. Default off:
   * only the lowest ids.
   */
  vtkSkdTreeSwitchMacro(AllTies);
  //@}

  enum SharedPartType
  {
    POINT = 0,
    EDGE = 1,
    FACE = 2
  };

  //@{
  /**
   * What cells must share in ADJACENCY to cells of the Source, by coordinates within Tolerance;
   * default POINT. A surface cell is its own face, a line its own edge. A cell with the same points
   * and dimension is not adjacent.
   */
  vtkSkdTreeChoiceMacro(SharedPart, POINT, FACE);
  //@}

  //@{
  /**
   * The box: its corner, the lengths of its edges, and its rotation about the corner in degrees
   * about y, then x, then z, as in ParaView's box widget. Edges of negative length are reversed.
   * Defaults (0, 0, 0), (1, 1, 1) and (0, 0, 0).
   */
  vtkSkdTreeFinite3Macro(BoxPosition);
  vtkSkdTreeFinite3Macro(BoxLength);
  vtkSkdTreeFinite3Macro(BoxRotation);
  //@}

  //@{
  /**
   * Whether BoxLength, BoxRotation and BoxPosition, in this order, scale, rotate and translate
   * ReferenceBounds (xmin, xmax, ymin, ymax, zmin, zmax) instead of the unit cube, as an option of
   * ParaView's box widget. Default off, and (0, 1, 0, 1, 0, 1).
   */
  vtkSkdTreeSwitchMacro(UseReferenceBounds);
  vtkSkdTreeFinite6Macro(ReferenceBounds);
  //@}

  //@{
  /**
   * The sphere. Defaults (0, 0, 0) and 1. A negative radius, which ParaView sets while the bounds
   * of Input are unknown, is accepted and finds nothing, with a warning.
   */
  vtkSkdTreeFinite3Macro(SphereCenter);
  vtkSkdTreeWithinMacro(SphereRadius, double, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * The plane; its normal may have any length. Defaults (0, 0, 0) and (1, 0, 0).
   */
  vtkSkdTreeFinite3Macro(PlaneOrigin);
  vtkSkdTreeFinite3Macro(PlaneNormal);
  //@}

  //@{
  /**
   * The ends of the line. Defaults (0, 0, 0) and (1, 0, 0).
   */
  vtkSkdTreeFinite3Macro(LinePoint1);
  vtkSkdTreeFinite3Macro(LinePoint2);
  //@}

  //@{
  /**
   * The distance, in world units, up to which objects count as touching. Default 0: rounding error
   * only.
   */
  vtkSkdTreeWithinMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

protected:
  vtkSkdTreeSpatialQuery();
  ~vtkSkdTreeSpatialQuery() override;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool NeedsWhole(int port) override;
  bool NeedsNearbySource(skdtree::SkdSearchRange& range) override;
  bool ListsByInputCells() override { return true; }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Relation = OVERLAP;
  int Shape = BOX;
  bool Exact = true;
  int NumberOfNearestCells = 1;
  bool AllTies = false;
  int SharedPart = POINT;
  double BoxPosition[3] = { 0.0, 0.0, 0.0 };
  double BoxLength[3] = { 1.0, 1.0, 1.0 };
  double BoxRotation[3] = { 0.0, 0.0, 0.0 };
  bool UseReferenceBounds = false;
  double ReferenceBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  double SphereCenter[3] = { 0.0, 0.0, 0.0 };
  double SphereRadius = 1.0;
  double PlaneOrigin[3] = { 0.0, 0.0, 0.0 };
  double PlaneNormal[3] = { 1.0, 0.0, 0.0 };
  double LinePoint1[3] = { 0.0, 0.0, 0.0 };
  double LinePoint2[3] = { 1.0, 0.0, 0.0 };
  double Tolerance = 0.0;

private:
  vtkSkdTreeSpatialQuery(const vtkSkdTreeSpatialQuery&) = delete;
  void operator=(const vtkSkdTreeSpatialQuery&) = delete;

  void FindJoined(vtkInformation* output);
  void UpdateTrees(vtkDataObject* input, vtkDataObject* source);
  void WarnAboutCells();
  bool MakeQueries(vtkDataObject* source);
  void FindPairs();
  vtkDataObject* KeepOwn(const skdtree::SkdWholeInput& whole);
  void FillOutputs(vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputVector);
  void Report(vtkDataObject* output, double buildSeconds, double querySeconds);

  class Internals;
  std::unique_ptr<Internals> Impl; // the trees, kept while the meshes are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
