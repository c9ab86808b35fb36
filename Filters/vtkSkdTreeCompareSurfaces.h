// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeCompareSurfaces
 * @brief   distances between two surfaces, and their Hausdorff distance within a stated bound
 *
 * Compares Input (port 0) and Source (port 1), each any vtkDataSet or composite of them: a surface
 * (surface cells and the outer faces of volume cells, as triangles; those between blocks of AMR
 * data, or pieces of a vtkPartitionedDataSet, are no outer ones) or, without any such face, the set
 * of its points. Distances are found by the skD-tree (sections 4 and 5 of Khamayseh and Hansen,
 * Commun. Comput. Phys. 2 (2007) 545-576), on all processors; results do not depend on their
 * number.
 *
 * Output ports 0 and 1: Input and Source with the point arrays
 * | name                 | type   | components | meaning                                  | none |
 * | -------------------- | ------ | ---------- | ---------------------------------------- | ---- |
 * | SkdDistance          | double | 1          | to the other; negative inside if signed  | NaN  |
 * | SkdClosestPoint      | double | 3          | nearest point of the other               | NaN  |
 * | SkdClosestCellId     | idtype | 1          | its cell; its id if the other is points  | -1   |
 * | SkdClosestBlockIndex | int    | 1          | flat index of its block, if composite    | -1   |
 * Ties go to the lowest block and cell.
 *
 * Output port 2: a vtkTable of three rows: from Input to Source, from Source to Input, and both:
 * | column                                  | meaning                                             |
 * | --------------------------------------- | --------------------------------------------------- |
 * | Direction                               | which row this is                                   |
 * | HausdorffDistance                       | the largest distance found, of all points of cells  |
 * | HausdorffUpperBound                     | what the exact Hausdorff distance cannot exceed     |
 * | From, To                                | the two points where it is attained                 |
 * | FromCellId, FromBlockIndex              | where From is: a cell (or point), and a flat index  |
 * | ToCellId, ToBlockIndex                  | the same of To                                      |
 * | Mean, RootMeanSquare                    | of unsigned distances, weighted by area             |
 * | SignedMean                              | of signed distances, NaN if they are not signed     |
 * | Median, Quantile90, Quantile95, Quantile99 | not exceeded on that share of the area           |
 * | Area                                    | the area, or the number of points                   |
 * | Samples                                 | distances from which the mean and quantiles are     |
 * | MeanError, RootMeanSquareError, ...     | of each of these, an estimate of its error          |
 * Block indices are 0 if that input is not composite.
 *
 * The Hausdorff distance is not that of vertices: triangles are bisected wherever bounds do not
 * exclude a larger distance (see SetTolerance). It lies between the two columns; for curved cells
 * within twice SkdReportChordalLength more, because these are flat facets here. A set of points
 * has the exact maximum. Means and quantiles are those of samples, which are taken closer where
 * that is needed until the estimated errors are within StatisticsTolerance. The estimate is no
 * bound: it is from the difference to a quarter as many samples, and holds unless distances change
 * between samples that are SampleSpacing apart without any of these showing it. The row of both
 * directions has the samples of the two.
 *
 * Field data of port 0: SkdReportTreesBuilt (0 if all were reused), SkdReportBisections,
 * SkdReportEpsilon, SkdReportBuildSeconds, SkdReportQuerySeconds; SkdReportOpenEdges if signed, and
 * SkdReportChordalLength for curved cells.
 *
 * Bad input: an Input or Source without any finite point gives one warning, "none" and NaN. Cells
 * that are not finite are left out. An aborted execution leaves the table empty.
 *
 * Cost: at a point whose distance is more than about 1e5 times the size of the other surface, boxes
 * of its cells hardly differ in distance at single precision, and from 1e7 times on the nearest is
 * searched among all cells: O(n) for each sample of a triangle with a corner so far away. Remove
 * such points.
 *
 * Several processes: each has the arrays of its own pieces, and bisects and samples its share of
 * the triangles; the first has the table, which is that of one process: locations and quantiles are
 * the same, and so are sums but for rounding. With SourceDistribution exchanged a process has of
 * both meshes the cells of its own piece, and those that may be nearest to its own piece of the
 * other; surfaces that are far from each other, compared with the boxes of a 64th of a piece, bring
 * more. With SignedDistance processes count the passes of lines through their own faces. All is
 * gathered on each process, but the work still shared, where that does not tell sides (open edges,
 * curved faces, bodies that overlap or are nested), some cells are no faces, or points are of no
 * cell.
 *
 * @sa
 * vtkSkdTreeClosestPoint
 */

