// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeClosestPoint
 * @brief   nearest point, cell and distance of a source mesh for each input point
 *
 * Finds, for each point of Input (port 0, any vtkDataSet or composite of them), the nearest point
 * on the cells of Source (port 1, any vtkDataSet or composite), by the skD-tree (sections 4, 5 and
 * 6.4 of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576). Exact in double precision;
 * the answer does not depend on the number of threads or processes.
 *
 * Several processes: a Source of which each has a piece is gathered on each, or with
 * SOURCE_EXCHANGED stays where it is: a process answers its points from its own piece, and sends
 * those to others that may have something nearer; data are interpolated in the cells found, which
 * are brought. For signs it also sends a line to the outside, on which each process counts the
 * passes through its own faces. The Source is gathered after all if its boundary has open edges or
 * curved faces or is that of a structured grid of volume cells, or if these numbers leave a point
 * undecided: in bodies that overlap or are nested.
 *
 * The tree is reused while the Source's points, cells and ghost marks keep their values, even in
 * other arrays: further time steps cost queries only, unless points move.
 *
 * Output port 0: the input with the point arrays
 * | name                 | type   | components | meaning                              | none |
 * | -------------------- | ------ | ---------- | ------------------------------------ | ---- |
 * | SkdClosestPoint      | double | 3          | nearest point on the source          | NaN  |
 * | SkdDistance          | double | 1          | distance; negative inside if signed  | NaN  |
 * | SkdClosestCellId     | idtype | 1          | source cell, ties to the lowest id   | -1   |
 * | SkdClosestBlockIndex | int    | 1          | flat index of the source's block     | -1   |
 * (the last one only for a composite Source) and, optionally, the source's point data interpolated,
 * and its cell data, at the nearest point (see InterpolateSourceData). "None" is for points farther
 * than MaximumDistance or not finite (NaN or beyond 1e152). SkdDistance becomes the active scalars.
 * An aborted execution leaves "none" at points that were not processed; VTK 9.3 and later then
 * empties the output.
 *
 * Field data of output port 0, one value each: SkdReportPoints, SkdReportPointsFound (with a
 * result), SkdReportSourceCells, SkdReportSourceCellsLeftOut (see vtkSkdTreeCellLocator),
 * SkdReportTreesBuilt (0 if all were reused), SkdReportEpsilon (the largest in use, in world
 * units), SkdReportBuildSeconds, SkdReportQuerySeconds; SkdReportOpenEdges if signed, and
 * SkdReportChordalLength for curved cells (see SetChordalDeviation), and SkdReportPointsSent, how
 * often this process sent a point or its line to another, if the Source stayed in its pieces.
 *
 * Output port 1: optional (see GenerateLines), vtkPolyData with a line from each point with a
 * result to its nearest point, with the point's arrays as cell data (ghost marks are not passed
 * on).
 *
 * Bad input: a Source without valid cells gives a warning and "none" everywhere. A missing Source
 * is an error of the pipeline. See SetSignedDistance for a Source that is not closed. An Input
 * without points gives an output without points.
 *
 * @sa
 * vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeClosestPoint_h
#define vtkSkdTreeClosestPoint_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeFacetAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeClosestPoint : public vtkSkdTreeFacetAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeClosestPoint, vtkSkdTreeFacetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeClosestPoint* New();

  //@{
  /**
   * The maximum search distance. Default VTK_DOUBLE_MAX: no limit.
   */
  vtkSkdTreeWithinMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * Compute signed distances, negative inside the closed surface that bounds Source: the boundary
   * of its volume cells or, without any, its surface cells. The distance is then measured to that
   * surface, and SkdClosestCellId is a cell that contains the nearest point on it; vertices and
   * lines are not searched. Faces are divided into triangles (a warped quad into two), and
   * non-linear cells into linear ones.
   *
   * Points of equal coordinates are treated as one, and faces between two volume cells, also of
   * different blocks, are not part of the boundary. Faces that do not match are, but for those
   * between levels of AMR data and between images, or grids of voxels, with the same axes of one
   * vtkPartitionedDataSet: a face that smaller ones cover wholly is not, nor are these. The sign is
   * exact, as with the method AUTOMATIC of vtkSkdTreePointInOut: orientation does not matter, and
   * overlaps of bodies are inside. A surface with open edges (used by an odd number of faces) gives
   * one warning that counts them; the sign is then that of AUTOMATIC, which may be wrong near gaps.
   * A Source without a surface gives a warning and unsigned distances. Default off.
   */
  vtkSkdTreeSwitchMacro(SignedDistance);
  //@}

  //@{
  /**
   * Interpolate the source's point data at the nearest point by the cell's weights, exactly for
   * linear fields, and copy its cell data; both become point arrays of the output with their own
   * names and types (rounded for integers). An array that only some blocks of a composite Source
   * have is NaN (0 if of integers) at points nearest to others, and an array SkdValid_ with its
   * name marks by 1 where it has a value; SkdReportPartialArrays lists them. An array whose name is
   * already in use is not added, with a warning: the Input's arrays take precedence over the
   * Source's, and its point data over its cell data. Ghost marks and point ids are not passed on.
   * Points without a result get NaN, or 0 in integer arrays. Default off.
   */
  vtkSkdTreeSwitchMacro(InterpolateSourceData);
  //@}

  //@{
  /**
   * Fill output port 1 with a line from each point to its nearest. Default off.
   */
  vtkSkdTreeSwitchMacro(GenerateLines);
  //@}

protected:
  vtkSkdTreeClosestPoint();
  ~vtkSkdTreeClosestPoint() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool CanAskPieces(int port) override;

  double MaximumDistance = VTK_DOUBLE_MAX;
  bool SignedDistance = false;
  bool InterpolateSourceData = false;
  bool GenerateLines = false;

private:
  vtkSkdTreeClosestPoint(const vtkSkdTreeClosestPoint&) = delete;
  void operator=(const vtkSkdTreeClosestPoint&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the source's trees, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
