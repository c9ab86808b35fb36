// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdTriangleSet.h"

#include "Bodies/SkdPieceSurfaces.h"
#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdForEach.h"
#include "Cells/Search/SkdBuildTree.h"
#include "Core/Geometry/MarkedNumbers.h"
#include "Core/Search/Tree/LazyTree.h"
#include "Solids/Surfaces/SkdPointFilter.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
SkdTriangleSet::SkdTriangleSet() = default;
SkdTriangleSet::~SkdTriangleSet() = default;
SkdTriangleSet::SkdTriangleSet(SkdTriangleSet&&) noexcept = default;
SkdTriangleSet& SkdTriangleSet::operator=(SkdTriangleSet&&) noexcept = default;

//------------------------------------------------------------------------------
SkdTriangleSet::SkdTriangleSet(SkdReadTriangles made)
  : Read(std::move(made))
  , IsRead(true)
{
  this->Read.FindExtents();
}

//------------------------------------------------------------------------------
bool SkdTriangleSet::Update(
  const std::vector<SkdBlock>& blocks, double chordalDeviation, const skd::Processes* processes)
{
  const double chordalLength = SkdChordalLength(blocks, chordalDeviation, processes);
  const bool isSame =
    this->IsRead && this->ChordalLength == chordalLength && this->Meshes.AreSameAs(blocks);
  std::optional<SkdTriangleReader> reader;
  const auto read = [&]
  {
    *this = SkdTriangleSet();
    this->ChordalLength = chordalLength;
    reader.emplace();
    SkdVisitSurfaces(this->Meshes.Keep(blocks), chordalLength,
      [&](int block, const SkdBlockSurface& surface)
      { reader->Read(block, this->Meshes.Get(block), surface); });
  };
  if (!isSame)
  {
    read();
  }
  const double own =
    reader ? reader->GetLargestCoordinate() : skd::LargestCoordinate(this->Read.Bounds);
  const double largest = processes ? -processes->LeastOf(-own) : own;
  if (!reader && largest == this->GetLargestCoordinate())
  {
    return false;
  }
  if (!reader)
  {
    read();
  }
  this->LargestElsewhere = processes ? largest : 0.0;
  this->Read = reader->Take(largest);
  this->IsRead = true;
  return true;
}

//------------------------------------------------------------------------------
std::optional<SkdTriangleSet> SkdTriangleSet::Moved(
  int firstBlock, const skd::RigidMotion& motion) const
{
  SkdReadTriangles moved = this->Read;
  // Points, cells and triangles are in the order of blocks.
  const auto isBefore = [](const auto& item, int block) { return item.Block < block; };
  const auto firstPoint =
    std::lower_bound(moved.Origins.begin(), moved.Origins.end(), firstBlock, isBefore) -
    moved.Origins.begin();
  const auto firstCell = static_cast<std::uint32_t>(
    std::lower_bound(moved.Cells.begin(), moved.Cells.end(), firstBlock, isBefore) -
    moved.Cells.begin());
  SkdForEach(static_cast<vtkIdType>(moved.Points.size()) - firstPoint,
    [&](vtkIdType i)
    {
      skd::Vector3& point = moved.Points[static_cast<std::size_t>(firstPoint + i)];
      point = motion.Forward(point);
    });
  if (!std::all_of(moved.Points.begin(), moved.Points.end(), skd::IsFinite<3>))
  {
    return std::nullopt;
  }
  const bool isMirrored = Dot(Cross(motion.Rows[0], motion.Rows[1]), motion.Rows[2]) < 0.0;
  const std::size_t first =
    std::lower_bound(moved.CellOf.begin(), moved.CellOf.end(), firstCell) - moved.CellOf.begin();
  for (std::size_t i = first; isMirrored && i < moved.Triangles.size(); ++i)
  {
    std::swap(moved.Triangles[i][1], moved.Triangles[i][2]);
  }
  moved.LeaveOutCollapsed(first);
  return SkdTriangleSet(std::move(moved));
}

