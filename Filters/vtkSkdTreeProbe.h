// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeProbe
 * @brief   probe a mesh's data and their gradients at points and along lines
 *
 * Finds, for each point of Input (port 0, any vtkDataSet or composite of them), the cell of Source
 * (port 1, any vtkDataSet or composite) that contains it, its parametric coordinates, and the
 * Source's data there: steps (i) to (iii) of section 6.6 of Khamayseh and Hansen, Commun. Comput.
 * Phys. 2 (2007) 545-576, by the skD-tree. Point data are interpolated, exactly for linear fields;
 * cell data are copied.
 *
 * If several cells contain a point, the lowest (block, cell) is used. No point within a cell is
 * missed, whatever the type of the cell, including warped and inverted cells. A point in no cell is
 * assigned to the nearest cell (ties to the lowest) if it is within the tolerance of it, see
 * SetRelativeTolerance and SetAbsoluteTolerance, and optionally if it is farther, see
 * SetOutsidePoints. The answer does not depend on the number of threads or processes. A Source in
 * pieces may stay spread (see SetSourceDistribution), unless OutsidePoints is NEAREST_CELL: each
 * process gets the cells near its own points.
 *
 * Points are processed along a space-filling curve, which reduces the time for scattered points to
 * a third (600 thousand points among as many cells). The cell of the previous point is not used as
 * a hint, although this would take 0.4 to 0.6 of the time along lines: where cells overlap the hint
 * would be preferred to a lower id, and answers would depend on the order of points and on threads.
 *
 * The tree is reused while the Source's points, cells and ghost marks keep their values, even in
 * other arrays.
 *
 * Output port 0: the input with the source's arrays and these point arrays
 * | name                     | type   | components | meaning                           | none |
 * | ------------------------ | ------ | ---------- | --------------------------------- | ---- |
 * | SkdValid                 | uchar  | 1          | 1 where there is an answer        | 0    |
 * | SkdSourceCellId          | idtype | 1          | the source's cell                 | -1   |
 * | SkdSourceBlockIndex      | int    | 1          | flat index of the cell's block    | -1   |
 * | SkdParametricCoordinates | double | 3          | in the cell, VTK's                | NaN  |
 * | SkdDistance              | double | 1          | distance to the cell, 0 within it | NaN  |
 * | name_Gradient            | double | 3 k        | see AddGradientArray              | NaN  |
 * (the block index only for a composite Source). See SetUseFillValue for the values of data arrays
 * at points without a result. The Source's active scalars become active, or else its first numeric
 * array.
 *
 * Output ports 1 and 2: optional (see SetProbeLines), the input's lines, divided where they pass
 * from one cell of the Source to another, and the integrals along them.
 *
 * Field data of output port 0, one value each: SkdReportPoints, SkdReportPointsFound (with a
 * result), SkdReportPointsOutside (of these, those in no cell), SkdReportSourceCells,
 * SkdReportSourceCellsLeftOut (see vtkSkdTreeCellLocator), SkdReportTreesBuilt (0 if all were
 * reused), SkdReportEpsilon (the largest in use, in world units), SkdReportBuildSeconds and
 * SkdReportQuerySeconds.
 *
 * Bad input: a Source without valid cells gives a warning and no results, and points that are not
 * finite have none. Gradient or categorical arrays that the Source does not have, and arrays whose
 * name is already in use, give a warning. ProbeLines with an Input without lines gives a warning.
 * An aborted execution leaves "none" at points that were not processed.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkSkdTreeClosestPoint vtkProbeFilter
 */

