// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/PrimitiveDistance.h"

namespace skdtest
{

Point NearestOnSegment(const Point& x, const Point& a, const Point& b)
{
  const double length2 = Dot(b - a, b - a);
  const double t = length2 > 0 ? Dot(x - a, b - a) / length2 : 0.0;
  if (t > 0.5)
  {
    return b + std::min(0.0, t - 1) * (b - a);
  }
  return a + std::max(0.0, t) * (b - a);
}

double SegmentDistance(const Point& x, const Point& a, const Point& b)
{
  return Distance(x, NearestOnSegment(x, a, b));
}

double TriangleDistance(const Point& x, const Point& a, const Point& b, const Point& c)
{
  const double edges =
    std::min({ SegmentDistance(x, a, b), SegmentDistance(x, b, c), SegmentDistance(x, c, a) });
  const Point normal = Cross(b - a, c - a);
  const double area = Length(normal);
  if (!(area > 0))
  {
    return edges;
  }
  const bool above = Dot(Cross(b - a, x - a), normal) >= 0 &&
    Dot(Cross(c - b, x - b), normal) >= 0 && Dot(Cross(a - c, x - c), normal) >= 0;
  return above ? std::min(edges, std::abs(Dot(x - a, normal)) / area) : edges;
}

namespace
{
double ParameterOnSegment(const Point& x, const Point& a, const Point& b)
{
  const double length2 = Dot(b - a, b - a);
  return length2 > 0 ? std::min(1.0, std::max(0.0, Dot(x - a, b - a) / length2)) : 0.0;
}

// With one parameter held the patch is a segment: go to its nearest point, in turns.
double Descend(const Point& x, const Patch& patch, double u, double v)
{
  double best = Distance(x, patch.At(u, v));
  for (int step = 0; step < 400; ++step)
  {
    v = ParameterOnSegment(x, patch.At(u, 0), patch.At(u, 1));
    u = ParameterOnSegment(x, patch.At(0, v), patch.At(1, v));
    const double now = Distance(x, patch.At(u, v));
    if (!(now < best * (1 - 1e-15)))
    {
      return std::min(now, best);
    }
    best = now;
  }
  return best;
}
}

double PatchDistance(const Point& x, const Patch& patch)
{
  std::vector<std::pair<double, int>> samples;
  for (int i = 0; i < 81; ++i)
  {
    samples.emplace_back(Distance(x, patch.At((i % 9) / 8.0, (i / 9) / 8.0)), i);
  }
  std::partial_sort(samples.begin(), samples.begin() + 3, samples.end());
  double best = samples.front().first;
  for (int k = 0; k < 3; ++k)
  {
    const int i = samples[k].second;
    best = std::min(best, Descend(x, patch, (i % 9) / 8.0, (i / 9) / 8.0));
  }
  return best;
}

}
