// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreePointInOut
 * @brief   find the parts that contain a point
 *
 * Finds, for each point or cell of Input (port 0, any vtkDataSet or composite of them), the parts
 * of Source (port 1, any vtkDataSet or composite) that contain it: the point in/out test of section
 * 6.3 of Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576, by the skD-tree, with both
 * of its models:
 * - BOUNDARIES: a part is the region enclosed by its surface: its surface cells or, for volume
 *   cells, their outer faces (see SetUseOuterFaces). See SetMethod for the tests.
 * - BODY_FITTED_MESH: the part of the lowest cell that contains the point.
 *
 * Each part has its own tree, so touching parts do not affect each other, and nested parts give a
 * depth. The test is exact for closed surfaces of triangles, by one ray with watertight crossings,
 * including thin shells, rays through edges and vertices, and overlapping bodies (see SetMethod).
 * Larger polygons are triangulated, curved cells are approximated by facets within the
 * ChordalDeviation, and duplicate faces count once. Points within rounding error of a surface may
 * be classified either way. For closed surfaces, rays do not depend on orientation. The answer does
 * not depend on the number of threads or processes. Trees are reused while the Source is unchanged.
 * On images and rectilinear grids the filter is a voxelizer: for closed parts and methods with
 * rays, one line classifies a whole row.
 *
 * Several processes: a Source of which each has a piece is gathered on each, or with
 * SOURCE_EXCHANGED stays where it is. Of a BODY_FITTED_MESH a process gets the cells near its own
 * Input. For BOUNDARIES it sends lines, on which each process counts the passes through its own
 * faces; parts may be on several. That needs the method AUTOMATIC, a block a part, outer faces and
 * no BoundaryBand; otherwise, and if a part has open edges or curved faces or is a structured grid
 * of volume cells, or if a point lies in bodies of one part that overlap or are nested, the Source
 * is gathered.
 *
 * Output port 0: the input with these point or cell arrays (see SetAsk)
 * | name             | type   | meaning                                                 | none |
 * | ---------------- | ------ | ------------------------------------------------------- | ---- |
 * | SkdInside        | uchar  | 1 inside some part                                      | 0    |
 * | SkdPartId        | int    | the innermost part: that with the shortest diagonal     | -1   |
 * | SkdDepth         | int    | how many parts hold it: the depth of nested ones        | 0    |
 * | SkdConfidence    | float  | 0.5 to 1, see SetMethod; the least of all parts         | 0    |
 * | SkdOnBoundary    | uchar  | 1 in the BoundaryBand                                   | 0    |
 * | SkdWindingNumber | double | the sum over the parts, with the method WINDING_NUMBER  | NaN  |
 * | SkdWindingBound  | double | upper bound of its error, see SetWindingTolerance      | NaN  |
 * "None" is for points outside; for points that are not finite the confidence is 0, too. SkdInside
 * becomes the active scalars.
 *
 * Output port 1: optional (see SetExtract), the part of the input that is inside, or outside, as a
 * vtkUnstructuredGrid; for composite data a vtkMultiBlockDataSet with one for each leaf, at the
 * leaf's number.
 *
 * Field data of output port 0, one value each: SkdReportPoints, SkdReportPointsInside,
 * SkdReportParts, SkdReportOpenParts, SkdReportOpenEdges, SkdReportOuterFaces (1 if outer faces of
 * volume cells were used), SkdReportTreesBuilt (0 if all were reused), SkdReportBuildSeconds and
 * SkdReportQuerySeconds; SkdReportChordalLength if there are curved cells (see
 * SetChordalDeviation); and SkdReportPointsSent, how often this process sent a point or a row's
 * line to another, if the Source's boundaries stayed in their pieces.
 *
 * Bad input: with a Source without cells, or without surfaces if these are needed, there is a
 * warning and everything is outside. A PartArray that some block does not have, and volume cells
 * with UseOuterFaces off, give an error and an empty output. Open edges (used by an odd number of a
 * part's faces) give one warning that counts them: points near them may be classified wrongly, with
 * a low confidence.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkSelectEnclosedPoints
 */

#ifndef vtkSkdTreePointInOut_h
#define vtkSkdTreePointInOut_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeFacetAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <memory>   // For std::unique_ptr
#include <optional> // For std::optional
#include <string>   // For std::string
#include <vector>   // For std::vector

namespace skdtree
{
class SkdInOuts;
struct SkdBlock;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreePointInOut : public vtkSkdTreeFacetAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreePointInOut, vtkSkdTreeFacetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreePointInOut* New();

  enum ModelType
  {
    BOUNDARIES = 0,
    BODY_FITTED_MESH = 1
  };

  //@{
  /**
   * The kind of Source: surfaces (default), or a mesh that fills the parts.
   */
  vtkSkdTreeChoiceMacro(Model, BOUNDARIES, BODY_FITTED_MESH);
  //@}

  enum PartsType
  {
    BLOCKS = 0,
    CELL_ARRAY = 1,
    CONNECTED_PIECES = 2
  };

  //@{
  /**
   * The parts of the Source: its blocks, with their flat index as id, or 0 if it is not composite
   * (BLOCKS, default; those of AMR data and the pieces of a vtkPartitionedDataSet, too, so that
   * SkdPartId tells the block and SkdOnBoundary marks its faces to others); the cells with one
   * value of PartArray, rounded, which is the id (CELL_ARRAY); or components connected by points of
   * equal coordinates, with ids 0, 1, ... in the order of their first cells (CONNECTED_PIECES; a
   * BODY_FITTED_MESH uses BLOCKS instead).
   */
  vtkSkdTreeChoiceMacro(Parts, BLOCKS, CONNECTED_PIECES);
  //@}

  //@{
  /**
   * The cell array for CELL_ARRAY: numeric and present in all blocks. Default "".
   */
  void SetPartArray(const char* name);
  const char* GetPartArray() const { return this->PartArray.c_str(); }
  //@}

  enum MethodType
  {
    AXIS_RAYS = 0,
    RANDOM_RAYS = 1,
    WINDING_NUMBER = 2,
    NEAREST_FEATURE = 3,
    AUTOMATIC = 4
  };

  //@{
  /**
   * The test for points inside a surface:
   * - AUTOMATIC (default): for a part without open edges, the directed crossings of a ray along an
   *   axis. Closed shells of the part that are nested without touching are alternately bodies and
   *   cavities, whatever their orientation. For shells that touch, overlap or intersect themselves,
   *   a point is inside if their winding number is not 0: the union of bodies oriented outward,
   *   minus cavities oriented inward. Touching shells are detected when a point is first found
   *   within two, for about the cost of a build. The confidence is 1, but 1/2 if the orientation of
   *   the triangles contradicts the result (a nested shell of the same orientation, overlapping
   *   bodies one of which is inside out) or they cannot be oriented consistently, and 3/4 where
   *   bodies overlap whose triangles are not oriented consistently. In a part with gaps these are
   *   closed first: a missing triangle by itself, a larger gap by a fan of triangles about its
   *   middle. Then the test is the same, and the confidence is at most 1 minus the share of
   *   directions in which the point sees gaps. Where the gaps of some component have more than a
   *   third of its area, WINDING_NUMBER decides, with an orientation that is consistent within each
   *   component. Of the given one and one outward by the parity of lines (wrong where bodies
   *   overlap) the number farther from 1/2 counts; the confidence is 1/2 if they contradict, else
   *   that of WINDING_NUMBER, and at most the share of seven lines whose directed crossings say the
   *   same.
   * - AXIS_RAYS: the parity of the crossings of a ray along an axis, in the direction of the
   *   shortest way out of the bounds; overlaps of two bodies of a part are outside. For a surface
   *   with gaps, a vote of up to six rays, and a seventh in case of a tie.
   * - RANDOM_RAYS: the same in directions distributed uniformly over the sphere; for a surface with
   *   gaps a vote of up to NumberOfRays, and one more in case of a tie. Voting ends once it is
   *   decided. The confidence is the share of votes.
   * - WINDING_NUMBER: inside if the generalized winding number is at least 1/2 or at most -1/2. It
   *   tolerates gaps, intersections and duplicate faces, and requires mostly consistent
   *   orientation. The confidence is 1/2 plus the distance of the number from this limit, at most
   *   1.
   * - NEAREST_FEATURE: the side of the nearest face, edge or vertex by its normal; requires outward
   *   normals. The confidence is 1/2 if that is an open edge.
   *
   * Points outside a part's bounds are outside the part: the confidence is 1 for closed parts and
   * for rays, else that of the method, or 1/2 if the method contradicts.
   */
  vtkSkdTreeChoiceMacro(Method, AXIS_RAYS, AUTOMATIC);
  //@}

  //@{
  /**
   * The number of RANDOM_RAYS for surfaces with gaps. Range 1 to 1000, default 10.
   */
  vtkSkdTreeWithinMacro(NumberOfRays, int, 1, 1000);
  //@}

  //@{
  /**
   * The seed of the directions of RANDOM_RAYS; each point has its own directions. Default 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  //@}

  //@{
  /**
   * The maximum error of SkdWindingNumber, and of the confidence, per part. Range 0 (sum over all
   * triangles: O(N) a point) to 1, default 0.25, which is fastest. The bound holds for any surface;
   * most errors are a hundredth of it. SkdWindingBound gives the bound for each point. Half the
   * tolerance takes about 1.6 times as long. Whether a number exceeds 1/2 is decided exactly at any
   * tolerance, except for rounding.
   */
  vtkSkdTreeWithinMacro(WindingTolerance, double, 0.0, 1.0);
  //@}

  enum AskType
  {
    POINTS = 0,
    CELL_CENTERS = 1,
    CELLS_ALL_POINTS = 2,
    CELLS_ANY_POINT = 3
  };

  //@{
  /**
   * What is classified: the input's points (default), or its cells: by their centres (the mean of
   * their points), as inside if all their points are, or if any point is. With all points a cell
   * gets the part and confidence of the point with the least depth, with any point those of the one
   * with the greatest; ties go to the first.
   */
  vtkSkdTreeChoiceMacro(Ask, POINTS, CELLS_ANY_POINT);
  //@}

  //@{
  /**
   * Points within this distance of a part's surface are marked in SkdOnBoundary. World units,
   * default 0: none.
   */
  vtkSkdTreeWithinMacro(BoundaryBand, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * Use the outer faces of volume cells as surfaces. Default on.
   */
  vtkSkdTreeSwitchMacro(UseOuterFaces);
  //@}

  //@{
  /**
   * For WINDING_NUMBER and NEAREST_FEATURE, which depend on the triangles' normals: orient the
   * triangles outward first. Adjacent triangles are oriented consistently, and each component
   * outward by axis rays from its largest triangle. Default off.
   */
  vtkSkdTreeSwitchMacro(RepairOrientation);
  //@}

  enum ExtractType
  {
    NOTHING = 0,
    INSIDE = 1,
    OUTSIDE = 2
  };

  //@{
  /**
   * The content of output port 1: nothing (default), or the input's points or cells (see SetAsk)
   * that are inside or outside, with all data of port 0.
   */
  vtkSkdTreeChoiceMacro(Extract, NOTHING, OUTSIDE);
  //@}

protected:
  vtkSkdTreePointInOut();
  ~vtkSkdTreePointInOut() override;

  bool NeedsNearbySource(skdtree::SkdSearchRange& range) override;
  bool CanAskPieces(int port) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Model = BOUNDARIES;
  int Parts = BLOCKS;
  std::string PartArray;
  int Method = AUTOMATIC;
  int NumberOfRays = 10;
  int Seed = 0;
  double WindingTolerance = 0.25;
  int Ask = POINTS;
  double BoundaryBand = 0.0;
  bool UseOuterFaces = true;
  bool RepairOrientation = false;
  int Extract = NOTHING;

private:
  vtkSkdTreePointInOut(const vtkSkdTreePointInOut&) = delete;
  void operator=(const vtkSkdTreePointInOut&) = delete;

  class Internals;
  struct PartFacts;
  bool CheckSource();
  void UpdateParts();
  PartFacts GetFacts() const;
  void WarnAbout(const PartFacts& facts);
  std::vector<skdtree::SkdInOuts> AskMeshes(const std::vector<skdtree::SkdBlock>& meshes);
  std::optional<PartFacts> AskPieces(
    const std::vector<skdtree::SkdBlock>& meshes, std::vector<skdtree::SkdInOuts>& answers);
  bool AsksCorners() const { return this->Ask == CELLS_ALL_POINTS || this->Ask == CELLS_ANY_POINT; }
  void FillOutputs(const PartFacts& facts, const std::vector<skdtree::SkdBlock>& meshes,
    const std::vector<skdtree::SkdInOuts>& answers, vtkInformationVector* outputVector);
  void ExtractFrom(vtkDataSet* mesh, unsigned int leaf, const skdtree::SkdInOuts& answers,
    vtkInformationVector* outputVector);
  vtkIdType CountQueryPoints(const std::vector<skdtree::SkdBlock>& blocks) const;

  std::unique_ptr<Internals> Impl; // the parts, kept while the source is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
