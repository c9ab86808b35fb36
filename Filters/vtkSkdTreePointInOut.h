// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreePointInOut
 * @brief   which part, or parts, hold a point
 *
 * For each point or cell of Input (port 0, any vtkDataSet or composite of them) the parts of Source
 * (port 1, any vtkDataSet or composite) that hold it: the point in/out test, section 6.3 of
 * Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576, by the skD-tree, after both of its
 * models:
 * - BOUNDARIES: a part is what its surface encloses: its surface cells, or of a part with volume
 *   cells their outer faces (see SetUseOuterFaces). See SetMethod for how it is told.
 * - BODY_FITTED_MESH: the lowest cell that holds the point tells the part.
 *
 * Each part has a tree of its own, so parts that touch do not hide each other, and nested ones give
 * a depth. A closed surface of triangles is decided exactly, by one ray whose crossings are
 * watertight, thin shells and rays through edges and vertices included, be it one body or several
 * that overlap (see SetMethod); of larger polygons the triangles that they are cut into are meant,
 * of curved cells facets within the ChordalDeviation, and faces that are there repeatedly count
 * once. Points within rounding of a surface may count as either. Without a gap no orientation is
 * needed by rays. The answer does not depend on the number of threads or processes (each needs the
 * whole Source). Trees are kept while the Source is unchanged. On an image, and on a rectilinear
 * grid, the filter is a voxeliser: one line along each row tells all of it, of closed parts and by
 * rays.
 *
 * Output port 0: the input with these arrays, of points or of cells by what was asked (see SetAsk)
 * | name             | type   | meaning                                                 | none |
 * | ---------------- | ------ | ------------------------------------------------------- | ---- |
 * | SkdInside        | uchar  | 1 inside some part                                      | 0    |
 * | SkdPartId        | int    | the innermost part: that with the shortest diagonal     | -1   |
 * | SkdDepth         | int    | how many parts hold it: the depth of nested ones        | 0    |
 * | SkdConfidence    | float  | 0.5 to 1, see SetMethod; the least of all parts         | 0    |
 * | SkdOnBoundary    | uchar  | 1 in the BoundaryBand                                   | 0    |
 * | SkdWindingNumber | double | the sum over the parts, with the method WINDING_NUMBER  | NaN  |
 * | SkdWindingBound  | double | what that is off by at most, see SetWindingTolerance    | NaN  |
 * "None" is a point that is outside; of one that is not finite the confidence is 0, too. SkdInside
 * becomes the active scalars.
 *
 * Output port 1: by choice (see SetExtract) what of the input is inside, or outside, as a
 * vtkUnstructuredGrid; of composite data a vtkMultiBlockDataSet with one for each data set in it.
 *
 * Field data of output port 0, one value each: SkdReportPoints, SkdReportPointsInside,
 * SkdReportParts, SkdReportOpenParts, SkdReportOpenEdges, SkdReportOuterFaces (1 where volume cells
 * were taken for their outer faces), SkdReportTreesBuilt (0 if all were reused),
 * SkdReportBuildSeconds and SkdReportQuerySeconds; and SkdReportChordalLength where there are
 * curved cells (see SetChordalDeviation).
 *
 * Bad input: a Source without cells, or without surfaces where they are needed, gives a warning and
 * nothing is inside. A PartArray that some block does not have, and volume cells with
 * UseOuterFaces off, give an error and an empty output. Open edges (that an odd number of a part's
 * faces use) give one warning that counts them: answers near them may be wrong, and the confidence
 * tells.
 *
 * @sa
 * vtkSkdTreeCellLocator vtkSelectEnclosedPoints
 */

