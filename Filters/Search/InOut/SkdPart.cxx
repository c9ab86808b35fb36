// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/InOut/SkdPart.h"

#include "Bodies/SkdOrientation.h"
#include "vtkBoundingBox.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// A number in [0, 1) from bits that look random (D. Lea's and G. Steele's SplitMix64).
double Scatter(std::uint64_t& state)
{
  state += 0x9e3779b97f4a7c15u;
  std::uint64_t bits = state;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31;
  return std::ldexp(static_cast<double>(bits >> 11), -53);
}

/// Directions uniformly distributed over the sphere for any number of them: the additive sequence
/// R2, with a different start for each (seed, point).
class RandomRayEnds
{
public:
  RandomRayEnds(const double bounds[6], std::uint64_t seed, std::uint64_t point);

  SkdRayEnd Next();

private:
  double Length; // longer than the diagonal
  double U;
  double V;
};

RandomRayEnds::RandomRayEnds(const double bounds[6], std::uint64_t seed, std::uint64_t point)
  : Length(1.01 * vtkBoundingBox(bounds).GetDiagonalLength())
{
  std::uint64_t state = seed;
  Scatter(state);
  state ^= point * 0xd1b54a32d192ed03u;
  this->U = Scatter(state);
  this->V = Scatter(state);
}

// R2 of M. Roberts: multiples of the inverses of the plastic number and of its square.
SkdRayEnd RandomRayEnds::Next()
{
  this->U = std::fmod(this->U + 0.75487766624669276005, 1.0);
  this->V = std::fmod(this->V + 0.56984029099805326591, 1.0);
  const double z = 1.0 - 2.0 * this->U;
  const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double angle = 2.0 * vtkMath::Pi() * this->V;
  return { this->Length * radius * std::cos(angle), this->Length * radius * std::sin(angle),
    this->Length * z };
}

/// Of `yes` among `rays` votes.
SkdSide Counted(int yes, int rays)
{
  const bool isInside = 2 * yes > rays;
  return { isInside, static_cast<double>(isInside ? yes : rays - yes) / rays };
}

/// Calls vote() until one side has more than half of `count`; of an even vote once more.
template <class Vote>
SkdSide Elect(int count, const Vote& vote)
{
  int yes = 0;
  int rays = 0;
  while (rays < count && 2 * yes <= count && 2 * (rays - yes) <= count)
  {
    yes += vote() ? 1 : 0;
    ++rays;
  }
  if (2 * yes == rays)
  {
    yes += vote() ? 1 : 0;
    ++rays;
  }
  return Counted(yes, rays);
}
}

SkdPart::SkdPart(int id, const std::vector<SkdBlock>& blocks, const SkdPartSettings& settings)
  : Id(id)
  , Body(blocks, settings.ChordalLength)
{
  const SkdInsideMethod method = settings.Method;
  this->Body.Build(
    settings.Epsilon, settings.RepairsOrientation || method == SkdInsideMethod::Automatic);
  this->GetBoundary().Faces->GetCellsBounds(this->Bounds);
  const vtkBoundingBox box(this->Bounds);
  this->Diagonal = box.IsValid() ? box.GetDiagonalLength() : 0.0;
  const auto reversedOf = [&](vtkPolyData* surface)
  { return settings.RepairsOrientation ? this->FindReversed(surface) : std::vector<bool>(); };
  if (method == SkdInsideMethod::WindingNumber)
  {
    vtkPolyData* surface = this->GetBoundary().Surface;
    this->Winding = std::make_unique<SkdWinding>(surface, reversedOf(surface));
  }
  if (method == SkdInsideMethod::NearestFeature)
  {
    vtkPolyData* faces = this->GetBoundary().Faces;
    this->Normals = std::make_unique<SkdFeatureNormals>(faces, reversedOf(faces));
  }
}

std::vector<bool> SkdPart::FindReversed(vtkPolyData* surface) const
{
  if (this->Body.GetOpenSolid())
  {
    return this->Body.GetOpenSolid()->FindOutward(surface);
  }
  return SkdFindReversed(SkdSurfacePoints(surface), SkdSurfaceTriangles(surface),
    [this](const skd::Vector3& x)
    { return this->BoundsHold(x.X) && this->AskSolid(x.X).IsInside; });
}

bool SkdPart::BoundsHold(const double x[3]) const
{
  return x[0] >= this->Bounds[0] && x[0] <= this->Bounds[1] && x[1] >= this->Bounds[2] &&
    x[1] <= this->Bounds[3] && x[2] >= this->Bounds[4] && x[2] <= this->Bounds[5];
}

