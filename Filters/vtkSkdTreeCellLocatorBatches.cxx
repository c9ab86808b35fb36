// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The locator's batches: queries over arrays, asked in parallel, answered into flat arrays.
#include "vtkSkdTreeCellLocator.h"

#include "Cells/SkdBatchLists.h"
#include "Cells/SkdLocatorState.h"
#include "Cells/SkdNearestInTurn.h"

#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Outputs = std::vector<vtkDataArray*>;

/// Whether an array is handed in twice, as an output and as another or as the queries.
bool HaveDoubles(vtkDataArray* queries, const Outputs& outputs)
{
  return std::any_of(outputs.begin(), outputs.end(),
    [&](vtkDataArray* array) {
      return array && (array == queries || std::count(outputs.begin(), outputs.end(), array) > 1);
    });
}

/// Why a batch cannot be asked, in words; empty if it can.
std::string ReasonAgainst(vtkDataArray* queries, SkdBatchOf kind, const Outputs& outputs)
{
  if (!queries)
  {
    return "the array of queries is missing";
  }
  const int components = SkdNumberOfComponents(kind);
  if (queries->GetNumberOfComponents() != components)
  {
    return "the queries have " + std::to_string(queries->GetNumberOfComponents()) +
      " components instead of " + std::to_string(components);
  }
  return HaveDoubles(queries, outputs) ? "the same array is passed twice" : "";
}

/// A batch that cannot be asked is refused with an error.
bool IsRefused(vtkObject* locator, const char* method, vtkDataArray* queries, SkdBatchOf kind,
  const Outputs& outputs)
{
  const std::string reason = ReasonAgainst(queries, kind, outputs);
  if (!reason.empty())
  {
    vtkErrorWithObjectMacro(locator, << method << ": " << reason << ".");
  }
  return !reason.empty();
}

/// Sizes an output and hands out its values: nullptr for one that is not wanted.
template <class Array>
auto Prepare(Array* array, const char* name, int components, vtkIdType size)
  -> decltype(array->GetPointer(0))
{
  if (!array)
  {
    return nullptr;
  }
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  return array->GetPointer(0);
}

template <class Value>
void Store(Value* values, vtkIdType i, Value value)
{
  if (values)
  {
    values[i] = value;
  }
}

void Store(double* values, vtkIdType i, const skd::Vector3& value)
{
  if (values)
  {
    SkdStore(value, values + 3 * i);
  }
}

skd::Vector3 NoPoint()
{
  return { { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() } };
}

/// The cells within boxes, as lists in the order of the tree, or by id.
vtkIdType FindLists(const SkdCellTree& tree, const skd::RigidMotion* motion, vtkDataArray* boxes,
  bool byId, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds)
{
  const SkdBatch batch(boxes, SkdBatchOf::Boxes);
  const SkdBatchLists<vtkIdType> lists(batch, offsets,
    [&](vtkIdType slot, std::vector<vtkIdType>& values)
    {
      thread_local vtkNew<vtkIdList> found;
      double b[6];
      batch.Read(slot, b);
      const skd::Box3 box({ { b[0], b[2], b[4] } }, { { b[1], b[3], b[5] } });
      tree.FindWithinBounds(box, motion, found);
      vtkIdType* first = found->GetPointer(0);
      vtkIdType* last = first + found->GetNumberOfIds();
      if (byId)
      {
        std::sort(first, last);
      }
      values.insert(values.end(), first, last);
    });
  vtkIdType* ids = Prepare(cellIds, "SkdCellId", 1, lists.GetNumberOfValues());
  lists.ForEach([ids](vtkIdType index, vtkIdType, vtkIdType id) { Store(ids, index, id); });
  return lists.GetNumberOfValues();
}

/// The bounds of all cells of a data set; empty for those that are not in the tree.
vtkSmartPointer<vtkDoubleArray> BoundsOfCells(
  const SkdCellTree& tree, const skd::RigidMotion* motion, vtkIdType numberOfCells)
{
  auto boxes = vtkSmartPointer<vtkDoubleArray>::New();
  double* bounds = Prepare(boxes.Get(), "SkdBounds", 6, numberOfCells);
  vtkSMPTools::For(0, numberOfCells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const std::int64_t cell = tree.Cells().CellOfId(id);
        const skd::Box3 box =
          cell < 0 ? skd::Box3() : tree.WorldBoundsOf(static_cast<std::uint32_t>(cell), motion);
        for (int axis = 0; axis < 3; ++axis)
        {
          bounds[6 * id + 2 * axis] = box.Min[axis];
          bounds[6 * id + 2 * axis + 1] = box.Max[axis];
        }
      }
    });
  return boxes;
}

