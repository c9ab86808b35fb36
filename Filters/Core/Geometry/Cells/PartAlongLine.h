// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_PartAlongLine_h
#define skd_Geometry_Cells_PartAlongLine_h

#include "BernsteinPart.h"
#include "Contraction.h"

#include "../Tolerances.h"

namespace skd
{

/// A part of a curve or of a surface as it is seen along a line. Its polynomials are two
/// coordinates across the line and one along it and, of a rational map, the weight, which is
/// positive and multiplies these. What its control points say of where the line meets the part.
class PartAlongLine
{
public:
  /// `memory` is for the control points of a rational part, three arrays of the layout's size.
  PartAlongLine(const BernsteinPart& part, double* memory)
    : Part(part)
    , Points(part.Count > 3 ? memory : part.Values)
  {
    if (part.Count > 3)
    {
      this->Project(memory);
    }
    const int size = part.Layout.Size;
    this->ForEachPoint(
      [&](const double* point)
      {
        this->Ranges[0].Add(point[0]);
        this->Ranges[1].Add(point[size]);
        this->Along.Add(point[2 * size]);
      });
  }

  const NumberRange& AlongLine() const { return this->Along; }

  /// How large the part is at most, along each axis.
  double Size() const
  {
    return 2.0 *
      std::max({ this->Ranges[0].Radius(), this->Ranges[1].Radius(), this->Along.Radius() });
  }

  /// The ranges across the part's own directions: it may be thin and lie askew.
  void LookAskew()
  {
    const int size = this->Part.Layout.Size;
    for (int axis = 0; axis < this->Part.Layout.Dimension; ++axis)
    {
      const double u = this->Chord(this->Points, axis);
      const double v = this->Chord(this->Points + size, axis);
      const double length = std::sqrt(u * u + v * v);
      if (length > 0.0)
      {
        NumberRange& range = this->Ranges[this->Count++];
        this->ForEachPoint(
          [&](const double* point) { range.Add((u * point[size] - v * point[0]) / length); });
      }
    }
  }

  /// Whether the part may come as near to the line as that.
  bool MayBeWithin(double distance) const
  {
    return std::all_of(this->Ranges, this->Ranges + this->Count,
      [distance](const NumberRange& range)
      { return range.Min <= distance && range.Max >= -distance; });
  }

  /// Whether it is a contact with the line, to be taken as one point: as thin as that in a plane
  /// along the line, or small, and not longer than that.
  bool IsContact(double distance, double length) const
  {
    const bool isThin = std::any_of(this->Ranges, this->Ranges + this->Count,
      [distance](const NumberRange& range) { return range.Size() <= distance; });
    const bool isSmall = std::max(this->Ranges[0].Radius(), this->Ranges[1].Radius()) <= distance;
    return (isThin || isSmall) && 2.0 * this->Along.Radius() <= length;
  }

  /// Krawczyk's test of the coordinates across, of a surface. `tolerance` is what counts as 0.
  Contraction<2> Contract(double tolerance) const
  {
    Contraction<2> contraction;
    std::fill(contraction.Spread, contraction.Spread + 2, std::numeric_limits<double>::infinity());
    double mean[2][2] = {};
    this->ForEachDerivative(
      [&](int axis, double u, double v, int count)
      {
        mean[0][axis] += u / count;
        mean[1][axis] += v / count;
      });
    const double determinant = mean[0][0] * mean[1][1] - mean[0][1] * mean[1][0];
    const double product2 = (mean[0][0] * mean[0][0] + mean[1][0] * mean[1][0]) *
      (mean[0][1] * mean[0][1] + mean[1][1] * mean[1][1]);
    if (!(std::abs(determinant) > tolerances::Pivot * std::sqrt(product2)))
    {
      return contraction;
    }
    const double inverse[2][2] = { { mean[1][1] / determinant, -mean[0][1] / determinant },
      { -mean[1][0] / determinant, mean[0][0] / determinant } };
    double most[2][2] = {};
    this->ForEachDerivative(
      [&](int axis, double u, double v, int)
      {
        for (int i = 0; i < 2; ++i)
        {
          const double off = inverse[i][0] * u + inverse[i][1] * v - (i == axis ? 1.0 : 0.0);
          most[i][axis] = std::max(most[i][axis], std::abs(off));
        }
      });
    const BernsteinWeights middle(this->Part.Layout, { { 0.5, 0.5, 0.0 } });
    const double weight = this->LargestWeight();
    const double u = middle.Sum(this->Part.Values).Value;
    const double v = middle.Sum(this->Part.Values + this->Part.Layout.Size).Value;
    for (int i = 0; i < 2; ++i)
    {
      contraction.Step[i] = -(inverse[i][0] * u + inverse[i][1] * v);
      contraction.Spread[i] = most[i][0] + most[i][1];
      contraction.Slack[i] = tolerance * weight * Length(inverse[i]);
    }
    return contraction;
  }

