// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdPointWeights.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Remap/SkdOverlapSearch.h"
#include "Remap/SkdPieceOverlap.h"
#include "Remap/SkdRemapTolerances.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace skdtree
{
namespace
{
using skd::Vector3;

struct Entry
{
  std::uint32_t Row;
  std::uint32_t Donor;
  vtkIdType Point;
  double Weight;
};

/// The linear function that is 1 at corner k of a simplex and 0 at the others: its gradient. Of a
/// triangle or a segment in space it has no part across.
Vector3 GradientOf(const Vector3* p, int size, int k)
{
  const Vector3& a = p[(k + 1) % size];
  const Vector3 edge = p[k] - a;
  if (size == 2)
  {
    return (1.0 / Norm2(edge)) * edge;
  }
  const Vector3& b = p[(k + 2) % size];
  const Vector3 across = Cross(b - a, (size == 3 ? p[k] : p[(k + 3) % size]) - a);
  const Vector3 normal = size == 3 ? Cross(across, b - a) : across;
  return (1.0 / Dot(normal, edge)) * normal;
}

/// The integrals of the functions of a simplex's corners over a part of it, by its moments. Of one
/// so flat that these functions have no gradients equal parts.
std::array<double, 4> IntegralsOf(
  const SkdPieceView& simplex, const skd::Moments& moments, const Vector3& reference)
{
  const Vector3* p = simplex.Corners;
  const int size = simplex.Piece.Size;
  std::array<double, 4> integrals{};
  bool isFinite = true;
  for (int k = 0; k < size; ++k)
  {
    const Vector3 gradient = GradientOf(p, size, k);
    const double atReference = Dot(gradient, reference - p[(k + 1) % size]);
    integrals[k] = moments.Measure * atReference + Dot(gradient, moments.First);
    isFinite = isFinite && std::isfinite(integrals[k]);
  }
  if (!isFinite)
  {
    std::fill_n(integrals.begin(), size, moments.Measure / size);
  }
  return integrals;
}

/// What a part of a donor's cell adds to the weights of its points.
class Weighing
{
public:
  Weighing(const SkdOverlapPieces& donors, std::uint32_t cell)
    : Block(donors.BlockOf(cell))
    , Own(donors.OwnPointsOf(cell))
  {
    if (this->Own.Size > 0)
    {
      thread_local std::vector<double> buffer; // keeps its memory
      buffer.assign(this->Own.Size, 0.0);
      this->Sums = buffer.data();
    }
  }

  /// Of a simplex, or a part of it, the integrals of its corners' functions: visit(point, weight)
  /// for corners that are points.
  template <class Visit>
  void Add(const SkdPieceView& simplex, const std::array<double, 4>& integrals, double scale,
    const Visit& visit)
  {
    const vtkIdType* ids = this->Block.PointIds.data() + simplex.Piece.FirstCorner;
    for (int k = 0; k < simplex.Piece.Size; ++k)
    {
      const double weight = scale * integrals[k];
      if (ids[k] >= 0)
      {
        visit(ids[k], weight);
        continue;
      }
      const double* of = this->Block.Weights.data() + (-1 - ids[k]);
      for (std::size_t i = 0; i < this->Own.Size; ++i)
      {
        this->Sums[i] += weight * of[i];
      }
    }
  }

  /// After all parts, of the other corners.
  template <class Visit>
  void Finish(const Visit& visit) const
  {
    for (std::size_t i = 0; i < this->Own.Size; ++i)
    {
      if (this->Sums[i] != 0.0)
      {
        visit(this->Own.First[i], this->Sums[i]);
      }
    }
  }

private:
  const SkdOverlapBlock& Block;
  SkdOverlapPieces::PointRange Own;
  double* Sums = nullptr;
};

/// The integrals of the points' functions over the whole donor, or what of it is this process's
/// own.
std::vector<double> FindMasses(
  const SkdOverlapPieces& donors, vtkDataSet* donor, const SkdOverlapSurface& surface)
{
  const vtkIdType numberOfPoints = donor->GetNumberOfPoints();
  const std::vector<unsigned char> own = SkdOwnCellsOf(donor);
  std::vector<double> masses(static_cast<std::size_t>(numberOfPoints), 0.0);
  const auto add = [&](vtkIdType point, double weight)
  { masses[static_cast<std::size_t>(point)] += weight; };
  const bool isFlat = surface.GetSpace() != SkdOverlapSpace::Sphere; // all corners have the same
  const auto integralsOver = [isFlat](const SkdPieceView& simplex, const SkdOverlapPiece& piece)
  {
    std::array<double, 4> equal;
    equal.fill(piece.Own.Measure / piece.Size);
    return isFlat ? equal : IntegralsOf(simplex, piece.Own, piece.Reference);
  };
  for (std::uint32_t cell = 0; cell < donors.GetNumberOfCells(); ++cell)
  {
    if (!own.empty() && own[static_cast<std::size_t>(donors.IdOf(cell))] == 0)
    {
      continue;
    }
    Weighing weighing(donors, cell);
    const SkdOverlapPieces::Range pieces = donors.PiecesOf(cell);
    for (std::uint32_t i = pieces.First; i < pieces.Last; ++i)
    {
      const SkdPieceView simplex(donors.BlockOf(cell), i);
      const SkdOverlapPiece& piece = simplex.Piece;
      weighing.Add(simplex, integralsOver(simplex, piece), surface.Measure(piece.Sign), add);
    }
    weighing.Finish(add);
  }
  return masses;
}

/// Negative weights that are nothing but rounding become 0. Returns whether there are others.
bool DropRounding(SkdOverlapPointTable& table)
{
  const auto isNegative = [](double weight) { return weight < 0.0; };
  bool hasNegative = false;
  for (std::size_t row = 0; row + 1 < table.Rows.size(); ++row)
  {
    const auto begin = table.Weights.begin() + static_cast<std::ptrdiff_t>(table.Rows[row]);
    const auto end = table.Weights.begin() + static_cast<std::ptrdiff_t>(table.Rows[row + 1]);
    if (std::none_of(begin, end, isNegative))
    {
      continue;
    }
    const double rounding = remap_tolerances::PointWeight * std::abs(*std::max_element(begin, end));
    std::replace_if(
      begin, end, [&](double weight) { return isNegative(weight) && weight >= -rounding; }, 0.0);
    hasNegative = hasNegative || std::any_of(begin, end, isNegative);
  }
  return hasNegative;
}

/// By rows, then points; those of one row and point are summed up in the order of the donor's
/// cells, which is the same of a part of the donor, whatever its tree.
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
    {
      return a.Row != b.Row  ? a.Row < b.Row
        : a.Point != b.Point ? a.Point < b.Point
                             : a.Donor < b.Donor;
    });
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
  table.IsSigned = DropRounding(table);
}
}

