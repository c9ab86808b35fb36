// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_LonLatOutline_h
#define skd_Geometry_Overlap_LonLatOutline_h

#include "LonLatCell.h"

#include <algorithm>
#include <vector>

namespace skd
{

/// Tells whether a polygon of the unit sphere is a cell between two meridians and two parallels, or
/// a cap about a pole, from its corners: each edge must be along a side, to RelativeTolerance of
/// the polygon's size. Corners on sides count, the date line and poles are nothing special. A cap
/// has at least LeastCapCorners: with fewer it is rather the cell of another kind of grid.
class LonLatOutline
{
public:
  explicit LonLatOutline(const std::vector<Vector3>& corners)
  {
    for (const Vector3& x : corners)
    {
      const double r = std::hypot(x[0], x[1]);
      this->Corners.push_back({ std::atan2(x[1], x[0]), std::atan2(x[2], r), r < PoleRadius });
      this->Tolerance = std::max(this->Tolerance, RelativeTolerance * Norm(x - corners[0]));
    }
    this->FollowLongitudes();
  }

  /// May be up to a turn wide. Both cells of a side have the same number for it.
  std::optional<LonLatCell> Find() const
  {
    LonLatCell cell{ Huge, -Huge, Huge, -Huge };
    for (const LonLatCorner& corner : this->Corners)
    {
      cell.South = std::min(cell.South, corner.Latitude);
      cell.North = std::max(cell.North, corner.Latitude);
      cell.West = std::min(cell.West, corner.IsPole ? Huge : corner.Longitude);
      cell.East = std::max(cell.East, corner.IsPole ? -Huge : corner.Longitude);
    }
    if (cell.North - cell.South <= this->Tolerance)
    {
      return this->FindCap(cell);
    }
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      if (!this->IsAlongSide(this->Corners[i], this->Corners[(i + 1) % this->Corners.size()], cell))
      {
        return std::nullopt;
      }
    }
    return LonLatCell{ this->MeanNear(&LonLatCorner::Longitude, cell.West),
      this->MeanNear(&LonLatCorner::Longitude, cell.East),
      this->MeanNear(&LonLatCorner::Latitude, cell.South),
      this->MeanNear(&LonLatCorner::Latitude, cell.North) };
  }

private:
  static constexpr double RelativeTolerance = 1e-6;
  static constexpr double PoleRadius = 1e-9; // nearer to the axis, a corner has no longitude
  static constexpr std::size_t LeastCapCorners = 7;
  static constexpr double Huge = 1e9;
  static constexpr double FullCircle = 6.28318530717958647692;

  struct LonLatCorner
  {
    double Longitude;
    double Latitude;
    bool IsPole;
  };

  /// Longitudes go on from corner to corner; a pole takes that of the corner before.
  void FollowLongitudes()
  {
    const auto start = std::find_if(this->Corners.begin(), this->Corners.end(),
      [](const LonLatCorner& corner) { return !corner.IsPole; });
    std::rotate(this->Corners.begin(), start, this->Corners.end());
    for (std::size_t i = 1; i < this->Corners.size(); ++i)
    {
      LonLatCorner& corner = this->Corners[i];
      const double before = this->Corners[i - 1].Longitude;
      corner.Longitude =
        before + (corner.IsPole ? 0.0 : std::remainder(corner.Longitude - before, FullCircle));
    }
  }

  bool IsAlongSide(const LonLatCorner& a, const LonLatCorner& b, const LonLatCell& cell) const
  {
    const auto isNear = [this](double x, double y) { return std::abs(x - y) <= this->Tolerance; };
    if (a.IsPole || b.IsPole)
    {
      const double longitude = a.IsPole ? b.Longitude : a.Longitude;
      return (a.IsPole && b.IsPole) || isNear(longitude, cell.West) || isNear(longitude, cell.East);
    }
    const bool isOnMeridian = isNear(a.Longitude, b.Longitude) &&
      (isNear(a.Longitude, cell.West) || isNear(a.Longitude, cell.East));
    const bool isOnParallel = isNear(a.Latitude, b.Latitude) &&
      (isNear(a.Latitude, cell.South) || isNear(a.Latitude, cell.North));
    return isOnMeridian || isOnParallel;
  }

  /// Of the corners on a side.
  double MeanNear(double LonLatCorner::*what, double side) const
  {
    double sum = 0.0;
    int count = 0;
    for (const LonLatCorner& corner : this->Corners)
    {
      const bool isKnown = what == &LonLatCorner::Latitude || !corner.IsPole;
      if (isKnown && std::abs(corner.*what - side) <= this->Tolerance)
      {
        sum += corner.*what - side;
        ++count;
      }
    }
    return side + sum / count;
  }

  /// The cell from a parallel to the nearer pole, if all corners are on that parallel (what the
  /// caller has found) and the polygon goes around it once. Longitudes go on from corner to corner
  /// (FollowLongitudes), so the last one less the first, and the edge that closes the polygon, add
  /// up to what it winds about the axis: a turn, east or west, or nothing if it goes back.
  std::optional<LonLatCell> FindCap(const LonLatCell& cell) const
  {
    const double closing =
      std::remainder(this->Corners.front().Longitude - this->Corners.back().Longitude, FullCircle);
    const double winding =
      this->Corners.back().Longitude - this->Corners.front().Longitude + closing;
    const bool isOnce = std::abs(std::abs(winding) - FullCircle) < RelativeTolerance;
    if (this->Corners.size() < LeastCapCorners || !isOnce)
    {
      return std::nullopt;
    }
    const double latitude = this->MeanNear(&LonLatCorner::Latitude, cell.South);
    const bool isNorthern = latitude >= 0.0;
    return LonLatCell{ cell.West, cell.West + FullCircle,
      isNorthern ? latitude : -0.25 * FullCircle, isNorthern ? 0.25 * FullCircle : latitude };
  }

  std::vector<LonLatCorner> Corners;
  double Tolerance = 0.0;
};

}

#endif