#ifndef vtkSkdTreeProbe_h
#define vtkSkdTreeProbe_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSearchAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeProbe : public vtkSkdTreeSearchAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeProbe, vtkSkdTreeSearchAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeProbe* New();

  //@{
  /**
   * A point counts as in the nearest cell if its distance is at most this fraction of the diagonal
   * of the cell's bounds. This is meant for points that are outside because of rounding, and for
   * points close to a surface. Range 0 and more, default 1e-3 as in vtkProbeFilter.
   */
  vtkSkdTreeWithinMacro(RelativeTolerance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * The same as a distance in world units; the larger of the two applies. Default 0.
   */
  vtkSkdTreeWithinMacro(AbsoluteTolerance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  enum OutsidePointsType
  {
    LEAVE = 0,
    NEAREST_CELL = 1,
    NEAREST_CELL_WITHIN_DISTANCE = 2
  };

  //@{
  /**
   * The treatment of points outside the Source: LEAVE (default): no result; NEAREST_CELL: the data
   * at the nearest point of the nearest cell; NEAREST_CELL_WITHIN_DISTANCE: the same up to
   * MaximumDistance.
   */
  vtkSkdTreeChoiceMacro(OutsidePoints, LEAVE, NEAREST_CELL_WITHIN_DISTANCE);
  //@}

  //@{
  /**
   * See SetOutsidePoints. World units, default 1.
   */
  vtkSkdTreeWithinMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * Use FillValue (rounded in integer arrays) for points without a result, instead of NaN (0 in
   * integer arrays). Default off.
   */
  vtkSkdTreeSwitchMacro(UseFillValue);
  //@}

  //@{
  /**
   * See SetUseFillValue. Default 0.
   */
  vtkSetMacro(FillValue, double);
  vtkGetMacro(FillValue, double);
  //@}

  //@{
  /**
   * Pass the input's own point and cell data. Source arrays whose name is then in use are not
   * added, with a warning. Default on.
   */
  vtkSkdTreeSwitchMacro(PassInputData);
  //@}

  //@{
  /**
   * Point arrays of the Source that are labels rather than quantities: values are copied from the
   * nearest point of the cell (ties to the lowest in the cell) instead of being interpolated. None
   * by default.
   */
  void AddCategoricalArray(const char* name);
  void ClearCategoricalArrays();
  //@}

  //@{
  /**
   * Point arrays of the Source whose gradient in the cell is computed, as "<name>_Gradient": for an
   * array of k components 3 k values, the derivatives by x, y and z of the first component, then of
   * the second, and so on. In surface cells and curves it is the tangential gradient; in polygons
   * and polyhedra that of the best-fitting linear field. None by default.
   */
  void AddGradientArray(const char* name);
  void ClearGradientArrays();
  //@}

  //@{
  /**
   * Cut the lines of Input (cells of type VTK_LINE and VTK_POLY_LINE). Default off.
   *
   * Output port 1, vtkPolyData: a line for each segment of an input line within one cell, from its
   * exact point of entry to its exit, in order. Segments also end at vertices of the line. Cell
   * arrays SkdSourceCellId, SkdSourceBlockIndex (of a composite Source), SkdInputCellId,
   * SkdInputBlockIndex (of a composite Input), SkdEntry and SkdExit (lengths along the input's
   * line), SkdLength, and the source's cell data; point array SkdArcLength, and the source's point
   * data at both ends, interpolated in this cell. Where cells overlap, or the line runs along a
   * face, the segment belongs to the lowest cell. For surfaces, segments are where the line is
   * within the tolerance. In non-linear cells, segments shorter than 1/32 of the line's length
   * within their bounds may be missed.
   *
   * Output port 2, vtkTable: a row for each of the input's lines: SkdInputCellId,
   * SkdInputBlockIndex, SkdLineLength, SkdLength (within the Source), and "<name>_Integral" for
   * each numeric array (two Gauss points a segment: exact for cubics).
   */
  vtkSkdTreeSwitchMacro(ProbeLines);
  //@}

protected:
  vtkSkdTreeProbe();
  ~vtkSkdTreeProbe() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool NeedsNearbySource(skdtree::SkdSearchRange& range) override;
  bool ListsByInputCells() override { return this->ProbeLines; }

  double RelativeTolerance = 1e-3;
  double AbsoluteTolerance = 0.0;
  int OutsidePoints = LEAVE;
  double MaximumDistance = 1.0;
  bool UseFillValue = false;
  double FillValue = 0.0;
  bool PassInputData = true;
  bool ProbeLines = false;

private:
  vtkSkdTreeProbe(const vtkSkdTreeProbe&) = delete;
  void operator=(const vtkSkdTreeProbe&) = delete;

  void CutLines(vtkDataObject* input, bool isSourceComposite, vtkInformationVector* outputVector);

  class Internals;
  std::unique_ptr<Internals> Impl; // the source's trees, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
