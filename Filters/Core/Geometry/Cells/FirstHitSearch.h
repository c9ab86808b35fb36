// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_FirstHitSearch_h
#define skd_Geometry_Cells_FirstHitSearch_h

#include "ParameterDomain.h"
#include "PartAlongLine.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace skd
{

/// What a search for hits goes by, all lengths.
struct HitLimits
{
  double Length;    ///< of the line: hits are between 0 and that
  double Rounding;  ///< the distance that is 0 to within rounding
  double Tolerance; ///< what comes as near as that to the line may be a hit; at least Rounding
};

/// Where a line first meets curves and surfaces in Bernstein form (patches), by branch and bound.
/// Parts that are certainly beside the line or behind the first hit so far go. On a part where
/// Krawczyk's test shows that there is one point of the line at most, Newton's method finds it.
/// What is left is halved. One a thread: it keeps its memory.
///
/// Hits are certain where the line crosses a patch. Where it runs along one, within rounding,
/// the hit may be off along the line by the root of rounding, relative to the size of the patches.
/// When there is too much to look at (a patch that is drawn together, say, and a line along it),
/// ever larger parts count as one point.
class FirstHitSearch
{
public:
  void Clear()
  {
    this->Patches.clear();
    this->Coefficients.clear();
  }

  /// Room for the coefficients of the polynomials of a patch, see PartAlongLine. Valid until the
  /// next one is added.
  double* Add(const BernsteinLayout& layout, bool isRational)
  {
    const std::size_t first = this->Coefficients.size();
    const int count = isRational ? 4 : 3;
    this->Patches.push_back({ layout, count, first });
    this->Coefficients.resize(first + static_cast<std::size_t>(count * layout.Size));
    return this->Coefficients.data() + first;
  }

  /// Calls solve(patch, p, along, isCrossing) with a point of a patch (its number, by order of
  /// adding, and parameters), and a position on the line, which are about the same point of space:
  /// it returns the position of the hit there, if it is one. It is for certain if isCrossing is
  /// true, however much the rounding of parameters leaves between both.
  template <class Solve>
  void Find(const HitLimits& limits, const Solve& solve)
  {
    this->Limits = limits;
    this->Last = limits.Length + limits.Tolerance;
    this->Resolution = limits.Rounding;
    this->PushPatches();
    for (int examined = 1; !this->Parts.empty(); ++examined)
    {
      if (examined >= Patience && examined % Period == 0)
      {
        this->Resolution *= 2.0;
      }
      this->Examine(solve);
    }
  }

private:
  static constexpr int Patience = 2048;
  static constexpr int Period = 32;

  struct Patch
  {
    BernsteinLayout Layout;
    int Count;
    std::size_t First; ///< of its coefficients

    const ParameterDomain& Domain() const
    {
      return this->Layout.Dimension == 1 ? UnitSegment
        : this->Layout.SimplexAxes > 0   ? UnitTriangle
                                         : UnitSquare;
    }
    std::size_t Size() const { return static_cast<std::size_t>(this->Count * this->Layout.Size); }
  };

  struct Part
  {
    BernsteinPart Map;
    int Number; ///< of the patch
  };

  /// Position on the line, and what a step across it, or of parameters, changes that by.
  struct Position
  {
    double Along;
    double Slope;
    Vector3 Gradient;
  };

  const double* ValuesOf(const Patch& patch) const
  {
    return this->Coefficients.data() + patch.First;
  }

  /// The coefficients of each part have a slot of their own.
  double* SlotOf(std::size_t part) { return this->Values.data() + part * this->Slot; }

  void Room(std::size_t slots)
  {
    if (this->Values.size() < slots * this->Slot)
    {
      this->Values.resize(2 * slots * this->Slot);
    }
  }

  /// Those that come first along the line on top.
  void PushPatches()
  {
    this->Slot = 0;
    for (const Patch& patch : this->Patches)
    {
      this->Slot = std::max(this->Slot, patch.Size());
    }
    this->Room(this->Patches.size() + 1);
    this->Memory.resize(this->Slot);
    this->SortPatches();
    this->Parts.clear();
    for (const auto& patch : this->Order)
    {
      const Patch& pushed = this->Patches[static_cast<std::size_t>(patch.second)];
      std::copy_n(this->ValuesOf(pushed), pushed.Size(), this->SlotOf(this->Parts.size()));
      this->Parts.push_back({ this->WholeOf(pushed), patch.second });
    }
  }

  /// Finds the order of those near the line, and the size of all.
  void SortPatches()
  {
    this->Size = 0.0;
    this->Order.clear();
    for (std::size_t i = 0; i < this->Patches.size(); ++i)
    {
      const BernsteinPart whole = this->WholeOf(this->Patches[i]);
      const PartAlongLine seen(whole, this->Memory.data());
      this->Size = std::max(this->Size, seen.Size());
      if (this->IsWanted(seen))
      {
        this->Order.push_back({ seen.AlongLine().Min, static_cast<int>(i) });
      }
    }
    std::sort(this->Order.begin(), this->Order.end(), std::greater<>());
  }

  BernsteinPart WholeOf(const Patch& patch)
  {
    BernsteinPart whole;
    whole.Layout = patch.Layout;
    whole.Count = patch.Count;
    whole.Legs[0][0] = 1.0;
    whole.Legs[1][1] = 1.0;
    whole.Values = this->Coefficients.data() + patch.First;
    return whole;
  }

  bool IsWanted(const PartAlongLine& seen) const
  {
    return seen.AlongLine().Min < this->Last && seen.AlongLine().Max >= -this->Limits.Tolerance &&
      seen.MayBeWithin(this->Limits.Tolerance);
  }

  /// Looks at the last part: it goes, or its halves take its position.
  template <class Solve>
  void Examine(const Solve& solve)
  {
    Part part = this->Parts.back();
    this->Parts.pop_back();
    part.Map.Values = this->SlotOf(this->Parts.size());
    PartAlongLine seen(part.Map, this->Memory.data());
    if (!this->IsWanted(seen))
    {
      return;
    }
    seen.LookAskew();
    if (!seen.MayBeWithin(this->Limits.Tolerance))
    {
      return;
    }
    if (part.Map.Layout.Dimension == 2)
    {
      const Contraction<2> contraction = seen.Contract(this->Limits.Tolerance);
      if (contraction.Excludes() || this->Finishes(part, contraction, solve))
      {
        return;
      }
    }
    const bool mayCross = seen.MayBeWithin(this->Limits.Rounding);
    const double distance =
      std::max(mayCross ? this->Limits.Rounding : this->Limits.Tolerance, this->Resolution);
    if (seen.IsContact(distance, std::sqrt(distance * this->Size)))
    {
      this->Try(
        part.Number, CornerOf(part.Map, seen.FirstCorner()), seen.AlongLine().Min, false, solve);
      return;
    }
    this->PushHalves(part, seen);
  }

  static Vector3 CornerOf(const BernsteinPart& part, int corner)
  {
    return part.Origin + (corner & 1 ? 1.0 : 0.0) * part.Legs[0] +
      (corner & 2 ? 1.0 : 0.0) * part.Legs[1];
  }

  template <class Solve>
  void Try(int patch, const Vector3& p, double along, bool isCrossing, const Solve& solve)
  {
    if (const std::optional<double> hit = solve(patch, p, along, isCrossing))
    {
      this->Last = std::min(this->Last, *hit - this->Resolution);
    }
  }

  /// Whether a part has been dealt with: its only root was found, or is elsewhere.
  template <class Solve>
  bool Finishes(const Part& part, Contraction<2> contraction, const Solve& solve)
  {
    constexpr double most = 0.9; // below 1 a root is the only one
    if (!(contraction.Worst() < most))
    {
      return false;
    }
    const auto start = [&contraction](int axis)
    { return std::clamp(0.5 + contraction.Step[axis], 0.0, 1.0); };
    const Patch& patch = this->Patches[static_cast<std::size_t>(part.Number)];
    Vector3 p = part.Map.Origin + start(0) * part.Map.Legs[0] + start(1) * part.Map.Legs[1];
    Position position;
    if (!this->FindRoot(patch, p, position))
    {
      return false;
    }
    const Vector3 inside = Clamped(patch.Domain(), p);
    const bool holds = Holds(part.Map, p);
    if (!holds)
    {
      for (double& slack : contraction.Slack)
      {
        slack *= this->Limits.Rounding / this->Limits.Tolerance;
      }
      const bool isElsewhere = contraction.Excludes();
      if (!isElsewhere || inside == p)
      {
        return isElsewhere; // where it is on the patch, the part that has it deals with it
      }
    }
    const double around = 2.0 * this->Limits.Tolerance * (1.0 + position.Slope);
    if (position.Along < this->Last + around && position.Along > -around)
    {
      const bool isBetweenEnds = position.Along >= 0.0 && position.Along <= this->Limits.Length;
      this->Try(part.Number, inside, position.Along, holds && inside == p && isBetweenEnds, solve);
    }
    return true;
  }

  /// Newton's method for the coordinates across, on what continues the patch beyond its sides, too.
  bool FindRoot(const Patch& patch, Vector3& p, Position& position) const
  {
    const double* values = this->ValuesOf(patch);
    const int size = patch.Layout.Size;
    constexpr int most = 20;
    for (int iteration = 0; iteration < most; ++iteration)
    {
      const BernsteinWeights weights(patch.Layout, p);
      const BernsteinPoint u = weights.Sum(values);
      const BernsteinPoint v = weights.Sum(values + size);
      const double determinant = u.Gradient[0] * v.Gradient[1] - u.Gradient[1] * v.Gradient[0];
      const double step[2] = { (u.Value * v.Gradient[1] - u.Gradient[1] * v.Value) / determinant,
        (u.Gradient[0] * v.Value - u.Value * v.Gradient[0]) / determinant };
      p[0] -= step[0];
      p[1] -= step[1];
      const double length = std::max(std::abs(step[0]), std::abs(step[1]));
      const double away = std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5));
      if (!(away < 2.0))
      {
        return false;
      }
      if (length <= tolerances::ConvexStep)
      {
        position = this->PositionAt(patch, weights, u, v, determinant);
        position.Along -= position.Gradient[0] * step[0] + position.Gradient[1] * step[1];
        return true;
      }
    }
    return false;
  }

  /// Of a point near a root.
  Position PositionAt(const Patch& patch, const BernsteinWeights& weights, const BernsteinPoint& u,
    const BernsteinPoint& v, double determinant) const
  {
    const double* values = this->ValuesOf(patch) + 2 * patch.Layout.Size;
    BernsteinPoint along = weights.Sum(values);
    if (patch.Count > 3)
    {
      const BernsteinPoint weight = weights.Sum(values + patch.Layout.Size);
      along.Value /= weight.Value;
      along.Gradient = (1.0 / weight.Value) * (along.Gradient - along.Value * weight.Gradient);
    }
    const Vector3& w = along.Gradient;
    const double ofU = (w[0] * v.Gradient[1] - w[1] * v.Gradient[0]) / determinant;
    const double ofV = (w[1] * u.Gradient[0] - w[0] * u.Gradient[1]) / determinant;
    return { along.Value, std::sqrt(ofU * ofU + ofV * ofV), w };
  }

  /// Whether a part has a point of its patch, or nearly so.
  static bool Holds(const BernsteinPart& part, const Vector3& p)
  {
    const Vector3 from = p - part.Origin;
    const Vector3& a = part.Legs[0];
    const Vector3& b = part.Legs[1];
    const double determinant = a[0] * b[1] - a[1] * b[0];
    const double r = (from[0] * b[1] - from[1] * b[0]) / determinant;
    const double s = (a[0] * from[1] - a[1] * from[0]) / determinant;
    const double far = part.Layout.SimplexAxes > 0 ? r + s : std::max(r, s);
    return std::min(r, s) >= -tolerances::NearPart && far <= 1.0 + tolerances::NearPart;
  }

  /// That which comes first along the line is looked at first.
  void PushHalves(Part& part, const PartAlongLine& seen)
  {
    const int axis = seen.LongestAxis();
    const bool endIsFirst = seen.EndIsFirst(axis);
    const std::size_t first = this->Parts.size();
    this->Room(first + 2);
    part.Map.Values = this->SlotOf(first);
    if (!endIsFirst)
    {
      part.Map.Reverse(axis);
    }
    Part other = part;
    other.Map.Values = this->SlotOf(first + 1);
    part.Map.SplitOff(axis, other.Map);
    this->Parts.push_back(part);
    this->Parts.push_back(other);
  }

  std::vector<Patch> Patches;
  std::vector<double> Coefficients;
  std::vector<std::pair<double, int>> Order;
  std::size_t Slot = 0;
  std::vector<double> Values;
  std::vector<double> Memory;
  std::vector<Part> Parts;
  HitLimits Limits{};
  double Size = 0.0;
  double Last = 0.0;
  double Resolution = 0.0;
};

}

#endif
