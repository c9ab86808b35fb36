// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdParametricCell.h"

#include "Cells/Kernels/SkdBernsteinMap.h"
#include "Core/Geometry/Box.h"
#include "Core/Geometry/Cells/LeastBernstein.h"
#include "Core/Geometry/Cells/LeastResidual.h"
#include "Core/Geometry/Distance/ClosestPointOnSegment.h"

#include "vtkCell.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace skdtree
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
// The nearest point of a cell.

/// The cell's points that are nearest to the origin, but apart from each other: each may be in a
/// valley of its own.
struct Starts
{
  static constexpr int Most = 3;
  skd::Vector3 Parameters[Most];
  int Count = 0;

  Starts(const SkdParametricCell& cell, int most)
  {
    while (this->Count < most && this->AddNearest(cell))
    {
    }
  }

private:
  bool AddNearest(const SkdParametricCell& cell)
  {
    double least = Infinity;
    for (int i = 0; i < cell.NumberOfPoints(); ++i)
    {
      const double distance2 = skd::Norm2(cell.Point(i));
      const skd::Vector3 p = cell.ParametersOfPoint(i);
      if (distance2 < least && this->IsApart(p))
      {
        least = distance2;
        this->Parameters[this->Count] = p;
      }
    }
    this->Count += least < Infinity ? 1 : 0;
    return least < Infinity;
  }

  bool IsApart(const skd::Vector3& p) const
  {
    constexpr double least = 0.7;
    return std::all_of(this->Parameters, this->Parameters + this->Count,
      [&p](const skd::Vector3& other) { return skd::Distance2(p, other) > least * least; });
  }
};

/// Whether a cell is nearer to the origin anywhere than at a point, by its Bernstein form. It is
/// relative to that point, so that what differs little loses nothing to rounding.
class NearerPoint
{
public:
  /// What is farther than limit2 need not be found.
  NearerPoint(const SkdParametricCell& cell, const SkdBernsteinMap& map, double limit2)
    : Cell(cell)
    , Map(map)
    , Limit2(limit2)
  {
  }

  /// The parameters of one, to begin a search at.
  std::optional<skd::Vector3> Find(const skd::LeastResidualPoint& known)
  {
    thread_local skd::LeastBernstein search;
    const double size = this->SizeFrom(known.Value);
    const double distance = std::sqrt(known.Norm2);
    const double unit = size * (size + 2.0 * distance);
    if (!(unit > 0.0 && unit < Infinity))
    {
      return std::nullopt;
    }
    const double rounding = this->Cell.Rounding();
    double tolerance = this->Slack *
      (skd::tolerances::SquareRounding + rounding * (rounding + 2.0 * distance) / unit);
    if (!this->Cell.RationalWeights()) // whose form is no distance, but a multiple of it
    {
      tolerance = std::max(tolerance, (known.Norm2 - this->Limit2) / unit - tolerance);
    }
    if (!this->Fill(known, 1.0 / unit, tolerance, search))
    {
      return std::nullopt;
    }
    return search.Find(known.Parameters, tolerance);
  }

  /// For one that was none.
  void AllowMoreRounding() { this->Slack *= 4.0; }

private:
  double SizeFrom(const skd::Vector3& point) const
  {
    double size2 = 0.0;
    for (int i = 0; i < this->Cell.NumberOfPoints(); ++i)
    {
      size2 = std::max(size2, skd::Distance2(this->Cell.Point(i), point));
    }
    return std::sqrt(size2);
  }

  /// False if the plane through the point, across the way to it, has the cell on its far side.
  bool Fill(const skd::LeastResidualPoint& known, double scale, double tolerance,
    skd::LeastBernstein& search)
  {
    thread_local std::vector<double> memory;
    const skd::DistanceForm& form = this->Map.GetDistanceForm();
    const auto size = static_cast<std::size_t>(form.GetLayout().Size);
    memory.resize(std::max(memory.size(), 7 * size));
    double* const controls[3] = { memory.data(), memory.data() + size, memory.data() + 2 * size };
    double* const weights = memory.data() + 3 * size;
    const double* ofPoints = this->Cell.RationalWeights();
    this->Map.Convert(&this->Cell.Point(0), known.Value, ofPoints, controls, weights);
    double* const used = ofPoints ? weights : nullptr;
    if (form.IsBeyond(controls, used, known.Value, -tolerance / scale))
    {
      return false;
    }
    form.Make(controls, used, known.Value, scale, weights + size, search.Reserve(form.GetSquare()));
    return true;
  }

  const SkdParametricCell& Cell;
  const SkdBernsteinMap& Map;
  double Limit2;
  double Slack = 1.0;
};

class NearestSearch
{
public:
  /// `map`: the cell's Bernstein form, nullptr if it has none.
  NearestSearch(const SkdParametricCell& cell, const SkdBernsteinMap* map, double limit2)
    : Cell(cell)
    , Search(cell.Domain(), cell)
    , Map(map)
    , Limit2(limit2)
  {
  }

