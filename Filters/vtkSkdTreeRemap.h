// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeRemap
 * @brief   fields from one mesh to another that has nothing to do with it
 *
 * Maps the point and cell data of Source (the donor, port 1, any vtkDataSet or composite of them)
 * onto the mesh Input (the target, port 0, any vtkDataSet or composite): section 6.6 of Khamayseh
 * and Hansen, Commun. Comput. Phys. 2 (2007) 545-576. See SetMethod for how. Arrays become arrays
 * of double of the same name; NaN where there is no answer.
 *
 * Meshes are curves, surfaces in a plane, surfaces on a sphere about the origin, volumes, or curved
 * surfaces that nearly coincide, see SetGeometry. On a sphere edges are arcs of great circles or,
 * by choice, run along meridians and parallels; poles and the date line are ordinary; points count
 * by their directions. A polygon is the smaller of the two parts that its edges divide the sphere
 * into: any simple one up to a hemisphere. One larger than an eighth of the sphere that is ordered
 * the other way round than the mesh's cells are (clockwise, seen from outside, if it is the only
 * one) is larger than a hemisphere: it has no part in it, with a warning that names it.
 *
 * Results are the same to the last bit whatever the number of threads. Overlaps, trees and
 * gradients' stencils are kept while both meshes' points and cells are the same, so that further
 * time steps only cost the sums. Each process gathers the whole Source, or with
 * SetSourceDistribution the cells near its piece of Input, of spheres by directions from the
 * origin, and those of its own piece; it gathers a Source that has blocks, for files of weights,
 * INVERSE_DISTANCE, ENCLOSING_BOX of CONTAINED, and interpolation on a sphere, samples (points or
 * middles of cells) if points are of no cell, and the nearest of them if values are missing. Cells
 * of the Source have the ids of the whole in the weights and overlaps; integrals, what of a curved
 * surface is covered, and the radius of a sphere are summed up over processes, in one order. Counts
 * in the report are of its piece of Input, integrals and coverage of all processes together, of
 * cells of Input that several have once.
 * Results on points that are not interpolated depend on all cells around them: the first process
 * then has all.
 *
 * Output port 0: the input with the source's arrays and these
 * | name        | of     | type   | meaning                                              |
 * | ----------- | ------ | ------ | ---------------------------------------------------- |
 * | SkdValid    | either | uchar  | 1 where there is an answer                           |
 * | SkdCoverage | cells  | double | share of the cell covered by Source; conservative    |
 * | SkdFraction | cells  | double | the same by source cells that MaskArray lets count:  |
 * |             |        |        | frac_b of ESMF; conservative                         |
 * | SkdCount    | cells  | idtype | source points, or cells' middles, in it; contained   |
 * and with interpolation those of vtkSkdTreeProbe.
 *
 * Output port 1, vtkTable, with GenerateWeights: a row an overlap: Row and Column (cells of Input
 * and of Source), Weight (by which the source's average counts), Measure (length, area or volume),
 * Moment (the integral of x less the source cell's centroid), RowBlockIndex (of a composite Input).
 * Of a composite Source, Column counts on from block to block.
 *
 * Output port 2, with GenerateOverlapMesh: the overlaps as cells with the cell arrays TargetCell,
 * DonorCell and Measure; blocks where Input is composite. Of curved surfaces they are in the planes
 * of the source's cells, and where Input has folds as they were before they were shared out.
 *
 * Field data of output port 0: SkdReportSourceCells, SkdReportInputCells, SkdReportInputCellsEmpty
 * (without an answer), SkdReportInputCellsPartlyCovered, SkdReportOverlaps, SkdReportWeightsFound
 * (blocks whose overlaps were not kept), SkdReportSeconds; and, of what was mapped conservatively,
 * a value for each component of each array: SkdReportArray (its name), SkdReportSourceIntegral
 * (over Source), SkdReportOverlapIntegral (over what of it Input covers), SkdReportTargetIntegral,
 * SkdReportConservationError (the difference of the last two, relative to the integral of the
 * source's absolute values) and SkdReportCoverage (share of Input that is covered). Of curved
 * surfaces also SkdReportSurfaceGap (the largest distance of facets that have to do with each
 * other) and SkdReportSourceCoverage (the share of Source's area that is handed out).
 *
 * Bad input: arrays of strings are left out, by name, with a warning, as those are whose name is in
 * use if RenameTakenArrays is off; arrays with infinite values, or of which nothing counts, are
 * named. Meshes that have nothing in common, cells of another dimension, degenerate ones (these
 * have no part in it), polygons that cross themselves, cells of one mesh that overlap each other (a
 * coverage above one), and of curved surfaces what has no partner, are warned of, with their
 * number. Concave cells are cut into convex ones. Cells with points that are not finite count as
 * empty.
 *
 * @sa
 * vtkSkdTreeProbe vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeRemap_h
#define vtkSkdTreeRemap_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr
#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeRemap : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeRemap, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeRemap* New();

  enum MethodType
  {
    AUTOMATIC_METHOD = 0,
    CONTAINED = 1,
    INTERPOLATION = 2,
    CONSERVATIVE_FIRST_ORDER = 3,
    CONSERVATIVE_SECOND_ORDER = 4,
    WEIGHTS_FROM_FILE = 5
  };

  //@{
  /**
   * How fields are mapped.
   * CONTAINED: a statistic of the source's points (of its cells the middles) that a target cell
   * truly contains, not those in its box.
   * INTERPOLATION: the source's data at target points or cell centres, see vtkSkdTreeProbe.
   * CONSERVATIVE_FIRST_ORDER: averages over target cells by the exact overlaps of both meshes'
   * cells: integrals are kept, and of cell data bounds. Point data are integrated exactly, as
   * linear between the points. A warped face is the triangles of its edges and the mean of its
   * corners. A curved side is cut into 8 parts along each parameter, whichever cell has it; the
   * field is linear on the pieces of curved cells, with the values of the cell's own functions on
   * its sides and the same integral over the cell (of what is quadratic on each piece).
   * CONSERVATIVE_SECOND_ORDER: the same with a gradient in each source cell, see SetLimiter.
   * WEIGHTS_FROM_FILE: sums by the weights of a file, see SetAppliedWeightsFileName.
   * AUTOMATIC_METHOD (default): cell data conservatively, of first order, and point data by
   * interpolation; where cells of Input and Source are not of one dimension, or surfaces are in no
   * common plane or sphere, all by interpolation.
   */
  vtkSkdTreeChoiceMacro(Method, AUTOMATIC_METHOD, WEIGHTS_FROM_FILE);
  //@}

  enum ResultsOnType
  {
    AUTOMATIC_RESULTS = 0,
    CELLS = 1,
    POINTS = 2
  };

  //@{
  /**
   * What of Input gets the results: of interpolation its points (AUTOMATIC_RESULTS, default) or its
   * cells, at their centres; of the other methods its cells, or by lumped masses its points: each
   * cell gives equal shares of its measure (or, CONTAINED, of one) to its corners, and a point has
   * the mean by these.
   */
  vtkSkdTreeChoiceMacro(ResultsOn, AUTOMATIC_RESULTS, POINTS);
  //@}

  enum GeometryType
  {
    AUTOMATIC_GEOMETRY = 0,
    LINE = 1,
    PLANE = 2,
    SPHERE = 3,
    VOLUME = 4,
    CURVED_SURFACE = 5
  };

  //@{
  /**
   * What the meshes are parts of. AUTOMATIC_GEOMETRY (default) goes by the highest dimension of
   * Input's cells; surfaces are on a sphere if all points of both meshes are equally far from the
   * origin, to a part in 10^5. CURVED_SURFACE: two surfaces in space that nearly coincide, say of a
   * fluid and of the structure in it; CONSERVATIVE_FIRST_ORDER and CONSERVATIVE_SECOND_ORDER take
   * surfaces in no common plane or sphere as such. Cells of Input are projected onto each cell of
   * Source along its normal: as one projection takes all of them, the source cell hands out its own
   * area, all of it where it is covered. One that is covered in part (at a border of Input, beside
   * a sharp edge, or where Input is farther than SurfaceDistance) hands out that part only: its
   * rest is missing in the integral over Input, and a warning counts such cells and tells what of
   * Source's area they leave. Overlaps are measured on Source. So with COVERED constants
   * stay, and the integral is kept over the areas handed out; with WHOLE the integral over Input's
   * own areas is that over Source, and constants change as areas do, by the square of the cells'
   * size. Where Input has folds a source cell's area is shared out among them. Warped polygons are
   * the triangles of their edges and the mean of their corners. Normals of both meshes must be
   * alike or opposite throughout, so that the sides of a thin plate are told apart; which of these
   * the meshes tell themselves, and it is warned of if they do not, as of what has no partner.
   */
  vtkSkdTreeChoiceMacro(Geometry, AUTOMATIC_GEOMETRY, CURVED_SURFACE);
  //@}

  //@{
  /**
   * Of curved surfaces, how far facets of Input and Source that have to do with each other may be
   * apart (0, the default: half the diameter of the larger one; in the mean over the overlap, along
   * the normal), and by how many degrees their normals may differ (range [1, 90], default 90).
   */
  vtkSkdTreeWithinMacro(SurfaceDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkSkdTreeWithinMacro(SurfaceAngle, double, 1.0, 90.0);
  //@}

  enum CoordinatesType
  {
    AS_GIVEN = 0,
    LONGITUDE_LATITUDE = 1
  };

  //@{
  /**
   * Whether the source's points are Cartesian (AS_GIVEN, default) or longitude and latitude in
   * degrees (x and y; z does not count), which are then moved to Input's sphere.
   */
  vtkSkdTreeChoiceMacro(SourceCoordinates, AS_GIVEN, LONGITUDE_LATITUDE);
  //@}

  //@{
  /**
   * The same of Input's points: cells are mapped on the sphere that Source is on (of radius 1 if it
   * is on none, too), and the output has Input's own points. Cells between meridians and parallels
   * need InputEdgesAlongParallels to be taken as such. Default AS_GIVEN.
   */
  vtkSkdTreeChoiceMacro(InputCoordinates, AS_GIVEN, LONGITUDE_LATITUDE);
  //@}

  //@{
  /**
   * On a sphere, whether cells whose corners lie on two meridians and two parallels are bounded by
   * these instead of by great circles. Of conservative methods, and of Input's cells with
   * CONTAINED. Default off.
   */
  vtkSkdTreeSwitchMacro(SourceEdgesAlongParallels);
  vtkSkdTreeSwitchMacro(InputEdgesAlongParallels);
  //@}

  enum StatisticType
  {
    MEAN = 0,
    MINIMUM = 1,
    MAXIMUM = 2,
    SUM = 3,
    STANDARD_DEVIATION = 4,
    MEDIAN = 5
  };

  //@{
  /**
   * What CONTAINED makes of the values in a cell. The array SkdCount has their number. The standard
   * deviation is that of the values there are, not an estimate. Default MEAN.
   */
  vtkSkdTreeChoiceMacro(Statistic, MEAN, MEDIAN);
  //@}

  enum SampleWeightsType
  {
    AUTOMATIC_WEIGHTS = 0,
    EQUAL = 1,
    COSINE_OF_LATITUDE = 2
  };

  //@{
  /**
   * What values of CONTAINED weigh in means, standard deviations and medians. Grids of longitude
   * and latitude have as many values near the poles as elsewhere: with EQUAL weights means are
   * drawn towards them. AUTOMATIC_WEIGHTS (default): COSINE_OF_LATITUDE where a structured source
   * is on a sphere, else EQUAL.
   */
  vtkSkdTreeChoiceMacro(SampleWeights, AUTOMATIC_WEIGHTS, COSINE_OF_LATITUDE);
  //@}

  enum EmptyCellsType
  {
    LEAVE = 0,
    NEAREST = 1,
    ENCLOSING_BOX = 2
  };

  //@{
  /**
   * What cells without a value (CONTAINED), or points that no source cell holds (INTERPOLATION),
   * get: LEAVE gives NaN; NEAREST (default) the value nearest to the mean of the cell's corners, or
   * the data of the nearest cell; ENCLOSING_BOX the statistic in the cell's box, grown twofold
   * until there are values (of INTERPOLATION the same as NEAREST). SkdValid is 0 for cells all the
   * same. A SUM over an empty cell is 0. Conservative methods leave cells that are not covered.
   */
  vtkSkdTreeChoiceMacro(EmptyCells, LEAVE, ENCLOSING_BOX);
  //@}

  enum ExtrapolationType
  {
    NO_EXTRAPOLATION = 0,
    NEAREST_VALUE = 1,
    CONSTANT_VALUE = 2,
    INVERSE_DISTANCE = 3
  };

  //@{
  /**
   * What cells get that conservative methods or the weights of a file leave without a value, since
   * Source, or what of it counts, is not there: NO_EXTRAPOLATION (default), NaN; NEAREST_VALUE, the
   * value of the nearest source cell or point; CONSTANT_VALUE, ExtrapolationConstant;
   * INVERSE_DISTANCE, the mean of the nearest ExtrapolationNeighbors (range [1, 1000], default 8)
   * by the inverse squares of their distances, as ESMF does. From middle to middle of cells.
   * Vectors are taken by components. Amounts (AddExtensiveArray) are not extrapolated. SkdValid is
   * 0 there all the same, and nothing is added to integrals. Other methods have EmptyCells.
   */
  vtkSkdTreeChoiceMacro(Extrapolation, NO_EXTRAPOLATION, INVERSE_DISTANCE);
  vtkSkdTreeWithinMacro(ExtrapolationConstant, double, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
  vtkSkdTreeWithinMacro(ExtrapolationNeighbors, int, 1, 1000);
  //@}

  enum LimiterType
  {
    NO_LIMITER = 0,
    BARTH_JESPERSEN = 1,
    CLIP_AND_ASSURED_SUM = 2
  };

  //@{
  /**
   * How results of CONSERVATIVE_SECOND_ORDER are kept within the averages that there are. "Around a
   * cell" is the cell and all that share a corner with it.
   * NO_LIMITER: gradients are those of the least squares fit, exact for linear fields.
   * BARTH_JESPERSEN (default): gradients are shortened until no source cell's field leaves what the
   * averages around it are between, at its corners and in the mean over any overlap; extremes of
   * smooth fields lose by it. On a sphere shortened gradients are along it.
   * CLIP_AND_ASSURED_SUM: gradients are as without a limiter. Results beyond the averages around
   * the source cells that they are made of are clipped, and what that takes from the integral over
   * Input, or adds to it, is shared out among the results by the room that they have
   * (A. M. Bradley et al., SIAM J. Sci. Comput. 41, 2019). Sharper where fields jump. Gradients of
   * source cells that are covered in part are limited as above, so that there is enough room. All
   * blocks, and the parts of all processes, are one in this.
   * With either results are within these bounds, and integrals are kept to rounding; where
   * MinimumCoverage leaves cells out bounds go before integrals. Vectors that are rotated on a
   * sphere have limits of their components before they are rotated, or none (CLIP_AND_ASSURED_SUM).
   */
  vtkSkdTreeChoiceMacro(Limiter, NO_LIMITER, CLIP_AND_ASSURED_SUM);
  //@}

  enum NormalizationType
  {
    COVERED = 0,
    WHOLE = 1
  };

  //@{
  /**
   * What averages of partly covered cells are taken over: COVERED (default), the covered part, so
   * that constants stay; WHOLE, the whole cell as if the field were 0 elsewhere, so that the
   * integral over whole cells is kept.
   */
  vtkSkdTreeChoiceMacro(Normalization, COVERED, WHOLE);
  //@}

  //@{
  /**
   * Cells of which a lesser share is covered by what counts get no value. Conservative methods;
   * range [0, 1], default 0: any overlap will do.
   */
  vtkSkdTreeWithinMacro(MinimumCoverage, double, 0.0, 1.0);
  //@}

  enum MissingValuesType
  {
    MASK = 0,
    SPREAD = 1
  };

  //@{
  /**
   * What becomes of the source's values that are NaN: MASK (default), they count as not there;
   * SPREAD, everything that has a share of them is NaN. INTERPOLATION always spreads them.
   */
  vtkSkdTreeChoiceMacro(MissingValues, MASK, SPREAD);
  //@}

  //@{
  /**
   * Whether values equal to MissingValue count as NaN. Default off, and -9999.
   */
  vtkSkdTreeSwitchMacro(UseMissingValue);
  vtkSetMacro(MissingValue, double);
  vtkGetMacro(MissingValue, double);
  //@}

  //@{
  /**
   * A point or cell array of the Source that is 0 where values of points or of cells do not count.
   * None by default. INTERPOLATION gives NaN where what does not count has a share.
   */
  void SetMaskArray(const char* name) { this->SetText(this->MaskArray, name); }
  const char* GetMaskArray() const { return this->MaskArray.c_str(); }
  //@}

  //@{
  /**
   * Cell arrays that are amounts (mass, say) and not averages or densities: conservative methods
   * divide them among target cells, and their sum is kept. None by default.
   */
  void AddExtensiveArray(const char* name);
  void ClearExtensiveArrays();
  //@}

  //@{
  /**
   * On a sphere, whether arrays of three components, unless of integers, are vectors which
   * conservative methods rotate from where the source cell is to where the target cell is. Else
   * they are mapped by components. Default on.
   */
  vtkSkdTreeSwitchMacro(RotateVectors);
  //@}

  //@{
  /**
   * Point arrays whose gradients INTERPOLATION adds, see vtkSkdTreeProbe. None by default.
   */
  void AddGradientArray(const char* name);
  void ClearGradientArrays();
  //@}

  //@{
  /**
   * Pass the input's own point and cell data. Default on.
   */
  vtkSkdTreeSwitchMacro(PassInputData);
  //@}

  //@{
  /**
   * Whether a result whose name is in use, say by the input's own data, gets another one: with
   * "_Remapped" appended, and a number from 2 on if need be. Else it is left out, with a warning.
   * The report has the source's names. Default on.
   */
  vtkSkdTreeSwitchMacro(RenameTakenArrays);
  //@}

  //@{
  /**
   * Whether conservative methods give their weights (port 1) and overlaps (port 2). Default off.
   */
  vtkSkdTreeSwitchMacro(GenerateWeights);
  vtkSkdTreeSwitchMacro(GenerateOverlapMesh);
  //@}

  enum WeightsFileFormatType
  {
    ESMF = 0,
    SCRIP = 1
  };

  //@{
  /**
   * A netCDF file that conservative methods write their weights to, for other programs. None by
   * default. It is written again when a mesh or a property has changed. ESMF (default): row, col
   * and S, of first order. SCRIP, of meshes on a sphere: dst_address, src_address and remap_matrix,
   * at second order with the weights of the gradient, without limiter. Cells count from 1, and on
   * from block to block. The attribute normalization is fracarea (COVERED) or destarea (WHOLE);
   * remap_order of SCRIP is 1 or 2. The grid dimensions of structured grids are theirs, of other
   * meshes their number of cells. CDO applies the gradient's weights of sources with two
   * dimensions, and says that it cannot of others; NCO's ncremap leaves them out without a word.
   * Of several processes one writes the weights of all; cells count as in the joined pieces. Needs
   * a build with VTK's netCDF.
   */
  void SetWeightsFileName(VTK_FILEPATH const char* name)
  {
    this->SetText(this->WeightsFileName, name);
  }
  VTK_FILEPATH const char* GetWeightsFileName() const { return this->WeightsFileName.c_str(); }
  vtkSkdTreeChoiceMacro(WeightsFileFormat, ESMF, SCRIP);
  //@}

  //@{
  /**
   * The netCDF file whose weights WEIGHTS_FROM_FILE applies, instead of finding any: row, col and S
   * as of ESMF, TempestRemap, NCO or this filter, or SCRIP's names as of CDO or this filter. Its
   * numbers are of Source's and Input's cells, or of their points where there are not as many
   * cells, in their order, from block to block; results go to what is asked for by ResultsOn. Of
   * second order (three weights) the gradients are those of Source's cells along the sphere, fitted
   * without limiter. Values that do not count have no share, and the others have their weight.
   * None by default. It is read again when it has changed. A file that is cut short or of other
   * meshes is told of, with the sizes, and nothing is mapped. Of several processes the first one
   * has all of Input.
   */
  void SetAppliedWeightsFileName(VTK_FILEPATH const char* name)
  {
    this->SetText(this->AppliedWeightsFileName, name);
  }
  VTK_FILEPATH const char* GetAppliedWeightsFileName() const
  {
    return this->AppliedWeightsFileName.c_str();
  }
  //@}

protected:
  vtkSkdTreeRemap();
  ~vtkSkdTreeRemap() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// Results of points depend on all cells around them, unless they are interpolated.
  bool NeedsWhole(int port) override;
  bool NeedsNearbySource(skdtree::SkdSearchRange& range) override;

  int Method = AUTOMATIC_METHOD;
  int ResultsOn = AUTOMATIC_RESULTS;
  int Geometry = AUTOMATIC_GEOMETRY;
  double SurfaceDistance = 0.0;
  double SurfaceAngle = 90.0;
  int SourceCoordinates = AS_GIVEN;
  int InputCoordinates = AS_GIVEN;
  bool SourceEdgesAlongParallels = false;
  bool InputEdgesAlongParallels = false;
  int Statistic = MEAN;
  int SampleWeights = AUTOMATIC_WEIGHTS;
  int EmptyCells = NEAREST;
  int Extrapolation = NO_EXTRAPOLATION;
  double ExtrapolationConstant = 0.0;
  int ExtrapolationNeighbors = 8;
  int Limiter = BARTH_JESPERSEN;
  int Normalization = COVERED;
  double MinimumCoverage = 0.0;
  int MissingValues = MASK;
  bool UseMissingValue = false;
  double MissingValue = -9999.0;
  std::string MaskArray;
  bool RotateVectors = true;
  bool PassInputData = true;
  bool RenameTakenArrays = true;
  bool GenerateWeights = false;
  bool GenerateOverlapMesh = false;
  std::string WeightsFileName;
  int WeightsFileFormat = ESMF;
  std::string AppliedWeightsFileName;

private:
  vtkSkdTreeRemap(const vtkSkdTreeRemap&) = delete;
  void operator=(const vtkSkdTreeRemap&) = delete;

  void SetText(std::string& property, const char* text);

  class Internals;
  std::unique_ptr<Internals> Impl; // what is kept while the meshes are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
