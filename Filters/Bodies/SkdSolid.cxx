// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdSolid.h"

#include "vtkBoundingBox.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
std::array<SkdRayEnd, 7> SkdRayEndsAlongAxes(const double bounds[6], const double x[3])
{
  const double diagonal = vtkBoundingBox(bounds).GetDiagonalLength();
  std::array<SkdRayEnd, 7> rays;
  for (int i = 0; i < 6; ++i)
  {
    const int axis = i / 2;
    const double toBound = bounds[i] - x[axis];
    const double length = std::abs(toBound) + 0.01 * diagonal;
    rays[i] = { 0.0437 * length, 0.0269 * length, 0.0163 * length };
    rays[i][axis] = i % 2 ? length : -length;
  }
  const auto length2 = [](const SkdRayEnd& ray) { return vtkMath::Dot(ray.data(), ray.data()); };
  std::stable_sort(rays.begin(), rays.begin() + 6,
    [&](const SkdRayEnd& a, const SkdRayEnd& b) { return length2(a) < length2(b); });
  rays[6] = { 1.31 * diagonal, 1.13 * diagonal, 1.23 * diagonal };
  return rays;
}

/// What one shell says of a point.
struct SkdSolid::Around
{
  int Shell;
  int Raw = 0;     // its winding number, as it is reversed
  int Outward = 0; // the same when it is oriented outward; parity of one that has one side
  int Passes = 0;
};

SkdSolid::SkdSolid(const SkdBoundary& boundary, vtkSkdTreeCellLocator* locator)
  : Surface(boundary.Surface)
  , Locator(locator)
  , Repeats(boundary.Repeats)
{
  this->Surface->GetCellsBounds(this->Bounds);
}

void SkdSolid::FindShells() const
{
  std::call_once(this->ShellsFlag,
    [this]
    {
      this->Shells = std::make_unique<SkdShells>(
        SkdSurfacePoints(this->Surface), SkdSurfaceTriangles(this->Surface));
      this->HasOneSided = this->Shells->HasOneSided();
      this->HasShells.store(true, std::memory_order_release);
    });
}

SkdSide SkdSolid::Ask(const double x[3], const SkdRayEnd& ray) const
{
  const double end[3] = { x[0] + ray[0], x[1] + ray[1], x[2] + ray[2] };
  const auto count = [&](vtkUnsignedCharArray* reversed, vtkIdType& sum)
  { return this->Locator->CountPasses(x, end, reversed, sum); };
  bool isKnown = this->HasShells.load(std::memory_order_acquire);
  vtkIdType sum;
  vtkIdType passes = count(isKnown ? this->Shells->GetReversed() : nullptr, sum);
  if (passes < 2)
  {
    return { passes == 1, 1.0 };
  }
  if (!isKnown)
  {
    this->FindShells();
    passes = this->Shells->GetReversed() ? count(this->Shells->GetReversed(), sum) : passes;
  }
  return this->IsClear(sum) ? SkdSide{ sum != 0, 1.0 } : this->Weigh(x, end);
}

/// Whether the sum of crossing directions, of shells oriented outward, decides.
bool SkdSolid::IsClear(vtkIdType sum) const
{
  return !this->HasOneSided && (sum == 0 ? this->Repeats.empty() : std::abs(sum) == 1);
}

void SkdSolid::FindPasses(
  const double p1[3], const double p2[3], double length, std::vector<SkdPassAlong>& passes) const
{
  thread_local vtkNew<vtkDoubleArray> parameters;
  thread_local vtkNew<vtkIdTypeArray> triangles;
  thread_local vtkNew<vtkIdTypeArray> rays;
  this->FindShells();
  vtkUnsignedCharArray* reversed = this->Shells->GetReversed();
  const vtkIdType n = this->Locator->FindPasses(p1, p2, parameters, triangles, rays);
  int around = 0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const bool isReversed = reversed && reversed->GetValue(triangles->GetValue(i)) != 0;
    const int ray = static_cast<int>(rays->GetValue(i));
    around -= isReversed ? -ray : ray;
    passes.push_back({ parameters->GetValue(i) * length, this->IsClear(around) ? around : 2 });
  }
}

// By ascending shell. In a vector of the calling thread.
const std::vector<SkdSolid::Around>& SkdSolid::FindAround(
  const double x[3], const double end[3]) const
{
  thread_local vtkNew<vtkIdTypeArray> triangles;
  thread_local vtkNew<vtkIdTypeArray> rays;
  thread_local std::vector<Around> arounds;
  arounds.clear();
  vtkUnsignedCharArray* reversed = this->Shells->GetReversed();
  const vtkIdType n = this->Locator->FindPasses(x, end, nullptr, triangles, rays);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType triangle = triangles->GetValue(i);
    const int ray = static_cast<int>(rays->GetValue(i));
    const int outward = reversed && reversed->GetValue(triangle) != 0 ? -ray : ray;
    const int raw = this->Repeats.empty() ? ray : ray * this->Repeats[triangle];
    arounds.push_back({ this->Shells->GetShellOf(triangle), raw, outward, 1 });
  }
  std::sort(arounds.begin(), arounds.end(),
    [](const Around& a, const Around& b) { return a.Shell < b.Shell; });
  std::size_t number = 0;
  for (const Around& pass : arounds)
  {
    const bool isNew = number == 0 || arounds[number - 1].Shell != pass.Shell;
    number += isNew ? 1 : 0;
    Around& shell = arounds[number - 1];
    shell = isNew
      ? pass
      : Around{ pass.Shell, shell.Raw + pass.Raw, shell.Outward + pass.Outward, shell.Passes + 1 };
  }
  arounds.resize(number);
  for (Around& shell : arounds)
  {
    shell.Outward = this->Shells->Get()[shell.Shell].IsOneSided ? shell.Passes % 2 : shell.Outward;
  }
  return arounds;
}