SkdSide SkdPart::AskSide(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const
{
  if (this->BoundsHold(x))
  {
    return this->AskWithin(x, rules, point);
  }
  const bool needsWinding = rules.Method == SkdInsideMethod::WindingNumber ||
    (!this->Body.GetSolid() &&
      (rules.Method == SkdInsideMethod::NearestFeature ||
        rules.Method == SkdInsideMethod::Automatic));
  if (!needsWinding || this->GetNumberOfFaces() == 0)
  {
    return SkdSide(); // a ray that leads away from the bounds meets nothing
  }
  SkdSide side = this->AskWithin(x, rules, point);
  side.Confidence = this->Body.GetSolid() ? 1.0 : side.IsInside ? 0.5 : side.Confidence;
  side.IsInside = false;
  return side;
}

SkdSide SkdPart::AskWithin(
  const double x[3], const SkdInsideRules& rules, std::uint64_t point) const
{
  switch (rules.Method)
  {
    case SkdInsideMethod::Automatic:
      return this->Body.GetSolid() ? this->AskSolid(x)
                                   : this->Body.GetOpenSolid()->Ask(x, rules.WindingTolerance);
    case SkdInsideMethod::AxisRays:
      return this->VoteAlongAxes(x);
    case SkdInsideMethod::RandomRays:
      return this->VoteAtRandom(x, rules, point);
    case SkdInsideMethod::WindingNumber:
      return this->AskWinding(x, rules.WindingTolerance);
    default:
      return this->AskNearest(x);
  }
}

bool SkdPart::IsOdd(const double x[3], const SkdRayEnd& ray) const
{
  const double end[3] = { x[0] + ray[0], x[1] + ray[1], x[2] + ray[2] };
  return this->Body.GetSurface()->CountCrossings(x, end) % 2 == 1;
}

SkdLineThrough::SkdLineThrough(const double bounds[6], double diagonal, const double from[3],
  const double along[3], double distance)
{
  double start = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double height = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      height += along[axis] * (bounds[2 * axis + (corner >> axis & 1)] - from[axis]);
    }
    start = std::min(start, height);
  }
  start -= 0.01 * diagonal;
  const double maxDistance = distance + 0.01 * diagonal;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->From[axis] = from[axis] + start * along[axis];
    this->To[axis] = from[axis] + maxDistance * along[axis];
  }
  this->Start = start;
  this->Length = maxDistance - start;
}

void SkdPart::FindPasses(const double from[3], const double along[3], double distance,
  SkdInsideMethod method, std::vector<SkdPassAlong>& passes) const
{
  const SkdLineThrough line(this->Bounds, this->Diagonal, from, along, distance);
  if (method == SkdInsideMethod::Automatic)
  {
    this->Body.GetSolid()->FindPasses(line.From.X, line.To.X, line.Length, passes);
  }
  else
  {
    this->FindTransitions(line.From.X, line.To.X, line.Length, passes);
  }
  for (SkdPassAlong& pass : passes)
  {
    pass.At += line.Start;
  }
}

// By parity.
void SkdPart::FindTransitions(
  const double p1[3], const double p2[3], double length, std::vector<SkdPassAlong>& passes) const
{
  thread_local vtkNew<vtkDoubleArray> parameters;
  thread_local vtkNew<vtkIdTypeArray> kinds;
  const vtkIdType n =
    this->Body.GetSurface()->FindCrossings(p1, p2, parameters, nullptr, nullptr, kinds);
  for (vtkIdType i = 0; i < n; ++i)
  {
    if (kinds->GetValue(i) == 1)
    {
      const int after = passes.size() % 2 == 0 ? 1 : 0;
      passes.push_back({ parameters->GetValue(i) * length, after });
    }
  }
}

SkdSide SkdPart::VoteAlongAxes(const double x[3]) const
{
  const std::array<SkdRayEnd, 7> rays = SkdRayEndsAlongAxes(this->Bounds, x);
  const int count = this->GetBoundary().OpenEdges == 0 ? 1 : 6;
  auto ray = rays.begin();
  return Elect(count, [&]() { return this->IsOdd(x, *ray++); });
}

SkdSide SkdPart::VoteAtRandom(
  const double x[3], const SkdInsideRules& rules, std::uint64_t point) const
{
  RandomRayEnds rays(this->Bounds, rules.Seed, point);
  const int count = this->GetBoundary().OpenEdges == 0 ? 1 : rules.NumberOfRays;
  return Elect(count, [&]() { return this->IsOdd(x, rays.Next()); });
}

SkdSide SkdPart::AskWinding(const double x[3], double tolerance) const
{
  return SkdSideOf(this->Winding->Ask(x, tolerance));
}

SkdSide SkdPart::AskNearest(const double x[3]) const
{
  double nearest[3], pcoords[3], dist2;
  int subId;
  const vtkIdType face = this->Body.GetFaces()->FindClosestLocation(
    x, std::numeric_limits<double>::infinity(), nearest, subId, pcoords, dist2, nullptr);
  if (face < 0)
  {
    return SkdSide();
  }
  const SkdFeatureNormals::Normal normal = this->Normals->At(face, pcoords);
  const skd::Vector3 away{ { x[0] - nearest[0], x[1] - nearest[1], x[2] - nearest[2] } };
  return { skd::Dot(away, normal.Direction) <= 0.0, normal.IsOpen ? 0.5 : 1.0 };
}
}
