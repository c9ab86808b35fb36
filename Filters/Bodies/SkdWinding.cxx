// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdWinding.h"

#include "Bodies/SkdTriangulation.h"
#include "Cells/Search/SkdBuildTree.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
using Triangle = skd::WindingNumber::Triangle;

std::vector<Triangle> CornersOf(vtkPolyData* surface, const std::vector<bool>& isReversed)
{
  const std::vector<skd::Vector3> points = SkdSurfacePoints(surface);
  std::vector<Triangle> triangles;
  for (const SkdTriangleIds& ids : SkdSurfaceTriangles(surface))
  {
    const bool reverses = !isReversed.empty() && isReversed[triangles.size()];
    triangles.push_back(
      { points[ids[0]], points[ids[reverses ? 2 : 1]], points[ids[reverses ? 1 : 2]] });
  }
  return triangles;
}

bool IsBefore(const skd::Vector3& a, const skd::Vector3& b)
{
  return std::lexicographical_compare(a.X, a.X + 3, b.X, b.X + 3);
}

// Which triangles are taken together, and sums, depend on their order. That of coordinates is the
// same however triangles are numbered: on any number of processes.
std::vector<Triangle> Sorted(std::vector<Triangle> triangles)
{
  for (Triangle& corners : triangles)
  {
    std::rotate(
      corners.begin(), std::min_element(corners.begin(), corners.end(), IsBefore), corners.end());
  }
  std::sort(triangles.begin(), triangles.end(),
    [](const Triangle& a, const Triangle& b)
    { return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), IsBefore); });
  return triangles;
}

skd::Tree<3> TreeOf(const std::vector<Triangle>& triangles)
{
  std::vector<skd::Box3> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (const skd::Vector3& corner : triangles[i])
    {
      boxes[i].Add(corner);
    }
  }
  return SkdBuildTreeSerial(skd::MakeTreeInput(boxes, 0.0));
}
}

SkdWinding::SkdWinding(vtkPolyData* triangles, const std::vector<bool>& isReversed)
  : SkdWinding(Sorted(CornersOf(triangles, isReversed)))
{
}

SkdWinding::SkdWinding(const std::vector<Triangle>& triangles)
  : Tree(TreeOf(triangles))
  , Number(this->Tree, triangles)
{
}

skd::WindingNumber::Sum SkdWinding::Ask(const double x[3], double tolerance) const
{
  const bool isFinite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
  return isFinite ? this->Number.Decide({ { x[0], x[1], x[2] } }, tolerance)
                  : skd::WindingNumber::Sum{ vtkMath::Nan(), vtkMath::Nan(), false };
}

double SkdWinding::At(const double x[3]) const
{
  return this->Ask(x, std::numeric_limits<double>::infinity()).Number;
}

bool SkdWinding::IsInside(const double x[3]) const
{
  return std::abs(this->At(x)) >= 0.5;
}
}
