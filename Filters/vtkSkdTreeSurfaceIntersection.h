// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSurfaceIntersection
 * @brief   intersection of a surface with another one or with itself
 *
 * Finds all pairs of cells of Input (port 0) and Source (port 1) that touch, their intersection
 * curves and the areas in which they coincide, by traversing both skD-trees together (section 5.4
 * of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576). Without a Source, Input is
 * intersected with itself. Inputs may be any vtkDataSet or composite of them; their surface cells
 * and the outer faces of volume cells are used. AMR data, and the pieces of a
 * vtkPartitionedDataSet, are one mesh: faces between its blocks or pieces are no outer ones, be
 * these of the same level or not, and of images and grids of voxels but for rounding.
 * Other blocks are meshes of their own, and meet where they touch. Cells with more than three
 * points are triangulated without new points (a quad along the shorter of its interior diagonals).
 *
 * Tests use exact signs: there is no tolerance, and the result is correct for surfaces that
 * coincide, touch, graze or lie far from the origin (for the given points; for a moved Source, for
 * the moved and rounded points). Cells touch if they have a point in common, including boundaries.
 * Within one surface, two triangles that share a vertex or an edge, by coordinates, are a pair only
 * if they have more than that in common: adjacent cells of a valid surface are not reported; folds,
 * duplicate cells and intersections at a vertex are. Positions are accurate to a few units in the
 * last place.
 *
 * Output port 0, vtkPolyData: the curves, as polylines that end only where one segment or more than
 * two meet (see JoinCurves), and isolated points of contact as vertices. Points are joined by the
 * features they lie on, never by distance.
 * | name                | where | type   | meaning                                              |
 * | ------------------- | ----- | ------ | ---------------------------------------------------- |
 * | SkdFirstCellId      | point | idtype | Input's cell of the segment that starts at the point |
 * | SkdSecondCellId     | point | idtype | the other cell of it                                 |
 * | SkdFirstBlockIndex  | point | int    | flat index of the cell's block, of a composite Input |
 * | SkdSecondBlockIndex | point | int    | the same of a composite Source                       |
 * | SkdCurveClosed      | cell  | uchar  | 1 of a closed curve                                  |
 * | SkdCurveLength      | cell  | double | its length                                           |
 * A closed curve starts from the least of its points, by x, then y, then z, and goes to the lesser
 * of the two beside it; an open one starts from its lesser end. Its last point has the ids of the
 * last segment. A segment of several pairs (for example along an edge) is given once, with the
 * lowest ids. Segments within an area in which the surfaces coincide are not part of curves.
 *
 * Output port 1, vtkPolyData: a convex polygon for each pair of coplanar triangles that overlap,
 * with the ids above as cell data.
 *
 * Output port 2, vtkTable: a row for each pair of cells, ascending, with the ids above and
 * | name           | type   | components | meaning                                                |
 * | -------------- | ------ | ---------- | ------------------------------------------------------ |
 * | SkdContact     | int    | 1          | 3 an area, 2 a segment, 1 a point in common, 0 near    |
 * | SkdDistance    | double | 1          | 0, or of cells that are near only their distance       |
 * | SkdFirstPoint  | double | 3          | the least in common, or the nearest of the first cell  |
 * | SkdSecondPoint | double | 3          | the same of the second cell                            |
 *
 * Output port 3, vtkPolyData: with a Clearance a line between the nearest points of each pair of
 * cells that is near but does not touch, with the ids and SkdDistance as cell data.
 *
 * Output ports 4 and 5, vtkPolyData, with SplitSurfaces: the triangulated Input and (moved) Source,
 * split along their intersection; empty without a Source. Along curves and around overlaps both
 * have the same points, and no edge crosses a curve; where curves cross each other, all surfaces
 * have a point. Tests use exact signs and only positions are rounded, so very thin pieces may be
 * inverted. Adjacent cells remain adjacent. Where the surfaces coincide both keep their pieces.
 * Points of equal coordinates are merged, with the data of the first; new points have the
 * interpolated data of the split triangle, triangles the data of their cell. Vectors of a moved
 * Source are not rotated. Of several processes each then needs the whole of both surfaces, and
 * outputs its share of the result of one process.
 * | name          | where | type   | meaning                                                      |
 * | ------------- | ----- | ------ | ------------------------------------------------------------ |
 * | SkdCellId     | cell  | idtype | the cell that the triangle comes from                        |
 * | SkdBlockIndex | cell  | int    | flat index of the cell's block, of composite data            |
 * | SkdRegionId   | cell  | idtype | the same of triangles that are joined without passing curves |
 *
 * Field data of output port 0, one value each: SkdReportPairs (of cells), SkdReportCurves,
 * SkdReportOverlaps (polygons), SkdReportTriangles, SkdReportFacesLeftOut (with points that are not
 * finite, or with less than three different points), SkdReportTrianglesWithoutArea,
 * SkdReportInputTrianglesSplit and SkdReportSourceTrianglesSplit (with SplitSurfaces),
 * SkdReportTreesBuilt (surfaces whose tree was built or begun, 0 if all were reused),
 * SkdReportBuildSeconds, SkdReportQuerySeconds; and SkdReportChordalLength, the larger of both
 * surfaces' if there are curved cells (see SetChordalDeviation).
 *
 * Trees are reused while points and cells keep their values; moving the Source (Translation,
 * Rotation or SetTransform) requires no new tree. One-shot intersections use a packed R-tree of
 * those triangles only that share a cell of a coarse grid with the other surface; a whole tree is
 * built when a surface is searched again. The result does not depend on the number of threads. Of
 * several processes each computes the result for its piece of Input and gathers the whole Source,
 * or the cells near its piece (see SetSourceDistribution) of a Source that does not move, if
 * ALL_PAIRS are found and no surfaces split; of volume cells the cells near a face say whether it
 * is an outer one. Points of contact are identified by the coordinates of what they lie on, so that
 * pieces must have the same coordinates where they meet; processes compare those that several may
 * have: segments and points on borders are listed once, and a curve over several processes is
 * joined by the one that has its longest part. Ids are those of cells in the joined pieces. An
 * Input in pieces with volume cells is gathered, too, because cells of other pieces have the other
 * sides of faces at its borders, and so it is where surfaces are split or one pair is wanted.
 * Without a Source the first process computes all.
 *
 * Cost: O(n) to read, O(n log n) to build whole trees, O(k) typical for k pairs of overlapping
 * boxes.
 *
 * Bad input: degenerate triangles, whose vertices are collinear, and faces with points that are not
 * finite are ignored and counted. An Input or Source without faces gives a warning and empty
 * outputs. Coordinates smaller than 1e-80 times the largest are taken as 0, with a warning: the
 * tests would not be exact with them. Of more than 64 triangles with the same corners the first 64
 * are used, with a warning: all pairs of n copies would be n^2 / 2. Of an Input in pieces each
 * process counts its own.
 * An aborted execution gives the results found until then; VTK 9.3 and later then empties the
 * output.
 *
 * @sa
 * vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeSurfaceIntersection_h
