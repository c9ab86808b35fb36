// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A curved face as flat facets no farther from it than a chordal deviation.
///
/// A side is cut by what it is itself, the same from every face that has it: facets of neighbours
/// fit together, corner by corner, to the last bit. A face within the deviation of a plane, with
/// sides that are straight within it, stays one polygon. Within other faces lies a lattice, with a
/// strip of triangles between it and each side.
///
/// The deviation of sides is a bound (SecondDerivative). That of facets is measured at four points
/// each, and the lattice refined until it is kept. Neither goes beyond MostPieces along a side.
#ifndef skd_Curves_PatchFacets_h
#define skd_Curves_PatchFacets_h

#include "../Geometry/Distance/ClosestPointOnTriangle.h"
#include "NodePatch.h"
#include "SecondDerivatives.h"
#include "Tolerances.h"

#include <array>
#include <vector>

namespace skd
{

class PatchFacets
{
public:
  static constexpr int MostPieces = 128;

  /// Reuses its memory. Nodes are finite, weights positive.
  void Cut(const NodePatch& face, double deviation)
  {
    bool isOver;
    const NodePatch common = InCommonOrder(face, isOver);
    this->Face = &common;
    this->Origin = common.Corner(0);
    this->Deviation = std::max(deviation, tolerances::LeastDivisor);
    this->Patch = ToBezier(common, this->Origin);
    Scale(this->Patch.Points, this->Patch.Size(), 1.0 / this->Deviation);
    this->ReadSides();
    if (this->IsOnePolygon())
    {
      this->Triangles.clear();
    }
    else
    {
      this->CutInside();
    }
    this->IsOver = isOver;
    this->Face = nullptr;
  }

  /// The index of a corner among the points; there are NumberOfSides() of them.
  int GetCorner(int side) const { return this->Sides[side].front(); }

  /// Whether it is one polygon, of all Points in turn.
  bool IsPolygon() const { return this->Triangles.empty(); }

  /// The points of the sides in turn, the corners among them, then those within.
  const std::vector<Vector3>& GetPoints() const { return this->Points; }

  /// The triangles turn as the face did that was given, if not IsFlipped(); the polygon as well.
  const std::vector<std::array<int, 3>>& GetTriangles() const { return this->Triangles; }
  bool IsFlipped() const { return this->IsOver; }

  /// Whether the facets that were found keep the deviation.
  bool IsKept() const { return this->IsWithinLimit; }

  /// Into how many pieces a side is cut.
  static int CountPieces(BezierCurve side, double deviation, bool& isExact)
  {
    Scale(side.Points, side.Degree + 1, 1.0 / deviation);
    const Vector3 start = side.Start();
    const Vector3 end = side.End();
    double farthest = 0.0;
    for (int i = 1; i < side.Degree; ++i)
    {
      farthest = std::max(farthest, ClosestPointOnSegment(start, end, side.Control(i)).Dist2);
    }
    return farthest <= 1.0 ? 1 : PiecesFor(SecondDerivative(side), start == end ? 3 : 2, isExact);
  }

private:
  using Parameters = Vector<2>;

  /// Lengths are in units of the deviation wherever it is looked at: so no scale is too small or
  /// too large.
  static void Scale(Homogeneous* points, int size, double factor)
  {
    for (int i = 0; i < size; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        points[i][axis] *= factor;
      }
    }
  }

  static int PiecesFor(double second, int least, bool& isExact)
  {
    const double wanted = std::sqrt(second / 8.0);
    isExact = isExact && wanted <= MostPieces;
    return wanted <= MostPieces ? std::max(least, static_cast<int>(std::ceil(wanted))) : MostPieces;
  }

  int Add(const Vector3& point, double r, double s)
  {
    this->Points.push_back(point);
    this->At.push_back({ { r, s } });
    return static_cast<int>(this->Points.size()) - 1;
  }

  //----------------------------------------------------------------------------
  void ReadSides()
  {
    constexpr double share = 0.7; // the rest is left to what the strips beside them add
    this->Points.clear();
    this->At.clear();
    this->IsWithinLimit = true;
    for (int side = 0; side < this->Face->NumberOfSides(); ++side)
    {
      const CommonSide common(*this->Face, side);
      const int n = CountPieces(common.Curve, share * this->Deviation, this->IsWithinLimit);
      this->Sides[side].clear();
      for (int i = 0; i < n; ++i)
      {
        const double t = static_cast<double>(common.IsReversed ? n - i : i) / n;
        const Vector3 x =
          i == 0 ? this->Face->Corner(side) : common.Origin + Projected(common.Curve.WeightedAt(t));
        const Parameters p = this->OnSide(side, static_cast<double>(i) / n);
        this->Sides[side].push_back(this->Add(x, p[0], p[1]));
      }
    }
    const int sides = this->Face->NumberOfSides();
    for (int side = 0; side < sides; ++side)
    {
      this->Sides[side].push_back(this->Sides[(side + 1) % sides].front());
    }
    this->NumberOnSides = static_cast<int>(this->Points.size());
  }

