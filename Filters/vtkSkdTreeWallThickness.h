// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeWallThickness
 * @brief   how thick a body is at each point or cell of its surface
 *
 * Measures at each point or cell centre of Input (port 0, a closed surface whose normals point
 * outwards, or a body of volume cells: any vtkDataSet or composite) how far the opposite side of
 * the body is, by the skD-tree (Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576). The
 * optional Source (port 1) is the surface to measure against; without it, it is Input itself with
 * all its blocks.
 *
 * - RAYS: along the inverted normal or, with NumberOfRays, the median over a cone of rays about it:
 *   the shape diameter function of L. Shapira, A. Shamir, D. Cohen-Or, The Visual Computer 24
 *   (2008) 249-259. Without a Source a ray ends where it leaves the body: where the winding number
 *   of the surface returns to 0, also through shells that overlap. Of a surface with open edges the
 *   generalized winding number at the start is rounded, and at least 1.
 * - SPHERES: the diameter of the largest sphere within the body that touches the surface there, by
 *   the shrinking ball of J. Ma, S. W. Bae, S. Choi, The Visual Computer 28 (2012) 7-19, with the
 *   exact nearest point of all cells: the sphere overlaps nothing but facets next to the point (see
 *   SeparationAngle). Where a quarter of more than 8192 cells is about equally near to the centres
 *   of many spheres, as in a ball, nearest points are those of points of a lattice, and spheres
 *   may extend through the surface by 0.002 of their radius. Faces within the body, of shells that
 *   overlap, bound spheres, too. Never larger than by one ray to the first face.
 *
 * Normals are the active ones of the points or cells or, without them, those of the surface cells
 * or of the outer faces of volume cells, at points their mean weighted by angles. Points and
 * normals of curved faces are those of the faces themselves: for a control point of a Bezier cell
 * stands the point of the face at its parameters, for the centre of a curved cell that in the
 * middle of its parameters. What is measured against is the outer faces of volume cells, of curved
 * ones as flat facets within 1e-4 of the diagonal. AMR data, and the pieces of a
 * vtkPartitionedDataSet, are one mesh: faces between its blocks or pieces are no outer ones, and
 * normals at points (unless it has curved cells) are those of all pieces there.
 *
 * Output: the input with the point arrays or, at cell centres, cell arrays
 * | name                  | type   | components | meaning                              | none |
 * | --------------------- | ------ | ---------- | ------------------------------------ | ---- |
 * | SkdThickness          | double | 1          | thickness                            | NaN  |
 * | SkdOppositePoint      | double | 3          | the end of the ray, or where the     | NaN  |
 * |                       |        |            | sphere touches the opposite side     |      |
 * | SkdOppositeCellId     | idtype | 1          | its cell, of several the lowest id   | -1   |
 * | SkdOppositeBlockIndex | int    | 1          | flat index of its block              | -1   |
 * (the last one only if what is measured against is composite). SkdThickness becomes the active
 * scalars. The answer does not depend on the number of threads or processes.
 * After an abort the remaining points have none.
 *
 * Several processes: the first gathers and outputs all, because normals at points, and what the
 * Input itself bounds, depend on all pieces. With a Source and at cell centers each has its own
 * piece of the Input and gathers the Source or, of RAYS with SOURCE_EXCHANGED, sends the rays to
 * the processes whose pieces they may hit, and gets the cells there; a Source with volume cells is
 * gathered nevertheless.
 *
 * Field data, one value each: SkdReportPoints, SkdReportPointsFound (with a thickness),
 * SkdReportEpsilon, SkdReportTreesBuilt (0 if all were reused), SkdReportBuildSeconds,
 * SkdReportQuerySeconds, and SkdReportRaysSent, how often this process sent a ray to another, if
 * the Source stayed in its pieces.
 *
 * Bad input: one warning counts the points that have no thickness because nothing is opposite (the
 * surface is open, or its normals point inwards: see Reversed), and because they have no normal or
 * are not finite. Points within a mesh of volume cells have none without a warning. Active normals
 * that are not as many as the points or cells are an error. An Input without points gives an output
 * without points.
 *
 * @sa
 * vtkSkdTreeRays vtkSkdTreeClosestPoint
 */

