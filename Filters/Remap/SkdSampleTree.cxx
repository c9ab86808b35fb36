// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdSampleTree.h"

#include "Cells/Read/SkdForEach.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Cells/Search/SkdBuildTree.h"
#include "Core/Search/Queries/WithinBox.h"
#include "Core/Search/Tree/Walk.h"

#include <utility>

namespace skdtree
{
namespace
{
/// Elements keep the indices of the points, of which some are left out.
skd::TreeInput<3> InputOf(const std::vector<skd::Vector3>& points, const SkdSampleTree& tree)
{
  skd::TreeInput<3> input;
  for (const skd::Vector3& point : points)
  {
    const skd::Vector3 position = tree.CoordinatesOf(point);
    if (SkdIsWithin(position, SkdMeasurable.Largest))
    {
      input.Bounds.Add(position);
    }
  }
  input.Frame = skd::Frame<3>::Of(input.Bounds);
  input.Elements.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const skd::Vector3 position = tree.CoordinatesOf(points[i]);
    if (SkdIsWithin(position, SkdMeasurable.Largest))
    {
      input.Elements.push_back(
        { input.Frame.Outward(skd::Box3(position, position)), static_cast<std::uint32_t>(i) });
    }
  }
  return input;
}
}

SkdSampleTree::SkdSampleTree(std::vector<skd::Vector3> points, bool isOnSphere)
  : Points(std::move(points))
  , OnSphere(isOnSphere)
  , Tree(SkdBuildTree(InputOf(this->Points, *this)))
{
}

void SkdSampleTree::FindWithin(const skd::Box3& box, std::vector<std::uint32_t>& points) const
{
  points.clear();
  auto visitor = [&points](std::uint32_t i)
  {
    points.push_back(i);
    return true;
  };
  skd::WithinBox<3, decltype(visitor)> query(this->Tree.GetFrame(), box, visitor);
  skd::Walk(this->Tree, query);
}
}
