// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeRays
 * @brief   where rays from the points or cells of a mesh hit a source mesh
 *
 * Casts a ray from each point or cell centre of Input (port 0, any vtkDataSet or composite of them)
 * at Source (port 1, any vtkDataSet or composite), by the skD-tree (Algorithm 5.2 of Khamayseh and
 * Hansen, Commun. Comput. Phys. 2 (2007) 545-576). Exact tests decide what is hit: no ray passes
 * between two triangles that share an edge. The answer does not depend on the number of threads or
 * processes. Each volume cell is hit once, at the face where the ray
 * enters it or, if it starts within, leaves it (a voxel then where the ray starts, as in VTK);
 * vertices and lines only within rounding. A ray in the plane of a cell does not hit it.
 *
 * Several processes: a Source of which each has a piece is gathered on each, or with
 * SOURCE_EXCHANGED stays where it is: rays are sent to the processes that have boxes on them, and
 * the cells that may be hit are brought. TO_NEAREST gathers, and along normals at points, which
 * other pieces' cells may determine, the first process has all.
 *
 * Output port 0: the input with the point arrays or, of rays from cell centres, cell arrays
 * | name             | type   | components | meaning                                   | none |
 * | ---------------- | ------ | ---------- | ----------------------------------------- | ---- |
 * | SkdRayHits       | idtype | 1          | number of hits (not of FIRST_HIT)         | 0    |
 * | SkdRayDistance   | double | 1          | distance of the first hit; negative       | NaN  |
 * |                  |        |            | against the direction, see BothWays       |      |
 * | SkdRayHitPoint   | double | 3          | where it is                               | NaN  |
 * | SkdRayCellId     | idtype | 1          | source cell hit, of several the lowest id | -1   |
 * | SkdRaySide       | int    | 1          | 1: its front (its normal faces the ray),  | 0    |
 * |                  |        |            | -1: its back, 0: no surface cell          |      |
 * | SkdRayBlockIndex | int    | 1          | flat index of its block                   | -1   |
 * (the last one only for a composite Source; all but the first not of COUNTS) and, optionally, the
 * source's data at the first hit. Rays from curved
 * faces start on the faces themselves: for a control point of a Bezier cell stands the point of the
 * face at its parameters, for the centre of a curved cell that in the middle of its parameters.
 * Output port 1 (empty for COUNTS): vtkPolyData with a point for each hit or, by choice, a line
 * from the start to it, with the same data, those of the start, and SkdRayStartId, the id of the
 * start's point or cell (in the piece of this process). After an abort the remaining rays have no
 * hits.
 *
 * Field data of output port 0, one value each: SkdReportRays, SkdReportRaysWithHits, SkdReportHits,
 * SkdReportSourceCells, SkdReportSourceCellsLeftOut (see vtkSkdTreeCellLocator), SkdReportTolerance
 * (in world units), SkdReportEpsilon, SkdReportTreesBuilt (0 if all were reused),
 * SkdReportBuildSeconds, SkdReportQuerySeconds, and SkdReportRaysSent, how often this process sent
 * a ray to another, if the Source stayed in its pieces.
 *
 * Bad input: an array of directions that is missing or has not a vector for each start is an
 * error, and there is no hit. Points without a direction (a zero or non-finite vector, or no
 * surface cell that has a normal) or that are not finite have no ray; one warning counts them,
 * except points within a mesh of volume cells. A Source without valid cells gives a warning, and no
 * hits. A missing Source is an error of the pipeline.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkSkdTreeClosestPoint
 */

