// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdArrayGather.h
 * @brief Arrays of several data sets, gathered tuple by tuple.
 *
 * Arrays of one name are one array if they have the same number of components and are all numeric
 * or all strings; of others the first counts. The result has the type of the first (a bit array
 * becomes unsigned char, whose values can be written in parallel). Where a data set does not have
 * it, tuples stay as they were allocated, and a second array marks where there is a value: see
 * SkdPartialArrays.h.
 */

#ifndef SkdArrayGather_h
#define SkdArrayGather_h

#include "Pipeline/SkdBlocks.h"
#include "vtkAbstractArray.h"
#include "vtkMath.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataSetAttributes;
class vtkIdList;

namespace skdtree
{
class SkdArrayGather
{
public:
  /// Finds the arrays for which `isWanted` returns true, in the order of their first data set. In
  /// place of a data set that has no elements may be nullptr.
  SkdArrayGather(const std::vector<vtkDataSetAttributes*>& sets,
    const std::function<bool(vtkAbstractArray*)>& isWanted);

  /// Makes the resulting arrays, of n tuples: `fill`, rounded and 0 for NaN in integer arrays;
  /// empty strings. With `isDouble` arrays of numbers become arrays of double, so nothing is
  /// rounded.
  void Allocate(vtkIdType n, double fill = vtkMath::Nan(), bool isDouble = false);

  /// The same for callers that take, interpolate or clear each tuple: to fill arrays first, but for
  /// partial ones, would be in vain.
  void AllocateUnfilled(vtkIdType n);

  ///@{
  /// Sets tuple `to` of each result from tuples of data set `set`. Thread-safe for distinct `to`.
  void Interpolate(vtkIdType to, int set, vtkIdList* ids, double* weights);
  void Take(vtkIdType to, int set, vtkIdType from);
  ///@}
  /// Sets tuple `to` to NaN, or 0 in integer arrays. Thread-safe for distinct `to`.
  void Clear(vtkIdType to);

  /// Adds the resulting arrays and the marks of partial ones.
  void AddTo(vtkDataSetAttributes* attributes) const;

  ///@{
  /// The resulting arrays one by one.
  int GetNumberOfArrays() const { return static_cast<int>(this->Arrays.size()); }
  vtkAbstractArray* GetResult(int i) const { return this->Arrays[i].Result; }
  vtkAbstractArray* GetFirst(int i) const { return this->Arrays[i].First; }
  /// nullptr if that data set does not have it.
  vtkAbstractArray* GetSource(int i, int set) const { return this->Arrays[i].Sources[set]; }
  ///@}

private:
  /// Copies tuples from a source into the result, without a virtual call a value for common array
  /// types.
  using InterpolateFunction = void (*)(vtkAbstractArray* result, vtkIdType to,
    vtkAbstractArray* source, vtkIdList* ids, double* weights);
  using TakeFunction = void (*)(
    vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdType from);

  struct Array
  {
    vtkAbstractArray* First = nullptr;
    std::vector<vtkAbstractArray*> Sources; // one a set
    bool IsPartial = false;
    vtkSmartPointer<vtkAbstractArray> Result;
    vtkSmartPointer<vtkUnsignedCharArray> Marks; // of a partial one
    InterpolateFunction Interpolate = nullptr;
    TakeFunction Take = nullptr;
  };

  static void AllocateMarks(Array& array, vtkIdType n);
  static Array Find(const std::vector<vtkDataSetAttributes*>& sets, vtkAbstractArray* first);
  static void ChooseFunctions(Array& array);
  static vtkAbstractArray* SourceOf(const Array& array, vtkIdType to, int set);

  std::vector<Array> Arrays;
};

/// The arrays (of points or cells, vtkDataObject's type) of the blocks, made for `n` tuples of
/// "none" and added to `target`: all but ghost marks, and points' ids and rational weights.
/// Names that are already in use are not added but inserted into `refused`.
SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused);

/// The same for callers that take, interpolate or clear each tuple.
SkdArrayGather SkdGatherUnfilled(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused);

/// The same for arrays for whose name `isWanted` returns true; "none" is `fill`, see
/// SkdArrayGather.
SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused, double fill,
  const std::function<bool(const std::string&)>& isWanted);

/// Warns about arrays that were not added.
void SkdWarnAboutRefused(vtkAlgorithm* self, const std::set<std::string>& refused);
}

#endif
