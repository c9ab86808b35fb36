// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where a segment crosses a triangle, watertight: S. Woop, C. Benthin, I. Wald, "Watertight
/// Ray/Triangle Intersection", J. Computer Graphics Techniques 2 (2013) 65-82, in double precision
/// with exact signs. The mesh is sheared so that the segment runs along an axis; each vertex is
/// rounded once, the same for all its triangles, and from there on signs are exact. So no segment
/// slips through a shared edge or vertex.
#ifndef skd_Geometry_Intersection_SegmentTriangle_h
#define skd_Geometry_Intersection_SegmentTriangle_h

#include "../Predicates/Sign.h"
#include "../Segment.h"

#include <cstdint>
#include <cstring>

namespace skd
{

/// A vertex seen along a segment: (X, Y) across it, 0 on it; Z its parameter, 0 at A and 1 at B. Or
/// several vertices, side by side.
template <class Number>
struct ShearedLanes
{
  Number X;
  Number Y;
  Number Z;
};
using Sheared = ShearedLanes<double>;

/// The axis that a direction runs along most, Z, the two others, and how far it goes along these
/// for each step along Z.
struct Shear
{
  explicit Shear(const Vector3& direction)
    : Z(MostAlong(direction))
  {
    static constexpr int after[] = { 1, 2, 0, 1 };
    this->X = after[this->Z];
    this->Y = after[this->Z + 1];
    this->SlopeX = direction[this->X] / direction[this->Z];
    this->SlopeY = direction[this->Y] / direction[this->Z];
  }

  int Z;
  int X;
  int Y;
  double SlopeX;
  double SlopeY;

private:
  /// Without a branch: which it is, is anyone's guess.
  static int MostAlong(const Vector3& direction)
  {
    const double x = std::abs(direction[0]);
    const double y = std::abs(direction[1]);
    const int isY = y > x;
    const int isZ = std::abs(direction[2]) > std::max(x, y);
    return 2 * isZ | (isY & ~isZ);
  }
};

/// A segment prepared to be intersected with many triangles.
class SegmentView
{
public:
  explicit SegmentView(const Segment<3>& segment)
    : SegmentView(segment, segment.B - segment.A)
  {
  }

  const Segment<3>& GetSegment() const { return this->TheSegment; }
  const Shear& GetShear() const { return this->TheShear; }

  /// False for a segment of no length and for one that is not finite: these hit nothing.
  bool IsValid() const { return this->Length != 0.0 && std::isfinite(this->Length); }

  Sheared See(const Vector3& vertex) const
  {
    return this->See<double>([&](int axis) { return vertex[axis]; });
  }
  /// The same of along(axis), coordinates of one vertex or of several. Scaling by a power of two
  /// keeps signs exact on tiny and huge data.
  template <class Number, class Along>
  ShearedLanes<Number> See(const Along& along) const
  {
    const Shear& shear = this->TheShear;
    const auto from = [&](int axis) { return along(axis) - Number(this->TheSegment.A[axis]); };
    const Number z = from(shear.Z);
    return { (from(shear.X) - Number(shear.SlopeX) * z) * Number(this->Scale),
      (from(shear.Y) - Number(shear.SlopeY) * z) * Number(this->Scale), z / Number(this->Length) };
  }

  /// The parameter to report for a computed one: those within rounding of an end are that end's;
  /// nothing beyond.
  std::optional<double> Accept(double parameter) const
  {
    if (parameter >= 0.0 && parameter <= 1.0)
    {
      return parameter;
    }
    const double slack = this->EndSlack();
    if (!(parameter >= -slack && parameter <= 1.0 + slack))
    {
      return std::nullopt;
    }
    return std::clamp(parameter, 0.0, 1.0);
  }

private:
  SegmentView(const Segment<3>& segment, const Vector3& direction)
    : TheSegment(segment)
    , TheShear(direction)
    , Length(direction[this->TheShear.Z])
    , Scale(ScaleOf(this->Length))
  {
  }

  /// 2^-e for |length| in [2^(e-1), 2^e), e within 1000 of 0: as frexp() and ldexp() have it, which
  /// are calls.
  static double ScaleOf(double length)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &length, sizeof(bits));
    constexpr int bias = 1023;
    const int exponent = static_cast<int>(bits >> 52 & 0x7ffu) - (bias - 1);
    bits = static_cast<std::uint64_t>(bias - std::clamp(exponent, -1000, 1000)) << 52;
    double scale;
    std::memcpy(&scale, &bits, sizeof(scale));
    return scale;
  }

  double EndSlack() const
  {
    double magnitude = 0.0;
    ForEachAxis<3>(
      [&](int axis)
      {
        magnitude = std::max(magnitude, std::abs(this->TheSegment.A[axis]));
        magnitude = std::max(magnitude, std::abs(this->TheSegment.B[axis]));
      });
    constexpr double ulp = std::numeric_limits<double>::epsilon();
    return 4.0 * ulp * (1.0 + magnitude / std::abs(this->Length));
  }

  Segment<3> TheSegment;
  Shear TheShear;
  double Length;
  double Scale;
};