#ifndef vtkSkdTreePointInOut_h
#define vtkSkdTreePointInOut_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class SkdInOuts;
class SkdLoop;
struct SkdBlock;

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreePointInOut : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreePointInOut, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreePointInOut* New();

  enum ModelType
  {
    BOUNDARIES = 0,
    BODY_FITTED_MESH = 1
  };

  ///@{
  /**
   * What the Source is: surfaces (default), or a mesh that fills the parts.
   */
  vtkSetClampMacro(Model, int, BOUNDARIES, BODY_FITTED_MESH);
  vtkGetMacro(Model, int);
  ///@}

  enum PartsType
  {
    BLOCKS = 0,
    CELL_ARRAY = 1,
    CONNECTED_PIECES = 2
  };

  ///@{
  /**
   * What a part is: a block of composite data, with its flat index as id, and all of other data,
   * with id 0 (BLOCKS, default); the cells of one value of PartArray, rounded, the id (CELL_ARRAY);
   * cells that are connected by points of equal coordinates, with ids 0, 1, ... in the order of
   * their first cells (CONNECTED_PIECES; a BODY_FITTED_MESH takes BLOCKS instead).
   */
  vtkSetClampMacro(Parts, int, BLOCKS, CONNECTED_PIECES);
  vtkGetMacro(Parts, int);
  ///@}

  ///@{
  /**
   * The cell array of Parts = CELL_ARRAY: numbers, in all blocks. Default "".
   */
  void SetPartArray(const char* name);
  const char* GetPartArray() const { return this->PartArray.c_str(); }
  ///@}

  enum MethodType
  {
    AXIS_RAYS = 0,
    RANDOM_RAYS = 1,
    WINDING_NUMBER = 2,
    NEAREST_FEATURE = 3,
    AUTOMATIC = 4
  };

  ///@{
  /**
   * How a surface tells inside from outside:
   * - AUTOMATIC (default): of a part without open edges the crossings of a ray along an axis, and
   *   which way it goes through each. Closed shells of the part that lie within each other without
   *   touching are by turns bodies and cavities, whatever the way their triangles are turned. Of
   *   shells that touch or overlap, and of one that runs through itself, all is inside that their
   *   winding number is not 0 of: the union, each turned outward, but cavities that are turned so.
   *   Which touch is found when a point is within two for the first time, for about the cost of a
   *   build. The confidence is 1, but 1/2 where the triangles as they are turned say otherwise (a
   *   shell within another that is turned the same way, bodies that overlap and one of which is
   *   inside out) or cannot be turned alike, and 3/4 where bodies overlap whose triangles are not
   *   turned alike. A part with gaps goes by WINDING_NUMBER, as if RepairOrientation were on.
   * - AXIS_RAYS: the parity of the crossings of a ray along an axis, the shortest way out: what two
   *   bodies of a part share is outside. Of a surface with gaps, a vote of up to six, and a seventh
   *   if they are divided.
   * - RANDOM_RAYS: the same in directions that are spread evenly over the sphere, of a surface with
   *   gaps a vote of up to NumberOfRays, and one more if they are divided. Voting ends once it is
   *   decided. The confidence is the share of the votes.
   * - WINDING_NUMBER: inside where the generalised winding number is at least 1/2, or at most -1/2.
   *   It bears gaps, intersections and double faces, and wants triangles that are mostly turned the
   *   same way. The confidence is 1/2 and the distance of the number to this limit, at most 1.
   * - NEAREST_FEATURE: the side of the nearest face, edge or corner by its normal; wants normals
   *   that point outward. The confidence is 1/2 where that is an open edge.
   *
   * Outside of a part's bounds nothing is inside: the confidence is 1 of closed parts and by rays,
   * else that of the answer, 1/2 where the number or the normal would have it inside.
   */
  vtkSetClampMacro(Method, int, AXIS_RAYS, AUTOMATIC);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Of RANDOM_RAYS, of surfaces with gaps. Range 1 to 1000, default 10.
   */
  vtkSkdTreeSetWithinMacro(NumberOfRays, int, 1, 1000);
  vtkGetMacro(NumberOfRays, int);
  ///@}

  ///@{
  /**
   * Of RANDOM_RAYS: another seed gives other directions; each point has its own. Default 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * What SkdWindingNumber, and the confidence by it, may be off by at most, times the number of
   * parts. Range 0 (all triangles are summed: O(N) a point) to 1, default 0.25, at which sums take
   * least: the bound is one for all surfaces, and the error mostly a hundredth of it.
   * SkdWindingBound tells the bound of each point. Half as much takes about 1.6 times as long.
   * Whether a number is beyond 1/2 is decided exactly at any tolerance, but for rounding.
   */
  vtkSkdTreeSetWithinMacro(WindingTolerance, double, 0.0, 1.0);
  vtkGetMacro(WindingTolerance, double);
  ///@}

  enum AskType
  {
    POINTS = 0,
    CELL_CENTERS = 1,
    CELLS_ALL_POINTS = 2,
    CELLS_ANY_POINT = 3
  };

  ///@{
  /**
   * What is asked for: the input's points (default), or its cells: by their centres (the mean of
   * their points), inside if all their points are, or if any is. Of all points a cell gets the part
   * and confidence of the one with the least depth, of any point those of the one with the
   * greatest, ties to the first.
   */
  vtkSetClampMacro(Ask, int, POINTS, CELLS_ANY_POINT);
  vtkGetMacro(Ask, int);
  ///@}

  ///@{
  /**
   * Points at this distance from a part's surface or nearer are marked as on the boundary. World
   * units, default 0: none is.
   */
  vtkSkdTreeSetWithinMacro(BoundaryBand, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BoundaryBand, double);
  ///@}

  ///@{
  /**
   * Take the outer faces of volume cells for surfaces. Default on.
   */
  vtkSetMacro(UseOuterFaces, bool);
  vtkGetMacro(UseOuterFaces, bool);
  vtkBooleanMacro(UseOuterFaces, bool);
  ///@}

  ///@{
  /**
   * For WINDING_NUMBER and NEAREST_FEATURE, which go by the triangles' normals: turn these outward
   * first. Neighbours are turned alike, and what hangs together so by axis rays from its largest
   * triangle. Default off.
   */
  vtkSetMacro(RepairOrientation, bool);
  vtkGetMacro(RepairOrientation, bool);
  vtkBooleanMacro(RepairOrientation, bool);
  ///@}

  enum ExtractType
  {
    NOTHING = 0,
    INSIDE = 1,
    OUTSIDE = 2
  };

  ///@{
  /**
   * What output port 1 holds: nothing (default), or the input's points or cells, by what was asked,
   * that are inside or outside, with all data of port 0.
   */
  vtkSetClampMacro(Extract, int, NOTHING, OUTSIDE);
  vtkGetMacro(Extract, int);
  ///@}

  ///@{
  /**
   * The largest distance of facets from a curved face, relative to the diagonal of the bounds of
   * the whole Source. Faces of quadratic, Lagrange and Bezier cells are cut into flat facets, and
   * these are what the filter is exact about: as many as are needed for the deviation, which fit
   * together without gaps, at most 128 along a side; a face that is straight within the deviation
   * stays one polygon. Of linear cells nothing changes. The number of facets grows as the inverse
   * of the deviation: about 10^4 of a sphere by default. SkdReportChordalLength tells the length
   * that it is, where there are curved cells. Clamped to [1e-7, 1]. Default 1e-4.
   */
  vtkSkdTreeSetWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  vtkGetMacro(ChordalDeviation, double);
  ///@}

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeSetWithinMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

protected:
  vtkSkdTreePointInOut();
  ~vtkSkdTreePointInOut() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

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
  double ChordalDeviation = 1e-4;
  double Epsilon = 1e-9;

private:
  vtkSkdTreePointInOut(const vtkSkdTreePointInOut&) = delete;
  void operator=(const vtkSkdTreePointInOut&) = delete;

  class Internals;
  bool CheckSource();
  void UpdateParts();
  void WarnAbout();
  SkdInOuts AskMesh(vtkDataSet* mesh, SkdLoop& loop);
  void ExtractFrom(vtkDataSet* mesh, const SkdInOuts& answers, vtkInformationVector* outputVector);
  vtkIdType CountQueryPoints(const std::vector<SkdBlock>& blocks) const;
  void Report(vtkDataObject* output, vtkIdType asked, vtkIdType inside, double buildSeconds,
    double querySeconds);

  std::unique_ptr<Internals> Impl; // the parts, kept while the source is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
