// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdParametricCell.h"

#include "Cells/Kernels/SkdBernsteinMap.h"
#include "Core/Geometry/Box.h"
#include "Core/Geometry/Cells/FirstHitSearch.h"
#include "Core/Geometry/Cells/LeastResidual.h"
#include "Core/Geometry/Distance/ClosestPointOnSegment.h"

#include "vtkCell.h"

#include <algorithm>
#include <limits>

namespace skdtree
{
namespace
{
/// The part of a segment near a cell: the points Start + t Direction, t in [0, 1], relative to the
/// segment's first end, because the cell would be lost in the rounding errors of a long segment.
struct LineInterval
{
  skd::Vector3 Start;
  skd::Vector3 Direction;
  skd::Interval Whole; ///< in the whole segment's parameter

  skd::Vector3 At(double t) const { return this->Start + t * this->Direction; }
  double ToWhole(double t) const
  {
    return this->Whole.Min + t * (this->Whole.Max - this->Whole.Min);
  }
};

/// `bounds`: of the cell.
std::optional<LineInterval> IntervalNear(
  const skd::Box3& bounds, const skd::Segment<3>& segment, double tolerance)
{
  // The interval's ends are rounded.
  const double around = tolerance + skd::Norm(bounds.Max - bounds.Min);
  const auto inside = skd::Clip(segment, bounds.Inflated(around));
  if (!inside)
  {
    return std::nullopt;
  }
  const skd::Vector3 direction = segment.B - segment.A;
  return LineInterval{ inside->Min * direction, (inside->Max - inside->Min) * direction, *inside };
}

/// The vector from a point of the segment to one of a patch, a map of (r, s, t), or of (r, t) if
/// the patch is a curve. It is zero at a hit.
class Gap
{
public:
  Gap(const SkdParametricCell& cell, const SkdPatch& patch, const LineInterval& interval)
    : Cell(cell)
    , ThePatch(patch)
    , TheInterval(interval)
  {
  }

  skd::Vector3 Value(const skd::Vector3& p) const
  {
    return this->Cell.Value(this->OnCell(p)) - this->TheInterval.At(p[this->AxisOfT()]);
  }

  void Tangents(const skd::Vector3& p, skd::Vector3 (&tangents)[3]) const
  {
    skd::Vector3 ofCell[3] = {};
    this->Cell.Tangents(this->OnCell(p), ofCell);
    for (int i = 0; i < this->AxisOfT(); ++i)
    {
      const skd::Vector3& axis = this->ThePatch.Axes[i];
      tangents[i] = axis[0] * ofCell[0] + axis[1] * ofCell[1] + axis[2] * ofCell[2];
    }
    tangents[this->AxisOfT()] = -1.0 * this->TheInterval.Direction;
  }

  const skd::ParameterDomain& Domain() const
  {
    return this->ThePatch.Domain == &skd::UnitSegment ? skd::UnitSquare
      : this->ThePatch.Domain == &skd::UnitSquare     ? skd::UnitCube
                                                      : skd::UnitPrism;
  }

  skd::Vector3 OnCell(const skd::Vector3& p) const
  {
    return this->ThePatch.At(p[0], this->AxisOfT() == 2 ? p[1] : 0.0);
  }
  double T(const skd::Vector3& p) const { return p[this->AxisOfT()]; }
  skd::Vector3 Join(double r, double s, double t) const
  {
    return this->AxisOfT() == 2 ? skd::Vector3{ { r, s, t } } : skd::Vector3{ { r, t, 0.0 } };
  }

private:
  int AxisOfT() const { return this->ThePatch.Domain->Dimension; }

  const SkdParametricCell& Cell;
  const SkdPatch& ThePatch;
  const LineInterval& TheInterval;
};

/// The first of the hits that are found so far.
class FirstHit
{
public:
  FirstHit(const SkdParametricCell& cell, const LineInterval& interval, double margin)
    : Cell(cell)
    , TheInterval(interval)
    , TheMargin(margin)
  {
  }

  double Margin() const { return this->TheMargin; }
  double T() const { return this->BestT; }
  const std::optional<SkdLineHit>& Get() const { return this->Hit; }

