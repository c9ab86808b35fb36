// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeBatchCellLocator.h"

#include "Cells/Search/SkdCoherentNearest.h"
#include "Cells/Search/SkdLineBatches.h"

#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// For each point of a batch calls find(state, slot, the point in the tree's coordinates), by
/// SkdBatch::CountTrue; of how many it returns true.
template <class Locator, class MakeState, class Find>
vtkIdType CountFound(
  const SkdBatch& points, const Locator& locator, const MakeState& makeState, const Find& find)
{
  return points.CountTrue(makeState,
    [&](auto& state, vtkIdType slot)
    {
      double x[3];
      points.Read(slot, x);
      return find(state, slot, locator.ToTree(x));
    });
}

/// The cells within boxes, as lists in the order of the tree, or by id.
vtkIdType FindLists(const SkdCellTree& tree, const skd::RigidMotion* motion, vtkDataArray* boxes,
  bool byId, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds)
{
  const SkdBatch batch(boxes, SkdBatchOf::Boxes);
  const auto find = [&](vtkIdType slot, std::vector<vtkIdType>& values)
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
  };
  const SkdBatchLists<vtkIdType> lists(batch, offsets, SkdOneByOne(batch, find));
  vtkIdType* ids = SkdPrepare(cellIds, "SkdCellId", 1, lists.GetNumberOfValues());
  lists.ForEach([ids](vtkIdType index, vtkIdType, vtkIdType id) { SkdStoreAt(ids, index, id); });
  return lists.GetNumberOfValues();
}

/// The bounds of all cells of a data set; empty for those that are not in the tree.
vtkSmartPointer<vtkDoubleArray> BoundsOfCells(
  const SkdCellTree& tree, const skd::RigidMotion* motion, vtkIdType numberOfCells)
{
  auto boxes = vtkSmartPointer<vtkDoubleArray>::New();
  double* bounds = SkdPrepare(boxes.Get(), "SkdBounds", 6, numberOfCells);
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
  vtkIdType* starts = SkdPrepare(offsets ? offsets : ownOffsets.Get(), "SkdOffsets", 1, size + 1);
  std::fill_n(starts, size + 1, vtkIdType(0));
  forEachPair([&](vtkIdType id, vtkIdType) { ++starts[id]; });
  std::partial_sum(starts, starts + size + 1, starts); // the ends of the lists
  vtkIdType* others = SkdPrepare(otherCellIds, "SkdCellId", 1, starts[size]);
  forEachPair([&](vtkIdType id, vtkIdType there) { SkdStoreAt(others, --starts[id], there); });
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

/// These pairs as tuples, in the order of the trees.
vtkIdType ListPairs(const SkdCellTree& tree, const SkdCellTree& other, vtkIdTypeArray* pairs)
{
  const auto parts = tree.FindBoundsPairs(other);
  std::size_t size = 0;
  std::for_each(parts.begin(), parts.end(), [&size](const auto& part) { size += part.size(); });
  vtkIdType* to = SkdPrepare(pairs, "SkdCellIds", 2, static_cast<vtkIdType>(size));
  for (std::size_t i = 0; to && i < parts.size(); ++i)
  {
    for (const SkdCellTree::CellPair& pair : parts[i])
    {
      *to++ = tree.Cells().IdOf(pair.first);
      *to++ = other.Cells().IdOf(pair.second);
    }
  }
  return static_cast<vtkIdType>(size);
}

/// Lists as tuples.
void ListPairs(vtkIdTypeArray* offsets, vtkIdTypeArray* ids, vtkIdTypeArray* pairs)
{
  vtkIdType* to = SkdPrepare(pairs, "SkdCellIds", 2, ids->GetNumberOfTuples());
  for (vtkIdType id = 0; to && id + 1 < offsets->GetNumberOfTuples(); ++id)
  {
    for (vtkIdType i = offsets->GetValue(id); i < offsets->GetValue(id + 1); ++i)
    {
      *to++ = id;
      *to++ = ids->GetValue(i);
    }
  }
}

/// The points of found cells and their weights, a row a query, as long as the largest cell needs.
class WeightRows
{
public:
  WeightRows(
    const SkdCellStore& cells, vtkIdTypeArray* pointIds, vtkDoubleArray* weights, vtkIdType size)
    : Cells(cells)
  {
    for (std::uint32_t cell = 0; (pointIds || weights) && cell < cells.NumberOfCells(); ++cell)
    {
      this->Width = std::max(this->Width, static_cast<int>(cells.SizeOf(cell)));
    }
    this->PointIds = SkdPrepare(pointIds, "SkdPointId", this->Width, size);
    this->Weights = SkdPrepare(weights, "SkdWeight", this->Width, size);
  }

  /// Writes the points, and returns the weights' location (nullptr if not requested),
  /// uninitialized.
  double* Begin(vtkIdType slot, vtkIdType id)
  {
    const std::int64_t found = this->Cells.CellOfId(id);
    const auto cell = static_cast<std::uint32_t>(found);
    const vtkIdType first = slot * this->Width;
    const int number = found < 0 ? 0 : static_cast<int>(this->Cells.SizeOf(cell));
    for (int i = 0; this->PointIds && i < this->Width; ++i)
    {
      this->PointIds[first + i] =
        i < number ? static_cast<vtkIdType>(this->Cells.PointIdsOf(cell)[i]) : vtkIdType(-1);
    }
    if (!this->Weights)
    {
      return nullptr;
    }
    std::fill_n(this->Weights + first, this->Width, found < 0 ? vtkMath::Nan() : 0.0);
    return this->Weights + first;
  }

private:
  const SkdCellStore& Cells;
  int Width = 1;
  vtkIdType* PointIds;
  double* Weights;
};
}

