// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdRayCaster.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <tuple>

namespace skdtree
{
namespace
{
bool IsBefore(const SkdRayHit& a, const SkdRayHit& b)
{
  const auto key = [](const SkdRayHit& hit)
  {
    return std::make_tuple(
      std::abs(hit.Distance), std::signbit(hit.Distance), hit.Block, hit.CellId);
  };
  return key(a) < key(b);
}
}

double SkdRayTolerance(
  double relative, const std::vector<SkdBlock>& source, const std::vector<SkdBlock>& input)
{
  skd::Box3 box;
  double largest = 0.0;
  for (const std::vector<SkdBlock>* blocks : { &source, &input })
  {
    for (const SkdBlock& block : *blocks)
    {
      const skd::Box3 bounds = SkdShownBounds(block.Mesh);
      largest = std::max(largest, skd::LargestCoordinate(bounds));
      box.Add(blocks == &source ? bounds : skd::Box3());
    }
  }
  const double diagonal = box.IsEmpty() ? 0.0 : box.Diagonal();
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * largest;
  return std::isfinite(diagonal) ? std::max(relative * diagonal, rounding) : rounding;
}

/// Rays at one block, one way.
struct SkdRayCaster::Batch
{
  vtkDoubleArray* Origins;
  vtkDoubleArray* Directions;
  vtkSkdTreeCellLocator* Locator;
  int Block;
  double Shift; // of the origin along the ray
  double Sign;  // 1, or -1 against the direction
  double Maximum;

  SkdRayHit MakeHit(double distance, vtkIdType cell) const
  {
    return { this->Sign * std::max(distance + this->Shift, 0.0), cell, this->Block };
  }
};

SkdRayCaster::SkdRayCaster(const SkdSourceTrees& trees, int blocks, const SkdRayLimits& limits)
  : Trees(trees)
  , Blocks(blocks)
  , Limits(limits)
{
}

/// Rays begin where hits begin to count, so that the first one is not a hit that does not.
template <class Cast>
void SkdRayCaster::ForEachBatch(const Vectors& starts, const Vectors& directions, vtkIdType begin,
  vtkIdType end, const Cast& cast) const
{
  for (const double sign : { 1.0, -1.0 })
  {
    if (sign < 0.0 && !this->Limits.BothWays)
    {
      return;
    }
    const double shift = sign > 0.0 ? this->Limits.Start : std::abs(this->Limits.Start);
    vtkNew<vtkDoubleArray> origins;
    vtkNew<vtkDoubleArray> along;
    for (vtkDoubleArray* array : { origins.Get(), along.Get() })
    {
      array->SetNumberOfComponents(3);
      array->SetNumberOfTuples(end - begin);
    }
    SkdForEach(end - begin,
      [&](vtkIdType i)
      {
        const auto ray = static_cast<std::size_t>(begin + i);
        const skd::Vector3 direction = sign * directions[ray];
        along->SetTypedTuple(i, direction.X);
        origins->SetTypedTuple(i, (starts[ray] + shift * direction).X);
      });
    for (int block = 0; block < this->Blocks; ++block)
    {
      cast(Batch{ origins, along, this->Trees.GetLocator(block), block, shift, sign,
        this->Limits.Maximum - shift });
    }
  }
}

void SkdRayCaster::FindFirstOf(const Vectors& starts, const Vectors& directions, vtkIdType begin,
  vtkIdType end, std::vector<SkdRayHit>& first) const
{
  vtkNew<vtkIdTypeArray> cells;
  vtkNew<vtkDoubleArray> distances;
  first.assign(static_cast<std::size_t>(end - begin), SkdRayHit{ 0.0, -1, -1 });
  this->ForEachBatch(starts, directions, begin, end,
    [&](const Batch& batch)
    {
      batch.Locator->IntersectWithRays(
        batch.Origins, batch.Directions, cells, distances, nullptr, batch.Maximum);
      SkdForEach(end - begin,
        [&](vtkIdType i)
        {
          if (cells->GetValue(i) >= 0)
          {
            SkdRayHit& before = first[static_cast<std::size_t>(i)];
            const SkdRayHit hit = batch.MakeHit(distances->GetValue(i), cells->GetValue(i));
            before = before.Block < 0 || IsBefore(hit, before) ? hit : before;
          }
        });
    });
}

SkdRayHitLists SkdRayCaster::FindFirst(
  const Vectors& starts, const Vectors& directions, SkdLoop& loop) const
{
  SkdRayHitLists lists;
  std::vector<SkdRayHit> first;
  loop.InPieces(static_cast<vtkIdType>(starts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      this->FindFirstOf(starts, directions, begin, end, first);
      for (const SkdRayHit& hit : first)
      {
        lists.Add(&hit, &hit + (hit.Block >= 0 ? 1 : 0));
      }
    });
  lists.AddEmpty(starts.size() - lists.size()); // where the user has aborted
  return lists;
}

/// Sorts hits and leaves one of each point, in front. Returns the number of points.
std::size_t SkdRayCaster::Merge(SkdRayHit* first, SkdRayHit* last) const
{
  std::sort(first, last, IsBefore);
  SkdRayHit* end = first;
  const SkdRayHit* latest[2] = { nullptr, nullptr }; // forwards, backwards
  for (const SkdRayHit* hit = first; hit != last; ++hit)
  {
    const SkdRayHit*& before = latest[std::signbit(hit->Distance)];
    if (!before || std::abs(hit->Distance - before->Distance) > this->Limits.Tolerance)
    {
      *end = *hit;
      before = end++;
    }
  }
  return static_cast<std::size_t>(end - first);
}

/// The answers to batches of the same rays.
struct SkdRayCaster::Answers
{
  struct Answer
  {
    Batch Queries;
    vtkNew<vtkIdTypeArray> Offsets;
    vtkNew<vtkIdTypeArray> Cells;
    vtkNew<vtkDoubleArray> Distances;
  };
  std::deque<Answer> List;

