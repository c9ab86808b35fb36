// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeMeshAdaptation
 * @brief   moves the points of a mesh so that its cells follow data (r-adaptation)
 *
 * Moves the points of Input (port 0: triangles, quads, pixels and polygons of any vtkPointSet, or
 * composite of them), a mesh in a plane, on a sphere or on any other surface, so that cells become
 * small where a field of Source (port 1, any vtkDataSet or composite) asks for it. Cells stay what
 * they are: none is added or removed. The algorithm is that of section 6.6 of Khamayseh and Hansen,
 * Commun. Comput. Phys. 2 (2007) 545-576: (1) the field's positions go into a tree, once; (2) each
 * cell asks it for the positions that it truly contains; (3) and takes the mean of the values
 * there; (4) the points move by these means; (5) back to (2).
 *
 * Step 4 makes a monitor function m of the means (see SetMonitor) and looks for the mesh in which
 * the integral of m over each cell is the cell's share of it all: its share of the mesh's area as
 * it was given, or the same for all (see SetTargetSizes). So areas become proportional to 1 / m.
 * Points move along the gradient of a potential, in a plane straight, on a sphere along great
 * circles: of all meshes of equal shares this is the one whose points move least (optimal
 * transport). The potential solves the equation of Monge and Ampere for the cells as they are; its
 * error falls with the square of the cells' size. There the first iteration goes nearly all the
 * way: in the opposite problem, of cells with the monitor's integrals that are to have the areas of
 * before, the monitor does not change with the cells, so Newton's method solves it in few steps;
 * its answer is then inverted by Legendre's transform (McCann 2001). The other iterations are
 * Newton's steps for what discretization leaves. On other surfaces each step is along the gradient
 * of a potential.
 *
 * No cell is ever flipped or crosses itself: all corners of all cells are looked at in each
 * iteration, by exact signs, and where a cell would be spoilt its points go amid their neighbours,
 * along with them, or not as far. Points stay on the surface that they were on (see SetSurface), on
 * borders and creases (see SetBorders), at corners and on edges that three cells or more have.
 *
 * The measure of equidistribution is the coefficient of variation of the monitor's integral per
 * share, the root mean square of (m A / share - 1), weighted by shares; 0 is perfect. Iterations
 * end when it is at most Tolerance, when it has not fallen for eight iterations, or after
 * MaximumIterations. The output is the iteration where it was least.
 *
 * Cost: O(N) an iteration for N cells, by multigrid, and a query of the tree a cell. The answer
 * does not depend on the number of threads. Of several processes each finds all of it; the first
 * one has it.
 *
 * Output port 0: the input with its points moved (in double precision) and these arrays
 * | name            | of     | meaning                                                      |
 * | --------------- | ------ | ------------------------------------------------------------ |
 * | SkdDisplacement | points | where the point moved, less where it was; 3 components       |
 * | SkdFieldMean    | cells  | the field's mean in the cell, NaN where it has no value      |
 * | SkdMonitor      | cells  | the monitor there                                            |
 * | SkdArea         | cells  | the cell's area, on a sphere between great circles           |
 * | SkdAreaRatio    | cells  | the area by what it was at first                             |
 * (cell arrays are NaN of cells that do not move).
 *
 * Output port 1, vtkTable: a row an iteration, the first one the mesh as it was given:
 * SkdIteration, SkdEquidistributionError (the measure), SkdLargestDisplacement (of the step that
 * led there, in world units), SkdSmallestQuality (see SetMinimumQuality), SkdStep (which part of
 * Newton's step it was) and SkdPointsCutBack (that went less far, or elsewhere, for cells to stay
 * valid).
 *
 * Field data of output port 0, one value each: SkdReportIterations, SkdReportBestIteration,
 * SkdReportEquidistributionBefore, SkdReportEquidistributionAfter, SkdReportSmallestQuality,
 * SkdReportMovedCells, SkdReportSamples, SkdReportSeconds. With Monitor VALUE and one mesh of
 * triangles, quads, pixels and polygons as Source also SkdReportEquidistributionOfField: the same
 * measure for the field itself, integrated over the cells of the output (interpolated in Source's
 * cells, or the same all over each, raised by MaximumRatio, not smoothed), where the others go by
 * the means of the values that cells contain.
 *
 * Bad input: a mesh without surface cells, a Source without the field or with one that has no
 * finite value, and a monitor that is nowhere greater than 0 give an error or a warning, and the
 * input as it was. Where an error of more than 0.03 (and Tolerance) is left, a warning names the
 * cell that has most of it and what holds points back. Cells that hold no value take the nearest.
 * Cells of other types, broken ones and those that cross themselves give a warning; their points
 * stay.
 *
 * @sa
 * vtkSkdTreeRemap vtkSkdTreeMeshRefinement vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeMeshAdaptation_h