//------------------------------------------------------------------------------
vtkSkdTreeBatchCellLocator::vtkSkdTreeBatchCellLocator() = default;
vtkSkdTreeBatchCellLocator::~vtkSkdTreeBatchCellLocator() = default;

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindClosestPoints(vtkDataArray* points,
  vtkIdTypeArray* cellIds, vtkDoubleArray* closestPoints, vtkDoubleArray* distances, double radius)
{
  if (SkdIsRefused(this, "FindClosestPoints", points, SkdBatchOf::Points,
        { cellIds, closestPoints, distances }))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(points, SkdBatchOf::Points);
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = SkdPrepare(cellIds, "SkdClosestCellId", 1, size);
  double* nearest = SkdPrepare(closestPoints, "SkdClosestPoint", 3, size);
  double* lengths = SkdPrepare(distances, "SkdDistance", 1, size);
  const double limit2 = radius >= 0.0 ? radius * radius : -1.0;
  return CountFound(
    batch, *this->Impl, [&] { return SkdCoherentNearest(tree, { this->DataSet }, limit2); },
    [&](SkdCoherentNearest& coherent, vtkIdType slot, const skd::Vector3& x)
    {
      const SkdFoundCell found = coherent.Find(x);
      const bool isFound = found.Id >= 0;
      SkdStoreAt(ids, slot, found.Id);
      SkdStoreAt(nearest, slot, isFound ? this->Impl->ToWorld(found.Point) : SkdNoPoint());
      SkdStoreAt(lengths, slot, isFound ? std::sqrt(found.Dist2) : vtkMath::Nan());
      return isFound;
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindClosestNCells(
  vtkDataArray* points, int n, vtkIdTypeArray* cellIds, vtkDoubleArray* distances, double radius)
{
  std::string reason =
    SkdReasonAgainst(points, "queries", SkdBatchOf::Points, { cellIds, distances });
  if (reason.empty() && n < 1)
  {
    reason = "n is " + std::to_string(n) + ", at least 1 is needed";
  }
  if (SkdIsRefused(this, "FindClosestNCells", reason))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(points, SkdBatchOf::Points);
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = SkdPrepare(cellIds, "SkdClosestCellId", n, size);
  double* lengths = SkdPrepare(distances, "SkdDistance", n, size);
  const double limit2 = radius >= 0.0 ? radius * radius : -1.0;
  return CountFound(
    batch, *this->Impl, [&] { return SkdCellSource{ this->DataSet }; },
    [&](const SkdCellSource& source, vtkIdType slot, const skd::Vector3& x)
    {
      const auto& found = tree.FindNearestCells(x, n, limit2, source);
      const auto number = static_cast<int>(found.size());
      for (int i = 0; i < n; ++i)
      {
        const bool isFound = i < number;
        SkdStoreAt(ids, n * slot + i, isFound ? found[i].second : vtkIdType(-1));
        SkdStoreAt(lengths, n * slot + i, isFound ? std::sqrt(found[i].first) : vtkMath::Nan());
      }
      return number > 0;
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindCells(
  vtkDataArray* points, vtkIdTypeArray* cellIds, vtkDoubleArray* pcoords, double tol2)
{
  return SkdIsRefused(this, "FindCells", points, SkdBatchOf::Points, { cellIds, pcoords })
    ? -1
    : this->FindCellsAndWeights(points, cellIds, pcoords, nullptr, nullptr, tol2);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindCellsAndWeights(vtkDataArray* points,
  vtkIdTypeArray* cellIds, vtkDoubleArray* pcoords, vtkIdTypeArray* pointIds,
  vtkDoubleArray* weights, double tol2)
{
  if (SkdIsRefused(this, "FindCellsAndWeights", points, SkdBatchOf::Points,
        { cellIds, pcoords, pointIds, weights }))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(points, SkdBatchOf::Points);
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = SkdPrepare(cellIds, "SkdCellId", 1, size);
  double* coordinates = SkdPrepare(pcoords, "SkdParametricCoordinates", 3, size);
  WeightRows rows(tree.Cells(), pointIds, weights, size);
  return CountFound(
    batch, *this->Impl, [&] { return SkdCellSource{ this->DataSet }; },
    [&](const SkdCellSource& source, vtkIdType slot, const skd::Vector3& x)
    {
      SkdFoundCell found = tree.FindContaining(x, tol2, -1, source);
      const bool isFound = found.Id >= 0;
      SkdStoreAt(ids, slot, found.Id);
      double* row = rows.Begin(slot, found.Id);
      if (isFound && (coordinates || row))
      {
        tree.Interpolate(found, row, source);
        found.PCoords = tree.MovedPCoords(
          this->Impl->GetMotion(), found.Id, this->Impl->ToWorld(found.Point), found.PCoords);
      }
      SkdStoreAt(coordinates, slot, isFound ? found.PCoords : SkdNoPoint());
      return isFound;
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::IntersectWithLines(vtkDataArray* lines,
  vtkIdTypeArray* cellIds, vtkDoubleArray* parameters, vtkDoubleArray* points, double tol)
{
  if (SkdIsRefused(
        this, "IntersectWithLines", lines, SkdBatchOf::Lines, { cellIds, parameters, points }))
  {
    return -1;
  }
  const SkdLineSearch queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(lines, SkdBatchOf::Lines, queries.Sorts());
  return SkdFindFirstHits(
    queries, batch, SkdGivenLines(batch), { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindAllHits(vtkDataArray* lines, vtkIdTypeArray* offsets,
  vtkIdTypeArray* cellIds, vtkDoubleArray* parameters, vtkDoubleArray* points, double tol)
{
  if (SkdIsRefused(
        this, "FindAllHits", lines, SkdBatchOf::Lines, { offsets, cellIds, parameters, points }))
  {
    return -1;
  }
  const SkdLineSearch queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(lines, SkdBatchOf::Lines, queries.Sorts());
  return SkdFindHitLists(
    queries, batch, SkdGivenLines(batch), offsets, { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::IntersectWithSegments(vtkDataArray* starts,
  vtkDataArray* ends, vtkIdTypeArray* cellIds, vtkDoubleArray* parameters, vtkDoubleArray* points,
  double tol)
{
  if (SkdIsRefused(this, "IntersectWithSegments",
        SkdReasonAgainstBoth(starts, "starts", ends, "ends", { cellIds, parameters, points })))
  {
    return -1;
  }
  const SkdLineSearch queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(starts, ends, queries.Sorts());
  return SkdFindFirstHits(
    queries, batch, SkdGivenLines(batch), { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindAllSegmentHits(vtkDataArray* starts, vtkDataArray* ends,
  vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds, vtkDoubleArray* parameters,
  vtkDoubleArray* points, double tol)
{
  if (SkdIsRefused(this, "FindAllSegmentHits",
        SkdReasonAgainstBoth(
          starts, "starts", ends, "ends", { offsets, cellIds, parameters, points })))
  {
    return -1;
  }
  const SkdLineSearch queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(starts, ends, queries.Sorts());
  return SkdFindHitLists(
    queries, batch, SkdGivenLines(batch), offsets, { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::IntersectWithRays(vtkDataArray* origins,
  vtkDataArray* directions, vtkIdTypeArray* cellIds, vtkDoubleArray* distances,
  vtkDoubleArray* points, double maximum, double tol)
{
  if (SkdIsRefused(this, "IntersectWithRays",
        SkdReasonAgainstBoth(
          origins, "origins", directions, "directions", { cellIds, distances, points })))
  {
    return -1;
  }
  const SkdLineSearch queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(origins, SkdBatchOf::Points, queries.Sorts());
  const SkdLinesOfRays lines(
    batch, directions, queries.Tree.Cells().GetBounds(), queries.State, maximum, tol);
  return SkdFindFirstHits(queries, batch, lines, { cellIds, distances, "SkdDistance", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindAllRayHits(vtkDataArray* origins,
  vtkDataArray* directions, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds,
  vtkDoubleArray* distances, vtkDoubleArray* points, double maximum, double tol)
{
  if (SkdIsRefused(this, "FindAllRayHits",
        SkdReasonAgainstBoth(
          origins, "origins", directions, "directions", { offsets, cellIds, distances, points })))
  {
    return -1;
  }
  const SkdLineSearch queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(origins, SkdBatchOf::Points, queries.Sorts());
  const SkdLinesOfRays lines(
    batch, directions, queries.Tree.Cells().GetBounds(), queries.State, maximum, tol);
  return SkdFindHitLists(
    queries, batch, lines, offsets, { cellIds, distances, "SkdDistance", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindCellsWithinBoxes(
  vtkDataArray* boxes, vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds)
{
  if (SkdIsRefused(this, "FindCellsWithinBoxes", boxes, SkdBatchOf::Boxes, { offsets, cellIds }))
  {
    return -1;
  }
  return FindLists(this->GetTree(), this->Impl->GetMotion(), boxes, false, offsets, cellIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindCellsWithinSpheres(vtkDataArray* spheres,
  vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds, vtkDoubleArray* distances)
{
  if (SkdIsRefused(this, "FindCellsWithinSpheres", spheres, SkdBatchOf::Spheres,
        { offsets, cellIds, distances }))
  {
    return -1;
  }
  const SkdCellTree& tree = this->GetTree();
  const SkdBatch batch(spheres, SkdBatchOf::Spheres);
  using Near = std::pair<double, vtkIdType>; // a squared distance
  const auto find = [&](vtkIdType slot, std::vector<Near>& values)
  {
    double sphere[4];
    batch.Read(slot, sphere);
    const double limit2 = sphere[3] >= 0.0 ? sphere[3] * sphere[3] : -1.0;
    auto& found = tree.FindNearestCells(
      this->Impl->ToTree(sphere), tree.Cells().NumberOfCells(), limit2, { this->DataSet });
    std::sort(
      found.begin(), found.end(), [](const Near& a, const Near& b) { return a.second < b.second; });
    values.insert(values.end(), found.begin(), found.end());
  };
  const SkdBatchLists<Near> lists(batch, offsets, SkdOneByOne(batch, find));
  const vtkIdType size = lists.GetNumberOfValues();
  vtkIdType* ids = SkdPrepare(cellIds, "SkdCellId", 1, size);
  double* lengths = SkdPrepare(distances, "SkdDistance", 1, size);
  lists.ForEach(
    [&](vtkIdType index, vtkIdType, const Near& near)
    {
      SkdStoreAt(ids, index, near.second);
      SkdStoreAt(lengths, index, std::sqrt(near.first));
    });
  return size;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindPairs(
  vtkSkdTreeBatchCellLocator* other, vtkIdTypeArray* offsets, vtkIdTypeArray* otherCellIds)
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

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeBatchCellLocator::FindPairs(
  vtkSkdTreeBatchCellLocator* other, vtkIdTypeArray* pairs)
{
  if (other && !this->Impl->GetMotion() && !other->Impl->GetMotion())
  {
    return ListPairs(this->GetTree(), other->GetTree(), pairs);
  }
  vtkNew<vtkIdTypeArray> offsets, ids;
  const vtkIdType size = this->FindPairs(other, offsets, ids);
  if (size >= 0)
  {
    ListPairs(offsets, ids, pairs);
  }
  return size;
}

//------------------------------------------------------------------------------
void vtkSkdTreeBatchCellLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