  /// The axis along which the part is longest.
  int LongestAxis() const
  {
    if (this->Part.Layout.Dimension < 2)
    {
      return 0;
    }
    return this->Length2(1) > this->Length2(0) ? 1 : 0;
  }

  /// The corner that comes first along the line, as 1 for the end of the first axis, 2 for that of
  /// the second, 3 for both.
  int FirstCorner() const
  {
    int first = 0;
    double least = std::numeric_limits<double>::infinity();
    const double* along = this->Points + 2 * this->Part.Layout.Size;
    for (int corner = 0; corner < this->NumberOfCorners(); ++corner)
    {
      const double at = along[this->OffsetOf(corner)];
      first = at < least ? corner : first;
      least = std::min(least, at);
    }
    return first;
  }

  /// Whether the end of an axis comes before the origin along the line.
  bool EndIsFirst(int axis) const
  {
    return this->Chord(this->Points + 2 * this->Part.Layout.Size, axis) < 0.0;
  }

private:
  void Project(double* points) const
  {
    const int size = this->Part.Layout.Size;
    const double* values = this->Part.Values;
    for (int i = 0; i < size; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        points[k * size + i] = values[k * size + i] / values[3 * size + i];
      }
    }
  }

  template <class Visit>
  void ForEachPoint(const Visit& visit) const
  {
    this->Part.Layout.ForEachRow(0,
      [&](int offset, int degree, const int(&)[3])
      {
        for (int i = 0; i <= degree; ++i)
        {
          visit(this->Points + offset + i);
        }
      });
  }

  /// visit(axis, u, v, count) for the coefficients of the derivatives of both coordinates across,
  /// and how many there are.
  template <class Visit>
  void ForEachDerivative(const Visit& visit) const
  {
    const BernsteinLayout& layout = this->Part.Layout;
    for (int axis = 0; axis < 2; ++axis)
    {
      const int n = layout.Degree[axis];
      const int stride = layout.Stride[axis];
      const int count =
        layout.IsInSimplex(axis) ? n * (n + 1) / 2 : n * (layout.Degree[1 - axis] + 1);
      layout.ForEachRow(axis,
        [&](int offset, int degree, const int(&)[3])
        {
          const double* row = this->Part.Values + offset;
          for (int i = 0; i < degree; ++i, row += stride)
          {
            visit(axis, n * (row[stride] - row[0]),
              n * (row[layout.Size + stride] - row[layout.Size]), count);
          }
        });
    }
  }

  static double Length(const double (&row)[2])
  {
    return std::sqrt(row[0] * row[0] + row[1] * row[1]);
  }

  double LargestWeight() const
  {
    double largest = 1.0;
    if (this->Part.Count > 3)
    {
      const double* weights = this->Part.Values + 3 * this->Part.Layout.Size;
      largest = *std::max_element(weights, weights + this->Part.Layout.Size);
    }
    return largest;
  }

  int NumberOfCorners() const
  {
    const BernsteinLayout& layout = this->Part.Layout;
    return layout.Dimension == 1 ? 2 : layout.SimplexAxes > 0 ? 3 : 4;
  }

  int OffsetOf(int corner) const
  {
    const BernsteinLayout& layout = this->Part.Layout;
    return (corner & 1 ? layout.Degree[0] : 0) +
      (corner & 2 ? layout.Degree[1] * layout.Stride[1] : 0);
  }

  /// How much a coordinate changes along an axis, on the mean of both sides.
  double Chord(const double* values, int axis) const
  {
    const int end = 1 << axis;
    const double chord = values[this->OffsetOf(end)] - values[0];
    return this->NumberOfCorners() < 4
      ? chord
      : 0.5 * (chord + values[this->OffsetOf(3)] - values[this->OffsetOf(3 - end)]);
  }

  /// At least the square of the length of any line along an axis.
  double Length2(int axis) const
  {
    const BernsteinLayout& layout = this->Part.Layout;
    const int stride = layout.Stride[axis];
    double largest = 0.0;
    layout.ForEachRow(axis,
      [&](int offset, int degree, const int(&)[3])
      {
        for (int i = 0; i < degree; ++i)
        {
          const double* at = this->Points + offset + i * stride;
          double length2 = 0.0;
          for (int k = 0; k < 3; ++k, at += layout.Size)
          {
            length2 += (at[stride] - at[0]) * (at[stride] - at[0]);
          }
          largest = std::max(largest, length2);
        }
      });
    return largest * layout.Degree[axis] * layout.Degree[axis];
  }

  const BernsteinPart& Part;
  const double* Points;
  NumberRange Ranges[4]; ///< across the line: of both coordinates, and askew
  int Count = 2;
  NumberRange Along;
};

}

#endif
