// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_NodePatch_h
#define skd_Curves_NodePatch_h

#include "BernsteinBasis.h"

#include <utility>

namespace skd
{

/// What the points of a curved face say of it.
enum class NodeMeaning
{
  Values,      ///< the face goes through them
  Serendipity, ///< so it does; of 3 x 3 points the one in the middle follows from the others
  Bubble,      ///< a quadratic triangle, bent by a seventh point: what it has in its middle
  Controls     ///< they are control points, with weights
};

/// A node: (x, y, z) as they are, and a weight.
using PatchNode = Vector<4>;

/// As curves and patches want it.
inline Homogeneous RelativeTo(const PatchNode& node, const Vector3& origin)
{
  return Weighted(Vector3{ { node[0], node[1], node[2] } } - origin, node[3]);
}

/// A curved face as cells store it: points on a lattice of parameters, (i/p, j/q), of a triangle
/// those with i + j <= p = q.
struct NodePatch
{
  int DegreeR = 1;
  int DegreeS = 1;
  bool IsTriangle = false;
  NodeMeaning Meaning = NodeMeaning::Values;
  PatchNode Middle{};                                           ///< of Bubble
  PatchNode Nodes[(MaximumDegree + 1) * (MaximumDegree + 1)]{}; ///< r runs first

  PatchNode& At(int i, int j) { return this->Nodes[i + j * (this->DegreeR + 1)]; }
  const PatchNode& At(int i, int j) const { return this->Nodes[i + j * (this->DegreeR + 1)]; }
  int Last(int j) const { return this->IsTriangle ? this->DegreeR - j : this->DegreeR; }
  int NumberOfSides() const { return this->IsTriangle ? 3 : 4; }

  bool HasNode(int i, int j) const
  {
    return this->Meaning != NodeMeaning::Serendipity || i != 1 || j != 1;
  }

  /// The nodes of a side, in the sense in which the sides run around the face; returns its degree.
  int CopySide(int side, PatchNode (&nodes)[MaximumDegree + 1]) const
  {
    const int degree = side % 2 == 0 || this->IsTriangle ? this->DegreeR : this->DegreeS;
    for (int k = 0; k <= degree; ++k)
    {
      const int back = degree - k;
      const int quad[4][2] = { { k, 0 }, { this->DegreeR, k }, { back, this->DegreeS },
        { 0, back } };
      const int triangle[3][2] = { { k, 0 }, { back, k }, { 0, back } };
      const int* at = this->IsTriangle ? triangle[side % 3] : quad[side];
      nodes[k] = this->At(at[0], at[1]);
    }
    return degree;
  }

  /// Where a side begins.
  Vector3 Corner(int side) const
  {
    PatchNode nodes[MaximumDegree + 1];
    this->CopySide(side, nodes);
    return Space(nodes[0]);
  }
};

/// A side of a face in Bernstein form, seen from where it begins: the same whichever of two faces
/// it is a side of, and whichever way it runs there.
struct CommonSide
{
  BezierCurve Curve;
  Vector3 Origin;
  bool IsReversed; ///< it runs against the sides of the face

