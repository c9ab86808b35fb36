// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSurfaceIntersection
 * @brief   where one surface meets another, or itself
 *
 * Finds all pairs of cells of Input (port 0) and Source (port 1) that touch, the curves along which
 * they meet and the areas in which they coincide, by walking the skD-trees of both together
 * (section 5.4 of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576). Without a Source:
 * Input against itself. Any vtkDataSet or composite of them: its surface cells, and the outer faces
 * of its volume cells. Cells with more than three points are cut into triangles without new points
 * (a quad along the shorter of the diagonals inside of it).
 *
 * Exact signs decide: there is no tolerance, and the answer is right for surfaces that coincide,
 * touch, graze or lie far from the origin (points as given; of a moved Source, points as moved and
 * rounded). Cells touch when they have a point in common, boundaries included. Within one surface,
 * two triangles that share a corner or an edge by the coordinates of its ends make a pair only if
 * they have more than that in common: neighbours of a sound surface are left out, folds, repeated
 * cells and crossings at a corner are not. Positions are right to a few units in the last place.
 *
 * Output port 0, vtkPolyData: the curves, as polylines that end only where other than two segments
 * meet (see JoinCurves), and as vertices single points of contact. Points are joined by what they
 * lie on, never by distance.
 * | name                | where | type   | meaning                                              |
 * | ------------------- | ----- | ------ | ---------------------------------------------------- |
 * | SkdFirstCellId      | point | idtype | Input's cell of the segment that starts at the point |
 * | SkdSecondCellId     | point | idtype | the other cell of it                                 |
 * | SkdFirstBlockIndex  | point | int    | flat index of the cell's block, of a composite Input |
 * | SkdSecondBlockIndex | point | int    | the same of a composite Source                       |
 * | SkdCurveClosed      | cell  | uchar  | 1 of a closed curve                                  |
 * | SkdCurveLength      | cell  | double | its length                                           |
 * The last point of an open curve has the ids of the last segment. A segment of several pairs
 * (along an edge, say) is there once, of the lowest ids. Segments inside of an area in which the
 * surfaces coincide are no curves.
 *
 * Output port 1, vtkPolyData: where cells of one plane overlap, a convex polygon for each pair of
 * triangles, with the ids above as cell data.
 *
 * Output port 2, vtkTable: a row for each pair of cells, ascending, with the ids above and
 * | name           | type   | components | meaning                                                |
 * | -------------- | ------ | ---------- | ------------------------------------------------------ |
 * | SkdContact     | int    | 1          | 3 an area, 2 a segment, 1 a point in common, 0 near    |
 * | SkdDistance    | double | 1          | 0, or of cells that are near only their distance       |
 * | SkdFirstPoint  | double | 3          | a point in common, or the nearest of the first cell    |
 * | SkdSecondPoint | double | 3          | the same of the second cell                            |
 *
 * Output port 3, vtkPolyData: with a Clearance a line between the nearest points of each pair of
 * cells that is near but does not touch, with the ids and SkdDistance as cell data.
 *
 * Output ports 4 and 5, vtkPolyData, with SplitSurfaces: the Input and the Source (where it is
 * looked at) as triangles, those that meet others cut along what they have in common; of a Source
 * that is not given nothing. Along curves and around overlaps the two have the same points, and no
 * edge crosses a curve: where curves cross each other, too, there is a point of all surfaces. Exact
 * signs decide; only the positions are rounded, so pieces that are thinner than that may turn over.
 * Neighbours stay neighbours. Where the surfaces coincide both keep their pieces. Points of equal
 * coordinates are one, with the data of the first; new points have the data of the cut triangle at
 * their place, triangles that of their cell. Vectors of a moved Source are passed on unturned.
 * Of several processes each asks for the whole of both surfaces then, and gives of all outputs its
 * share of what one process would.
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
 * SkdReportTreesBuilt (surfaces whose tree was begun, 0 when all were kept), SkdReportBuildSeconds,
 * SkdReportQuerySeconds; and SkdReportChordalLength, the larger of both surfaces' where there are
 * curved cells (see SetChordalDeviation).
 *
 * The trees are kept while points and cells stay the same; moving the Source (Translation, Rotation
 * or SetTransform) builds none. A tree is built as far as it is asked: when two surfaces meet for
 * the first time, of those triangles only that share a cell of a coarse grid with the other
 * surface, and of the others when a surface is asked again. The answer is the same whatever the
 * number of threads. Of several processes each answers for its piece of Input and asks for the
 * whole Source; without a Source the first process answers.
 *
 * Cost: O(n) to read, O(n log n) to build whole trees, O(k) typical for k pairs of overlapping
 * boxes.
 *
 * Bad input: triangles whose corners lie on one line have no inside and are left out, as are faces
 * with points that are not finite; they are counted. An Input without faces gives empty outputs and
 * a warning, a Source without faces too. Exact as long as coordinates, unless 0, span less than 80
 * orders of magnitude. An execution that is aborted tells of what it found until then; VTK 9.3 and
 * later then empties the output.
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

  ///@{
  /**
   * What to find: all pairs; the lowest pair of cells only; or, fastest, just whether there is any:
   * then one pair is given, and not always the same. Default ALL_PAIRS.
   */
  vtkSetClampMacro(Pairs, int, ALL_PAIRS, WHETHER_ANY);
  vtkGetMacro(Pairs, int);
  void SetPairsToAll() { this->SetPairs(ALL_PAIRS); }
  void SetPairsToLowest() { this->SetPairs(LOWEST_PAIR); }
  void SetPairsToWhetherAny() { this->SetPairs(WHETHER_ANY); }
  ///@}

  ///@{
  /**
   * Give curves as polylines, with the ids of each segment at the point that it starts from. Off: a
   * line cell for each segment, with the ids as cell data and no SkdCurve arrays. Default on.
   */
  vtkSetMacro(JoinCurves, bool);
  vtkGetMacro(JoinCurves, bool);
  vtkBooleanMacro(JoinCurves, bool);
  ///@}

  ///@{
  /**
   * Give both surfaces cut along the curves, as output ports 4 and 5. Takes all pairs: with Pairs
   * set otherwise nothing is cut. Default off.
   */
  vtkSetMacro(SplitSurfaces, bool);
  vtkGetMacro(SplitSurfaces, bool);
  vtkBooleanMacro(SplitSurfaces, bool);
  ///@}

  ///@{
  /**
   * Pairs that are at most this far apart are given, too, with their distance and nearest points.
   * Within one surface no pairs of cells that share a corner. Default 0: pairs that touch, only.
   */
  vtkSkdTreeSetWithinMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * The largest distance of facets from a curved face, relative to the diagonal of the bounds of
   * the surface that it is of, Input or Source: see vtkSkdTreePointInOut::SetChordalDeviation.
   * Default 1e-4.
   */
  vtkSkdTreeSetWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  vtkGetMacro(ChordalDeviation, double);
  ///@}

  ///@{
  /**
   * Where the Source is looked at: turned about RotationCenter by Rotation (degrees about y, then
   * x, then z, as vtkProp3D's orientation) and shifted by Translation. Default 0: where it is.
   * Without a Source they do nothing.
   */
  vtkSkdTreeSetFinite3Macro(Translation);
  vtkGetVector3Macro(Translation, double);
  vtkSkdTreeSetFinite3Macro(Rotation);
  vtkGetVector3Macro(Rotation, double);
  vtkSkdTreeSetFinite3Macro(RotationCenter);
  vtkGetVector3Macro(RotationCenter, double);
  ///@}

  ///@{
  /**
   * The same by a matrix, done before the turn and the shift above. It must keep distances
   * (orthonormal to 1e-9, no perspective): any other is refused with an error and the former stays.
   * The values are copied. Default nullptr: none.
   */
  void SetTransform(vtkMatrix4x4* motion);
  vtkMatrix4x4* GetTransform();
  ///@}

protected:
  vtkSkdTreeSurfaceIntersection();
  ~vtkSkdTreeSurfaceIntersection() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

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
