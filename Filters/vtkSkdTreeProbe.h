// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeProbe
 * @brief   a mesh's data, and their gradients, at points and along lines
 *
 * For each point of Input (port 0, any vtkDataSet or composite of them) the cell of Source (port 1,
 * any vtkDataSet or composite) that holds it, where in the cell it is, and the Source's data there:
 * steps (i) to (iii) of section 6.6 of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007)
 * 545-576, by the skD-tree. Point data are interpolated, exactly for linear fields; cell data are
 * taken.
 *
 * A point is in the lowest (block, cell) that holds it. No point within a cell is missed, of
 * whatever type the cell is, warped and inverted ones too. A point that no cell holds is taken for
 * one of the nearest cell (ties to the lowest) when it is within the tolerance of it, see
 * SetRelativeTolerance and SetAbsoluteTolerance, and by choice when it is farther, see
 * SetOutsidePoints. The answer does not depend on the number of threads or processes (each needs
 * the whole Source).
 *
 * Points are asked in the order of a space-filling curve, which takes a third of the time to find
 * the cells of scattered ones (600 thousand among as many), and not by the cell of the last one as
 * a hint, though that would take 0.4 to 0.6 along a line: where cells overlap it would win over a
 * lower one, and so the answer would depend on what was asked before, by which thread.
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
 * (the block index only of a composite Source). See SetUseFillValue for what data arrays have where
 * there is no answer. The active scalars become the Source's own, or else its first array of
 * numbers.
 *
 * Output ports 1 and 2: by choice (see SetProbeLines) the input's lines, cut where they pass from
 * one cell of the Source to another, and the integrals along them.
 *
 * Field data of output port 0, one value each: SkdReportPoints, SkdReportPointsFound (with a
 * result), SkdReportPointsOutside (of these, those in no cell), SkdReportSourceCells,
 * SkdReportSourceCellsLeftOut (see vtkSkdTreeCellLocator), SkdReportTreesBuilt (0 if all were
 * reused), SkdReportEpsilon (the largest in use, in world units), SkdReportBuildSeconds and
 * SkdReportQuerySeconds.
 *
 * Bad input: a Source without cells, or without any valid ones, gives a warning and no answers. A
 * point that is not finite gets none. An array named for gradients or as categorical that the
 * Source does not have gives a warning, as an array whose name is in use does. ProbeLines with an
 * Input that has no lines gives a warning. An aborted execution leaves "none" at points that were
 * not processed.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkSkdTreeClosestPoint vtkProbeFilter
 */