  skd::LeastResidualPoint Find()
  {
    const Starts starts(this->Cell, this->Map ? 1 : Starts::Most);
    for (int i = 0; i < starts.Count && !this->IsOn(); ++i)
    {
      this->TryFrom(starts.Parameters[i]);
    }
    if (this->Map)
    {
      this->MakeCertain();
    }
    return this->Best;
  }

private:
  bool IsOn() const { return this->Best.Norm2 <= this->Cell.Rounding() * this->Cell.Rounding(); }

  /// Newton's method finds one minimum, which need not be the least.
  void TryFrom(const skd::Vector3& start)
  {
    const double enough = 0.125 * this->Cell.Rounding();
    const auto isKnown = [this](const skd::Vector3& p)
    {
      constexpr double apart = 0.01;
      return !this->Map && this->Best.Norm2 < Infinity &&
        skd::Distance2(p, this->Best.Parameters) < apart * apart;
    };
    const auto found = this->Search.Find(start, enough * enough, isKnown);
    this->Best = found.Norm2 < this->Best.Norm2 ? found : this->Best;
  }

  /// Each point that is nearer is the start of a search for the least nearby. There are few minima,
  /// and what rounding makes of one is passed over soon.
  void MakeCertain()
  {
    NearerPoint nearer(this->Cell, *this->Map, this->Limit2);
    constexpr int most = 32;
    for (int i = 0; i < most && !this->IsOn() && this->Best.Norm2 < Infinity; ++i)
    {
      const auto start = nearer.Find(this->Best);
      if (!start)
      {
        return;
      }
      const double before = this->Best.Norm2;
      this->TryFrom(*start);
      if (!(this->Best.Norm2 < before))
      {
        nearer.AllowMoreRounding();
      }
    }
  }

  const SkdParametricCell& Cell;
  skd::LeastResidual<SkdParametricCell> Search;
  const SkdBernsteinMap* Map;
  double Limit2;
  skd::LeastResidualPoint Best{ {}, {}, Infinity };
};

//------------------------------------------------------------------------------
// Where a segment meets a cell.

/// A part of a domain that a segment may hit: all of a curve or surface, a side of a volume.
struct Patch
{
  const skd::ParameterDomain* Domain;
  skd::Vector3 Origin;
  skd::Vector3 Axes[2];

  skd::Vector3 At(double r, double s) const
  {
    return this->Origin + r * this->Axes[0] + s * this->Axes[1];
  }
};

constexpr skd::Vector3 O = { { 0.0, 0.0, 0.0 } };
constexpr skd::Vector3 X = { { 1.0, 0.0, 0.0 } };
constexpr skd::Vector3 Y = { { 0.0, 1.0, 0.0 } };
constexpr skd::Vector3 Z = { { 0.0, 0.0, 1.0 } };
constexpr skd::Vector3 FromXToY = { { -1.0, 1.0, 0.0 } };
constexpr skd::Vector3 FromXToZ = { { -1.0, 0.0, 1.0 } };

constexpr Patch PatchOfSegment[] = { { &skd::UnitSegment, O, { X, O } } };
constexpr Patch PatchOfSquare[] = { { &skd::UnitSquare, O, { X, Y } } };
constexpr Patch PatchOfTriangle[] = { { &skd::UnitTriangle, O, { X, Y } } };
constexpr Patch PatchesOfCube[] = { { &skd::UnitSquare, O, { X, Y } },
  { &skd::UnitSquare, Z, { X, Y } }, { &skd::UnitSquare, O, { X, Z } },
  { &skd::UnitSquare, Y, { X, Z } }, { &skd::UnitSquare, O, { Y, Z } },
  { &skd::UnitSquare, X, { Y, Z } } };
constexpr Patch PatchesOfTetrahedron[] = { { &skd::UnitTriangle, O, { X, Y } },
  { &skd::UnitTriangle, O, { X, Z } }, { &skd::UnitTriangle, O, { Y, Z } },
  { &skd::UnitTriangle, X, { FromXToY, FromXToZ } } };
constexpr Patch PatchesOfPrism[] = { { &skd::UnitTriangle, O, { X, Y } },
  { &skd::UnitTriangle, Z, { X, Y } }, { &skd::UnitSquare, O, { X, Z } },
  { &skd::UnitSquare, O, { Y, Z } }, { &skd::UnitSquare, X, { FromXToY, Z } } };

struct PatchRange
{
  const Patch* First;
  const Patch* Last;
  const Patch* begin() const { return this->First; }
  const Patch* end() const { return this->Last; }
};

PatchRange PatchesOf(const skd::ParameterDomain& domain)
{
  const auto range = [](const auto& patches) {
    return PatchRange{ std::begin(patches), std::end(patches) };
  };
  return &domain == &skd::UnitSegment ? range(PatchOfSegment)
    : &domain == &skd::UnitSquare     ? range(PatchOfSquare)
    : &domain == &skd::UnitTriangle   ? range(PatchOfTriangle)
    : &domain == &skd::UnitCube       ? range(PatchesOfCube)
    : &domain == &skd::UnitPrism      ? range(PatchesOfPrism)
                                      : range(PatchesOfTetrahedron);
}

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

