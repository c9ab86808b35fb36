// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSpatialQuery
 * @brief   the cells that overlap, enclose, fill, touch or come nearest to something
 *
 * The spatial queries of section 3 of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576,
 * by the skD-tree. The objects are the cells of Input (port 0, any vtkDataSet or composite of
 * them); the target query object q is a box, a sphere, a plane, a line, or each point or each cell
 * of Source (port 1, optional, any vtkDataSet or composite). The kinds of query in the words of the
 * paper:
 * - EXACT_MATCH: "Find all geometric objects that have the same spatial extent as the target query
 *   object q."
 * - OVERLAP: "Find all geometric objects that have at least one point in common with the object q."
 * - ENCLOSURE: "Find all geometric objects that enclose an object q."
 * - CONTAINMENT: "Find all geometric objects that are enclosed by an object q."
 * - ADJACENCY: "Find all geometric objects that have common boundaries with an object q."
 * - NEAREST: "Find all geometric objects that have a minimum distance from an object q."
 *
 * Cells and queries are closed: their boundaries belong to them, and what touches overlaps. Balls,
 * not shells, are spheres here, and boxes are solid. Lengths of 0 make flat boxes, and a sphere of
 * radius 0 is a point. A plane has no end, so nothing encloses or matches it; it encloses the cells
 * that lie in it. Cells of the same points are the same whatever the order of these. See
 * SetRelation for what adjacency and nearest mean here, and SetExact for boxes instead of cells.
 *
 * What cells are: to spheres and points they are what they are to vtkSkdTreeCellLocator. To all
 * else a quad is two triangles, a polygon flat, a volume cell what its faces enclose, and a curved
 * cell what 8 straight pieces along each of its parameters make of it. A cell's or a query's
 * distance counts as 0, and something as held, up to Tolerance or to what rounding makes of
 * coordinates: 8 units in the last place of the largest.
 *
 * The trees are kept while the points, cells and ghost marks of Input and Source are the same:
 * another query, or another time step of the same mesh, costs the query only, O(log N + k) for k
 * cells that are found or near the query's boundary. An Input that is asked about one shape for the
 * first time, but for the nearest, gets no tree yet: all its cells are looked at, O(N), in a
 * fraction of the time that a tree takes. The answers are the same with and without, and whatever
 * the number of threads or processes (each needs the whole Source, and to find the nearest for the
 * whole Input, of whose answers it then gives a share). Ghost and blanked cells are no answers.
 *
 * Output port 0: the cells found, by ascending id, with all data of the Input; a
 * vtkUnstructuredGrid, of a composite Input a composite of them of the same structure (of AMR data
 * a vtkMultiBlockDataSet of its blocks). Cell arrays
 * | name          | type   | meaning                                                          |
 * | ------------- | ------ | ---------------------------------------------------------------- |
 * | SkdCellId     | idtype | the cell in the Input                                            |
 * | SkdQueryCount | idtype | the number of queries that it answers: of points or cells, maybe |
 * |               |        | more than one                                                    |
 * | SkdDistance   | double | the least distance to these                                      |
 *
 * Output port 1: the same cells as a vtkSelection of cell indices, a node for each block that has
 * any.
 *
 * Output port 2: a vtkTable with a row for each pair of a query and a cell, by ascending (query,
 * block, cell id); of NEAREST the nearest first. Columns
 * | name                   | type   | meaning                                                 |
 * | ---------------------- | ------ | ------------------------------------------------------- |
 * | SkdQueryId             | idtype | the point or cell of the Source; 0 for other shapes     |
 * | SkdQueryBlockIndex     | int    | its block, of a composite Source                        |
 * | SkdCellId              | idtype | the cell                                                |
 * | SkdBlockIndex          | int    | its block, of a composite Input                         |
 * | SkdOptimisticDistance  | double | section 4: of the nearest points of the query and of the|
 * |                        |        | cell's safety box; if the query is a cell, of its box   |
 * | SkdPessimisticDistance | double | section 4: of their farthest points                     |
 * | SkdMinimumDistance     | double | of the nearest points of the query and the cell         |
 * | SkdMaximumDistance     | double | of their farthest points                                |
 * (the last two if Exact). From a plane the farthest is the farthest point of the cell, or box.
 *
 * Field data of output port 0, one value each: SkdReportQueries, SkdReportPairs,
 * SkdReportCellsFound, SkdReportCells (that were searched), SkdReportCellsLeftOut (see
 * vtkSkdTreeCellLocator), SkdReportTreesBuilt (0 if all were reused, or none was needed),
 * SkdReportEpsilon (the largest in use, in world units), SkdReportBuildSeconds and
 * SkdReportQuerySeconds.
 *
 * Bad input: a Shape that needs the Source, which is not there, and 0 nearest cells are errors, and
 * nothing is found. A shape that is not finite or reaches beyond 1e50, a negative radius and a
 * normal of length 0 give a warning, and nothing is found. Points and cells that are so find
 * nothing; cells of Input that are so, or of a mesh of which all is within 1e-50 of the origin, are
 * in no tree, with a warning if there are no others. An Input without cells gives outputs without
 * cells. An execution that is aborted finds what it got to; VTK 9.3 and later then empties the
 * output.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkSkdTreeProbe vtkExtractGeometry vtkExtractSelection
 */

