// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_LeastBernstein_h
#define skd_Geometry_Cells_LeastBernstein_h

#include "BernsteinConvexity.h"

#include <optional>
#include <vector>

namespace skd
{

/// Whether a polynomial in Bernstein form is anywhere below a value that it is known to have, by
/// branch and bound. Its coefficients bound a part; a part on which it does not decrease along a
/// leg shrinks to the side where that begins; a convex part that has a minimum which is known needs
/// no further look. What is left is halved. One a thread: it keeps its memory.
class LeastBernstein
{
public:
  /// Room for the coefficients of the polynomial, to be filled before Find.
  double* Reserve(const BernsteinLayout& layout)
  {
    this->Slot = layout.Size;
    this->Room(0);
    this->Whole.Layout = layout;
    return this->Values.data();
  }

  /// A point where the polynomial is less than -tolerance, if there is one. `known` are the
  /// parameters of a minimum where it is about 0. The tolerance grows, and its last value is
  /// returned, when there is too much to look at: where it is about 0 on a whole line.
  std::optional<Vector3> Find(const Vector3& known, double& tolerance)
  {
    this->Whole.Values = this->Values.data();
    this->Whole.Origin = {};
    for (int i = 0; i < 3; ++i)
    {
      this->Whole.Legs[i] = { { i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0 } };
    }
    this->Known = BernsteinWeights(this->Whole.Layout, known).Sum(this->Whole.Values);
    this->Parts.assign(1, this->Whole);
    int examined = 0;
    while (!this->Parts.empty())
    {
      ++examined;
      if (examined >= Patience && examined % Period == 0)
      {
        tolerance *= 2.0;
      }
      if (const auto lower = this->Examine(tolerance))
      {
        return lower;
      }
    }
    return std::nullopt;
  }

private:
  static constexpr int Patience = 384;
  static constexpr int Period = 32;

  /// The values of each part have a slot of their own.
  void Room(std::size_t slots)
  {
    const std::size_t size = (slots + 1) * static_cast<std::size_t>(this->Slot);
    if (this->Values.size() < size)
    {
      this->Values.resize(2 * size);
    }
  }

  double* SlotOf(std::size_t part)
  {
    return this->Values.data() + part * static_cast<std::size_t>(this->Slot);
  }

  /// Looks at the last part: it goes, or its halves take its position.
  std::optional<Vector3> Examine(double tolerance)
  {
    BernsteinPart part = this->Parts.back();
    part.Values = this->SlotOf(this->Parts.size() - 1);
    this->Parts.pop_back();
    do
    {
      if (part.Range().Min >= -tolerance)
      {
        return std::nullopt;
      }
      if (const auto corner = LowCorner(part, tolerance))
      {
        return corner;
      }
    } while (CollapseAny(part));
    const BernsteinConvexity convexity(part);
    if (convexity.IsConvex() && convexity.LeastBy(this->Known) >= -tolerance)
    {
      return std::nullopt;
    }
    this->PushHalves(part, convexity.MostBentAxis());
    return std::nullopt;
  }

  /// The coefficients at corners are values.
  static std::optional<Vector3> LowCorner(const BernsteinPart& part, double tolerance)
  {
    const BernsteinLayout& layout = part.Layout;
    for (int corner = 0; corner < 1 << layout.Dimension; ++corner)
    {
      int offset = 0;
      int inSimplex = 0;
      Vector3 at = part.Origin;
      for (int axis = 0; axis < layout.Dimension; ++axis)
      {
        const bool isAtEnd = (corner >> axis & 1) != 0;
        offset += isAtEnd ? layout.Degree[axis] * layout.Stride[axis] : 0;
        inSimplex += isAtEnd && layout.IsInSimplex(axis) ? 1 : 0;
        at = isAtEnd ? at + part.Legs[axis] : at;
      }
      if (inSimplex <= 1 && part.Values[offset] < -tolerance)
      {
        return at;
      }
    }
    return std::nullopt;
  }

  static bool CollapseAny(BernsteinPart& part)
  {
    for (int axis = 0; axis < part.Layout.Dimension; ++axis)
    {
      const NumberRange slope = part.Differences(axis);
      if (slope.Max <= 0.0 && slope.Min < 0.0)
      {
        part.Reverse(axis);
      }
      if (slope.Min >= 0.0 || slope.Max <= 0.0)
      {
        part.Collapse(axis);
        return true;
      }
    }
    return false;
  }

  /// That at the lower end is looked at first.
  void PushHalves(BernsteinPart& part, int axis)
  {
    const std::size_t first = this->Parts.size();
    this->Room(first + 2);
    part.Values = this->SlotOf(first);
    const int end = part.Layout.Degree[axis] * part.Layout.Stride[axis];
    if (part.Values[0] < part.Values[end])
    {
      part.Reverse(axis);
    }
    BernsteinPart other;
    other.Values = this->SlotOf(first + 1);
    part.SplitOff(axis, other);
    this->Parts.push_back(part);
    this->Parts.push_back(other);
  }

  int Slot = 0;
  std::vector<double> Values;
  std::vector<BernsteinPart> Parts;
  BernsteinPart Whole;
  BernsteinPoint Known{};
};

}

#endif