#ifndef vtkSkdTreeRays_h
#define vtkSkdTreeRays_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr
#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeRays : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeRays, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeRays* New();

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
   * Where rays start: at the points of Input, or at the centres of its cells (the mean of their
   * points). Default POINTS.
   */
  vtkSkdTreeChoiceMacro(Start, POINTS, CELL_CENTERS);
  void SetStartToPoints() { this->SetStart(POINTS); }
  void SetStartToCellCenters() { this->SetStart(CELL_CENTERS); }
  //@}

  /**
   * See SetAlong.
   */
  enum Directions
  {
    NORMALS = 0,
    ARRAY = 1,
    DIRECTION = 2,
    TO_POINT = 3,
    TO_POSITIONS = 4,
    TO_NEAREST = 5
  };

  //@{
  /**
   * Where rays go: along the normals of the points or cells (the active ones or, without them,
   * those of the surface cells or of the outer faces of volume cells, at points their mean
   * weighted by angles; AMR data, and the pieces of a vtkPartitionedDataSet, have no outer faces
   * between blocks or pieces), along the vectors of DirectionArray, along one Direction; or towards
   * TargetPoint, towards the positions in DirectionArray, or each towards the nearest point of
   * Source, and beyond. Towards the nearest point on the border of an open surface, rounding
   * decides whether a ray hits. Default NORMALS.
   */
  vtkSkdTreeChoiceMacro(Along, NORMALS, TO_NEAREST);
  void SetAlongToNormals() { this->SetAlong(NORMALS); }
  void SetAlongToArray() { this->SetAlong(ARRAY); }
  void SetAlongToDirection() { this->SetAlong(DIRECTION); }
  void SetAlongToPoint() { this->SetAlong(TO_POINT); }
  void SetAlongToPositions() { this->SetAlong(TO_POSITIONS); }
  void SetAlongToNearest() { this->SetAlong(TO_NEAREST); }
  //@}

  //@{
  /**
   * For ARRAY: the point (or cell) array of three components, of any length but 0. Default empty:
   * the active vectors. For TO_POSITIONS: the array of positions, for example of the corresponding
   * points of another mesh; it must be named.
   */
  void SetDirectionArray(const char* name);
  const char* GetDirectionArray() const { return this->DirectionArray.c_str(); }
  //@}

  //@{
  /**
   * For DIRECTION: a vector of any length but 0. Default (0, 0, 1).
   */
  vtkSkdTreeFinite3Macro(Direction);
  //@}

  //@{
  /**
   * For TO_POINT. Default (0, 0, 0).
   */
  vtkSkdTreeFinite3Macro(TargetPoint);
  //@}

  //@{
  /**
   * Turn directions round, for example normals inwards. Default off.
   */
  vtkSkdTreeSwitchMacro(Reversed);
  //@}

  //@{
  /**
   * Cast rays in both directions: the first hit is the nearest of either, and distances are
   * negative against the direction. Default off.
   */
  vtkSkdTreeSwitchMacro(BothWays);
  //@}

  /**
   * See SetHits.
   */
  enum HitKinds
  {
    FIRST_HIT = 0,
    ALL_HITS = 1,
    COUNTS = 2
  };

  //@{
  /**
   * What is found: the first hit of each ray, all of them, or their number. Where a ray hits
   * several cells at one point, for example at an edge that they share, that is one hit, also if it
   * only touches the surface there. Default FIRST_HIT, which takes the least time.
   */
  vtkSkdTreeChoiceMacro(Hits, FIRST_HIT, COUNTS);
  void SetHitsToFirstHit() { this->SetHits(FIRST_HIT); }
  void SetHitsToAllHits() { this->SetHits(ALL_HITS); }
  void SetHitsToCounts() { this->SetHits(COUNTS); }
  //@}

  //@{
  /**
   * The length of the rays. Default VTK_DOUBLE_MAX: no limit.
   */
  vtkSkdTreeWithinMacro(MaximumLength, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * Hits at a distance of at most this from the start are left out (see IncludeStart), and hits of
   * one ray that are no farther apart are one. Relative to the diagonal of the bounds of Source,
   * and at least 8 units in the last place of the largest coordinate. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Tolerance, double, 0.0, 1.0);
  //@}

  //@{
  /**
   * Count hits within Tolerance of the start, too, on either side of it, which have the distance 0
   * or up to Tolerance. Default off, for rays that start on Source.
   */
  vtkSkdTreeSwitchMacro(IncludeStart);
  //@}

  //@{
  /**
   * Add data of Source at the first hit, see vtkSkdTreeClosestPoint::SetInterpolateSourceData.
   * Default off.
   */
  vtkSkdTreeSwitchMacro(InterpolateSourceData);
  //@}

  //@{
  /**
   * Fill output port 1 with lines from starts to hits instead of points. Default off.
   */
  vtkSkdTreeSwitchMacro(GenerateLines);
  //@}

  //@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Epsilon, double, 0.0, 1.0);
  //@}

protected:
  vtkSkdTreeRays();
  ~vtkSkdTreeRays() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Normals of points may depend on cells of other pieces.
  bool NeedsWhole(int port) override;
  bool CanAskPieces(int port) override;

  int Start = POINTS;
  int Along = NORMALS;
  std::string DirectionArray;
  double Direction[3] = { 0.0, 0.0, 1.0 };
  double TargetPoint[3] = { 0.0, 0.0, 0.0 };
  bool Reversed = false;
  bool BothWays = false;
  int Hits = FIRST_HIT;
  double MaximumLength = VTK_DOUBLE_MAX;
  double Tolerance = 1e-9;
  bool IncludeStart = false;
  bool InterpolateSourceData = false;
  bool GenerateLines = false;
  double Epsilon = 1e-9;

private:
  vtkSkdTreeRays(const vtkSkdTreeRays&) = delete;
  void operator=(const vtkSkdTreeRays&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the source's trees, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
