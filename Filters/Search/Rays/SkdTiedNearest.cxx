// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdTiedNearest.h"

#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdCellReader.h"
#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace skdtree
{
namespace
{
using skd::Vector3;

constexpr double ManyCells = 2048.0; // cost more than the sample, many times
constexpr double ManyShare = 0.25;
constexpr double Samples = 128.0;
constexpr int SpacingExponent = -10; // of the lattice, relative to the radius
constexpr double Offset[3] = { 0.3183098861837907, 0.1961524227066320, 0.4142135623730951 };

/// Whether a point is a sample: of a number of points about as many are as `Samples`. Not by ids,
/// which depend on how many processes have the mesh.
bool IsSample(const Vector3& x, double number)
{
  constexpr double range = 1048576.0;                            // of so many bits of the hash
  const Vector3 point{ { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 } }; // no -0: its bits differ
  const auto hash = static_cast<double>(SkdWeld::HashOf(point) % static_cast<std::size_t>(range));
  return skd::IsFinite(x) && hash * number < Samples * range;
}

/// Those of the cells that begin with a sample.
void AddDiagonals2(
  vtkDataSet* mesh, const std::vector<unsigned char>& areSamples, std::vector<double>& diagonals2)
{
  const SkdCellReader reader(mesh);
  vtkNew<vtkIdList> list;
  reader.VisitCells(0, mesh->GetNumberOfCells(), list,
    [&](vtkIdType cell, const auto* ids, std::size_t size)
    {
      if (size == 0 || !areSamples[static_cast<std::size_t>(ids[0])])
      {
        return;
      }
      double bounds[6];
      mesh->GetCellBounds(cell, bounds);
      const vtkBoundingBox box(bounds);
      const double diagonal = box.IsValid() ? box.GetDiagonalLength() : 0.0;
      diagonals2.push_back(std::isfinite(diagonal) ? diagonal * diagonal : 0.0);
    });
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
  std::vector<double> diagonals2;
  for (int block = 0; block < blocks; ++block)
  {
    vtkDataSet* mesh = trees.GetMesh(block);
    std::vector<unsigned char> areSamples(static_cast<std::size_t>(mesh->GetNumberOfPoints()), 0);
    for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
    {
      Vector3 x;
      mesh->GetPoint(id, x.X);
      if (IsSample(x, points))
      {
        areSamples[static_cast<std::size_t>(id)] = 1;
        this->Sample.push_back(x);
      }
    }
    AddDiagonals2(mesh, areSamples, diagonals2);
  }
  std::sort(diagonals2.begin(), diagonals2.end()); // or the sum would depend on ids
  const double sum = std::accumulate(diagonals2.begin(), diagonals2.end(), 0.0);
  const auto number = static_cast<double>(std::max<std::size_t>(diagonals2.size(), 1));
  this->BoxSize = 2.0 * std::sqrt(sum / number); // 2 by 2 quads of two triangles
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

// The lattice's points have no coordinates that surfaces are symmetric about: of several points
// that are equally near, ids would decide.
SkdNearest SkdTiedNearest::FindShared(const Vector3& centre, double radius) const
{
  const int exponent = std::ilogb(radius) + SpacingExponent;
  LatticeKey key{ 0, 0, 0, exponent };
  Vector3 x;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double count = std::round(std::ldexp(centre[axis], -exponent) - Offset[axis]);
    key[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(count);
    x[axis] = std::ldexp(count + Offset[axis], exponent);
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