std::optional<LineInterval> IntervalNear(
  const SkdParametricCell& cell, const skd::Vector3& direction, double tolerance)
{
  skd::Box3 box;
  for (int i = 0; i < cell.NumberOfPoints(); ++i)
  {
    box.Add(cell.Point(i));
  }
  const skd::Segment<3> whole{ { { 0.0, 0.0, 0.0 } }, direction };
  const double around = 3.0 * skd::Norm(box.Max - box.Min) + tolerance + cell.Rounding();
  const auto inside = skd::Clip(whole, box.Inflated(around));
  if (!inside)
  {
    return std::nullopt;
  }
  return LineInterval{ inside->Min * direction, (inside->Max - inside->Min) * direction, *inside };
}

/// The vector from a point of the segment to one of a patch, a map of (r, s, t), or of (r, t) if
/// the patch is a curve. It is zero at a hit.
class Gap
{
public:
  Gap(const SkdParametricCell& cell, const Patch& patch, const LineInterval& interval)
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
  const Patch& ThePatch;
  const LineInterval& TheInterval;
};

/// The first hit of a segment with the patches of a cell: each is divided into a lattice of small
/// pieces, and each piece near the segment is the start of a solution for the hit.
class FirstHit
{
public:
  FirstHit(const SkdParametricCell& cell, const LineInterval& interval, double margin)
    : Cell(cell)
    , TheInterval(interval)
    , Margin(margin)
    , Steps(cell.NumberOfPoints() <= 27 ? 4 : MostSteps)
  {
  }

  std::optional<SkdLineHit> Find()
  {
    for (const Patch& patch : PatchesOf(this->Cell.Domain()))
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
    return this->Best;
  }

private:
  static constexpr int MostSteps = 7;

  int StepsAt(const Patch& patch, int j) const
  {
    return patch.Domain == &skd::UnitTriangle ? this->Steps - j : this->Steps;
  }

  void Sample(const Patch& patch)
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
  void TryPieces(const Patch& patch, int i, int j)
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

  void TryPiece(const Patch& patch, const skd::Vector3 (&corners)[3], double i, double j)
  {
    const skd::Vector3 middle = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
    const double radius = 1.25 *
      std::sqrt(std::max({ skd::Distance2(middle, corners[0]), skd::Distance2(middle, corners[1]),
        skd::Distance2(middle, corners[2]) }));
    const auto nearest =
      skd::ClosestPointOnSegment(this->TheInterval.At(0.0), this->TheInterval.At(1.0), middle);
    const double near = radius + this->Margin;
    const double length = skd::Norm(this->TheInterval.Direction);
    const bool isLate = this->Best && (nearest.R - this->BestT) * length > 2.0 * near;
    if (nearest.Dist2 <= near * near && !isLate)
    {
      this->Solve(patch, i / this->Steps, j / this->Steps, nearest.R);
    }
  }

  void Solve(const Patch& patch, double r, double s, double t)
  {
    const Gap gap(this->Cell, patch, this->TheInterval);
    skd::LeastResidual<Gap> search(gap.Domain(), gap);
    const double enough = 0.125 * this->Cell.Rounding();
    const auto found =
      search.Find(gap.Join(r, s, t), enough * enough, [](const skd::Vector3&) { return false; });
    const double at = gap.T(found.Parameters);
    if (found.Norm2 <= this->Margin * this->Margin && (!this->Best || at < this->BestT))
    {
      this->BestT = at;
      this->Best =
        SkdLineHit{ this->TheInterval.ToWhole(at), this->Cell.ToVTK(gap.OnCell(found.Parameters)) };
    }
  }

  const SkdParametricCell& Cell;
  const LineInterval& TheInterval;
  double Margin;
  int Steps;
  skd::Vector3 Samples[MostSteps + 1][MostSteps + 1];
  double BestT = 0.0;
  std::optional<SkdLineHit> Best;
};
}

//------------------------------------------------------------------------------
SkdCellPoint SkdParametricKernel::Closest(vtkCell* cell, const skd::Vector3& x, double limit2)
{
  const SkdParametricCell map(cell, x);
  const skd::LeastResidualPoint nearest =
    NearestSearch(map, SkdBernsteinMap::Of(cell, map.Domain()), limit2).Find();
  SkdCellPoint found;
  const bool isOn = nearest.Norm2 <= map.Rounding() * map.Rounding();
  found.Point = isOn ? x : x + nearest.Value;
  found.Dist2 = isOn ? 0.0 : nearest.Norm2;
  found.PCoords = map.ToVTK(nearest.Parameters);
  found.ProjectsInside =
    map.Domain().Dimension == 3 ? isOn : skd::IsInterior(map.Domain(), nearest.Parameters);
  return found;
}

//------------------------------------------------------------------------------
std::optional<SkdLineHit> SkdParametricKernel::Intersect(
  vtkCell* cell, const skd::Segment<3>& segment, double tolerance)
{
  const SkdParametricCell map(cell, segment.A);
  const double maxDistance = std::max(tolerance, map.Rounding());
  const auto interval = IntervalNear(map, segment.B - segment.A, maxDistance);
  if (!interval)
  {
    return std::nullopt;
  }
  return FirstHit(map, *interval, maxDistance).Find();
}
}
