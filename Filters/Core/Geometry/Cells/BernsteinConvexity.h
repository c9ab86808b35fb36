// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_BernsteinConvexity_h
#define skd_Geometry_Cells_BernsteinConvexity_h

#include "BernsteinPart.h"

#include "../Tolerances.h"

namespace skd
{

/// Bounds of the second derivatives of a part.
class BernsteinConvexity
{
public:
  explicit BernsteinConvexity(const BernsteinPart& part)
    : Part(part)
    , Dimension(part.Layout.Dimension)
  {
    for (int i = 0; i < this->Dimension; ++i)
    {
      for (int j = i; j < this->Dimension; ++j)
      {
        this->Bounds[i][j] = this->Bounds[j][i] = part.SecondDerivatives(i, j);
      }
    }
    this->Decompose();
  }

  bool IsConvex() const { return this->Convex; }

  /// The axis along which the polynomial is farthest from a straight line.
  int MostBentAxis() const
  {
    int most = 0;
    double largest = -1.0;
    for (int i = 0; i < this->Dimension; ++i)
    {
      double bend = 0.0;
      for (int j = 0; j < this->Dimension; ++j)
      {
        bend += (i == j ? 1.0 : 0.5) * this->Bounds[i][j].Size();
      }
      most = bend > largest ? i : most;
      largest = std::max(largest, bend);
    }
    return most;
  }

  /// What the polynomial is at least on a convex part, by its value and its gradient at a point
  /// that is in the part or very near to it: the sharper the better that is a minimum.
  double LeastBy(const BernsteinPoint& point) const
  {
    Vector3 local;
    if (!this->ToLocal(point.Parameters, local))
    {
      return -std::numeric_limits<double>::infinity();
    }
    const Vector3 inside = this->Clamped(local);
    if (!(Norm2(inside - local) <= tolerances::NearPart * tolerances::NearPart))
    {
      return -std::numeric_limits<double>::infinity();
    }
    Vector3 slope{};
    for (int i = 0; i < this->Dimension; ++i)
    {
      slope[i] = Dot(point.Gradient, this->Part.Legs[i]);
    }
    const double value = point.Value + this->LossOf(slope, inside - local);
    return value + this->LeastAround(inside, slope);
  }

private:
  /// Whether the second derivatives, each divided by the square roots of those on the diagonal, are
  /// a positive definite matrix for certain; then at least LeastPart times the identity.
  void Decompose()
  {
    double middle[3][3];
    double radius = 0.0;
    for (int i = 0; i < this->Dimension; ++i)
    {
      this->Diagonal[i] = this->Bounds[i][i].Middle();
      if (!(this->Bounds[i][i].Min > 0.0))
      {
        return;
      }
    }
    for (int i = 0; i < this->Dimension; ++i)
    {
      double sum = 0.0;
      for (int j = 0; j < this->Dimension; ++j)
      {
        const double scale = std::sqrt(this->Diagonal[i]) * std::sqrt(this->Diagonal[j]);
        middle[i][j] = this->Bounds[i][j].Middle() / scale;
        sum += this->Bounds[i][j].Radius() / scale;
      }
      radius = std::max(radius, sum);
    }
    this->Convex = this->IsAtLeast(middle, radius + LeastPart);
  }

  /// By Cholesky's decomposition of what is left.
  bool IsAtLeast(double (&matrix)[3][3], double least) const
  {
    for (int i = 0; i < this->Dimension; ++i)
    {
      const double pivot = matrix[i][i] - least;
      if (!(pivot > tolerances::Pivot))
      {
        return false;
      }
      for (int j = i + 1; j < this->Dimension; ++j)
      {
        for (int k = i + 1; k < this->Dimension; ++k)
        {
          matrix[j][k] -= matrix[j][i] * matrix[i][k] / pivot;
        }
      }
    }
    return true;
  }

