// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeClosestPoint
 * @brief   nearest point, cell and distance of a source mesh for each input point
 *
 * For each point of Input (port 0, any vtkDataSet or composite of them) the nearest point on the
 * cells of Source (port 1, any vtkDataSet or composite), by the skD-tree (sections 4, 5 and 6.4 of
 * Khamayseh and Hansen, Commun. Comput. Phys. 2 (2007) 545-576). Exact in double precision; the
 * same answer whatever the number of threads; the tree is kept while the Source is unchanged.
 *
 * Output port 0: the input with the point arrays
 * | name                 | type   | components | meaning                              | none |
 * | -------------------- | ------ | ---------- | ------------------------------------ | ---- |
 * | SkdClosestPoint      | double | 3          | nearest point on the source          | NaN  |
 * | SkdDistance          | double | 1          | distance; negative inside if signed  | NaN  |
 * | SkdClosestCellId     | idtype | 1          | source cell, ties to the lowest id   | -1   |
 * | SkdClosestBlockIndex | int    | 1          | flat index of the source's block; only of a composite Source | -1 |
 * and by choice the source's point data interpolated, and cell data taken, at the nearest point
 * (see InterpolateSourceData). "None" is a point farther than MaximumDistance, or not finite.
 *
 * Output port 1: by choice (see GenerateLines) vtkPolyData with a line from each point that has an
 * answer to its nearest point, with the point's arrays as cell data.
 *
 * Bad input: a Source without cells, or with none that a tree can hold, gives a warning and "none"
 * everywhere. An unset Source is an error of the pipeline. SignedDistance on a Source that is no
 * closed surface gives one warning that counts its open edges; the sign then goes by vote.
 *
 * @sa
 * vtkSkdTreeCellLocator
 */

#ifndef vtkSkdTreeClosestPoint_h
#define vtkSkdTreeClosestPoint_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeClosestPoint : public vtkPassInputTypeAlgorithm
{
public:
  vtkTypeMacro(vtkSkdTreeClosestPoint, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  static vtkSkdTreeClosestPoint* New();

  ///@{
  /**
   * The mesh that is searched (port 1).
   */
  void SetSourceConnection(vtkAlgorithmOutput* algOutput);
  void SetSourceData(vtkDataObject* source);
  ///@}

  ///@{
  /**
   * Distance beyond which a point gets no answer. Default VTK_DOUBLE_MAX: none.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Give the distance a sign, negative inside the closed surface that Source is (or that bounds
   * it). Inside is decided by the parity of exact crossings, so orientation does not matter.
   * Default off.
   */
  vtkSetMacro(SignedDistance, bool);
  vtkGetMacro(SignedDistance, bool);
  vtkBooleanMacro(SignedDistance, bool);
  ///@}

  ///@{
  /**
   * Interpolate the source's point data at the nearest point, and take its cell data there; both
   * become point arrays of the output, under their own names. Of a composite Source, the arrays
   * that all its blocks have; a name that the Input has already keeps the Input's array, with a
   * warning. Points without an answer get NaN, or 0 in integer arrays. Default off.
   */
  vtkSetMacro(InterpolateSourceData, bool);
  vtkGetMacro(InterpolateSourceData, bool);
  vtkBooleanMacro(InterpolateSourceData, bool);
  ///@}

  ///@{
  /**
   * Fill output port 1 with a line from each point to its nearest. Default off.
   */
  vtkSetMacro(GenerateLines, bool);
  vtkGetMacro(GenerateLines, bool);
  vtkBooleanMacro(GenerateLines, bool);
  ///@}

  ///@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSetClampMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

protected:
  vtkSkdTreeClosestPoint();
  ~vtkSkdTreeClosestPoint() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double MaximumDistance = VTK_DOUBLE_MAX;
  bool SignedDistance = false;
  bool InterpolateSourceData = false;
  bool GenerateLines = false;
  double Epsilon = 1e-9;

private:
  vtkSkdTreeClosestPoint(const vtkSkdTreeClosestPoint&) = delete;
  void operator=(const vtkSkdTreeClosestPoint&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl; // the source's trees, kept while it is unchanged
};

VTK_ABI_NAMESPACE_END
#endif
