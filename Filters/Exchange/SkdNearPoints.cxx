// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdNearPoints.h"

#include "Cells/Read/SkdMagnitudes.h"
#include "Cells/Read/SkdVisitPoints.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace skdtree
{
namespace
{
constexpr double UnitsInTheLastPlace = 4.0;

using Pair = std::pair<vtkIdType, vtkIdType>; // of points, the lower number first

double MagnitudeOf(const skd::Vector3& point)
{
  return std::max({ std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) });
}

/// The share of points that are low: small, because many may be far away or stand for none.
constexpr double LowShare = 0.1;

/// The low magnitude of all pieces: that of the one up to which they have this share of the points.
double LowOf(std::vector<SkdPointMagnitudes>& pieces)
{
  std::sort(pieces.begin(), pieces.end(),
    [](const SkdPointMagnitudes& a, const SkdPointMagnitudes& b) { return a.Low < b.Low; });
  double all = 0.0;
  for (const SkdPointMagnitudes& piece : pieces)
  {
    all += static_cast<double>(piece.Points);
  }
  double before = 0.0;
  for (const SkdPointMagnitudes& piece : pieces)
  {
    before += static_cast<double>(piece.Points);
    if (before > LowShare * all)
    {
      return piece.Low;
    }
  }
  return 0.0;
}

// Along a direction in which points of a lattice have different coordinates, so that few other
// points lie between two that are near each other.
double Along(const skd::Vector3& point)
{
  return point[0] + 0.6180339887498949 * point[1] + 0.4142135623730951 * point[2];
}

bool AreNear(const skd::Vector3& a, const skd::Vector3& b, double tolerance)
{
  return std::abs(a[0] - b[0]) <= tolerance && std::abs(a[1] - b[1]) <= tolerance &&
    std::abs(a[2] - b[2]) <= tolerance;
}

std::vector<Pair> FindNearPairs(
  const std::vector<skd::Vector3>& points, const SkdRounding& rounding)
{
  std::vector<std::pair<double, vtkIdType>> order;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (std::isfinite(Along(points[i])))
    {
      order.emplace_back(Along(points[i]), static_cast<vtkIdType>(i));
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    // Points that are near have nearly the same, and 2.04 is the sum of the direction's components.
    const double tolerance =
      rounding.ToleranceAt(points[static_cast<std::size_t>(order[i].second)]);
    const double maxDistance = 3.0 * tolerance;
    for (std::size_t k = i + 1; k < order.size() && order[k].first - order[i].first <= maxDistance;
         ++k)
    {
      const auto [first, second] = std::minmax(order[i].second, order[k].second);
      if (AreNear(points[static_cast<std::size_t>(first)], points[static_cast<std::size_t>(second)],
            tolerance))
      {
        pairs.emplace_back(first, second);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Which pieces have each of the points of the pairs.
std::map<vtkIdType, std::set<int>> FindPieces(
  const std::vector<Pair>& pairs, const std::vector<std::vector<vtkIdType>>& keys)
{
  std::map<vtkIdType, std::set<int>> pieces;
  for (const Pair& pair : pairs)
  {
    pieces[pair.first];
    pieces[pair.second];
  }
  for (std::size_t piece = 0; piece < keys.size(); ++piece)
  {
    for (const vtkIdType key : keys[piece])
    {
      const auto found = pieces.find(key);
      if (found != pieces.end())
      {
        found->second.insert(static_cast<int>(piece));
      }
    }
  }
  return pieces;
}

bool HaveNoneInCommon(const std::set<int>& a, const std::set<int>& b)
{
  return std::none_of(a.begin(), a.end(), [&b](int piece) { return b.count(piece) > 0; });
}
}

bool SkdIsSingle(vtkDataSet* piece)
{
  auto* set = vtkPointSet::SafeDownCast(piece);
  return set && set->GetPoints() && set->GetPoints()->GetDataType() == VTK_FLOAT;
}

SkdPointMagnitudes SkdMagnitudesOf(vtkDataSet* piece)
{
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(piece->GetNumberOfPoints()));
  SkdVisitPoints(piece,
    [&all](vtkIdType, const skd::Vector3& point)
    {
      if (SkdIsWithin(point, SkdMeasurable.Largest))
      {
        all.push_back(MagnitudeOf(point));
      }
    });
  SkdPointMagnitudes magnitudes;
  if (!all.empty())
  {
    const auto low = all.begin() + static_cast<std::ptrdiff_t>(LowShare * double(all.size()));
    std::nth_element(all.begin(), low, all.end());
    magnitudes = { static_cast<vtkIdType>(all.size()), *low, *std::max_element(low, all.end()) };
  }
  return magnitudes;
}

// Most points of most meshes are farther from the origin than a quarter of the farthest: then what
// is usual is the largest coordinate.
SkdRounding::SkdRounding(bool isSingle, std::vector<SkdPointMagnitudes> pieces)
  : Precision(UnitsInTheLastPlace *
      (isSingle ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon()))
{
  constexpr double mostOfLow = 4.0;
  for (const SkdPointMagnitudes& piece : pieces)
  {
    this->Usual = std::max(this->Usual, piece.Largest);
  }
  this->Usual = std::min(this->Usual, mostOfLow * LowOf(pieces));
}

double SkdRounding::MagnitudeAt(const skd::Vector3& x) const
{
  return SkdIsWithin(x, SkdMeasurable.Largest) ? std::max(this->Usual, MagnitudeOf(x))
                                               : this->Usual;
}

double SkdRounding::ToleranceAt(const skd::Vector3& x) const
{
  return this->Precision * this->MagnitudeAt(x);
}

double SkdRounding::PowerAt(const skd::Vector3& x) const
{
  const double magnitude = this->MagnitudeAt(x);
  return magnitude > 0.0 ? std::ldexp(this->Precision, std::ilogb(magnitude) + 1) : 0.0;
}

void SkdMergeNearPoints(const SkdPieces& pieces, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys)
{
  std::vector<SkdPointMagnitudes> magnitudes;
  for (vtkDataSet* piece : pieces)
  {
    magnitudes.push_back(SkdMagnitudesOf(piece));
  }
  const bool isSingle = std::any_of(pieces.begin(), pieces.end(), SkdIsSingle);
  SkdMergeNearPoints(SkdRounding(isSingle, magnitudes), points, keys);
}

void SkdMergeNearPoints(const SkdRounding& rounding, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys)
{
  const std::vector<Pair> pairs = FindNearPairs(points, rounding);
  if (pairs.empty())
  {
    return;
  }
  std::map<vtkIdType, std::set<int>> piecesOf = FindPieces(pairs, keys);
  std::map<vtkIdType, vtkIdType> merged;
  for (const Pair& pair : pairs)
  {
    const auto known = merged.find(pair.first);
    const vtkIdType into = known == merged.end() ? pair.first : known->second;
    if (merged.count(pair.second) == 0 && HaveNoneInCommon(piecesOf[into], piecesOf[pair.second]))
    {
      merged[pair.second] = into;
      piecesOf[into].insert(piecesOf[pair.second].begin(), piecesOf[pair.second].end());
    }
  }
  for (std::vector<vtkIdType>& own : keys)
  {
    for (vtkIdType& key : own)
    {
      const auto found = merged.find(key);
      key = found == merged.end() ? key : found->second;
    }
  }
}
}