  /// Where the segment, around t, comes nearest to a patch around its point (r, s): a hit if that
  /// is within a distance. Returns its t.
  std::optional<double> SolveFrom(
    const SkdPatch& patch, double r, double s, double t, double distance)
  {
    const Gap gap(this->Cell, patch, this->TheInterval);
    skd::LeastResidual<Gap> search(gap.Domain(), gap);
    const double enough = 0.125 * this->Cell.Rounding();
    const auto found =
      search.Find(gap.Join(r, s, t), enough * enough, [](const skd::Vector3&) { return false; });
    if (!(found.Norm2 <= distance * distance))
    {
      return std::nullopt;
    }
    const double at = gap.T(found.Parameters);
    if (at < this->BestT)
    {
      this->BestT = at;
      this->Hit =
        SkdLineHit{ this->TheInterval.ToWhole(at), this->Cell.ToVTK(gap.OnCell(found.Parameters)) };
    }
    return at;
  }

private:
  const SkdParametricCell& Cell;
  const LineInterval& TheInterval;
  double TheMargin;
  double BestT = std::numeric_limits<double>::infinity();
  std::optional<SkdLineHit> Hit;
};

/// Coordinates across a segment, two, and along it, all lengths.
class LineFrame
{
public:
  explicit LineFrame(const skd::Vector3& direction)
    : TheLength(skd::Norm(direction))
  {
    const skd::Vector3 along =
      this->TheLength > 0.0 ? (1.0 / this->TheLength) * direction : SkdPatches::X;
    const skd::Vector3 side = std::abs(along[0]) < 0.6 ? SkdPatches::X : SkdPatches::Y;
    const skd::Vector3 across = skd::Cross(along, side);
    this->Axes[0] = (1.0 / skd::Norm(across)) * across;
    this->Axes[1] = skd::Cross(along, this->Axes[0]);
    this->Axes[2] = along;
  }

  double Length() const { return this->TheLength; }

  /// Changes three arrays of coordinates. Returns the largest one.
  double Change(double* const (&coordinates)[3], int size) const
  {
    double largest = 0.0;
    for (int i = 0; i < size; ++i)
    {
      const skd::Vector3 p = { { coordinates[0][i], coordinates[1][i], coordinates[2][i] } };
      for (int axis = 0; axis < 3; ++axis)
      {
        coordinates[axis][i] = skd::Dot(p, this->Axes[axis]);
        largest = std::max(largest, std::abs(coordinates[axis][i]));
      }
    }
    return largest;
  }

private:
  double TheLength;
  skd::Vector3 Axes[3];
};

/// Finds the first hit for certain, by the Bernstein form of a cell's patches.
class CertainSearch
{
public:
  CertainSearch(const SkdParametricCell& cell, const LineInterval& interval)
    : Cell(cell)
    , TheInterval(interval)
    , Frame(interval.Direction)
  {
  }

  /// False if a patch has no such form, or weights that are not positive.
  bool Find(vtkCell* cell, FirstHit& best)
  {
    thread_local skd::FirstHitSearch search;
    search.Clear();
    const SkdPatchRange patches = SkdPatches::Of(this->Cell.Domain());
    for (const SkdPatch& patch : patches)
    {
      const SkdBernsteinMap* map =
        SkdBernsteinMap::Of(cell, this->Cell.Domain(), static_cast<int>(&patch - patches.First));
      if (!map || !this->Add(*map, search))
      {
        return false;
      }
    }
    const double length = this->Frame.Length();
    const double rounding = this->Cell.Rounding() + this->ControlRounding;
    // What is left at a crossing: parameters are rounded, too.
    const double ofCrossing =
      best.Margin() + std::min(this->ControlRounding, 8.0 * this->Cell.Rounding());
    search.Find({ length, rounding, best.Margin() + this->ControlRounding },
      [&](int patch, const skd::Vector3& p, double along, bool isCrossing) -> std::optional<double>
      {
        const double start = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
        const auto t = best.SolveFrom(
          patches.First[patch], p[0], p[1], start, isCrossing ? ofCrossing : best.Margin());
        return t ? std::optional<double>(*t * length) : std::nullopt;
      });
    return true;
  }

private:
  bool Add(const SkdBernsteinMap& map, skd::FirstHitSearch& search)
  {
    const skd::BernsteinLayout& layout = map.GetLayout();
    const double* ofPoints = this->Cell.RationalWeights();
    double* values = search.Add(layout, ofPoints != nullptr);
    double* const controls[3] = { values, values + layout.Size, values + 2 * layout.Size };
    double* const weights = values + 3 * layout.Size;
    map.Convert(&this->Cell.Point(0), this->TheInterval.Start, ofPoints, controls, weights);
    const double size = this->Frame.Change(controls, layout.Size);
    this->ControlRounding = std::max(this->ControlRounding,
      4.0 * std::numeric_limits<double>::epsilon() * map.Amplification() * size);
    return !ofPoints || layout.AllOf([weights](int i) { return weights[i] > 0.0; });
  }

