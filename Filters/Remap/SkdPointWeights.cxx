// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdPointWeights.h"

#include "Cells/SkdForEach.h"
#include "Remap/SkdOverlapSearch.h"
#include "Remap/SkdPieceOverlap.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <numeric>

namespace
{
using skd::Vector3;

struct Entry
{
  vtkIdType Row;
  vtkIdType Point;
  double Weight;
};

/// The linear function that is 1 at corner k of a simplex and 0 at the others: its gradient. Of a
/// triangle or a segment in space it has no part across.
Vector3 GradientOf(const Vector3* p, int size, int k)
{
  const Vector3& a = p[(k + 1) % size];
  const Vector3 way = p[k] - a;
  if (size == 2)
  {
    return (1.0 / Norm2(way)) * way;
  }
  const Vector3& b = p[(k + 2) % size];
  const Vector3 across = Cross(b - a, (size == 3 ? p[k] : p[(k + 3) % size]) - a);
  const Vector3 normal = size == 3 ? Cross(across, b - a) : across;
  return (1.0 / Dot(normal, way)) * normal;
}

/// The overlap of a piece of the target and a simplex of the donor, given to its corners.
void AddWeights(const SkdPieceView& simplex, const vtkIdType* ids, const skd::Moments& moments,
  const Vector3& reference, Entry entry, std::vector<Entry>& found)
{
  const Vector3* p = simplex.Corners;
  const int size = simplex.Piece.Size;
  for (int k = 0; k < size; ++k)
  {
    const Vector3 gradient = GradientOf(p, size, k);
    const double atReference = Dot(gradient, reference - p[(k + 1) % size]);
    entry.Point = ids[k];
    found.push_back(entry);
    found.back().Weight *= moments.Measure * atReference + Dot(gradient, moments.First);
  }
}

/// By rows, then points; those of one place are summed up in the order of the parts.
void FillTable(
  const std::vector<std::vector<Entry>>& parts, vtkIdType numberOfRows, SkdOverlapPointTable& table)
{
  std::vector<Entry> all;
  for (const std::vector<Entry>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  std::stable_sort(all.begin(), all.end(),
    [](const Entry& a, const Entry& b)
    { return a.Row != b.Row ? a.Row < b.Row : a.Point < b.Point; });
  table = {};
  table.Rows.assign(static_cast<std::size_t>(numberOfRows) + 1, 0);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Entry& entry = all[i];
    if (i > 0 && all[i - 1].Row == entry.Row && all[i - 1].Point == entry.Point)
    {
      table.Weights.back() += entry.Weight;
      continue;
    }
    table.Columns.push_back(entry.Point);
    table.Weights.push_back(entry.Weight);
    ++table.Rows[static_cast<std::size_t>(entry.Row) + 1];
  }
  std::partial_sum(table.Rows.begin(), table.Rows.end(), table.Rows.begin());
}
}

//------------------------------------------------------------------------------
bool SkdFindPointWeights(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings,
  SkdOverlapPointTable& table, vtkAlgorithm* algorithm, double first, double last)
{
  const SkdOverlapSurface ground(donor, target, settings);
  const auto at = [&](double share) { return first + share * (last - first); };
  SkdLoop ofDonor(algorithm, 0, at(0.0), at(0.1), 8);
  SkdLoop ofTarget(algorithm, 0, at(0.1), at(0.2), 8);
  SkdLoop ofPairs(algorithm, 0, at(0.2), at(1.0), 8);
  SkdOverlapPieces donors;
  SkdOverlapPieces targets;
  const SkdOverlapReading simplices{ false, settings.SkipsGhosts, true };
  const SkdOverlapReading cells{ settings.TargetIsLonLat, settings.SkipsGhosts, false };
  if (!ground.GetProblem().empty() || !donors.Read(donor, ground, simplices, ofDonor) ||
    !targets.Read(target, ground, cells, ofTarget))
  {
    return false;
  }
  const SkdNoShapes noShapes;
  const SkdPieceOverlap<SkdNoShapes> overlap(settings.Space, noShapes);
  std::vector<std::vector<Entry>> found;
  const auto visitPieces = [&](std::size_t part, std::uint32_t a, std::uint32_t b)
  {
    const SkdOverlapBlock& block = donors.BlockOf(b);
    SkdForEachPiecePair(targets, a, donors, b,
      [&](const SkdPieceView& one, const SkdPieceView& simplex)
      {
        const vtkIdType* ids = block.PointIds.data() + simplex.Piece.FirstCorner;
        const bool isOfPoints =
          std::all_of(ids, ids + simplex.Piece.Size, [](vtkIdType id) { return id >= 0; });
        const Vector3* reference = nullptr;
        const skd::Moments moments =
          isOfPoints ? overlap.Find(one, simplex, reference) : skd::Moments();
        if (moments.Measure > 0.0)
        {
          const double scale = ground.Measure(one.Piece.Sign * simplex.Piece.Sign);
          AddWeights(simplex, ids, moments, *reference, { targets.IdOf(a), 0, scale }, found[part]);
        }
      });
  };
  const bool isDone = SkdForEachCandidatePair(
    SkdOverlapTree(targets), SkdOverlapTree(donors), ofPairs,
    [&](std::size_t parts) { found.resize(parts); }, visitPieces);
  if (isDone)
  {
    FillTable(found, target->GetNumberOfCells(), table);
  }
  return isDone;
}
