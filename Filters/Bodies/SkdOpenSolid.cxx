// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdOpenSolid.h"

#include "Bodies/SkdHoleCaps.h"
#include "Bodies/SkdOrientation.h"
#include "Pipeline/SkdMakeMesh.h"
#include "Pipeline/SkdSourceTrees.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// What closes a shell has at most this area, relative to the shell: a triangle that is missing
/// from a tetrahedron is a third.
constexpr double LargestCaps = 0.34;

double AreaOf(const std::vector<skd::Vector3>& points, const SkdTriangleIds& ids)
{
  return 0.5 *
    skd::Norm(skd::Cross(points[ids[1]] - points[ids[0]], points[ids[2]] - points[ids[0]]));
}
}

//------------------------------------------------------------------------------
SkdSide SkdSideOf(const skd::WindingNumber::Sum& sum)
{
  const double beyond = std::abs(sum.Number) - 0.5;
  return { beyond >= 0.0, 0.5 + std::min(0.5, std::abs(beyond)), sum.Number, sum.Bound };
}

SkdOpenSolid::SkdOpenSolid(
  const SkdBoundary& boundary, vtkSkdTreeCellLocator* locator, double epsilon)
  : Surface(boundary.Surface)
  , Locator(locator)
{
  this->Surface->GetCellsBounds(this->Bounds);
  const SkdHoleCaps caps(SkdSurfacePoints(this->Surface), SkdSurfaceTriangles(this->Surface));
  if (!this->Close(boundary, caps, epsilon))
  {
    this->MakeWindings();
  }
}

bool SkdOpenSolid::Close(const SkdBoundary& boundary, const SkdHoleCaps& caps, double epsilon)
{
  const std::vector<skd::Vector3>& points = caps.GetPoints();
  std::vector<SkdTriangleIds> triangles = SkdSurfaceTriangles(this->Surface);
  triangles.insert(triangles.end(), caps.GetTriangles().begin(), caps.GetTriangles().end());
  SkdBoundary closed;
  closed.Surface = vtkSmartPointer<vtkPolyData>::New();
  SkdSetTriangles(
    closed.Surface, static_cast<vtkIdType>(points.size()),
    [&](vtkIdType i) { return points[static_cast<std::size_t>(i)]; }, triangles,
    [](const SkdTriangleIds& ids) -> const auto& { return ids; });
  closed.Repeats = boundary.Repeats;
  closed.Repeats.resize(closed.Repeats.empty() ? 0 : triangles.size(), 1);
  this->Closed = closed.Surface;
  if (!this->IsNearlyClosed(static_cast<vtkIdType>(caps.GetTriangles().size())))
  {
    this->Closed = nullptr;
    return false;
  }
  const auto locator = SkdMakeLocator(this->Closed);
  SkdBuildLocator(locator, epsilon, true);
  this->Solid = std::make_unique<SkdSolid>(closed, locator);
  std::vector<skd::WindingNumber::Triangle> corners;
  for (const SkdTriangleIds& ids : caps.GetTriangles())
  {
    corners.push_back({ points[ids[0]], points[ids[1]], points[ids[2]] });
  }
  this->Holes = std::make_unique<SkdWinding>(corners);
  return true;
}

bool SkdOpenSolid::IsNearlyClosed(vtkIdType numberOfCaps) const
{
  const std::vector<skd::Vector3> points = SkdSurfacePoints(this->Closed);
  const std::vector<SkdTriangleIds> triangles = SkdSurfaceTriangles(this->Closed);
  const SkdShells shells(points, triangles);
  std::vector<double> surface(shells.Get().size(), 0.0);
  std::vector<double> caps(shells.Get().size(), 0.0);
  const std::size_t firstCap = triangles.size() - static_cast<std::size_t>(numberOfCaps);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto shell = static_cast<std::size_t>(shells.GetShellOf(static_cast<vtkIdType>(i)));
    (i < firstCap ? surface : caps)[shell] += AreaOf(points, triangles[i]);
  }
  return std::equal(caps.begin(), caps.end(), surface.begin(),
    [](double cap, double rest) { return cap <= LargestCaps * rest; });
}

//------------------------------------------------------------------------------
void SkdOpenSolid::MakeWindings()
{
  const std::vector<bool> outward = this->FindOutward(this->Surface);
  const std::vector<bool> given = this->FindConsistent(outward);
  this->Given = std::make_unique<SkdWinding>(this->Surface, given);
  if (std::find(given.begin(), given.end(), true) != given.end())
  {
    this->Reversed = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Reversed->SetNumberOfValues(static_cast<vtkIdType>(given.size()));
    std::copy(given.begin(), given.end(), this->Reversed->GetPointer(0));
  }
  std::vector<bool> opposite = given; // whose numbers are the same but for the sign
  opposite.flip();
  if (outward != given && outward != opposite)
  {
    this->Outward = std::make_unique<SkdWinding>(this->Surface, outward);
  }
}

