// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdPlacement.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
/// A power of two that keeps products of three coordinates in range.
double FindScale(double reach)
{
  constexpr double least = 1e-20;
  constexpr double largest = 1e80;
  int exponent = 0;
  std::frexp(reach, &exponent);
  const bool isInRange = reach == 0.0 || (reach >= least && reach <= largest);
  return isInRange ? 1.0 : std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
}
}

//------------------------------------------------------------------------------
SkdPlacedTriangles::SkdPlacedTriangles(
  const SkdTriangleSet& set, const std::optional<skd::RigidMotion>& motion, double scale)
  : Set(&set)
  , Points(set.GetPoints())
  , Axes(set.GetTriangles().size())
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        skd::Vector3& point = this->Points[i];
        point = scale * (motion ? motion->Forward(point) : point);
      }
    });
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Axes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto triangle = static_cast<std::uint32_t>(i);
        this->Axes[i] =
          static_cast<std::int8_t>(skd::SeenTriangle::FindAxis(this->Get(triangle).Corners));
      }
    });
}

vtkIdType SkdPlacedTriangles::CountWithoutArea() const
{
  return std::count(this->Axes.begin(), this->Axes.end(), -1);
}

//------------------------------------------------------------------------------
vtkIdType SkdPlacement::CountWithoutArea() const
{
  return this->First.CountWithoutArea() + (this->Other ? this->Other->CountWithoutArea() : 0);
}

//------------------------------------------------------------------------------
SkdPlacement SkdPlace(const SkdTriangleSet& first, const SkdTriangleSet* other,
  const std::optional<skd::RigidMotion>& motion)
{
  const double shift = motion ? Norm(motion->Shift) : 0.0;
  const double scale =
    FindScale(std::max({ first.GetReach(), other ? other->GetReach() : 0.0, shift }));
  std::optional<SkdPlacedTriangles> placed;
  if (other)
  {
    placed.emplace(*other, motion, scale);
  }
  return { SkdPlacedTriangles(first, std::nullopt, scale), std::move(placed), motion, scale };
}
