// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdTiedNearest.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
using skd::Vector3;

constexpr double ManyCells = 2048.0; // cost more than the sample, many times
constexpr double ManyShare = 0.25;
constexpr double Samples = 128.0;
constexpr int SpacingExponent = -10; // of the lattice, relative to the radius

/// Calls visit(id) for some of n numbers: about as many as `Samples` of a whole.
template <class Visit>
void ForSome(vtkIdType n, double whole, const Visit& visit)
{
  const double step = std::max(1.0, whole / Samples);
  for (double next = 0.5 * step; next < static_cast<double>(n); next += step)
  {
    visit(static_cast<vtkIdType>(next));
  }
}
}

//------------------------------------------------------------------------------
SkdTiedNearest::SkdTiedNearest(const SkdSourceTrees& trees, int blocks)
  : Trees(trees)
{
  double cells = 0.0;
  double points = 0.0;
  for (int block = 0; block < blocks; ++block)
  {
    cells += static_cast<double>(trees.GetMesh(block)->GetNumberOfCells());
    points += static_cast<double>(trees.GetMesh(block)->GetNumberOfPoints());
  }
  if (!(cells > ManyCells))
  {
    return;
  }
  this->Share = std::max(ManyShare, ManyCells / cells);
  double diagonals = 0.0;
  for (int block = 0; block < blocks; ++block)
  {
    vtkDataSet* mesh = trees.GetMesh(block);
    ForSome(mesh->GetNumberOfPoints(), points,
      [&](vtkIdType id)
      {
        Vector3 x;
        mesh->GetPoint(id, x.X);
        if (skd::IsFinite(x))
        {
          this->Sample.push_back(x);
        }
      });
    ForSome(mesh->GetNumberOfCells(), cells,
      [&](vtkIdType id)
      {
        double bounds[6];
        mesh->GetCellBounds(id, bounds);
        const vtkBoundingBox box(bounds);
        const double diagonal = box.IsValid() ? box.GetDiagonalLength() : 0.0;
        diagonals += std::isfinite(diagonal) ? diagonal * diagonal : 0.0;
      });
  }
  this->BoxSize = 2.0 * std::sqrt(diagonals / Samples); // 2 by 2 quads of two triangles
}

std::optional<SkdNearest> SkdTiedNearest::Find(const Vector3& centre, double radius) const
{
  if (!this->AreMany(centre, radius))
  {
    return this->FindExact(centre, radius);
  }
  SkdNearest nearest = this->FindShared(centre, radius);
  const Vector3 key{ { nearest.Point[0], nearest.Point[1], nearest.Point[2] } };
  nearest.Distance2 = skd::Norm2(key - centre);
  return nearest.Distance2 <= radius * radius ? std::make_optional(nearest) : std::nullopt;
}

std::size_t SkdTiedNearest::GetNumberShared() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Known.size();
}

// A query looks into all boxes that are not farther than what is nearest.
bool SkdTiedNearest::AreMany(const Vector3& centre, double radius) const
{
  thread_local std::vector<double> distances2;
  distances2.clear();
  double least2 = radius * radius;
  for (const Vector3& x : this->Sample)
  {
    distances2.push_back(skd::Norm2(x - centre));
    least2 = std::min(least2, distances2.back());
  }
  const double maxDistance = std::sqrt(least2) + this->BoxSize;
  const auto number = std::count_if(distances2.begin(), distances2.end(),
    [&](double distance2) { return distance2 <= maxDistance * maxDistance; });
  return static_cast<double>(number) > this->Share * static_cast<double>(this->Sample.size());
}

SkdNearest SkdTiedNearest::FindShared(const Vector3& centre, double radius) const
{
  const int exponent = std::ilogb(radius) + SpacingExponent;
  LatticeKey key{ 0, 0, 0, exponent };
  Vector3 x;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double count = std::round(std::ldexp(centre[axis], -exponent));
    key[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(count);
    x[axis] = std::ldexp(count, exponent);
  }
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto known = this->Known.find(key);
    if (known != this->Known.end())
    {
      return known->second;
    }
  }
  const auto nearest = this->Trees.FindNearest(x.X, std::numeric_limits<double>::infinity());
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Known.emplace(key, *nearest).first->second;
}
}
