// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdSampleSides.h"

#include "Search/Compare/SkdSpreadSides.h"

#include <cmath>

namespace skdtree
{
namespace
{
/// Samples by number: corners, middles of edges, centroids, of which the last is the centre.
constexpr int FirstMiddle = 3;
constexpr int FirstCentroid = 6;
constexpr int Centre = SkdSampledTriangle::Samples - 1;

double& DistanceOf(SkdSampledTriangle& triangle, int sample)
{
  return sample < FirstMiddle ? triangle.AtCorners[sample]
    : sample < FirstCentroid  ? triangle.AtMiddles[sample - FirstMiddle]
                              : triangle.AtCentroids[sample - FirstCentroid];
}

skd::Vector3 PositionOf(const SkdSampledTriangle& triangle, int sample)
{
  return sample < FirstMiddle ? triangle.Corners[sample]
    : sample < FirstCentroid  ? triangle.GetMiddle(sample - FirstMiddle)
                              : triangle.GetCentroid(sample - FirstCentroid);
}

/// A sample of one of the triangles.
struct Place
{
  std::size_t Triangle;
  int Sample;
};

/// Gives samples the side of the centre, from which the way is shorter than to the surface; returns
/// the others.
std::vector<Place> SpreadFromCentres(std::vector<SkdSampledTriangle>& triangles, int firstSample)
{
  constexpr double rounding = 1e-9;
  std::vector<Place> others;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const skd::Vector3 centre = PositionOf(triangles[i], Centre);
    const double distance = DistanceOf(triangles[i], Centre);
    for (int sample = firstSample; sample < Centre; ++sample)
    {
      const double moved = skd::Norm(PositionOf(triangles[i], sample) - centre);
      double& here = DistanceOf(triangles[i], sample);
      if (moved < std::abs(distance) * (1.0 - rounding))
      {
        here = distance < 0.0 ? -here : here;
      }
      else
      {
        others.push_back({ i, sample });
      }
    }
  }
  return others;
}
}

// Around a part all is known but what lies between its corners and its centre.
bool SkdFindSides(const SkdComparedSet& to, std::vector<SkdSampledTriangle>& triangles,
  bool areParts, SkdLoop& loop)
{
  SkdSpreadSides* const sides = to.GetSpreadSides();
  if (!sides)
  {
    return true;
  }
  const auto findOf = [&](const auto& placeOf, std::size_t number)
  {
    return sides->Find(
      number,
      [&](std::size_t i)
      {
        const Place place = placeOf(i);
        return PositionOf(triangles[place.Triangle], place.Sample);
      },
      [&](std::size_t i, bool isInside)
      {
        const Place place = placeOf(i);
        double& distance = DistanceOf(triangles[place.Triangle], place.Sample);
        distance = isInside ? -distance : distance;
      },
      loop);
  };
  const auto centreOf = [](std::size_t i) { return Place{ i, Centre }; };
  if (!areParts && !findOf(centreOf, triangles.size()))
  {
    return false;
  }
  const std::vector<Place> others = SpreadFromCentres(triangles, areParts ? FirstMiddle : 0);
  return findOf([&others](std::size_t i) { return others[i]; }, others.size());
}
}
