// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdPlacement.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/Predicates/ExactScale.h"
#include "vtkObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace skdtree
{
//------------------------------------------------------------------------------
// A motion rounds each corner, by less than `rounding`. That takes the area of no triangle which is
// much wider.
SkdMovedTriangles::SkdMovedTriangles(const SkdTriangleSet& set,
  const std::optional<skd::RigidMotion>& motion, double scale, double least)
  : Set(&set)
  , IsElsewhere(motion || scale != 1.0 || set.GetLeastCoordinate() < least)
  , Points(this->IsElsewhere ? set.GetPoints().size() : 0)
{
  const double extent = set.GetLargestCoordinate() + (motion ? Norm(motion->Shift) : 0.0);
  const double rounding = 32.0 * std::numeric_limits<double>::epsilon() * extent;
  this->HaveAllArea =
    scale == 1.0 && !(set.GetLeastCoordinate() < least) && set.GetLeastWidth() > 64.0 * rounding;
  SkdForEach(static_cast<vtkIdType>(this->Points.size()),
    [&](vtkIdType i)
    {
      const skd::Vector3& point = set.GetPoints()[i];
      skd::Vector3 moved = scale * (motion ? motion->Forward(point) : point);
      skd::TakeTinyAsZero(moved, scale * least);
      this->Points[i] = moved;
    });
}

//------------------------------------------------------------------------------
vtkIdType SkdMovedTriangles::CountWithoutArea() const
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
  const double extent =
    std::max({ first.GetLargestCoordinate(), other ? other->GetLargestCoordinate() : 0.0, shift });
  const double scale = skd::ExactScale(extent);
  const double least = skd::LeastExactCoordinate * extent;
  const auto hasTiny = [least](const SkdTriangleSet& set)
  { return set.GetNumberOfTinyPoints() > 0 || set.GetLeastCoordinate() < least; };
  std::optional<SkdMovedTriangles> moved;
  if (other)
  {
    moved.emplace(*other, motion, scale, least);
  }
  return { SkdMovedTriangles(first, std::nullopt, scale, least), std::move(moved), motion, scale,
    hasTiny(first) || (other && hasTiny(*other)) };
}

//------------------------------------------------------------------------------
void SkdWarnAboutTinyPoints(vtkObject* self, const SkdPlacement& placement)
{
  if (placement.HasTinyPoints)
  {
    vtkWarningWithObjectMacro(self,
      "Coordinates smaller than "
        << skd::LeastExactCoordinate
        << " times the largest one are taken as 0, for exact signs have no room for both. What "
           "becomes flat by that is left out. Remove the points that are so far away, or scale "
           "the data sets to a common size.");
  }
}
}
