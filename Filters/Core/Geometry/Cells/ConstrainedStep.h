// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_ConstrainedStep_h
#define skd_Geometry_Cells_ConstrainedStep_h

#include "../Tolerances.h"
#include "Core/Geometry/Cells/ParameterDomain.h"

#include <algorithm>
#include <optional>

namespace skd
{

/// The function 2 Gradient . d + d . Hessian d of a step d. Rows and columns beyond the dimension
/// of the domain are not looked at.
struct QuadraticModel
{
  Vector3 Gradient;
  Vector3 Hessian[3];

  Vector3 Times(const Vector3& d) const
  {
    return d[0] * this->Hessian[0] + d[1] * this->Hessian[1] + d[2] * this->Hessian[2];
  }
  double operator()(const Vector3& d) const
  {
    return 2.0 * Dot(this->Gradient, d) + Dot(d, this->Times(d));
  }
};

namespace detail
{

/// Solves A x = b by Cholesky's decomposition. False when A is not safely positive definite.
inline bool SolvePositive(int size, double (&a)[3][3], double (&x)[3])
{
  for (int i = 0; i < size; ++i)
  {
    const double least = tolerances::Pivot * a[i][i];
    for (int j = 0; j < i; ++j)
    {
      a[i][i] -= a[i][j] * a[i][j] / a[j][j];
      for (int k = i + 1; k < size; ++k)
      {
        a[k][i] -= a[k][j] * a[i][j] / a[j][j];
      }
      x[i] -= a[i][j] / a[j][j] * x[j];
    }
    if (!(a[i][i] > least))
    {
      return false;
    }
  }
  for (int i = size - 1; i >= 0; --i)
  {
    for (int k = i + 1; k < size; ++k)
    {
      x[i] -= a[k][i] * x[k];
    }
    x[i] /= a[i][i];
  }
  return true;
}

/// The directions across up to three independent normals. Returns their number.
inline int DirectionsAcross(const Vector3* normals, int size, Vector3 (&directions)[3])
{
  if (size == 0)
  {
    directions[0] = { { 1.0, 0.0, 0.0 } };
    directions[1] = { { 0.0, 1.0, 0.0 } };
    directions[2] = { { 0.0, 0.0, 1.0 } };
  }
  else if (size == 1)
  {
    const Vector3& n = normals[0];
    const Vector3 side =
      std::abs(n[2]) > std::abs(n[0]) ? Vector3{ { 1.0, 0.0, 0.0 } } : Vector3{ { 0.0, 0.0, 1.0 } };
    directions[0] = Cross(n, side);
    directions[1] = Cross(n, directions[0]);
  }
  else if (size == 2)
  {
    directions[0] = Cross(normals[0], normals[1]);
  }
  return 3 - size;
}

}

/// The step that minimises a quadratic model on a domain, seen from a point of it: sides that bar
/// the way join the working set, and those that the gradient pulls away from leave it.
class ConstrainedStep
{
public:
  ConstrainedStep(const ParameterDomain& domain, const Vector3& point, const QuadraticModel& model)
    : Domain(domain)
    , Point(point)
    , Model(model)
  {
    for (int axis = domain.Dimension; axis < 3; ++axis)
    {
      this->Normals[this->Count++] = AtMost1[axis].Normal;
    }
    this->Fixed = this->Count;
  }

  /// Nothing when the model has no minimum.
  std::optional<Vector3> Find()
  {
    constexpr int most = 24;
    for (int iteration = 0; iteration < most; ++iteration)
    {
      const Vector3 slope = this->Model.Gradient + this->Model.Times(this->Step);
      Vector3 free{ { 0.0, 0.0, 0.0 } };
      if (!this->FindFree(slope, free))
      {
        return std::nullopt;
      }
      if (this->Advance(free))
      {
        const Vector3 end = this->Model.Gradient + this->Model.Times(this->Step);
        if (!this->Release(end))
        {
          return this->Step;
        }
      }
    }
    return this->Step;
  }

private:
  /// The best step along the working set's sides.
  bool FindFree(const Vector3& slope, Vector3& step) const
  {
    Vector3 directions[3];
    const int size = detail::DirectionsAcross(this->Normals, this->Count, directions);
    double a[3][3] = {};
    double x[3] = {};
    for (int i = 0; i < size; ++i)
    {
      const Vector3 image = this->Model.Times(directions[i]);
      x[i] = -Dot(slope, directions[i]);
      for (int j = 0; j < size; ++j)
      {
        a[j][i] = Dot(image, directions[j]);
      }
    }
    if (!detail::SolvePositive(size, a, x))
    {
      return false;
    }
    for (int i = 0; i < size; ++i)
    {
      step = step + x[i] * directions[i];
    }
    return true;
  }

  /// As far as the next side. True when none is in the way.
  bool Advance(const Vector3& free)
  {
    const Vector3 here = this->Point + this->Step;
    double part = 1.0;
    int barrier = -1;
    for (int i = 0; i < this->Domain.Size; ++i)
    {
      const double approach = Dot(this->Domain.Sides[i].Normal, free);
      const double slack = std::max(0.0, Slack(this->Domain.Sides[i], here));
      if (!this->IsWorking(i) && approach > 0.0 && slack < part * approach)
      {
        part = slack / approach;
        barrier = i;
      }
    }
    this->Step = this->Step + part * free;
    if (barrier < 0 || this->Count == 3)
    {
      return true;
    }
    this->Sides[this->Count] = barrier;
    this->Normals[this->Count++] = this->Domain.Sides[barrier].Normal;
    return false;
  }

  bool IsWorking(int side) const
  {
    return std::find(this->Sides + this->Fixed, this->Sides + this->Count, side) !=
      this->Sides + this->Count;
  }

  /// Drops the side that holds the step back most. False when none does.
  bool Release(const Vector3& slope)
  {
    double gram[3][3];
    double forces[3];
    for (int i = 0; i < this->Count; ++i)
    {
      forces[i] = -Dot(slope, this->Normals[i]);
      for (int j = 0; j < this->Count; ++j)
      {
        gram[i][j] = Dot(this->Normals[i], this->Normals[j]);
      }
    }
    if (this->Count == this->Fixed || !detail::SolvePositive(this->Count, gram, forces))
    {
      return false;
    }
    const double* least = std::min_element(forces + this->Fixed, forces + this->Count);
    if (!(*least < -tolerances::Force * Norm(this->Model.Gradient)))
    {
      return false;
    }
    const auto dropped = static_cast<int>(least - forces);
    for (int i = dropped; i + 1 < this->Count; ++i)
    {
      this->Sides[i] = this->Sides[i + 1];
      this->Normals[i] = this->Normals[i + 1];
    }
    --this->Count;
    return true;
  }

  const ParameterDomain& Domain;
  const Vector3& Point;
  const QuadraticModel& Model;
  Vector3 Step{ { 0.0, 0.0, 0.0 } };
  Vector3 Normals[3]; // of the coordinates that are always 0, then of the working set
  int Sides[3] = { -1, -1, -1 };
  int Count = 0;
  int Fixed = 0;
};

}

#endif