/// Pairs of cells whose bounds overlap, none of them moved: for each cell id of the first tree's
/// data set a list by id.
vtkIdType FindPairLists(const SkdCellTree& tree, const SkdCellTree& other, vtkIdType size,
  vtkIdTypeArray* offsets, vtkIdTypeArray* otherCellIds)
{
  const auto parts = tree.FindBoundsPairs(other);
  const auto forEachPair = [&](const auto& body)
  {
    for (const auto& part : parts)
    {
      for (const SkdCellTree::CellPair& pair : part)
      {
        body(tree.Cells().IdOf(pair.first), other.Cells().IdOf(pair.second));
      }
    }
  };
  vtkNew<vtkIdTypeArray> ownOffsets; // for those who want none
  vtkIdType* starts = Prepare(offsets ? offsets : ownOffsets.Get(), "SkdOffsets", 1, size + 1);
  std::fill_n(starts, size + 1, vtkIdType(0));
  forEachPair([&](vtkIdType id, vtkIdType) { ++starts[id]; });
  std::partial_sum(starts, starts + size + 1, starts); // the ends of the lists
  vtkIdType* others = Prepare(otherCellIds, "SkdCellId", 1, starts[size]);
  forEachPair([&](vtkIdType id, vtkIdType there) { Store(others, --starts[id], there); });
  vtkSMPTools::For(0, others ? size : 0,
    [=](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        if (starts[id + 1] - starts[id] > 1) // a glance at each of many cells that have none
        {
          std::sort(others + starts[id], others + starts[id + 1]);
        }
      }
    });
  return starts[size];
}