//------------------------------------------------------------------------------
bool SkdFindPointWeights(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings,
  SkdOverlapPointTable& table, vtkAlgorithm* algorithm, double first, double last,
  const std::vector<double>& shares)
{
  const SkdOverlapSurface surface(donor, target, settings);
  const auto at = [&](double share) { return first + share * (last - first); };
  SkdOverlapPair pair;
  if (!pair.Read(donor, target, surface, settings, true, algorithm, at(0.0), at(0.2)))
  {
    return false;
  }
  const SkdOverlapPieces& donors = pair.Donor;
  const SkdOverlapPieces& targets = pair.Target;
  SkdLoop ofPairs(algorithm, 0, at(0.2), at(1.0), 8);
  table = {};
  table.Masses = FindMasses(donors, donor, surface);
  const SkdNoShapes noShapes;
  const SkdPieceOverlap<SkdNoShapes> overlap(settings, noShapes);
  std::vector<std::vector<Entry>> found;
  const auto visitPieces = [&](std::size_t part, std::uint32_t a, std::uint32_t b)
  {
    Weighing weighing(donors, b);
    const double share = shares.empty() ? 1.0 : shares[static_cast<std::size_t>(donors.IdOf(b))];
    const auto add = [&](vtkIdType point, double weight) {
      found[part].push_back({ static_cast<std::uint32_t>(targets.IdOf(a)), b, point, weight });
    };
    SkdForEachPiecePair(targets, a, donors, b,
      [&](const SkdPieceView& one, const SkdPieceView& simplex)
      {
        const Vector3* reference = nullptr;
        const skd::Moments moments = overlap.Find(one, simplex, reference);
        if (moments.Measure > 0.0)
        {
          const double scale = surface.Measure(share * one.Piece.Sign * simplex.Piece.Sign);
          weighing.Add(simplex, IntegralsOf(simplex, moments, *reference), scale, add);
        }
      });
    weighing.Finish(add);
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
}
