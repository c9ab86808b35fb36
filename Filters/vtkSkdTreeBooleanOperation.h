// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSkdTreeBooleanOperation
 * @brief Union, intersection and differences of two solids
 *
 * Combines the solids within two closed surfaces, Input (port 0) and Source (port 1). The output is
 * the surface of the combination, triangulated, with the solid behind each face. It is found by
 * exact tests: where surfaces intersect, both are cut at the same points, and faces that coincide
 * are kept once or dropped as the operation says. Inputs may be any data sets or composite data;
 * the outer faces of volume cells are used.
 *
 * Cell data of the output, besides those that all input data sets have:
 *
 * | name          | type   | meaning                                           |
 * | ------------- | ------ | ------------------------------------------------- |
 * | SkdInputId    | int    | 0 of a face of the Input, 1 of one of the Source  |
 * | SkdCellId     | idtype | the cell that the triangle comes from             |
 * | SkdBlockIndex | int    | flat index of the cell's block, of composite data |
 *
 * They replace arrays of these names, such as those of an operation before.
 *
 * Point data that all input data sets have are interpolated within the face that a point is in; a
 * point of both surfaces has those of the Input.
 *
 * Field data, one value each: SkdReportInputVolume, SkdReportSourceVolume, SkdReportVolume (of the
 * output), SkdReportTrianglesSplit, SkdReportBadEdges (of the output: 0 of a closed oriented
 * surface), SkdReportSeconds.
 *
 * Both surfaces must be closed and oriented consistently, cavities against their bodies; a surface
 * whose volume is negative is turned over. A surface must not intersect itself; blocks of one input
 * must not overlap each other.
 *
 * Cost: O(n log n) for n triangles, plus the exact tests of those that intersect. The result does
 * not depend on the number of threads. Of several processes the first computes all.
 *
 * Bad input: a surface that is open or has faces turned against each other is an error that tells
 * where, and there is no output. A surface that intersects itself gives a warning: then what it
 * covers twice counts as its faces say. Should the output have bad edges nevertheless, a warning
 * tells where.
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

VTK_ABI_NAMESPACE_BEGIN

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
    SYMMETRIC_DIFFERENCE = 4
  };

  //@{
  /**
   * What is solid: what is in the Input or the Source (union), in both (intersection), in the Input
   * only (difference), in the Source only (reverse difference), or in exactly one of them
   * (symmetric difference). Default UNION.
   */
  vtkSkdTreeChoiceMacro(Operation, UNION, SYMMETRIC_DIFFERENCE);
  void SetOperationToUnion() { this->SetOperation(UNION); }
  void SetOperationToIntersection() { this->SetOperation(INTERSECTION); }
  void SetOperationToDifference() { this->SetOperation(DIFFERENCE); }
  void SetOperationToReverseDifference() { this->SetOperation(REVERSE_DIFFERENCE); }
  void SetOperationToSymmetricDifference() { this->SetOperation(SYMMETRIC_DIFFERENCE); }
  //@}

  //@{
  /**
   * The largest distance of facets from a curved face, relative to the diagonal of the bounds of
   * its surface, Input or Source: see vtkSkdTreePointInOut::SetChordalDeviation. Default 1e-4.
   */
  vtkSkdTreeWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  //@}

protected:
  vtkSkdTreeBooleanOperation();
  ~vtkSkdTreeBooleanOperation() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Operation = UNION;
  double ChordalDeviation = 1e-4;

private:
  vtkSkdTreeBooleanOperation(const vtkSkdTreeBooleanOperation&) = delete;
  void operator=(const vtkSkdTreeBooleanOperation&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
