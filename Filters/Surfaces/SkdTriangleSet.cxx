// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SkdTriangleSet.h"

#include "Pipeline/SkdOuterSurface.h"
#include "Pipeline/SkdWeld.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace
{
/// A filter that excludes most points that are not in a set: by bounds, and a bit for each hash
/// value.
class PointFilter
{
public:
  explicit PointFilter(std::size_t count)
  {
    while ((std::size_t(1) << this->Log2) < 32 * count)
    {
      ++this->Log2;
    }
    this->Bits.assign(std::size_t(1) << (this->Log2 - 6), 0);
  }

  void Add(const skd::Vector3& x)
  {
    this->Bounds.Add(x);
    const std::uint64_t hash = this->HashOf(x);
    this->Bits[hash >> 6] |= std::uint64_t(1) << (hash & 63);
  }

  bool MayHave(const skd::Vector3& x) const
  {
    if (!this->Bounds.Contains(x))
    {
      return false;
    }
    const std::uint64_t hash = this->HashOf(x);
    return (this->Bits[hash >> 6] >> (hash & 63) & 1) != 0;
  }

private:
  static std::uint64_t BitsOf(double coordinate)
  {
    std::uint64_t bits;
    coordinate += 0.0; // -0 and 0 are one
    std::memcpy(&bits, &coordinate, sizeof(bits));
    return bits;
  }

  std::uint64_t HashOf(const skd::Vector3& x) const
  {
    const std::uint64_t mixed = BitsOf(x[0]) * 0x9e3779b97f4a7c15u +
      BitsOf(x[1]) * 0xc2b2ae3d27d4eb4fu + BitsOf(x[2]) * 0x165667b19e3779f9u;
    return ((mixed ^ (mixed >> 32)) * 0xd6e8feb86659fd93u) >> (64 - this->Log2);
  }

  int Log2 = 6;
  std::vector<std::uint64_t> Bits;
  skd::Box3 Bounds;
};
}

//------------------------------------------------------------------------------
bool SkdTriangleSet::Update(
  const std::vector<SkdBlock>& blocks, double chordalDeviation, const skd::Processes* processes)
{
  const double chordalLength = SkdChordalLength(blocks, chordalDeviation, processes);
  if (this->IsRead && this->ChordalLength == chordalLength && this->Meshes.AreSameAs(blocks))
  {
    return false;
  }
  *this = SkdTriangleSet();
  this->ChordalLength = chordalLength;
  SkdTriangleReader reader;
  int block = 0;
  for (const SkdBlock& structure : this->Meshes.Keep(blocks))
  {
    reader.Read(block++, structure.Mesh, chordalLength);
  }
  this->Read = reader.Take();
  this->IsRead = true;
  return true;
}

//------------------------------------------------------------------------------
void SkdTriangleSet::Complete()
{
  if (!this->HasTree)
  {
    this->MergePoints();
    this->BuildTree();
    this->HasTree = true;
  }
}

//------------------------------------------------------------------------------
void SkdTriangleSet::MergePoints()
{
  if (this->IsMerged)
  {
    return;
  }
  this->IsMerged = true;
  PointList& points = this->Read.Points;
  SkdWeld weld(points.size());
  this->PointOf.resize(points.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto id = static_cast<std::size_t>(weld.GetId(points[i].X));
    this->PointOf[i] = static_cast<std::uint32_t>(id);
    if (id == count)
    {
      points[count++] = points[i];
    }
  }
  points.resize(count);
  for (Corners& triangle : this->Read.Triangles)
  {
    for (std::uint32_t& corner : triangle)
    {
      corner = this->PointOf[corner];
    }
  }
}

//------------------------------------------------------------------------------
void SkdTriangleSet::MakeCornersOne(const std::vector<std::uint32_t>& triangles)
{
  if (this->IsMerged || triangles.empty())
  {
    return;
  }
  PointFilter filter(3 * triangles.size());
  for (const std::uint32_t triangle : triangles)
  {
    for (const std::uint32_t corner : this->Read.Triangles[triangle])
    {
      filter.Add(this->Read.Points[corner]);
    }
  }
  SkdWeld weld;
  std::vector<std::uint32_t> first; // of the points at the places that the weld has
  skd::RawVector<std::uint32_t> firstLike(this->Read.Points.size()); // set of those in the filter
  for (std::size_t i = 0; i < this->Read.Points.size(); ++i)
  {
    const skd::Vector3& point = this->Read.Points[i];
    if (filter.MayHave(point))
    {
      const auto place = static_cast<std::size_t>(weld.GetId(point.X));
      if (place == first.size())
      {
        first.push_back(static_cast<std::uint32_t>(i));
      }
      firstLike[i] = first[place];
    }
  }
  for (const std::uint32_t triangle : triangles)
  {
    for (std::uint32_t& corner : this->Read.Triangles[triangle])
    {
      corner = firstLike[corner];
    }
  }
}

//------------------------------------------------------------------------------
// Points are counted first: most have one origin, so sorting them costs next to nothing.
std::vector<SkdTriangleSet::Origin> SkdTriangleSet::FindOrigins() const
{
  std::vector<std::size_t> next(this->Read.Points.size() + 1, 0);
  for (const std::uint32_t point : this->PointOf)
  {
    ++next[point + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Origin> origins(this->PointOf.size());
  for (std::size_t i = 0; i < this->PointOf.size(); ++i)
  {
    origins[next[this->PointOf[i]]++] = { this->PointOf[i], this->Read.Origins[i].Block,
      this->Read.Origins[i].Id };
  }
  for (std::size_t point = 0; point + 1 < next.size(); ++point) // next is now the end of each
  {
    const std::size_t first = point > 0 ? next[point - 1] : 0;
    std::sort(origins.begin() + static_cast<std::ptrdiff_t>(first),
      origins.begin() + static_cast<std::ptrdiff_t>(next[point]));
  }
  return origins;
}

//------------------------------------------------------------------------------
double SkdTriangleSet::GetLargestCoordinate() const
{
  const skd::Box3& bounds = this->Read.Bounds;
  return bounds.IsEmpty() ? 0.0 : skd::LargestCoordinate(bounds);
}

//------------------------------------------------------------------------------
// A width is an area over the length of an edge, which the bounds have room for.
double SkdTriangleSet::GetLeastWidth() const
{
  const double longest = this->Read.Bounds.Diagonal();
  return longest > 0.0 ? this->Read.LeastArea / longest : 0.0;
}

//------------------------------------------------------------------------------
void SkdTriangleSet::BuildTree()
{
  std::vector<skd::Box3> boxes;
  boxes.reserve(this->Read.Triangles.size());
  for (const Corners& triangle : this->Read.Triangles)
  {
    skd::Box3 box;
    for (const std::uint32_t corner : triangle)
    {
      box.Add(this->Read.Points[corner]);
    }
    boxes.push_back(box);
  }
  this->Tree = skd::LazyTree<3>(skd::MakeTreeInput(boxes, 0.0));
}