  const SkdParametricCell& Cell;
  const LineInterval& TheInterval;
  LineFrame Frame;
  double ControlRounding = 0.0;
};

/// For cells without a Bernstein form: each patch is divided into a lattice of small pieces, and
/// each piece near the segment is the start of a solution for the hit. Hits may be missed.
class LatticeSearch
{
public:
  LatticeSearch(const SkdParametricCell& cell, const LineInterval& interval, FirstHit& best)
    : Cell(cell)
    , TheInterval(interval)
    , Best(best)
    , Steps(cell.NumberOfPoints() <= 27 ? 4 : MostSteps)
  {
  }

  void Find()
  {
    for (const SkdPatch& patch : SkdPatches::Of(this->Cell.Domain()))
    {
      this->Sample(patch);
      for (int j = 0; j < (patch.Domain->Dimension == 2 ? this->Steps : 1); ++j)
      {
        for (int i = 0; i < this->StepsAt(patch, j); ++i)
        {
          this->TryPieces(patch, i, j);
        }
      }
    }
  }

private:
  static constexpr int MostSteps = 7;

  int StepsAt(const SkdPatch& patch, int j) const
  {
    return patch.Domain == &skd::UnitTriangle ? this->Steps - j : this->Steps;
  }

  void Sample(const SkdPatch& patch)
  {
    const int last = patch.Domain->Dimension == 2 ? this->Steps : 0;
    for (int j = 0; j <= last; ++j)
    {
      for (int i = 0; i <= this->StepsAt(patch, j); ++i)
      {
        this->Samples[j][i] =
          this->Cell.Value(patch.At(double(i) / this->Steps, double(j) / this->Steps));
      }
    }
  }

  /// A interval of a curve, or the two triangles of a square of the lattice.
  void TryPieces(const SkdPatch& patch, int i, int j)
  {
    const auto& at = this->Samples;
    if (patch.Domain->Dimension == 1)
    {
      const skd::Vector3 ends[] = { at[0][i], at[0][i + 1], 0.5 * (at[0][i] + at[0][i + 1]) };
      this->TryPiece(patch, ends, i + 0.5, 0.0);
      return;
    }
    const skd::Vector3 lower[] = { at[j][i], at[j][i + 1], at[j + 1][i] };
    this->TryPiece(patch, lower, i + 1.0 / 3.0, j + 1.0 / 3.0);
    if (patch.Domain != &skd::UnitTriangle || i + j + 1 < this->Steps)
    {
      const skd::Vector3 upper[] = { at[j + 1][i + 1], at[j + 1][i], at[j][i + 1] };
      this->TryPiece(patch, upper, i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
  }

  void TryPiece(const SkdPatch& patch, const skd::Vector3 (&corners)[3], double i, double j)
  {
    const skd::Vector3 middle = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
    const double radius = 1.25 *
      std::sqrt(std::max({ skd::Distance2(middle, corners[0]), skd::Distance2(middle, corners[1]),
        skd::Distance2(middle, corners[2]) }));
    const auto nearest =
      skd::ClosestPointOnSegment(this->TheInterval.At(0.0), this->TheInterval.At(1.0), middle);
    const double near = radius + this->Best.Margin();
    const double length = skd::Norm(this->TheInterval.Direction);
    const bool isLate = (nearest.R - this->Best.T()) * length > 2.0 * near;
    if (nearest.Dist2 <= near * near && !isLate)
    {
      this->Best.SolveFrom(patch, i / this->Steps, j / this->Steps, nearest.R, this->Best.Margin());
    }
  }

  const SkdParametricCell& Cell;
  const LineInterval& TheInterval;
  FirstHit& Best;
  int Steps;
  skd::Vector3 Samples[MostSteps + 1][MostSteps + 1];
};
}

//------------------------------------------------------------------------------
std::optional<SkdLineHit> SkdParametricKernel::Intersect(
  vtkCell* cell, const skd::Box3& bounds, const skd::Segment<3>& segment, double tolerance)
{
  const SkdParametricCell map(cell, segment.A);
  const double maxDistance = std::max(tolerance, map.Rounding());
  const auto interval = IntervalNear(bounds, segment, maxDistance);
  if (!interval)
  {
    return std::nullopt;
  }
  FirstHit best(map, *interval, maxDistance);
  if (!CertainSearch(map, *interval).Find(cell, best))
  {
    LatticeSearch(map, *interval, best).Find();
  }
  return best.Get();
}
}