#define vtkSkdTreeMeshAdaptation_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr
#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeMeshAdaptation : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeMeshAdaptation, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeMeshAdaptation* New();

  //@{
  /**
   * The array of Source's points, else of its cells (then known at their middles), that is the
   * field; of several components their magnitude. Default "": the first array of numbers.
   */
  void SetFieldArray(const char* name);
  const char* GetFieldArray() const { return this->FieldArray.c_str(); }
  //@}

  enum CoordinatesType
  {
    AS_GIVEN = 0,
    LONGITUDE_LATITUDE = 1
  };

  //@{
  /**
   * What Source's coordinates are: AS_GIVEN (default), those of Input, or LONGITUDE_LATITUDE, x and
   * y in degrees on the sphere that Input is on, north at positive z.
   */
  vtkSkdTreeChoiceMacro(SourceCoordinates, AS_GIVEN, LONGITUDE_LATITUDE);
  //@}

  enum SampleWeightsType
  {
    AUTOMATIC_WEIGHTS = 0,
    EQUAL = 1,
    COSINE_OF_LATITUDE = 2
  };

  //@{
  /**
   * What each value of Source counts in a mean: EQUAL, the same, or COSINE_OF_LATITUDE, the area
   * that it stands for in a grid of longitudes and latitudes, which has as many values near the
   * poles as elsewhere. AUTOMATIC_WEIGHTS (default): by the cosine where SourceCoordinates are
   * LONGITUDE_LATITUDE, or a structured Source lies around the sphere that Input is on, else equal.
   */
  vtkSkdTreeChoiceMacro(SampleWeights, AUTOMATIC_WEIGHTS, COSINE_OF_LATITUDE);
  //@}

  enum MonitorType
  {
    ARC_LENGTH = 0,
    GRADIENT = 1,
    VALUE = 2
  };

  //@{
  /**
   * The monitor function: ARC_LENGTH (default), sqrt(1 + Strength g^2), GRADIENT, 1 + Strength g,
   * or VALUE, the field itself, which should be greater than 0. g is the length of the field's
   * gradient along the surface, relative to its mean over the mesh as it was given.
   */
  vtkSkdTreeChoiceMacro(Monitor, ARC_LENGTH, VALUE);
  //@}

  //@{
  /**
   * See SetMonitor. 0 and more, default 10: 0 moves nothing, larger values make cells differ more.
   */
  vtkSkdTreeWithinMacro(Strength, double, 0.0, 1e6);
  //@}

  //@{
  /**
   * How many times the monitor is smoothed: each cell takes half of its value from its neighbours.
   * 0 to 100, default 4. What a field has at the scale of single cells changes with every move.
   */
  vtkSetClampMacro(Smoothing, int, 0, 100);
  vtkGetMacro(Smoothing, int);
  //@}

  //@{
  /**
   * The largest ratio of the monitor's values: smaller ones are raised. It limits how much areas
   * differ. 1 and more, default 100.
   */
  vtkSkdTreeWithinMacro(MaximumRatio, double, 1.0, 1e9);
  //@}

  enum SurfaceType
  {
    AUTOMATIC_SURFACE = 0,
    PLANE = 1,
    SPHERE = 2,
    INPUT_SURFACE = 3
  };

  //@{
  /**
   * What points stay on: PLANE, SPHERE (their distance to its centre is kept), INPUT_SURFACE, the
   * nearest point of the mesh as it was given, or AUTOMATIC_SURFACE (default), the first of these
   * that all points are on, to a part in 10^6 (planes) or 10^5 (spheres).
   */
  vtkSkdTreeChoiceMacro(Surface, AUTOMATIC_SURFACE, INPUT_SURFACE);
  //@}

  enum BordersType
  {
    SLIDE = 0,
    STAY = 1
  };

  //@{
  /**
   * Whether points of borders SLIDE along them (default) or STAY. Corners stay, see FeatureAngle.
   */
  vtkSkdTreeChoiceMacro(Borders, SLIDE, STAY);
  //@}

  //@{
  /**
   * A border or crease that turns by more has a corner, and cells whose normals differ by more meet
   * in a crease, which points slide along like a border. Degrees, 0 to 180, default 40.
   */
  vtkSkdTreeWithinMacro(FeatureAngle, double, 0.0, 180.0);
  //@}

  enum TargetSizesType
  {
    RELATIVE_TO_INPUT = 0,
    UNIFORM = 1
  };

  //@{
  /**
   * What areas would be for a monitor that is the same everywhere: RELATIVE_TO_INPUT (default), as
   * they are in Input, or UNIFORM, all the same.
   */
  vtkSkdTreeChoiceMacro(TargetSizes, RELATIVE_TO_INPUT, UNIFORM);
  //@}

  //@{
  /**
   * The number of iterations, at most. 0 to 10000, default 50. With 0
   * nothing moves, and the means and the monitor are told.
   */
  vtkSetClampMacro(MaximumIterations, int, 0, 10000);
  vtkGetMacro(MaximumIterations, int);
  //@}

  //@{
  /**
   * The measure of equidistribution that is small enough (see above). Default 0.01.
   */
  vtkSkdTreeWithinMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * Which part of Newton's step is made in each iteration. 0.01 to 1, default 0.5: 1 is faster for
   * smooth fields, less is better for those that are rough at the scale of cells.
   */
  vtkSkdTreeWithinMacro(Relaxation, double, 0.01, 1.0);
  //@}

  //@{
  /**
   * The quality that no cell falls below (but those below 0.5 at first, twice that part of it): the
   * least sine of its corners relative to that of the regular polygon, 1 of a regular cell, 0 of
   * one with a flat corner. 0 to 0.9, default 0.02: a
   * larger one may keep irregular meshes, whose cells are far from regular at first, from reaching
   * equal shares.
   */
  vtkSkdTreeWithinMacro(MinimumQuality, double, 0.0, 0.9);
  //@}

  //@{
  /**
   * Offer the iterations as time steps: time 0 is the mesh as it was given, time k the mesh after k
   * iterations, times after the last the last. Else the output is the best iteration. Default off.
   */
  vtkSkdTreeSwitchMacro(AnimateIterations);
  //@}

protected:
  vtkSkdTreeMeshAdaptation();
  ~vtkSkdTreeMeshAdaptation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::string FieldArray;
  int SourceCoordinates = AS_GIVEN;
  int SampleWeights = AUTOMATIC_WEIGHTS;
  int Monitor = ARC_LENGTH;
  double Strength = 10.0;
  int Smoothing = 4;
  double MaximumRatio = 100.0;
  int Surface = AUTOMATIC_SURFACE;
  int Borders = SLIDE;
  double FeatureAngle = 40.0;
  int TargetSizes = RELATIVE_TO_INPUT;
  int MaximumIterations = 50;
  double Tolerance = 0.01;
  double Relaxation = 0.5;
  double MinimumQuality = 0.02;
  bool AnimateIterations = false;

private:
  vtkSkdTreeMeshAdaptation(const vtkSkdTreeMeshAdaptation&) = delete;
  void operator=(const vtkSkdTreeMeshAdaptation&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the iterations, kept for an animation
};

VTK_ABI_NAMESPACE_END
#endif