//------------------------------------------------------------------------------
void SkdTriangleSet::PutPoints(PointList points)
{
  this->Read.Points = std::move(points);
  this->Read.LeaveOutCollapsed(0);
  this->Read.FindExtents();
}

//------------------------------------------------------------------------------
SkdTriangleSet SkdTriangleSet::Subset(
  const std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& points) const
{
  SkdTriangleSet some;
  some.IsRead = true;
  SkdReadTriangles& to = some.Read;
  to.Bounds = this->Read.Bounds;
  to.LeastArea = this->Read.LeastArea;
  to.LeastCoordinate = this->Read.LeastCoordinate;
  to.TinyPoints = this->Read.TinyPoints;
  skd::MarkedNumbers marked(this->Read.Points.size());
  for (const std::uint32_t triangle : triangles)
  {
    for (const std::uint32_t corner : this->Read.Triangles[triangle])
    {
      marked.Mark(corner);
    }
  }
  points = marked.List();
  skd::RawVector<std::uint32_t> numbers(this->Read.Points.size()); // of these
  to.Points.reserve(points.size());
  for (const std::uint32_t point : points)
  {
    numbers[point] = static_cast<std::uint32_t>(to.Points.size());
    to.Points.push_back(this->Read.Points[point]);
  }
  std::uint32_t last = 0; // cell
  for (const std::uint32_t triangle : triangles)
  {
    const auto [a, b, c] = this->Read.Triangles[triangle];
    const std::uint32_t cell = this->Read.CellOf[triangle];
    if (to.Cells.empty() || cell != last)
    {
      to.Cells.push_back(this->Read.Cells[cell]);
    }
    last = cell;
    to.CellOf.push_back(static_cast<std::uint32_t>(to.Cells.size() - 1));
    to.Triangles.push_back({ numbers[a], numbers[b], numbers[c] });
  }
  return some;
}

//------------------------------------------------------------------------------
bool SkdTriangleSet::PlacePoints(std::uint32_t first, const PointList& from,
  const skd::RigidMotion& motion, const Extents& extents, skd::Box3& bounds)
{
  skd::Box3 box;
  double least = extents.LeastCoordinate;
  double zero = 0.0; // not a number if a coordinate is not finite
  skd::Vector3* const to = this->Read.Points.data() + first;
  const skd::RigidMotion by = motion; // not where the points are written, for the compiler
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const skd::Vector3 point = by.Forward(from[i]);
    to[i] = point;
    box.Add(point);
    zero += (point[0] - point[0]) + (point[1] - point[1]) + (point[2] - point[2]);
    if (std::min({ std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) }) < least)
    {
      least = SkdLeastCoordinateOf(least, point);
    }
  }
  const bool areFinite = zero == 0.0;
  bounds = box;
  box.Add(extents.Bounds.Min);
  box.Add(extents.Bounds.Max);
  this->Read.Bounds = extents.Bounds.IsEmpty() ? bounds : box;
  this->Read.LeastCoordinate = least;
  this->Read.LeastArea = extents.LeastArea;
  return areFinite;
}

//------------------------------------------------------------------------------
SkdTriangleSet::Extents SkdTriangleSet::FindExtents(std::uint32_t end) const
{
  Extents extents{ {}, std::numeric_limits<double>::infinity(), this->Read.LeastArea };
  for (std::uint32_t point = 0; point < end; ++point)
  {
    extents.Bounds.Add(this->Read.Points[point]);
    extents.LeastCoordinate =
      SkdLeastCoordinateOf(extents.LeastCoordinate, this->Read.Points[point]);
  }
  return extents;
}