  Parameters OnSide(int side, double t) const
  {
    const Parameters quad[4] = { { { t, 0.0 } }, { { 1.0, t } }, { { 1.0 - t, 1.0 } },
      { { 0.0, 1.0 - t } } };
    const Parameters triangle[3] = { { { t, 0.0 } }, { { 1.0 - t, t } }, { { 0.0, 1.0 - t } } };
    return this->Face->IsTriangle ? triangle[side] : quad[side];
  }

  Vector3 InUnits(int point) const
  {
    return (1.0 / this->Deviation) * (this->Points[static_cast<std::size_t>(point)] - this->Origin);
  }

  int Pieces(int side) const { return static_cast<int>(this->Sides[side].size()) - 1; }

  //----------------------------------------------------------------------------
  /// All control points are near the plane of the corners; four of these may be a little warped.
  bool IsOnePolygon() const
  {
    const int sides = this->Face->NumberOfSides();
    if (this->NumberOnSides > sides)
    {
      return false;
    }
    const Vector3 a = this->InUnits(0);
    const Vector3 b = this->InUnits(1);
    const Vector3 c = this->InUnits(2);
    const Vector3 normal = Cross(c - a, sides == 3 ? c - b : this->InUnits(3) - b);
    double most = 0.0;
    for (int i = 0; i < this->Patch.Size(); ++i)
    {
      most = std::max(most, std::abs(Dot(Projected(this->Patch.Points[i]) - a, normal)));
    }
    return most <= 0.5 * Norm(normal);
  }

  //----------------------------------------------------------------------------
  void CutInside()
  {
    const PatchDerivatives second = SecondDerivatives(this->Patch);
    bool isExact = true;
    double r = PiecesFor(second.RR, 1, isExact);
    double s = PiecesFor(second.SS, 1, isExact);
    const double twisted = second.RS / (4.0 * r * s);
    const double more = twisted > 1.0 ? std::sqrt(twisted) : 1.0;
    r *= more;
    s *= more;
    for (;;)
    {
      const int m[2] = { AsCount(r), AsCount(s) };
      this->Points.resize(static_cast<std::size_t>(this->NumberOnSides));
      this->At.resize(static_cast<std::size_t>(this->NumberOnSides));
      this->Triangles.clear();
      if (this->Face->IsTriangle)
      {
        this->CutTriangle(std::max(m[0], m[1]));
      }
      else
      {
        this->CutQuad(m[0], m[1]);
      }
      const bool isFine = this->IsWithinDeviation();
      if (isFine || (m[0] == MostPieces && m[1] == MostPieces))
      {
        this->IsWithinLimit = this->IsWithinLimit && isFine;
        return;
      }
      r = 1.4 * std::max(r, 1.0);
      s = 1.4 * std::max(s, 1.0);
    }
  }

  static int AsCount(double pieces)
  {
    return pieces <= MostPieces ? static_cast<int>(std::ceil(pieces)) : MostPieces;
  }

  bool IsWithinDeviation() const
  {
    for (const std::array<int, 3>& triangle : this->Triangles)
    {
      Vector3 x[3];
      Parameters p[3];
      for (int i = 0; i < 3; ++i)
      {
        x[i] = this->InUnits(triangle[i]);
        p[i] = this->At[static_cast<std::size_t>(triangle[i])];
      }
      const double weights[4][3] = { { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 }, { 0.5, 0.5, 0.0 },
        { 0.0, 0.5, 0.5 }, { 0.5, 0.0, 0.5 } };
      for (const auto& w : weights)
      {
        const Parameters at = w[0] * p[0] + w[1] * p[1] + w[2] * p[2];
        const Vector3 on = Projected(this->Patch.WeightedAt(at[0], at[1]));
        const double dist2 = ClosestPointOnTriangle(x[0], x[1], x[2], on).Dist2;
        if (!(dist2 <= 1.0))
        {
          return false;
        }
      }
    }
    return true;
  }

  //----------------------------------------------------------------------------
  int AddInner(double r, double s)
  {
    const Vector3 x = Projected(this->Patch.WeightedAt(r, s)); // in units of the deviation
    return this->Add(this->Origin + this->Deviation * x, r, s);
  }