#ifndef vtkSkdTreeSpatialQuery_h
#define vtkSkdTreeSpatialQuery_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeSpatialQuery : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeSpatialQuery, vtkSkdTreeSourceAlgorithm);
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

  ///@{
  /**
   * The kind of query, see above; default OVERLAP.
   *
   * ADJACENCY: to a cell of the Source those that share a point, an edge or a face with it (see
   * SetSharedPart). To a box, line or point those that it touches: they have a point in common, but
   * their insides have none. To a sphere those that it touches from outside; to a plane those that
   * touch it, and are on one side of it. The inside of a surface is without its rim, of a curve
   * without its ends.
   *
   * NEAREST: the NumberOfNearestCells cells that are nearest to the query, ties to the lowest
   * (block, cell id), or all of them (see SetAllTies). Of points and cells of the Source so many to
   * each.
   */
  vtkSetClampMacro(Relation, int, EXACT_MATCH, NEAREST);
  vtkGetMacro(Relation, int);
  ///@}

  enum ShapeType
  {
    BOX = 0,
    SPHERE = 1,
    PLANE = 2,
    LINE = 3,
    SOURCE_POINTS = 4,
    SOURCE_CELLS = 5
  };

  ///@{
  /**
   * What the query object is; default BOX.
   */
  vtkSetClampMacro(Shape, int, BOX, SOURCE_CELLS);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /**
   * Whether cells decide (default), or their boxes: then the answers are candidates, all exact
   * answers among them, found faster. With boxes a cell is its safety box for OVERLAP and
   * ADJACENCY, and a cell of the Source is its own. For the other kinds the bounding box of the
   * cell, which may miss by 2 epsilon (see SetEpsilon), must besides hold, be in, or be that of the
   * query. NEAREST gives the cells that Algorithm 5.1 is left with: those whose optimistic distance
   * is not more than the NumberOfNearestCells-th least pessimistic distance.
   */
  vtkSetMacro(Exact, bool);
  vtkGetMacro(Exact, bool);
  vtkBooleanMacro(Exact, bool);
  ///@}

  ///@{
  /**
   * See NEAREST. Default 1; more than there are gives all, to ask for 0 is an error.
   */
  vtkSetClampMacro(NumberOfNearestCells, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfNearestCells, int);
  ///@}

  ///@{
  /**
   * Whether NEAREST tells all cells that are as near as the last of the NumberOfNearestCells, as
   * section 3 has it: around a corner of a mesh these are all that have it. As near is what is
   * farther by no more than Tolerance or rounding. Of boxes (see SetExact) the candidates have them
   * anyway. Default off: the lowest are taken.
   */
  vtkSetMacro(AllTies, bool);
  vtkGetMacro(AllTies, bool);
  vtkBooleanMacro(AllTies, bool);
  ///@}

  enum SharedPartType
  {
    POINT = 0,
    EDGE = 1,
    FACE = 2
  };

  ///@{
  /**
   * What ADJACENCY to cells of the Source asks for, by where points are, at Tolerance; default
   * POINT. A surface cell is a face of its own, a line its own edge. The cell itself, that is one
   * of the same points and dimension, is not its neighbour.
   */
  vtkSetClampMacro(SharedPart, int, POINT, FACE);
  vtkGetMacro(SharedPart, int);
  ///@}

  ///@{
  /**
   * The box: its corner, where its edges begin, their lengths, and by how many degrees it is turned
   * around the corner by y, then x, then z, as ParaView's box widget has it. Edges of negative
   * length go the other way. Defaults (0, 0, 0), (1, 1, 1) and (0, 0, 0).
   */
  vtkSkdTreeSetFinite3Macro(BoxPosition);
  vtkGetVector3Macro(BoxPosition, double);
  vtkSkdTreeSetFinite3Macro(BoxLength);
  vtkGetVector3Macro(BoxLength, double);
  vtkSkdTreeSetFinite3Macro(BoxRotation);
  vtkGetVector3Macro(BoxRotation, double);
  ///@}

  ///@{
  /**
   * Whether BoxLength, BoxRotation and BoxPosition, in this order, scale, turn and move
   * ReferenceBounds (xmin, xmax, ymin, ymax, zmin, zmax) instead of the unit cube, as ParaView's
   * box widget can have it. Default off, and (0, 1, 0, 1, 0, 1).
   */
  vtkSetMacro(UseReferenceBounds, bool);
  vtkGetMacro(UseReferenceBounds, bool);
  vtkBooleanMacro(UseReferenceBounds, bool);
  vtkSkdTreeSetFinite6Macro(ReferenceBounds);
  vtkGetVector6Macro(ReferenceBounds, double);
  ///@}

  ///@{
  /**
   * The sphere. Defaults (0, 0, 0) and 1. A negative radius, which ParaView sets as long as it does
   * not know the bounds of Input, is taken, and finds nothing with a warning.
   */
  vtkSkdTreeSetFinite3Macro(SphereCenter);
  vtkGetVector3Macro(SphereCenter, double);
  vtkSkdTreeSetWithinMacro(SphereRadius, double, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(SphereRadius, double);
  ///@}

  ///@{
  /**
   * The plane; its normal may have any length. Defaults (0, 0, 0) and (1, 0, 0).
   */
  vtkSkdTreeSetFinite3Macro(PlaneOrigin);
  vtkGetVector3Macro(PlaneOrigin, double);
  vtkSkdTreeSetFinite3Macro(PlaneNormal);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /**
   * The ends of the line. Defaults (0, 0, 0) and (1, 0, 0).
   */
  vtkSkdTreeSetFinite3Macro(LinePoint1);
  vtkGetVector3Macro(LinePoint1, double);
  vtkSkdTreeSetFinite3Macro(LinePoint2);
  vtkGetVector3Macro(LinePoint2, double);
  ///@}

  ///@{
  /**
   * How far apart, in world units, what counts as touching may be. Default 0: rounding alone.
   */
  vtkSkdTreeSetWithinMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

protected:
  vtkSkdTreeSpatialQuery();
  ~vtkSkdTreeSpatialQuery() override;

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

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
  double Epsilon = 1e-9;

private:
  vtkSkdTreeSpatialQuery(const vtkSkdTreeSpatialQuery&) = delete;
  void operator=(const vtkSkdTreeSpatialQuery&) = delete;

  void UpdateTrees(vtkDataObject* input, vtkDataObject* source);
  void WarnAboutCells();
  bool MakeQueries(vtkDataObject* source);
  void FindPairs();
  void KeepShare(vtkInformationVector* outputs);
  void FillOutputs(vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputVector);
  void Report(vtkDataObject* output, double buildSeconds, double querySeconds);

  class Internals;
  std::unique_ptr<Internals> Impl; // the trees, kept while the meshes are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
