// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Boolean/SkdSolidAngles.h"

#include "Core/Queries/WindingNumber.h"

#include <algorithm>

/// The tree of a surface.
struct SkdSolidAngles::Surface
{
  std::vector<skd::Box3> Boxes;
  std::vector<skd::WindingNumber::Triangle> Triangles;
  std::unique_ptr<skd::Tree<3>> Tree;
  std::unique_ptr<skd::WindingNumber> Number;

  void Complete()
  {
    this->Tree = std::make_unique<skd::Tree<3>>(skd::MakeTreeInput(this->Boxes, 0.0));
    this->Number = std::make_unique<skd::WindingNumber>(*this->Tree, this->Triangles);
  }
};

SkdSolidAngles::SkdSolidAngles(const SkdPlacedTriangles& set,
  const std::vector<std::uint32_t>& surfaceOf, const std::vector<std::uint32_t>& triangles,
  std::size_t numberOfPoints)
  : Set(set)
  , SurfaceOf(surfaceOf)
  , Triangles(triangles)
{
  constexpr std::size_t few = 24; // about as many sums as the trees cost
  if (numberOfPoints <= few)
  {
    return;
  }
  for (const std::uint32_t triangle : triangles)
  {
    auto& surface = this->Surfaces[surfaceOf[triangle]];
    surface = surface ? std::move(surface) : std::make_unique<Surface>();
    surface->Boxes.push_back(set.GetBox(triangle));
    surface->Triangles.push_back(set.GetCornerPoints(triangle));
  }
  for (auto& [number, surface] : this->Surfaces)
  {
    surface->Complete();
  }
}

SkdSolidAngles::~SkdSolidAngles() = default;

void SkdSolidAngles::Add(const skd::Vector3& x, Numbers& to) const
{
  if (this->Surfaces.empty())
  {
    SkdAddSolidAngles(this->Set, this->SurfaceOf, this->Triangles, {}, x, to);
  }
  for (const auto& [number, surface] : this->Surfaces)
  {
    constexpr double tolerance = 0.25; // numbers are integers
    to[number] += surface->Number->Decide(x, tolerance).Number;
  }
}

void SkdAddSolidAngles(const SkdPlacedTriangles& set, const std::vector<std::uint32_t>& surfaceOf,
  const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& leftOut,
  const skd::Vector3& x, SkdSolidAngles::Numbers& to)
{
  constexpr double fourPi = 12.566370614359172954;
  for (const std::uint32_t triangle : triangles)
  {
    if (std::find(leftOut.begin(), leftOut.end(), triangle) == leftOut.end())
    {
      const auto corners = set.GetCornerPoints(triangle);
      to[surfaceOf[triangle]] += skd::SolidAngle(corners[0], corners[1], corners[2], x) / fourPi;
    }
  }
}