  /// The triangles between a side and a row within, both from left to right, the row above the
  /// side. The row's point j is above the parameter (j + shift) / count of the side.
  void Stitch(const std::vector<int>& side, const std::vector<int>& row, double shift, int count)
  {
    const std::size_t n = side.size() - 1;
    const std::size_t k = row.size() - 1;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < n || j < k)
    {
      const double nextOfSide = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
      const double nextOfRow = (static_cast<double>(j) + 0.5 + shift) / count;
      if (j == k || (i < n && nextOfSide <= nextOfRow))
      {
        this->Triangles.push_back({ side[i], side[i + 1], row[j] });
        ++i;
      }
      else
      {
        this->Triangles.push_back({ side[i], row[j + 1], row[j] });
        ++j;
      }
    }
  }

  static std::vector<int> Backward(const std::vector<int>& row)
  {
    return std::vector<int>(row.rbegin(), row.rend());
  }

  /// A face that is bent along one parameter alone, as a single strip. Returns whether it is one.
  bool CutStrip(int m, int n)
  {
    for (int side = 0; side < 2; ++side)
    {
      if ((side == 0 ? n : m) == 1 && this->Pieces(side + 1) == 1 &&
        this->Pieces((side + 3) % 4) == 1)
      {
        const std::vector<int> opposite = Backward(this->Sides[side + 2]);
        this->Stitch(this->Sides[side], opposite, 0.0, this->Pieces(side + 2));
        return true;
      }
    }
    return false;
  }

  void CutQuad(int m, int n)
  {
    if (this->CutStrip(m, n))
    {
      return;
    }
    m = std::max(m, 2);
    n = std::max(n, 2);
    this->FirstInner = static_cast<int>(this->Points.size());
    for (int j = 1; j < n; ++j)
    {
      for (int i = 1; i < m; ++i)
      {
        this->AddInner(static_cast<double>(i) / m, static_cast<double>(j) / n);
      }
    }
    const auto at = [&](int i, int j) { return this->FirstInner + (i - 1) + (j - 1) * (m - 1); };
    for (int j = 1; j + 1 < n; ++j)
    {
      for (int i = 1; i + 1 < m; ++i)
      {
        this->Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        this->Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
    for (int side = 0; side < 4; ++side)
    {
      const int count = side % 2 == 0 ? m : n;
      std::vector<int> row;
      for (int k = 1; k < count; ++k)
      {
        const int indices[4][2] = { { k, 1 }, { m - 1, k }, { m - k, n - 1 }, { 1, n - k } };
        row.push_back(at(indices[side][0], indices[side][1]));
      }
      this->Stitch(this->Sides[side], row, 1.0, count);
    }
  }

  void CutTriangle(int m)
  {
    m = std::max(m, 3);
    this->FirstInner = static_cast<int>(this->Points.size());
    for (int j = 1; j + 2 <= m; ++j)
    {
      for (int i = 1; i + j + 1 <= m; ++i)
      {
        this->AddInner(static_cast<double>(i) / m, static_cast<double>(j) / m);
      }
    }
    const auto at = [&](int i, int j)
    { return this->FirstInner + (j - 1) * (m - 1) - (j - 1) * j / 2 + (i - 1); };
    for (int j = 1; j + 2 < m; ++j)
    {
      for (int i = 1; i + j + 1 < m; ++i)
      {
        this->Triangles.push_back({ at(i, j), at(i + 1, j), at(i, j + 1) });
        if (i + j + 2 < m)
        {
          this->Triangles.push_back({ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
    for (int side = 0; side < 3; ++side)
    {
      std::vector<int> row;
      for (int k = 1; k + 1 < m; ++k)
      {
        const int back = m - 1 - k;
        const int indices[3][2] = { { k, 1 }, { back, k }, { 1, back } };
        row.push_back(at(indices[side][0], indices[side][1]));
      }
      this->Stitch(this->Sides[side], row, 1.5, m);
    }
  }

  const NodePatch* Face = nullptr; // while it is cut
  BezierPatch Patch;               // seen from the origin
  Vector3 Origin{};
  double Deviation = 0.0;
  std::vector<Vector3> Points;
  std::vector<Parameters> At; // of the points
  std::vector<int> Sides[4];  // both corners included
  int NumberOnSides = 0;
  int FirstInner = 0;
  std::vector<std::array<int, 3>> Triangles;
  bool IsOver = false;
  bool IsWithinLimit = true;
};

}

#endif