std::vector<bool> SkdOpenSolid::FindOutward(vtkPolyData* surface) const
{
  return SkdFindReversed(SkdSurfacePoints(surface), SkdSurfaceTriangles(surface),
    [this](const skd::Vector3& x)
    {
      return this->IsInsideBounds(x.X) &&
        (this->Solid ? this->IsInside(x.X) : this->IsInsideForLines(x.X));
    });
}

// Where that is not consistent within a component, most of its area remains as it is.
std::vector<bool> SkdOpenSolid::FindConsistent(const std::vector<bool>& outward) const
{
  const std::vector<skd::Vector3> points = SkdSurfacePoints(this->Surface);
  const std::vector<SkdTriangleIds> triangles = SkdSurfaceTriangles(this->Surface);
  const SkdShells shells(points, triangles);
  std::vector<double> areas(shells.Get().size(), 0.0); // area, minus that of reversed triangles
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const double area = AreaOf(points, triangles[i]);
    areas[static_cast<std::size_t>(shells.GetShellsOf()[i])] += outward[i] ? -area : area;
  }
  std::vector<bool> consistent(triangles.size(), false);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto shell = static_cast<std::size_t>(shells.GetShellsOf()[i]);
    consistent[i] = !shells.Get()[shell].IsCoherent && outward[i] == (areas[shell] >= 0.0);
  }
  return consistent;
}

//------------------------------------------------------------------------------
bool SkdOpenSolid::IsInsideBounds(const double x[3]) const
{
  return x[0] >= this->Bounds[0] && x[0] <= this->Bounds[1] && x[1] >= this->Bounds[2] &&
    x[1] <= this->Bounds[3] && x[2] >= this->Bounds[4] && x[2] <= this->Bounds[5];
}

bool SkdOpenSolid::IsInsideForLines(const double x[3]) const
{
  const std::array<SkdRayEnd, 7> rays = SkdRayEndsAlongAxes(this->Bounds, x);
  const auto votes = std::count_if(rays.begin(), rays.end(),
    [&](const SkdRayEnd& ray)
    {
      const double end[3] = { x[0] + ray[0], x[1] + ray[1], x[2] + ray[2] };
      return this->Locator->CountCrossings(x, end) % 2 == 1;
    });
  return 2 * votes > static_cast<std::ptrdiff_t>(rays.size());
}

bool SkdOpenSolid::IsInside(const double x[3]) const
{
  if (!this->IsInsideBounds(x))
  {
    return false;
  }
  if (this->Solid)
  {
    return this->Solid->Ask(x, SkdRayEndsAlongAxes(this->Bounds, x)[0]).IsInside;
  }
  return this->Outward ? this->AskWindings(x, std::numeric_limits<double>::infinity()).IsInside
                       : this->Given->IsInside(x);
}

SkdSide SkdOpenSolid::Ask(const double x[3], double tolerance) const
{
  const bool isWithin = this->IsInsideBounds(x);
  SkdSide side;
  if (this->Solid)
  {
    side = isWithin ? this->Solid->Ask(x, SkdRayEndsAlongAxes(this->Bounds, x)[0]) : SkdSide();
    side.Confidence = std::min(side.Confidence, 1.0 - this->Holes->BoundShare(x));
    return side;
  }
  side = this->AskWindings(x, tolerance);
  if (!isWithin)
  {
    return { false, side.IsInside ? 0.5 : side.Confidence, side.WindingNumber, side.WindingBound };
  }
  if (side.Confidence > 0.5)
  {
    const double share = this->ShareOfLines(x, side.IsInside);
    side.Confidence = std::max(0.5, std::min(side.Confidence, share));
  }
  return side;
}

SkdSide SkdOpenSolid::AskWindings(const double x[3], double tolerance) const
{
  const SkdSide given = SkdSideOf(this->Given->Ask(x, tolerance));
  if (!this->Outward)
  {
    return given;
  }
  const SkdSide outward = SkdSideOf(this->Outward->Ask(x, tolerance));
  const auto clear = [](const SkdSide& side)
  { return std::abs(std::abs(side.WindingNumber) - 0.5); };
  const bool isGivenClearer = clear(given) > clear(outward);
  if (given.IsInside == outward.IsInside)
  {
    return isGivenClearer ? outward : given;
  }
  SkdSide side = isGivenClearer ? given : outward;
  side.Confidence = 0.5;
  return side;
}

double SkdOpenSolid::ShareOfLines(const double x[3], bool isInside) const
{
  const std::array<SkdRayEnd, 7> rays = SkdRayEndsAlongAxes(this->Bounds, x);
  const auto agreeing = std::count_if(rays.begin(), rays.end(),
    [&](const SkdRayEnd& ray)
    {
      const double end[3] = { x[0] + ray[0], x[1] + ray[1], x[2] + ray[2] };
      vtkIdType sum;
      this->Locator->CountPasses(x, end, this->Reversed, sum);
      return (sum != 0) == isInside;
    });
  return static_cast<double>(agreeing) / static_cast<double>(rays.size());
}
}