#ifndef vtkSkdTreeProbe_h
#define vtkSkdTreeProbe_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeProbe : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeProbe, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeProbe* New();

  ///@{
  /**
   * How far from the nearest cell a point may be and still count as in it: this part of the
   * diagonal of that cell's bounds. It is for points that are in the mesh but for rounding, and for
   * those just off a surface. Range 0 and more, default 1e-3, which is what vtkProbeFilter allows.
   */
  vtkSkdTreeSetWithinMacro(RelativeTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  ///@{
  /**
   * The same as a distance in world units; the larger of the two holds. Default 0.
   */
  vtkSkdTreeSetWithinMacro(AbsoluteTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AbsoluteTolerance, double);
  ///@}

  enum OutsidePointsType
  {
    LEAVE = 0,
    NEAREST_CELL = 1,
    NEAREST_CELL_WITHIN_DISTANCE = 2
  };

  ///@{
  /**
   * What becomes of points outside the Source: LEAVE (default) gives them no answer, NEAREST_CELL
   * the data at the nearest point of the nearest cell, NEAREST_CELL_WITHIN_DISTANCE the same if it
   * is no farther than MaximumDistance.
   */
  vtkSetClampMacro(OutsidePoints, int, LEAVE, NEAREST_CELL_WITHIN_DISTANCE);
  vtkGetMacro(OutsidePoints, int);
  ///@}

  ///@{
  /**
   * See SetOutsidePoints. World units, default 1.
   */
  vtkSkdTreeSetWithinMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Whether the source's data are FillValue (rounded in arrays of integers) where there is no
   * answer, instead of NaN (0 in arrays of integers). Default off.
   */
  vtkSetMacro(UseFillValue, bool);
  vtkGetMacro(UseFillValue, bool);
  vtkBooleanMacro(UseFillValue, bool);
  ///@}

  ///@{
  /**
   * See SetUseFillValue. Default 0.
   */
  vtkSetMacro(FillValue, double);
  vtkGetMacro(FillValue, double);
  ///@}

  ///@{
  /**
   * Pass the input's own point and cell data. A source's array whose name is in use by then is left
   * out, with a warning. Default on.
   */
  vtkSetMacro(PassInputData, bool);
  vtkGetMacro(PassInputData, bool);
  vtkBooleanMacro(PassInputData, bool);
  ///@}

  ///@{
  /**
   * Point arrays of the Source whose values are no quantities, but labels: they are taken from the
   * nearest point of the cell (ties to the lowest in the cell) instead of being interpolated. None
   * by default.
   */
  void AddCategoricalArray(const char* name);
  void ClearCategoricalArrays();
  ///@}

  ///@{
  /**
   * Point arrays of the Source whose gradient in the cell is wanted, as "<name>_Gradient": of an
   * array of k components 3 k, the derivatives by x, y and z of the first, then of the second ...
   * Along a surface or curve it is the part along it; of polygons and polyhedra that of the linear
   * field which fits best. None by default.
   */
  void AddGradientArray(const char* name);
  void ClearGradientArrays();
  ///@}

  ///@{
  /**
   * Cut the lines of Input (cells of type VTK_LINE and VTK_POLY_LINE). Default off.
   *
   * Output port 1, vtkPolyData: a line for each stretch of an input's line within one cell, from
   * where it enters to where it leaves, exactly; in order. It also ends where the line bends. Cell
   * arrays SkdSourceCellId, SkdSourceBlockIndex (of a composite Source), SkdInputCellId,
   * SkdInputBlockIndex (of a composite Input), SkdEntry and SkdExit (lengths along the input's
   * line), SkdLength, and the source's cell data; point array SkdArcLength, and the source's point
   * data at both ends as this cell has them. Where cells overlap, or the line runs along a face,
   * the stretch is that of the lowest cell. Of a surface, stretches are where the line is within
   * the tolerance of it. Of non-linear cells, what they have for less than a part in 32 of the
   * line's way through their bounds may be missed.
   *
   * Output port 2, vtkTable: a row for each of the input's lines: SkdInputCellId,
   * SkdInputBlockIndex, SkdLineLength, SkdLength (of what is within the Source), and
   * "<name>_Integral" for each array of numbers along it (two Gauss points a stretch: exact for
   * cubics).
   */
  vtkSetMacro(ProbeLines, bool);
  vtkGetMacro(ProbeLines, bool);
  vtkBooleanMacro(ProbeLines, bool);
  ///@}

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

protected:
  vtkSkdTreeProbe();
  ~vtkSkdTreeProbe() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double RelativeTolerance = 1e-3;
  double AbsoluteTolerance = 0.0;
  int OutsidePoints = LEAVE;
  double MaximumDistance = 1.0;
  bool UseFillValue = false;
  double FillValue = 0.0;
  bool PassInputData = true;
  bool ProbeLines = false;
  double Epsilon = 1e-9;

private:
  vtkSkdTreeProbe(const vtkSkdTreeProbe&) = delete;
  void operator=(const vtkSkdTreeProbe&) = delete;

  void CutLines(vtkDataObject* input, bool isSourceComposite, vtkInformationVector* outputVector);

  class Internals;
  std::unique_ptr<Internals> Impl; // the source's trees, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