SkdSide SkdSolid::Weigh(const double x[3], const double end[3]) const
{
  const std::vector<Around> arounds = this->FindAround(x, end);
  bool isOneSided = false;
  bool isCoherent = true;
  int raw = 0;
  int passes = 0;
  for (const Around& around : arounds)
  {
    const SkdShells::Shell& shell = this->Shells->Get()[around.Shell];
    isOneSided = isOneSided || (shell.IsOneSided && around.Passes > 1);
    isCoherent = isCoherent && shell.IsCoherent;
    raw += around.Raw;
    passes += around.Passes;
  }
  const bool isInside = this->CountGroupsAround(arounds) % 2 == 1;
  if (isOneSided)
  {
    return { isInside, 0.5 };
  }
  if (isCoherent)
  {
    return { isInside, isInside == (raw != 0) ? 1.0 : 0.5 };
  }
  return { isInside, isInside == (passes % 2 == 1) ? 1.0 : 0.75 };
}

// How many groups of shells hold the point.
int SkdSolid::CountGroupsAround(const std::vector<Around>& arounds) const
{
  const auto isAround = [](const Around& around) { return around.Outward != 0; };
  const auto those = std::count_if(arounds.begin(), arounds.end(), isAround);
  if (those < 2)
  {
    return static_cast<int>(those);
  }
  this->FindGroups();
  std::vector<std::pair<int, int>> sums; // of a group
  for (const Around& around : arounds)
  {
    const int outward = this->Cavity[around.Shell] ? -around.Outward : around.Outward;
    sums.emplace_back(this->Groups[around.Shell], outward);
  }
  std::sort(sums.begin(), sums.end());
  int number = 0;
  for (auto begin = sums.begin(); begin != sums.end();)
  {
    const auto end =
      std::find_if(begin, sums.end(), [&](const auto& sum) { return sum.first != begin->first; });
    int sum = 0;
    std::for_each(begin, end, [&](const auto& one) { sum += one.second; });
    number += sum != 0 ? 1 : 0;
    begin = end;
  }
  return number;
}

void SkdSolid::FindGroups() const
{
  std::call_once(this->GroupsFlag,
    [this]
    {
      std::vector<int> groups = SkdFindShellGroups(
        SkdSurfacePoints(this->Surface), SkdSurfaceTriangles(this->Surface), *this->Shells);
      this->JoinCavities(groups);
      const std::vector<SkdShells::Shell>& shells = this->Shells->Get();
      std::vector<int> largest(groups.size(), -1); // shell of a group
      for (int i = 0; i < static_cast<int>(groups.size()); ++i)
      {
        int& other = largest[groups[i]];
        const bool isLarger =
          other < 0 || std::abs(shells[i].Volume) > std::abs(shells[other].Volume);
        other = isLarger ? i : other;
      }
      this->Cavity.assign(groups.size(), 0);
      for (int i = 0; i < static_cast<int>(groups.size()); ++i)
      {
        const bool isCavity = this->AreOpposite(i, largest[groups[i]]) && this->IsWithin(i, groups);
        this->Cavity[i] = isCavity ? 1 : 0;
      }
      this->Groups = groups;
    });
}

/// Whether two shells are oriented against each other, as they are.
bool SkdSolid::AreOpposite(int a, int b) const
{
  const SkdShells::Shell& one = this->Shells->Get()[a];
  const SkdShells::Shell& other = this->Shells->Get()[b];
  return one.IsCoherent && other.IsCoherent && one.GetSign() != other.GetSign();
}

/// A shell within another one of opposite orientation, touching or not, belongs to its group:
/// crossing the surface of a cavity is crossing that of the body.
void SkdSolid::JoinCavities(std::vector<int>& groups) const
{
  const auto find = [&](int group)
  {
    while (groups[group] != group)
    {
      group = groups[group] = groups[groups[group]];
    }
    return group;
  };
  const auto sizeOf = [&](int shell) { return std::abs(this->Shells->Get()[shell].Volume); };
  for (int i = 0; i < static_cast<int>(groups.size()); ++i)
  {
    int nearest = -1; // the smallest that holds it
    for (const Around& around : this->FindAround(this->Shells->Get()[i].Extremes[0]))
    {
      const bool holds = around.Outward != 0 && find(around.Shell) != find(i);
      const bool isNearer = nearest < 0 || sizeOf(around.Shell) < sizeOf(nearest);
      nearest = holds && isNearer ? around.Shell : nearest;
    }
    if (nearest >= 0 && this->AreOpposite(i, nearest))
    {
      const int a = find(i), b = find(nearest);
      groups[std::max(a, b)] = std::min(a, b);
    }
  }
  for (int i = 0; i < static_cast<int>(groups.size()); ++i)
  {
    groups[i] = find(i);
  }
}

const std::vector<SkdSolid::Around>& SkdSolid::FindAround(const skd::Vector3& x) const
{
  const SkdRayEnd ray = SkdRayEndsAlongAxes(this->Bounds, x.X)[0];
  const double end[3] = { x[0] + ray[0], x[1] + ray[1], x[2] + ray[2] };
  return this->FindAround(x.X, end);
}

/// Whether most of a shell's outermost points are in others of its group.
bool SkdSolid::IsWithin(int shell, const std::vector<int>& groups) const
{
  int within = 0;
  for (const skd::Vector3& x : this->Shells->Get()[shell].Extremes)
  {
    const std::vector<Around>& arounds = this->FindAround(x);
    within += std::any_of(arounds.begin(), arounds.end(),
      [&](const Around& around) {
        return around.Shell != shell && groups[around.Shell] == groups[shell] &&
          around.Outward != 0;
      });
  }
  return within > 3;
}
}