struct Hit
{
  vtkIdType Id;
  double T;
};
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindClosestPoints(vtkDataArray* points, vtkIdTypeArray* cellIds,
  vtkDoubleArray* closestPoints, vtkDoubleArray* distances, double radius)
{
  if (IsRefused(this, "FindClosestPoints", points, SkdBatchOf::Points,
        { cellIds, closestPoints, distances }))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(points, SkdBatchOf::Points);
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = Prepare(cellIds, "SkdClosestCellId", 1, size);
  double* nearest = Prepare(closestPoints, "SkdClosestPoint", 3, size);
  double* lengths = Prepare(distances, "SkdDistance", 1, size);
  const double limit2 = radius >= 0.0 ? radius * radius : -1.0;
  return batch.CountTrue(
    [&] {
      return SkdNearestInTurn(tree, { this->DataSet, SkdScratchCell() }, limit2);
    },
    [&](SkdNearestInTurn& inTurn, vtkIdType slot)
    {
      double x[3];
      batch.Read(slot, x);
      const SkdFoundCell found = inTurn.Find(this->Impl->ToTree(x));
      const bool isFound = found.Id >= 0;
      Store(ids, slot, found.Id);
      Store(nearest, slot, isFound ? this->Impl->ToWorld(found.Point) : NoPoint());
      Store(lengths, slot, isFound ? std::sqrt(found.Dist2) : vtkMath::Nan());
      return isFound;
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCells(
  vtkDataArray* points, vtkIdTypeArray* cellIds, vtkDoubleArray* pcoords, double tol2)
{
  if (IsRefused(this, "FindCells", points, SkdBatchOf::Points, { cellIds, pcoords }))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(points, SkdBatchOf::Points);
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = Prepare(cellIds, "SkdCellId", 1, size);
  double* coordinates = Prepare(pcoords, "SkdParametricCoordinates", 3, size);
  return batch.CountTrue(
    [&] {
      return SkdCellSource{ this->DataSet, SkdScratchCell() };
    },
    [&](const SkdCellSource& source, vtkIdType slot)
    {
      double x[3];
      batch.Read(slot, x);
      SkdFoundCell found = tree.FindContaining(this->Impl->ToTree(x), tol2, -1, source);
      const bool isFound = found.Id >= 0;
      Store(ids, slot, found.Id);
      if (isFound && coordinates)
      {
        tree.Interpolate(found, nullptr, source);
        found.PCoords = tree.MovedPCoords(
          this->Impl->GetMotion(), found.Id, this->Impl->ToWorld(found.Point), found.PCoords);
      }
      Store(coordinates, slot, isFound ? found.PCoords : NoPoint());
      return isFound;
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::IntersectWithLines(vtkDataArray* lines, vtkIdTypeArray* cellIds,
  vtkDoubleArray* parameters, vtkDoubleArray* points, double tol)
{
  if (IsRefused(
        this, "IntersectWithLines", lines, SkdBatchOf::Lines, { cellIds, parameters, points }))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(lines, SkdBatchOf::Lines);
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = Prepare(cellIds, "SkdCellId", 1, size);
  double* ts = Prepare(parameters, "SkdParameter", 1, size);
  double* xs = Prepare(points, "SkdPoint", 3, size);
  return batch.CountTrue(
    [&] {
      return SkdCellSource{ this->DataSet, SkdScratchCell() };
    },
    [&](const SkdCellSource& source, vtkIdType slot)
    {
      double ends[6];
      batch.Read(slot, ends);
      const SkdHitCell hit = tree.FindFirstHit(this->Impl->ToTree(ends, ends + 3), tol, source);
      const bool isHit = hit.Id >= 0;
      Store(ids, slot, hit.Id);
      Store(ts, slot, isHit ? hit.T : vtkMath::Nan());
      Store(xs, slot, isHit ? skd::Lerp(SkdVector(ends), SkdVector(ends + 3), hit.T) : NoPoint());
      return isHit;
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindAllHits(vtkDataArray* lines, vtkIdTypeArray* offsets,
  vtkIdTypeArray* cellIds, vtkDoubleArray* parameters, vtkDoubleArray* points, double tol)
{
  if (IsRefused(
        this, "FindAllHits", lines, SkdBatchOf::Lines, { offsets, cellIds, parameters, points }))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(lines, SkdBatchOf::Lines);
  const SkdBatchLists<Hit> hits(batch, offsets,
    [&](vtkIdType slot, std::vector<Hit>& values)
    {
      double ends[6];
      batch.Read(slot, ends);
      const SkdCellSource source{ this->DataSet, SkdScratchCell() };
      for (const SkdHitCell& hit : tree.FindHits(this->Impl->ToTree(ends, ends + 3), tol, source))
      {
        values.push_back({ hit.Id, hit.T });
      }
    });
  vtkIdType* ids = Prepare(cellIds, "SkdCellId", 1, hits.GetNumberOfValues());
  double* ts = Prepare(parameters, "SkdParameter", 1, hits.GetNumberOfValues());
  double* xs = Prepare(points, "SkdPoint", 3, hits.GetNumberOfValues());
  hits.ForEach(
    [&](vtkIdType index, vtkIdType slot, const Hit& hit)
    {
      Store(ids, index, hit.Id);
      Store(ts, index, hit.T);
      if (xs)
      {
        double ends[6];
        batch.Read(slot, ends);
        Store(xs, index, skd::Lerp(SkdVector(ends), SkdVector(ends + 3), hit.T));
      }
    });
  return hits.GetNumberOfValues();
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCellsWithinBoxes(
  vtkDataArray* boxes, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds)
{
  if (IsRefused(this, "FindCellsWithinBoxes", boxes, SkdBatchOf::Boxes, { offsets, cellIds }))
  {
    return -1;
  }
  return FindLists(this->GetTree(), this->Impl->GetMotion(), boxes, false, offsets, cellIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindPairs(
  vtkSkdTreeCellLocator* other, vtkIdTypeArray* offsets, vtkIdTypeArray* otherCellIds)
{
  if (!other || (offsets && offsets == otherCellIds))
  {
    vtkErrorMacro("FindPairs: " << (other ? "the same array is passed twice."
                                          : "the other locator is missing."));
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const vtkIdType size = this->DataSet ? this->DataSet->GetNumberOfCells() : 0;
  if (!this->Impl->GetMotion() && !other->Impl->GetMotion())
  {
    return FindPairLists(tree, other->GetTree(), size, offsets, otherCellIds);
  }
  return FindLists(other->GetTree(), other->Impl->GetMotion(),
    BoundsOfCells(tree, this->Impl->GetMotion(), size), true, offsets, otherCellIds);
}
VTK_ABI_NAMESPACE_END
