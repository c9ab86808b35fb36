// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SkdPlacement.h"

#include "Cells/SkdForEach.h"
#include "Core/Predicates/ExactScale.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
// A motion rounds each corner, by less than `rounding`. That takes the area of no triangle which is
// much wider.
SkdPlacedTriangles::SkdPlacedTriangles(
  const SkdTriangleSet& set, const std::optional<skd::RigidMotion>& motion, double scale)
  : Set(&set)
  , IsElsewhere(motion || scale != 1.0)
  , Points(this->IsElsewhere ? set.GetPoints().size() : 0)
{
  const double reach = set.GetLargestCoordinate() + (motion ? Norm(motion->Shift) : 0.0);
  const double rounding = 32.0 * std::numeric_limits<double>::epsilon() * reach;
  this->HaveAllArea = scale == 1.0 && set.GetLeastWidth() > 64.0 * rounding;
  SkdForEach(static_cast<vtkIdType>(this->Points.size()),
    [&](vtkIdType i)
    {
      const skd::Vector3& point = set.GetPoints()[i];
      this->Points[i] = scale * (motion ? motion->Forward(point) : point);
    });
}

//------------------------------------------------------------------------------
vtkIdType SkdPlacedTriangles::CountWithoutArea() const
{
  if (this->HaveAllArea)
  {
    return 0;
  }
  std::atomic<vtkIdType> count{ 0 };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Set->GetTriangles().size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType some = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        some += !this->HasArea(static_cast<std::uint32_t>(i));
      }
      count += some;
    });
  return count;
}

//------------------------------------------------------------------------------
vtkIdType SkdPlacement::CountWithoutArea() const
{
  return this->First.CountWithoutArea() + (this->Other ? this->Other->CountWithoutArea() : 0);
}

//------------------------------------------------------------------------------
SkdPlacement SkdMakePlacement(const SkdTriangleSet& first, const SkdTriangleSet* other,
  const std::optional<skd::RigidMotion>& motion)
{
  const double shift = motion ? Norm(motion->Shift) : 0.0;
  const double scale = skd::ExactScale(
    std::max({ first.GetLargestCoordinate(), other ? other->GetLargestCoordinate() : 0.0, shift }));
  std::optional<SkdPlacedTriangles> placed;
  if (other)
  {
    placed.emplace(*other, motion, scale);
  }
  return { SkdPlacedTriangles(first, std::nullopt, scale), std::move(placed), motion, scale };
}
