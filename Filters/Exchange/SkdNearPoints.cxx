// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdNearPoints.h"

#include "Cells/Read/SkdMagnitudes.h"
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

/// Of points that cells are not left out for: a tolerance by one at infinity would make all points
/// one.
void AddCoordinates(const skd::Vector3& point, double& largest)
{
  for (int axis = 0; axis < 3 && SkdIsWithin(point, SkdMeasurable.Largest); ++axis)
  {
    largest = std::max(largest, std::abs(point[axis]));
  }
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

std::vector<Pair> FindNearPairs(const std::vector<skd::Vector3>& points, double tolerance)
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
  const double maxDistance = 3.0 * tolerance; // more than the sum of the direction's components
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
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

double SkdLargestCoordinateOf(vtkDataSet* piece)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
  {
    skd::Vector3 point;
    piece->GetPoint(i, point.X);
    AddCoordinates(point, largest);
  }
  return largest;
}

double SkdNearTolerance(bool isSingle, double largestCoordinate)
{
  const double precision =
    isSingle ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
  return UnitsInTheLastPlace * precision * largestCoordinate;
}

void SkdMergeNearPoints(const SkdPieces& pieces, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys)
{
  const bool isSingle = std::any_of(pieces.begin(), pieces.end(), SkdIsSingle);
  double largest = 0.0;
  for (const skd::Vector3& point : points)
  {
    AddCoordinates(point, largest);
  }
  SkdMergeNearPoints(SkdNearTolerance(isSingle, largest), points, keys);
}

void SkdMergeNearPoints(double tolerance, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys)
{
  const std::vector<Pair> pairs = FindNearPairs(points, tolerance);
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