//------------------------------------------------------------------------------
void SkdTriangleSet::Complete()
{
  if (!this->Tree)
  {
    this->LeaveOutCopies(SkdManyCopies);
    this->BuildTree();
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
const std::vector<SkdDuplicate>& SkdTriangleSet::LeaveOutCopies(std::size_t mostCopies)
{
  if (this->AreCopiesKnown)
  {
    return this->Copies;
  }
  this->MergePoints();
  this->AreCopiesKnown = true;
  this->Copies = SkdFindCopies(this->Read.Triangles, this->Read.Points.size(), mostCopies);
  if (!this->Copies.empty())
  {
    std::vector<bool> isCopy(this->Read.Triangles.size(), false);
    for (const SkdDuplicate& copy : this->Copies)
    {
      isCopy[copy.Triangle] = true;
    }
    for (std::uint32_t triangle = 0; triangle < isCopy.size(); ++triangle)
    {
      if (!isCopy[triangle])
      {
        this->Searched.push_back(triangle);
      }
    }
  }
  return this->Copies;
}

//------------------------------------------------------------------------------
void SkdTriangleSet::MakeCornersOne(const std::vector<std::uint32_t>& triangles)
{
  if (this->IsMerged || triangles.empty())
  {
    return;
  }
  SkdPointFilter filter(3 * triangles.size());
  for (const std::uint32_t triangle : triangles)
  {
    for (const std::uint32_t corner : this->Read.Triangles[triangle])
    {
      filter.Add(this->Read.Points[corner]);
    }
  }
  SkdWeld weld;
  std::vector<std::uint32_t> first; // of the points at the positions that the weld has
  skd::RawVector<std::uint32_t> firstLike(this->Read.Points.size()); // set of those in the filter
  for (std::size_t i = 0; i < this->Read.Points.size(); ++i)
  {
    const skd::Vector3& point = this->Read.Points[i];
    if (filter.MayHave(point))
    {
      const auto welded = static_cast<std::size_t>(weld.GetId(point.X));
      if (welded == first.size())
      {
        first.push_back(static_cast<std::uint32_t>(i));
      }
      firstLike[i] = first[welded];
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
const skd::Rows<SkdTriangleSet::Origin>& SkdTriangleSet::GetOrigins() const
{
  if (this->Origins.size() == this->Read.Points.size())
  {
    return this->Origins;
  }
  skd::Rows<Origin> origins(this->Read.Points.size(),
    [this](const auto& add)
    {
      for (std::size_t i = 0; i < this->PointOf.size(); ++i)
      {
        add(this->PointOf[i], Origin{ this->Read.Origins[i].Block, this->Read.Origins[i].Id });
      }
    });
  origins.SortEach([](std::size_t n, const auto& body) { SkdForEach(n, body); });
  this->Origins = std::move(origins);
  this->FindRuns();
  return this->Origins;
}

//------------------------------------------------------------------------------
void SkdTriangleSet::FindRuns() const
{
  const auto n = static_cast<std::uint32_t>(this->Origins.size());
  this->EndsOfRuns.clear();
  Origin next{ 0, -1 }; // of the run, if it goes on
  for (std::uint32_t point = 0; point < n; ++point)
  {
    const auto origins = this->Origins[point];
    const Origin* const at = std::find_if(
      origins.begin(), origins.end(), [](const Origin& origin) { return origin.Id >= 0; });
    const bool isGiven = at != origins.end();
    if (point > 0 && !(isGiven && at->Block == next.Block && at->Id == next.Id))
    {
      this->EndsOfRuns.push_back(point);
    }
    next = isGiven ? Origin{ at->Block, at->Id + 1 } : Origin{ 0, -1 };
  }
  this->EndsOfRuns.push_back(n);
}

//------------------------------------------------------------------------------
double SkdTriangleSet::GetLargestCoordinate() const
{
  const skd::Box3& bounds = this->Read.Bounds;
  return std::max(this->LargestElsewhere, bounds.IsEmpty() ? 0.0 : skd::LargestCoordinate(bounds));
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
  const bool areSome = !this->Searched.empty();
  const std::size_t count = areSome ? this->Searched.size() : this->Read.Triangles.size();
  boxes.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    skd::Box3 box;
    for (const std::uint32_t corner : this->Read.Triangles[areSome ? this->Searched[i] : i])
    {
      box.Add(this->Read.Points[corner]);
    }
    boxes.push_back(box);
  }
  this->Tree = std::make_unique<skd::LazyTree<3>>(SkdBuildLazyTree(skd::MakeTreeInput(boxes, 0.0)));
}
}