  void Add(const Batch& batch)
  {
    Answer& answer = this->List.emplace_back();
    answer.Queries = batch;
    batch.Locator->FindAllRayHits(batch.Origins, batch.Directions, answer.Offsets, answer.Cells,
      answer.Distances, nullptr, batch.Maximum);
  }

  /// The number of hits of the rays before ray i.
  vtkIdType CountBefore(vtkIdType i) const
  {
    vtkIdType sum = 0;
    for (const Answer& answer : this->List)
    {
      sum += answer.Offsets->GetValue(i);
    }
    return sum;
  }

  /// Writes the hits of ray i, and returns where they end.
  SkdRayHit* Write(vtkIdType i, SkdRayHit* hit) const
  {
    for (const Answer& answer : this->List)
    {
      const vtkIdType last = answer.Offsets->GetValue(i + 1);
      for (vtkIdType k = answer.Offsets->GetValue(i); k < last; ++k)
      {
        *hit++ = answer.Queries.MakeHit(answer.Distances->GetValue(k), answer.Cells->GetValue(k));
      }
    }
    return hit;
  }
};

SkdRayHitLists SkdRayCaster::FindAll(
  const Vectors& starts, const Vectors& directions, SkdLoop& loop) const
{
  SkdRayHitLists lists;
  std::vector<SkdRayHit> found;
  std::vector<std::size_t> sizes;
  loop.InPieces(static_cast<vtkIdType>(starts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Answers answers;
      this->ForEachBatch(
        starts, directions, begin, end, [&](const Batch& batch) { answers.Add(batch); });
      found.resize(static_cast<std::size_t>(answers.CountBefore(end - begin)));
      sizes.resize(static_cast<std::size_t>(end - begin));
      SkdForEach(sizes.size(),
        [&](std::size_t i)
        {
          const auto ray = static_cast<vtkIdType>(i);
          SkdRayHit* const first = found.data() + answers.CountBefore(ray);
          sizes[i] = this->Merge(first, answers.Write(ray, first));
        });
      for (std::size_t i = 0; i < sizes.size(); ++i)
      {
        const SkdRayHit* first = found.data() + answers.CountBefore(static_cast<vtkIdType>(i));
        lists.Add(first, first + sizes[i]);
      }
    });
  lists.AddEmpty(starts.size() - lists.size()); // where the user has aborted
  return lists;
}
}