  CommonSide(const NodePatch& face, int side)
  {
    PatchNode nodes[MaximumDegree + 1];
    this->Curve.Degree = face.CopySide(side, nodes);
    PatchNode* const end = nodes + this->Curve.Degree + 1;
    PatchNode reversed[MaximumDegree + 1];
    std::reverse_copy(nodes, end, reversed);
    this->IsReversed =
      std::lexicographical_compare(reversed, reversed + this->Curve.Degree + 1, nodes, end);
    const PatchNode* const from = this->IsReversed ? reversed : nodes;
    this->Origin = Space(from[0]);
    for (int i = 0; i <= this->Curve.Degree; ++i)
    {
      this->Curve.Points[i] = RelativeTo(from[i], this->Origin);
    }
    if (face.Meaning != NodeMeaning::Controls)
    {
      BernsteinBasisOf(this->Curve.Degree).Convert(this->Curve.Points);
    }
  }
};

/// The patch with its lattice put down differently: 8 ways of a quadrilateral, 6 of a triangle.
/// `isOver` returns whether that flips the face.
inline NodePatch PutDown(const NodePatch& patch, int orientation, bool& isOver)
{
  constexpr int orders[6][3] = { { 0, 1, 2 }, { 1, 0, 2 }, { 1, 2, 0 }, { 0, 2, 1 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  const bool isSwapped = !patch.IsTriangle && orientation % 2 == 1;
  NodePatch reversed = patch;
  reversed.DegreeR = isSwapped ? patch.DegreeS : patch.DegreeR;
  reversed.DegreeS = isSwapped ? patch.DegreeR : patch.DegreeS;
  isOver = patch.IsTriangle ? orientation % 2 == 1
                            : (orientation ^ (orientation >> 1) ^ (orientation >> 2)) % 2 == 1;
  for (int j = 0; j <= reversed.DegreeS; ++j)
  {
    for (int i = 0; i <= reversed.Last(j); ++i)
    {
      const int all[3] = { i, j, patch.DegreeR - i - j };
      int r = patch.IsTriangle ? all[orders[orientation % 6][0]] : (isSwapped ? j : i);
      int s = patch.IsTriangle ? all[orders[orientation % 6][1]] : (isSwapped ? i : j);
      r = !patch.IsTriangle && (orientation & 2) != 0 ? patch.DegreeR - r : r;
      s = !patch.IsTriangle && (orientation & 4) != 0 ? patch.DegreeS - s : s;
      reversed.At(i, j) = patch.At(r, s);
    }
  }
  return reversed;
}

/// Whether `a` comes before `b`, both being the same face put down differently.
inline bool IsBefore(const NodePatch& a, const NodePatch& b)
{
  if (a.DegreeR != b.DegreeR)
  {
    return a.DegreeR < b.DegreeR;
  }
  for (int j = 0; j <= a.DegreeS; ++j)
  {
    for (int i = 0; i <= a.Last(j); ++i)
    {
      if (a.HasNode(i, j) && !(a.At(i, j) == b.At(i, j)))
      {
        return a.At(i, j) < b.At(i, j);
      }
    }
  }
  return false;
}

/// The face as it is from whichever of two cells it is seen, for rounding depends on the order of
/// the points. `isOver` returns whether it is flipped.
inline NodePatch InCommonOrder(const NodePatch& patch, bool& isOver)
{
  NodePatch first = patch;
  isOver = false;
  for (int orientation = 1; orientation < (patch.IsTriangle ? 6 : 8); ++orientation)
  {
    bool isThisOver;
    const NodePatch other = PutDown(patch, orientation, isThisOver);
    if (IsBefore(other, first))
    {
      first = other;
      isOver = isThisOver;
    }
  }
  return first;
}

/// The value of a triangle's polynomial of the total degree of its nodes, at any (r, s): also
/// beyond its long side.
inline Homogeneous TriangleValue(const NodePatch& patch, double r, double s)
{
  const int n = patch.DegreeR;
  const bool isBezier = patch.Meaning == NodeMeaning::Controls;
  double factors[3][MaximumDegree + 1]; // of the count of steps along each
  const double at[3] = { r, s, 1.0 - r - s };
  for (int axis = 0; axis < 3; ++axis)
  {
    factors[axis][0] = 1.0;
    for (int k = 1; k <= n; ++k)
    {
      const double next = isBezier ? at[axis] : n * at[axis] - (k - 1);
      factors[axis][k] = factors[axis][k - 1] * next / k;
    }
  }
  double scale = 1.0; // n! of Bernstein's polynomials, of which factors[][] have the denominators
  for (int k = 2; isBezier && k <= n; ++k)
  {
    scale *= k;
  }
  Homogeneous sum{};
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i + j <= n; ++i)
    {
      const double weight = factors[0][i] * factors[1][j] * factors[2][n - i - j];
      sum = sum + (scale * weight) * patch.At(i, j);
    }
  }
  return sum;
}

/// The triangle whose seventh point bends a quadratic one, as a cubic one.
inline Homogeneous BubbleValue(const NodePatch& patch, double r, double s)
{
  const Homogeneous bubble = patch.Middle - TriangleValue(patch, 1.0 / 3.0, 1.0 / 3.0);
  return TriangleValue(patch, r, s) + (27.0 * r * s * (1.0 - r - s)) * bubble;
}

/// The point that a quadratic quadrilateral of 8 points has in its middle.
inline Homogeneous SerendipityMiddle(const NodePatch& patch)
{
  const Homogeneous corners = (patch.At(0, 0) + patch.At(2, 2)) + (patch.At(2, 0) + patch.At(0, 2));
  const Homogeneous sides = (patch.At(1, 0) + patch.At(1, 2)) + (patch.At(0, 1) + patch.At(2, 1));
  return 0.5 * sides - 0.25 * corners;
}

/// In Bernstein form, seen from an origin. Exact to rounding.
inline BezierPatch ToBezier(const NodePatch& nodes, const Vector3& origin)
{
  NodePatch from = nodes;
  from.Middle = RelativeTo(nodes.Middle, origin);
  for (int j = 0; j <= nodes.DegreeS; ++j)
  {
    for (int i = 0; i <= nodes.Last(j); ++i)
    {
      from.At(i, j) = RelativeTo(nodes.At(i, j), origin);
    }
  }
  if (from.Meaning == NodeMeaning::Serendipity)
  {
    from.At(1, 1) = SerendipityMiddle(from);
  }
  const bool isBubble = from.Meaning == NodeMeaning::Bubble;
  BezierPatch patch;
  patch.IsTriangle = from.IsTriangle;
  patch.DegreeR = isBubble ? 3 : from.DegreeR;
  patch.DegreeS = isBubble ? 3 : from.DegreeS;
  for (int j = 0; j <= patch.DegreeS; ++j)
  {
    for (int i = 0; i <= patch.DegreeR; ++i)
    {
      const double r = static_cast<double>(i) / patch.DegreeR;
      const double s = static_cast<double>(j) / patch.DegreeS;
      patch.Point(i, j) = !from.IsTriangle ? from.At(i, j)
        : isBubble                         ? BubbleValue(from, r, s)
                                           : TriangleValue(from, r, s);
    }
  }
  if (from.IsTriangle || from.Meaning != NodeMeaning::Controls)
  {
    ConvertToBernstein(patch);
  }
  return patch;
}

}

#endif