#define vtkSkdTreeSurfaceIntersection_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeSurfaceIntersection : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeSurfaceIntersection, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeSurfaceIntersection* New();

  enum PairsWanted
  {
    ALL_PAIRS = 0,
    LOWEST_PAIR = 1,
    WHETHER_ANY = 2
  };

  //@{
  /**
   * The pairs to find: all; the lowest pair of cells only; or, fastest, any single pair, which may
   * differ from run to run. Default ALL_PAIRS.
   */
  vtkSkdTreeChoiceMacro(Pairs, ALL_PAIRS, WHETHER_ANY);
  void SetPairsToAll() { this->SetPairs(ALL_PAIRS); }
  void SetPairsToLowest() { this->SetPairs(LOWEST_PAIR); }
  void SetPairsToWhetherAny() { this->SetPairs(WHETHER_ANY); }
  //@}

  //@{
  /**
   * Output curves as polylines, with the ids of each segment at its first point. Off: a line cell
   * for each segment, with the ids as cell data and no SkdCurve arrays. A curve that goes on over
   * several processes is brought to one of them, which joins it. Default on.
   */
  vtkSkdTreeSwitchMacro(JoinCurves);
  //@}

  //@{
  /**
   * Output both surfaces split along the curves on ports 4 and 5. Requires all pairs: with other
   * values of Pairs nothing is split. Default off.
   */
  vtkSkdTreeSwitchMacro(SplitSurfaces);
  //@}

  //@{
  /**
   * Also output pairs of cells that do not touch but are at most this far apart, with their
   * distance and nearest points. Within one surface, cells that share a vertex are excluded.
   * Default 0: only pairs that touch.
   */
  vtkSkdTreeWithinMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * The largest distance of facets from a curved face, relative to the diagonal of the bounds of
   * its surface, Input or Source: see vtkSkdTreeFacetAlgorithm::SetChordalDeviation. Default 1e-4.
   */
  vtkSkdTreeWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  //@}

  //@{
  /**
   * A motion of the Source: rotated about RotationCenter by Rotation (degrees about y, then x, then
   * z, as the orientation of vtkProp3D) and translated by Translation. Default 0: not moved.
   * Ignored without a Source.
   */
  vtkSkdTreeFinite3Macro(Translation);
  vtkSkdTreeFinite3Macro(Rotation);
  vtkSkdTreeFinite3Macro(RotationCenter);
  //@}

  //@{
  /**
   * The same by a matrix, applied before the rotation and translation above. It must be rigid
   * (orthonormal to 1e-9, no perspective); any other is ignored with an error and the previous one
   * is kept. The values are copied. Default nullptr: none.
   */
  void SetTransform(vtkMatrix4x4* motion);
  vtkMatrix4x4* GetTransform();
  //@}

  /**
   * Finds out whether any process has volume cells of the Input: it is gathered then.
   */
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkSkdTreeSurfaceIntersection();
  ~vtkSkdTreeSurfaceIntersection() override;

  bool NeedsWhole(int port) override;
  bool NeedsNearbySource(skdtree::SkdSearchRange& range) override;
  bool ListsByInputCells() override { return true; }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Pairs = ALL_PAIRS;
  bool JoinCurves = true;
  bool SplitSurfaces = false;
  double Clearance = 0.0;
  double ChordalDeviation = 1e-4;
  double Translation[3] = { 0.0, 0.0, 0.0 };
  double Rotation[3] = { 0.0, 0.0, 0.0 };
  double RotationCenter[3] = { 0.0, 0.0, 0.0 };

private:
  vtkSkdTreeSurfaceIntersection(const vtkSkdTreeSurfaceIntersection&) = delete;
  void operator=(const vtkSkdTreeSurfaceIntersection&) = delete;

  bool IsSplitting() const;

  class Internals;
  std::unique_ptr<Internals> Impl; // the triangles with their trees, kept while they are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