  /// False for points that are not near the plane or the line of the part.
  bool ToLocal(const Vector3& p, Vector3& local) const
  {
    const Vector3 from = p - this->Part.Origin;
    const auto& legs = this->Part.Legs;
    Vector3 rest = from;
    Vector3 orthogonal[3];
    double coordinate[3] = {};
    local = {};
    for (int i = 0; i < this->Dimension; ++i)
    {
      orthogonal[i] = legs[i];
      for (int j = 0; j < i; ++j)
      {
        orthogonal[i] =
          orthogonal[i] - (Dot(legs[i], orthogonal[j]) / Norm2(orthogonal[j])) * orthogonal[j];
      }
      coordinate[i] = Dot(rest, orthogonal[i]) / Norm2(orthogonal[i]);
      rest = rest - coordinate[i] * orthogonal[i];
    }
    for (int i = this->Dimension - 1; i >= 0; --i)
    {
      local[i] = coordinate[i];
      for (int j = i + 1; j < this->Dimension; ++j)
      {
        local[i] -= local[j] * Dot(legs[j], orthogonal[i]) / Norm2(orthogonal[i]);
      }
    }
    return Norm2(rest) <= tolerances::OnPart * tolerances::OnPart;
  }

  Vector3 Clamped(Vector3 local) const
  {
    double sum = 0.0;
    for (int i = 0; i < this->Dimension; ++i)
    {
      local[i] = std::min(std::max(local[i], 0.0), 1.0);
      sum += this->Part.Layout.IsInSimplex(i) ? local[i] : 0.0;
    }
    for (int i = 0; i < this->Part.Layout.SimplexAxes && sum > 1.0; ++i)
    {
      local[i] /= sum;
    }
    return local;
  }

  /// At most what the value changes by on a step into the part, where the gradient changes, too.
  double LossOf(const Vector3& slope, const Vector3& step) const
  {
    double loss = 0.0;
    for (int i = 0; i < this->Dimension; ++i)
    {
      double change = 0.0;
      for (int j = 0; j < this->Dimension; ++j)
      {
        change += this->Bounds[i][j].Size() * std::abs(step[j]);
      }
      loss += slope[i] * step[i] - 0.5 * change * std::abs(step[i]) -
        change * change / (0.5 * LeastPart * this->Diagonal[i]);
    }
    return loss;
  }

  /// The least of slope d + curvature d^2 / 2 for all d with 0 <= at + d <= 1.
  static double LeastOfParabola(double slope, double curvature, double at)
  {
    const double wanted = -slope / curvature;
    const double d = std::min(std::max(wanted, -at), 1.0 - at);
    return slope * d + 0.5 * curvature * d * d;
  }

  /// Of the change from a point, in barycentric coordinates of each simplex that the domain is a
  /// product of: of these each by itself, of which the slopes' common part does not count.
  double LeastAround(const Vector3& at, const Vector3& slope) const
  {
    const int simplex = this->Part.Layout.SimplexAxes;
    double least = simplex > 0 ? this->LeastInSimplex(0, simplex, at, slope) : 0.0;
    for (int i = simplex; i < this->Dimension; ++i)
    {
      least += this->LeastInSimplex(i, i + 1, at, slope);
    }
    return least;
  }

  double LeastInSimplex(int first, int last, const Vector3& at, const Vector3& slope) const
  {
    double rest = 1.0;
    double common = 0.0;
    double curvature = std::numeric_limits<double>::infinity();
    for (int i = first; i < last; ++i)
    {
      rest -= at[i];
      common += at[i] * slope[i];
      curvature = std::min(curvature, this->Diagonal[i]);
    }
    const double share = 0.25 * LeastPart;
    double least = LeastOfParabola(-common, share * curvature / (last - first), rest);
    for (int i = first; i < last; ++i)
    {
      least += LeastOfParabola(slope[i] - common, share * this->Diagonal[i], at[i]);
    }
    return least;
  }

  static constexpr double LeastPart = 1.0 / 16.0;

  const BernsteinPart& Part;
  int Dimension;
  NumberRange Bounds[3][3];
  double Diagonal[3] = {};
  bool Convex = false;
};

}

#endif