/// A crossing of a segment and a triangle.
struct TriangleHit
{
  double T; ///< parameter along the segment, [0, 1]
  double R; ///< x = (1 - R - S) p0 + R p1 + S p2
  double S;
  bool OnEdge; ///< on the boundary of the triangle: neighbours report it, too, with an equal T
  /// Whether the hit stays when the segment is moved aside by less than any number, the same way
  /// for all triangles: true for exactly one of two triangles that meet at a crossed edge, and for
  /// both or none where the segment only touches. So sums over a closed surface have exact parity.
  bool Passes;
};

namespace detail
{

/// The edge from P to Q as seen from the segment: which side, exactly.
struct EdgeSide
{
  int Sign;
  int MovedSign; ///< the sign when the segment moves by (e, e^2), e > 0 below any number
};

inline EdgeSide SideOf(const Sheared& p, const Sheared& q)
{
  const int sign = SignOfDifference(p.X, q.Y, p.Y, q.X);
  if (sign != 0)
  {
    return { sign, sign };
  }
  if (p.Y != q.Y)
  {
    return { 0, p.Y > q.Y ? 1 : -1 };
  }
  return { 0, q.X > p.X ? 1 : (q.X < p.X ? -1 : 0) };
}

inline double EdgeParameter(const Sheared& p, const Sheared& q)
{
  const double x = q.X - p.X;
  const double y = q.Y - p.Y;
  const double part = std::abs(x) > std::abs(y) ? -p.X / x : -p.Y / y;
  return p.Z + part * (q.Z - p.Z);
}

/// The same number whichever way, and from whichever triangle, the edge is named.
inline double ParameterOnEdge(const Sheared& p, const Sheared& q)
{
  const bool isOrdered = p.X != q.X ? p.X < q.X : (p.Y != q.Y ? p.Y < q.Y : p.Z < q.Z);
  return isOrdered ? EdgeParameter(p, q) : EdgeParameter(q, p);
}

}

/// The crossing of the segment with the triangle p0 p1 p2, boundary included. A triangle seen
/// exactly edge-on, or of no area, is not hit.
inline std::optional<TriangleHit> Intersect(
  const SegmentView& view, const Vector3& p0, const Vector3& p1, const Vector3& p2)
{
  const Sheared a = view.See(p0);
  const Sheared b = view.See(p1);
  const Sheared c = view.See(p2);
  const detail::EdgeSide u = detail::SideOf(b, c);
  const detail::EdgeSide v = detail::SideOf(c, a);
  const detail::EdgeSide w = detail::SideOf(a, b);
  const bool isOutside =
    (u.Sign > 0 || v.Sign > 0 || w.Sign > 0) && (u.Sign < 0 || v.Sign < 0 || w.Sign < 0);
  const int zeros = (u.Sign == 0) + (v.Sign == 0) + (w.Sign == 0);
  if (isOutside || zeros == 3)
  {
    return std::nullopt;
  }
  const double weightA = Difference(b.X, c.Y, b.Y, c.X);
  const double weightB = Difference(c.X, a.Y, c.Y, a.X);
  const double weightC = Difference(a.X, b.Y, a.Y, b.X);
  const double area = weightA + weightB + weightC;
  double parameter = (weightA * a.Z + weightB * b.Z + weightC * c.Z) / area;
  if (zeros == 2)
  {
    parameter = u.Sign != 0 ? a.Z : (v.Sign != 0 ? b.Z : c.Z);
  }
  else if (zeros == 1)
  {
    parameter = u.Sign == 0
      ? detail::ParameterOnEdge(b, c)
      : (v.Sign == 0 ? detail::ParameterOnEdge(c, a) : detail::ParameterOnEdge(a, b));
  }
  const std::optional<double> accepted = view.Accept(parameter);
  if (!accepted)
  {
    return std::nullopt;
  }
  const bool passes = u.MovedSign != 0 && u.MovedSign == v.MovedSign && v.MovedSign == w.MovedSign;
  return TriangleHit{ *accepted, weightB / area, weightC / area, zeros > 0, passes };
}

}

#endif