#ifndef vtkSkdTreeCompareSurfaces_h
#define vtkSkdTreeCompareSurfaces_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeFacetAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <array>  // For std::array
#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

namespace skdtree
{
class SkdReduction;
struct SkdBlock;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeCompareSurfaces : public vtkSkdTreeFacetAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeCompareSurfaces, vtkSkdTreeFacetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeCompareSurfaces* New();

  //@{
  /**
   * How far the upper bound of the Hausdorff distance may be from the distance found, relative to
   * the diagonal of the bounds of both inputs (but at least 64 units in the last place of the
   * largest coordinate). The cost grows where the distance is nearly the same everywhere, as on an
   * offset of a surface. Default 1e-5.
   */
  vtkSkdTreeWithinMacro(Tolerance, double, 0.0, 1.0);
  //@}

  //@{
  /**
   * The largest number of bisections of triangles a direction. When it is reached before the
   * tolerance is, there is a warning, and HausdorffUpperBound states what is known. About 0.4
   * kilobytes of memory each at most. Default 10 million.
   */
  vtkSkdTreeWithinMacro(MaximumBisections, int, 0, 1000000000);
  //@}

  //@{
  /**
   * The error up to which means and quantiles are determined, relative to them (of SignedMean and
   * of quantiles below Mean, to Mean) but at least 64 units in the last place of the largest
   * coordinate. The cost grows with its inverse. With 2 million divided triangles a direction no
   * more are divided; columns state the errors that were reached. Default 0.01.
   */
  vtkSkdTreeWithinMacro(StatisticsTolerance, double, 1e-6, 1.0);
  //@}

  //@{
  /**
   * About how far apart the first samples are, relative to the diagonal of the bounds of both
   * inputs: triangles are bisected until their edges are no longer than three times this, or they
   * are narrow, and each is sampled at ten points. With more than 2 million triangles it grows.
   * Default 0.01.
   */
  vtkSkdTreeWithinMacro(SampleSpacing, double, 1e-6, 1.0);
  //@}

  //@{
  /**
   * Distances are negative inside the other surface: see vtkSkdTreeClosestPoint::SetSignedDistance
   * for what is inside and for surfaces that are not closed. The distance itself is that to the
   * whole surface, signed or not. Default off.
   */
  vtkSkdTreeSwitchMacro(SignedDistance);
  //@}

protected:
  vtkSkdTreeCompareSurfaces();
  ~vtkSkdTreeCompareSurfaces() override;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Tolerance = 1e-5;
  int MaximumBisections = 10000000;
  double StatisticsTolerance = 0.01;
  double SampleSpacing = 0.01;
  bool SignedDistance = false;

private:
  bool FindRange(skdtree::SkdSearchRange& range);
  bool UpdateSides(vtkMultiProcessController* controller);
  bool AreSidesSure() const;
  std::vector<skdtree::SkdBlock> Prepare(int port, vtkDataObject* data, vtkDataObject* output,
    bool isInPieces, const skdtree::SkdReduction& all);
  bool CompareInputs(const std::array<vtkDataObject*, 2>& data, vtkInformationVector* outputVector,
    bool areInPieces, const skdtree::SkdReduction& all);

  vtkSkdTreeCompareSurfaces(const vtkSkdTreeCompareSurfaces&) = delete;
  void operator=(const vtkSkdTreeCompareSurfaces&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // both trees, kept while the meshes are unchanged
};

VTK_ABI_NAMESPACE_END
#endif
