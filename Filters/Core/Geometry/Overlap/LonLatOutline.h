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
      this->Places.push_back({ std::atan2(x[1], x[0]), std::atan2(x[2], r), r < PoleRadius });
      this->Tolerance = std::max(this->Tolerance, RelativeTolerance * Norm(x - corners[0]));
    }
    this->FollowLongitudes();
  }

  /// May be up to a turn wide. Both cells of a side have the same number for it.
  std::optional<LonLatCell> Find() const
  {
    LonLatCell cell{ Huge, -Huge, Huge, -Huge };
    for (const Place& place : this->Places)
    {
      cell.South = std::min(cell.South, place.Latitude);
      cell.North = std::max(cell.North, place.Latitude);
      cell.West = std::min(cell.West, place.IsPole ? Huge : place.Longitude);
      cell.East = std::max(cell.East, place.IsPole ? -Huge : place.Longitude);
    }
    if (cell.North - cell.South <= this->Tolerance)
    {
      return this->FindCap(cell);
    }
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      if (!this->IsAlongSide(this->Places[i], this->Places[(i + 1) % this->Places.size()], cell))
      {
        return std::nullopt;
      }
    }
    return LonLatCell{ this->MeanNear(&Place::Longitude, cell.West),
      this->MeanNear(&Place::Longitude, cell.East), this->MeanNear(&Place::Latitude, cell.South),
      this->MeanNear(&Place::Latitude, cell.North) };
  }

private:
  static constexpr double RelativeTolerance = 1e-6;
  static constexpr double PoleRadius = 1e-9; // nearer to the axis, a corner has no longitude
  static constexpr std::size_t LeastCapCorners = 7;
  static constexpr double Huge = 1e9;
  static constexpr double Turn = 6.28318530717958647692;

  struct Place
  {
    double Longitude;
    double Latitude;
    bool IsPole;
  };

  /// Longitudes go on from corner to corner; a pole takes that of the corner before.
  void FollowLongitudes()
  {
    const auto start = std::find_if(
      this->Places.begin(), this->Places.end(), [](const Place& place) { return !place.IsPole; });
    std::rotate(this->Places.begin(), start, this->Places.end());
    for (std::size_t i = 1; i < this->Places.size(); ++i)
    {
      Place& place = this->Places[i];
      const double before = this->Places[i - 1].Longitude;
      place.Longitude =
        before + (place.IsPole ? 0.0 : std::remainder(place.Longitude - before, Turn));
    }
  }

  bool IsAlongSide(const Place& a, const Place& b, const LonLatCell& cell) const
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
  double MeanNear(double Place::*what, double side) const
  {
    double sum = 0.0;
    int count = 0;
    for (const Place& place : this->Places)
    {
      const bool isKnown = what == &Place::Latitude || !place.IsPole;
      if (isKnown && std::abs(place.*what - side) <= this->Tolerance)
      {
        sum += place.*what - side;
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
      std::remainder(this->Places.front().Longitude - this->Places.back().Longitude, Turn);
    const double winding = this->Places.back().Longitude - this->Places.front().Longitude + closing;
    const bool isOnce = std::abs(std::abs(winding) - Turn) < RelativeTolerance;
    if (this->Places.size() < LeastCapCorners || !isOnce)
    {
      return std::nullopt;
    }
    const double latitude = this->MeanNear(&Place::Latitude, cell.South);
    const bool isNorthern = latitude >= 0.0;
    return LonLatCell{ cell.West, cell.West + Turn, isNorthern ? latitude : -0.25 * Turn,
      isNorthern ? 0.25 * Turn : latitude };
  }

  std::vector<Place> Places;
  double Tolerance = 0.0;
};

}

#endif
