// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSkdTreeBooleanOperation
 * @brief Union, intersection and differences of solids
 *
 * Combines the solids within two closed surfaces, Input (port 0) and Source (port 1). Without a
 * Source the solids are the blocks of the Input if it has several (those without faces are empty),
 * else its pieces that edges connect. The output is the surface of the combination, with the solid
 * behind each face. It is found by exact tests: all surfaces are split along all their
 * intersections, also with themselves, and the exact order of the pieces around each edge tells
 * which regions of space they separate. Faces that coincide are kept once or dropped as the
 * operation says. Inputs may be any data sets or composite data; the outer faces of volume cells
 * are used. With a Source, AMR data and the pieces of a vtkPartitionedDataSet are one mesh: faces
 * between its blocks or pieces are no outer ones.
 *
 * Inside of a surface is where its winding number is not 0 (see InsideRule). So a surface may
 * intersect itself, overlap in parts, have faces twice, or be inside out.
 *
 * In an intersection, a difference or a split the Source may be open: then it cuts the Input, and
 * stands for what is behind it (where its normals do not point). Several sheets may cut it into
 * several parts: a winding number grows by 1 from in front of each sheet to behind it, and is 0
 * where it is least. What of the Source does not divide the Input, as its border is within it,
 * counts for nothing, with a warning: an Input that is not divided stays whole in a difference, and
 * is not in an intersection. Parts of the Input that the Source does not meet are on the side of
 * its nearest triangle.
 *
 * Without a Source a plane can do the same: see CutByPlane.
 *
 * A split has all parts of the first solid at once, each with its closed surface: two of them have
 * no point in common, and the faces of a cut are there twice, facing each other.
 *
 * Output port 1, vtkPolyData: the section, what of the Source is within the Input, with the normals
 * of the Source, of a split and of a difference or an intersection that an open Source cuts.
 * Where the Source coincides with the surface of the Input it is not within. Its points are those
 * of port 0 at the cut, and so are its arrays. Each connected piece of a flat face is one polygon;
 * one with holes is triangles, and so are all unless JoinPieces and KeepPolygons are on.
 *
 * Points that round to the same coordinates are one. Pieces that become flat by that, or come to
 * lie face to face, are not in the output. So it is closed as it is stored, and stays closed when
 * it is triangulated by vtkTriangleFilter or equal points are merged (vtkCleanPolyData with a
 * tolerance of 0); no edge has the length 0.
 *
 * Cell data of the output, besides those that all input data sets have:
 *
 * | name             | type   | meaning                                                     |
 * | ---------------- | ------ | ----------------------------------------------------------- |
 * | SkdInputId       | int    | 0 of a face of the Input, 1 of one of the Source            |
 * | SkdSolidId       | int    | the solid of a face, unless the solids are the inputs       |
 * | SkdCellId        | idtype | the cell that the face comes from                           |
 * | SkdBlockIndex    | int    | flat index of the cell's block, of composite data           |
 * | SkdFaceId        | idtype | the same for pieces of one face: see JoinPieces             |
 * | SkdSolidsInFront | int    | of an imprint of closed surfaces: how many solids are there |
 * | SkdSolidsBehind  | int    | the same behind the face                                    |
 * | SkdPartId        | int    | of a split: the number of the part of a face                |
 *
 * They replace arrays of these names, such as those of an operation before. Of several faces that
 * coincide the output has the first. A part's number is 0 of what is outside of all others, or in
 * front of an open Source, and else how many solids it is in, or how many sheets it is behind: of
 * two inputs 1 is inside of the Source, or behind it.
 *
 * Point data that all input data sets have are interpolated within the face that a point is in; a
 * point of several surfaces has those of the first.
 *
 * Field data, one value each: SkdReportInputVolume, SkdReportInputArea, SkdReportSourceVolume,
 * SkdReportSourceArea, SkdReportVolume and SkdReportArea (of the output), SkdReportPartVolumes (of
 * a split, one value a part from 0 on), SkdReportTreesBuilt, SkdReportSolids,
 * SkdReportTrianglesArranged (not all where only those near the Input of a Source that moves),
 * SkdReportTrianglesSplit, SkdReportTrianglesFolded (pieces that rounding has made flat),
 * SkdReportPointsAligned (see AlignFaces), SkdReportCoordinateBits (24 if some points are stored as
 * floats or an input says so, else 53),
 * SkdReportBadEdges (of the output as it is stored: 0 of a closed oriented surface),
 * SkdReportCellsInContact (see "Several processes"), SkdReportSeconds.
 *
 * Cost: O(n log n) for n triangles, plus the exact tests of those that intersect. What was found is
 * kept while the inputs are unchanged, about 150 bytes a triangle: then another operation costs
 * O(n). All pieces are made, also those within other solids: where k solids overlap, there are up
 * to O(k^3) of them, at about 6 us each. Where that is many more than there are triangles that
 * intersect, solids are united in pairs instead, those near each other first, which takes about
 * O(m log n) for n solids and m triangles of their unions; nothing is kept. Each step is exact, and
 * rounds its new points. That goes for unions and differences, and for the pieces of the inputs in
 * all operations on two but the imprint, if the pieces of an input are closed, face outward and do
 * not intersect themselves. Triangles that are there many times cost what others do. The result
 * does not depend on the number of threads.
 *
 * Several processes: with SourceDistribution SOURCE_EXCHANGED two closed surfaces of plane faces
 * that are not moved stay in their pieces, for unions, intersections and differences. Cells that
 * touch or cross others that are not their neighbours come together on the process that has most of
 * those which hang together by boxes; the others stay where they are, and which side of them is
 * inside is counted along lines through the cells of all processes, by exact signs. Each process
 * outputs a part; together these have the same faces, to the last bit, ids and numbers of faces as
 * the output of one process that has all. SkdReportCellsInContact counts the cells that came
 * together. Whether the output is closed is told of all parts together; if it is not, and in all
 * other cases, the pieces are gathered, and the first process computes all; so they are where faces
 * of the two inputs are to be aligned (AlignFaces), as other triangles of these may be anywhere.
 *
 * Bad input: a surface that is open or has faces of opposite orientation side by side is an error
 * that tells where, and there is no output (see OpenSurfaces for scans). Triangles without area are
 * left out. An open Source that does not cut through gives a warning, and so do coordinates smaller
 * than 1e-80 times the largest, which are taken as 0: exact tests have no room for both.
 *
 * @sa
 * vtkSkdTreeSurfaceIntersection
 */

