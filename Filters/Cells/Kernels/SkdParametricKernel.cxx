// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdParametricCell.h"

#include "Cells/Kernels/SkdBernsteinMap.h"
#include "Core/Geometry/Cells/LeastBernstein.h"
#include "Core/Geometry/Cells/LeastResidual.h"

#include "vtkCell.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace skdtree
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

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
}
