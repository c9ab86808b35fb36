// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_LeastResidual_h
#define skd_Geometry_Cells_LeastResidual_h

#include "../Tolerances.h"
#include "Core/Geometry/Cells/ConstrainedStep.h"

#include <limits>

namespace skd
{

/// Where on a domain a smooth map into space comes nearest to the origin, and the map's value
/// there.
struct LeastResidualPoint
{
  Vector3 Parameters;
  Vector3 Value;
  double Norm2;
};

/// Newton's method for the least |map(p)|^2 on a domain, damped (Levenberg, Marquardt) where it
/// would not descend. A map tells
///   Vector3 Value(p), void Tangents(p, Vector3 tangents[3])
/// for p in the domain, and, for differences, a little beyond.
template <class Map>
class LeastResidual
{
public:
  LeastResidual(const ParameterDomain& domain, const Map& map)
    : Domain(domain)
    , TheMap(map)
  {
  }

  /// The valley below `start`. The search ends when the squared residual is at most `enough2`, or
  /// `isKnown(p)` is true: then somebody was there already.
  template <class IsKnown>
  LeastResidualPoint Find(const Vector3& start, double enough2, const IsKnown& isKnown)
  {
    this->Damping = 0.0;
    this->IsBent = false;
    this->LastGain = std::numeric_limits<double>::infinity();
    this->MoveTo(start, this->TheMap.Value(start));
    constexpr int most = 60;
    for (int iteration = 0; iteration<most&& this->Best.Norm2> enough2; ++iteration)
    {
      if (!this->Improve() || isKnown(this->Best.Parameters))
      {
        break;
      }
    }
    return this->Best;
  }

private:
  void MoveTo(const Vector3& p, const Vector3& value)
  {
    this->Best = { p, value, skd::Norm2(value) };
  }

  /// One step down. False when there is nothing more to gain.
  bool Improve()
  {
    Vector3 tangents[3] = {};
    this->TheMap.Tangents(this->Best.Parameters, tangents);
    const QuadraticModel linear = this->MakeModel(tangents);
    bool isLinear = !this->IsBent;
    QuadraticModel model = linear;
    if (!isLinear)
    {
      this->AddCurvature(tangents, model);
    }
    constexpr int most = 16;
    for (int attempt = 0; attempt < most; ++attempt)
    {
      const QuadraticModel damped = this->Damped(model);
      const auto step = ConstrainedStep(this->Domain, this->Best.Parameters, damped).Find();
      const double gain = step ? -damped(*step) : 0.0;
      const bool isLast = step && !(gain > tolerances::LeastGain * this->Best.Norm2);
      if ((step && this->Try(*step, gain)) || isLast)
      {
        return !isLast;
      }
      this->Damping = step || isLinear ? this->MoreDamping() : this->Damping;
      model = step ? model : linear;
      isLinear = isLinear || !step;
    }
    return false;
  }

  double MoreDamping() const { return std::max(tolerances::FirstDamping, 10.0 * this->Damping); }

  /// Goes there if enough of the gain comes true.
  bool Try(const Vector3& step, double gain)
  {
    const Vector3 p = Clamped(this->Domain, this->Best.Parameters + step);
    const Vector3 value = this->TheMap.Value(p);
    const double gained = this->Best.Norm2 - skd::Norm2(value);
    if (!(gained > 0.0 && gained >= tolerances::GainShare * gain))
    {
      return false;
    }
    this->Damping = gained > 0.5 * gain && this->Damping > tolerances::LastDamping
      ? 0.1 * this->Damping
      : gained > 0.5 * gain ? 0.0
                            : this->Damping;
    this->IsBent = this->IsBent || gain > 0.05 * this->LastGain;
    this->LastGain = gain;
    this->MoveTo(p, value);
    return true;
  }

  QuadraticModel MakeModel(const Vector3 (&tangents)[3]) const
  {
    QuadraticModel model;
    for (int i = 0; i < 3; ++i)
    {
      model.Gradient[i] = Dot(tangents[i], this->Best.Value);
      for (int j = 0; j < 3; ++j)
      {
        model.Hessian[i][j] = Dot(tangents[i], tangents[j]);
      }
    }
    return model;
  }

  /// The second derivatives of the map along the residual, by differences. They matter where the
  /// residual does not vanish: without them the way to a point far off is long.
  void AddCurvature(const Vector3 (&tangents)[3], QuadraticModel& model) const
  {
    double curvature[3][3] = {};
    for (int axis = 0; axis < this->Domain.Dimension; ++axis)
    {
      Vector3 p = this->Best.Parameters;
      const double h = (p[axis] > 0.5 ? -1.0 : 1.0) * tolerances::SecondDifference;
      p[axis] += h;
      Vector3 there[3] = {};
      this->TheMap.Tangents(p, there);
      for (int i = 0; i < this->Domain.Dimension; ++i)
      {
        curvature[i][axis] = Dot(this->Best.Value, there[i] - tangents[i]) / h;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        model.Hessian[i][j] += 0.5 * (curvature[i][j] + curvature[j][i]);
      }
    }
  }

  QuadraticModel Damped(QuadraticModel model) const
  {
    const double largest =
      std::max({ model.Hessian[0][0], model.Hessian[1][1], model.Hessian[2][2] });
    for (int i = 0; i < 3 && this->Damping > 0.0; ++i)
    {
      model.Hessian[i][i] +=
        this->Damping * std::max(model.Hessian[i][i], tolerances::LeastCurvature * largest);
    }
    return model;
  }

  const ParameterDomain& Domain;
  const Map& TheMap;
  LeastResidualPoint Best;
  double Damping = 0.0;
  double LastGain = 0.0;
  bool IsBent = false;
};

}

#endif