#ifndef vtkSkdTreeBooleanOperation_h
#define vtkSkdTreeBooleanOperation_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeSourceAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeBooleanOperation : public vtkSkdTreeSourceAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeBooleanOperation, vtkSkdTreeSourceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeBooleanOperation* New();

  enum Operations
  {
    UNION = 0,
    INTERSECTION = 1,
    DIFFERENCE = 2,
    REVERSE_DIFFERENCE = 3,
    SYMMETRIC_DIFFERENCE = 4,
    AT_LEAST = 5,
    IMPRINT = 6,
    SPLIT = 7
  };
  enum OpenSurfacesRules
  {
    REFUSE = 0,
    WINDING_NUMBER = 1
  };
  enum InsideRules
  {
    NONZERO = 0,
    ODD = 1,
    POSITIVE = 2
  };

  //@{
  /**
   * What is solid: what is in any of the solids (union), in all of them (intersection), in the
   * first only (difference), in others only (reverse difference), in an odd number of them, of two
   * in exactly one (symmetric difference), or in at least MinimumNumberOfSolids of them (then also
   * blocks or pieces of two inputs count). An imprint keeps all faces, split along all
   * intersections, each part once; surfaces may be open. A split has all parts into which others
   * divide the first (see SkdPartId). Default UNION.
   */
  vtkSkdTreeChoiceMacro(Operation, UNION, SPLIT);
  void SetOperationToUnion() { this->SetOperation(UNION); }
  void SetOperationToIntersection() { this->SetOperation(INTERSECTION); }
  void SetOperationToDifference() { this->SetOperation(DIFFERENCE); }
  void SetOperationToReverseDifference() { this->SetOperation(REVERSE_DIFFERENCE); }
  void SetOperationToSymmetricDifference() { this->SetOperation(SYMMETRIC_DIFFERENCE); }
  void SetOperationToAtLeast() { this->SetOperation(AT_LEAST); }
  void SetOperationToImprint() { this->SetOperation(IMPRINT); }
  void SetOperationToSplit() { this->SetOperation(SPLIT); }
  //@}

  //@{
  /**
   * In how many solids a point must be to be inside, for AT_LEAST. Default 2.
   */
  vtkSkdTreeWithinMacro(MinimumNumberOfSolids, int, 1, VTK_INT_MAX);
  //@}

  //@{
  /**
   * Inside of a surface is where its winding number is not 0 (NONZERO), is odd (ODD: what it covers
   * twice is outside) or is positive (POSITIVE: what is inside out is empty). Default NONZERO.
   */
  vtkSkdTreeChoiceMacro(InsideRule, NONZERO, POSITIVE);
  void SetInsideRuleToNonZero() { this->SetInsideRule(NONZERO); }
  void SetInsideRuleToOdd() { this->SetInsideRule(ODD); }
  void SetInsideRuleToPositive() { this->SetInsideRule(POSITIVE); }
  //@}

  //@{
  /**
   * What becomes of surfaces that are not closed: an error (REFUSE), but for a Source that cuts; or
   * inside is where their generalized winding number is at least one half (WINDING_NUMBER; Jacobson
   * et al. 2013), rounded for the InsideRule. Then the output is closed where its faces are far
   * from gaps compared with these, and may be open by them, with a warning that says so;
   * SkdReportOpenEdges are those of the inputs. Faces must have their normals outward. Default
   * REFUSE.
   */
  vtkSkdTreeChoiceMacro(OpenSurfaces, REFUSE, WINDING_NUMBER);
  void SetOpenSurfacesToRefuse() { this->SetOpenSurfaces(REFUSE); }
  void SetOpenSurfacesToWindingNumber() { this->SetOpenSurfaces(WINDING_NUMBER); }
  //@}

  //@{
  /**
   * Whether quads and polygons that are not cut stay such, if VTK can triangulate them, and flat
   * faces of the section are polygons. Otherwise, and of those that are cut, the output has
   * triangles (see MergePieces). Default on.
   */
  vtkSetMacro(KeepPolygons, vtkTypeBool);
  vtkGetMacro(KeepPolygons, vtkTypeBool);
  vtkBooleanMacro(KeepPolygons, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether faces of two bodies that are flush but for the rounding of their points to floats (or
   * of what their surfaces were made of: see SkdReportCoordinateBits) are put in one plane, that of
   * the largest, before all else. Without that, faces of bodies that were turned cross each other,
   * or have gaps between them, as exact tests see them: walls and slivers stay. Faces count as
   * flush within 16 roundings (2^-24 of each coordinate, along its axis); their points move by at
   * most 128, points of doubles not at all, nor those of plates that are thinner than that. That is
   * so of the inputs as they are, not as a motion places the Source. Default on.
   */
  vtkSetMacro(AlignFaces, vtkTypeBool);
  vtkGetMacro(AlignFaces, vtkTypeBool);
  vtkBooleanMacro(AlignFaces, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether pieces of one flat face that stay together are joined and triangulated anew, without
   * points that only pieces needed: none inside of a face, and none on a straight line between two
   * faces (a point leaves the line at most by rounding). A face is a cell, cells side by side with
   * the same cell data, or all cells of a data set with the same value of the cell array SkdFaceId,
   * as far as they are in one plane to within rounding. The output has this array, so that a face
   * stays one across operations that follow each other. A face has the ids and data of its first
   * cell. Where solids are united in pairs, pieces are joined in any case. Not in an imprint.
   * Default on.
   */
  vtkSetMacro(JoinPieces, vtkTypeBool);
  vtkGetMacro(JoinPieces, vtkTypeBool);
  vtkBooleanMacro(JoinPieces, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether pieces of a triangle that is cut are merged into convex polygons, where no other face
   * of the output meets their common edge, and where VTK can triangulate the polygon without losing
   * an edge of it. Not in an imprint. Default off.
   */
  vtkSetMacro(MergePieces, vtkTypeBool);
  vtkGetMacro(MergePieces, vtkTypeBool);
  vtkBooleanMacro(MergePieces, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether the cut by an open Source is closed by what of the Source is within the Input. Default
   * on.
   */
  vtkSetMacro(CloseCut, vtkTypeBool);
  vtkGetMacro(CloseCut, vtkTypeBool);
  vtkBooleanMacro(CloseCut, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether a plane cuts the Input in an intersection, a difference or a split without a Source, as
   * an open Source in the plane would that reaches beyond the Input: what is behind it is where
   * PlaneNormal (of any length but 0) does not point. A plane that is normal to an axis is exactly
   * where its origin is, any other to rounding. With WINDING_NUMBER (see OpenSurfaces) it cuts
   * surfaces that are not closed, too; CloseCut is on then. Other operations ignore it, with a
   * warning. Defaults off, (0, 0, 0) and (1, 0, 0).
   */
  vtkSetMacro(CutByPlane, vtkTypeBool);
  vtkGetMacro(CutByPlane, vtkTypeBool);
  vtkBooleanMacro(CutByPlane, vtkTypeBool);
  vtkSkdTreeFinite3Macro(PlaneOrigin);
  vtkSkdTreeFinite3Macro(PlaneNormal);
  //@}

  //@{
  /**
   * A motion of the Source: rotated about RotationCenter by Rotation (degrees about y, then x, then
   * z, as the orientation of vtkProp3D) and translated by Translation; its points are rounded where
   * they are then. While only the motion changes, inputs are not read again, and intersections of
   * the Input with itself are not searched again; from the second motion on only triangles near the
   * other surface are looked at, if both are closed surfaces of triangles that do not intersect
   * themselves. Vectors in the data are not rotated. Default 0:
   * not moved. Ignored without a Source.
   */
  vtkSkdTreeFinite3Macro(Translation);
  vtkSkdTreeFinite3Macro(Rotation);
  vtkSkdTreeFinite3Macro(RotationCenter);
  //@}

  //@{
  /**
   * The same by a matrix, applied before the rotation and translation above: see
   * vtkSkdTreeSurfaceIntersection::SetTransform. Default nullptr: none.
   */
  void SetTransform(vtkMatrix4x4* motion);
  vtkMatrix4x4* GetTransform();
  //@}

  //@{
  /**
   * The largest distance of facets from a curved face, relative to the diagonal of the bounds of
   * both inputs: see vtkSkdTreePointInOut::SetChordalDeviation. Default 1e-4.
   */
  vtkSkdTreeWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  //@}

protected:
  vtkSkdTreeBooleanOperation();
  ~vtkSkdTreeBooleanOperation() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool CanStayInPieces();
  void CombineWhole(
    vtkDataObject* input, vtkDataObject* source, vtkPolyData* output, vtkPolyData* section);

  int Operation = UNION;
  int MinimumNumberOfSolids = 2;
  int InsideRule = NONZERO;
  int OpenSurfaces = REFUSE;
  vtkTypeBool KeepPolygons = 1;
  vtkTypeBool AlignFaces = 1;
  vtkTypeBool JoinPieces = 1;
  vtkTypeBool MergePieces = 0;
  vtkTypeBool CloseCut = 1;
  vtkTypeBool CutByPlane = 0;
  double PlaneOrigin[3] = { 0.0, 0.0, 0.0 };
  double PlaneNormal[3] = { 1.0, 0.0, 0.0 };
  double ChordalDeviation = 1e-4;
  double Translation[3] = { 0.0, 0.0, 0.0 };
  double Rotation[3] = { 0.0, 0.0, 0.0 };
  double RotationCenter[3] = { 0.0, 0.0, 0.0 };

private:
  vtkSkdTreeBooleanOperation(const vtkSkdTreeBooleanOperation&) = delete;
  void operator=(const vtkSkdTreeBooleanOperation&) = delete;

  bool UsesPlane() const;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