#ifndef vtkSkdTreeWallThickness_h
#define vtkSkdTreeWallThickness_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeWallThickness : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeWallThickness, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeWallThickness* New();

  /**
   * See SetStart.
   */
  enum Starts
  {
    POINTS = 0,
    CELL_CENTERS = 1
  };

  //@{
  /**
   * Where thickness is measured: at points, or at the centres of cells (the mean of their points,
   * of curved surface cells the middle of their parameters).
   * Default POINTS.
   */
  vtkSkdTreeChoiceMacro(Start, POINTS, CELL_CENTERS);
  void SetStartToPoints() { this->SetStart(POINTS); }
  void SetStartToCellCenters() { this->SetStart(CELL_CENTERS); }
  //@}

  /**
   * See SetMethod.
   */
  enum Methods
  {
    RAYS = 0,
    SPHERES = 1
  };

  //@{
  /**
   * What thickness is: see the description of the class. Default RAYS.
   */
  vtkSkdTreeChoiceMacro(Method, RAYS, SPHERES);
  void SetMethodToRays() { this->SetMethod(RAYS); }
  void SetMethodToSpheres() { this->SetMethod(SPHERES); }
  //@}

  //@{
  /**
   * For RAYS: how many there are, evenly over the solid angle of the cone, the first along its
   * axis; of an even number of hits the lower of the two in the middle counts. Default 1: the
   * inverted normal alone.
   */
  vtkSkdTreeWithinMacro(NumberOfRays, int, 1, 1000);
  //@}

  //@{
  /**
   * For several RAYS: the angle between the cone's axis and its side, in degrees. Default 60.
   */
  vtkSkdTreeWithinMacro(ConeAngle, double, 0.0, 89.0);
  //@}

  //@{
  /**
   * For SPHERES: points of the surface that the sphere's centre sees at less than this angle, in
   * degrees, from the point do not bound it. They are on facets next to the point, which, however
   * fine, leave a sphere no room at a convex edge. Default 60; a body with flatter edges than this
   * is measured as if they were smooth.
   */
  vtkSkdTreeWithinMacro(SeparationAngle, double, 0.0, 180.0);
  //@}

  //@{
  /**
   * Measure along the normals, for surfaces whose normals point inwards. Default off.
   */
  vtkSkdTreeSwitchMacro(Reversed);
  //@}

  //@{
  /**
   * Nothing thicker is found. Default VTK_DOUBLE_MAX: no limit.
   */
  vtkSkdTreeWithinMacro(MaximumThickness, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * What is at most this far from the point is not opposite to it. Relative to the diagonal of the
   * bounds of the surface measured against, and at least 8 units in the last place of the largest
   * coordinate. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Tolerance, double, 0.0, 1.0);
  //@}

  //@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Epsilon, double, 0.0, 1.0);
  //@}

protected:
  vtkSkdTreeWallThickness();
  ~vtkSkdTreeWallThickness() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Normals of points may depend on cells of other pieces.
  bool NeedsWhole(int port) override;
  bool CanAskPieces(int port) override;

  int Start = POINTS;
  int Method = RAYS;
  int NumberOfRays = 1;
  double ConeAngle = 60.0;
  double SeparationAngle = 60.0;
  bool Reversed = false;
  double MaximumThickness = VTK_DOUBLE_MAX;
  double Tolerance = 1e-9;
  double Epsilon = 1e-9;

private:
  vtkSkdTreeWallThickness(const vtkSkdTreeWallThickness&) = delete;
  void operator=(const vtkSkdTreeWallThickness&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the trees, kept while the surface is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
