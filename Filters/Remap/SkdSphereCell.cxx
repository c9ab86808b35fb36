// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdSphereCell.h"

#include "Core/Geometry/Polygons/EarClipping.h"
#include "Core/Geometry/Predicates/Orient3D.h"

namespace skdtree
{
namespace
{
/// The side of the plane through the origin, a and b that x is on: 1 to the left of the way from a
/// to b, seen from outside.
int SideOf(const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& x)
{
  return skd::Orient3D(skd::Vector3{ { 0.0, 0.0, 0.0 } }, a, b, x);
}

skd::Vector3 Unit(const skd::Vector3& x)
{
  return (1.0 / skd::Norm(x)) * x;
}
}

bool SkdSphereCell::Set(const std::vector<skd::Vector3>& corners)
{
  this->Corners.clear();
  this->Loops.clear();
  this->Pieces.clear();
  this->Box = skd::Box3();
  for (const skd::Vector3& corner : corners)
  {
    if (this->Corners.empty() || !(corner == this->Corners.back()))
    {
      this->Corners.push_back(corner);
    }
  }
  while (this->Corners.size() > 1 && this->Corners.front() == this->Corners.back())
  {
    this->Corners.pop_back();
  }
  if (this->Corners.size() < 3 || !this->FindCentre())
  {
    return false;
  }
  this->SetBox();
  const int orientation = this->FindOrientation();
  if (orientation == 0)
  {
    this->AddTriangles();
  }
  else
  {
    this->AddLoop(orientation < 0);
  }
  return true;
}

bool SkdSphereCell::FindCentre()
{
  skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (const skd::Vector3& corner : this->Corners)
  {
    sum = sum + Unit(corner);
  }
  this->Centre = Unit(sum);
  return skd::IsFinite(this->Centre); // not of corners that are no directions
}

// A point of the cell is a sum of its corners with weights that are not negative, made one long. If
// all corners are within an angle of the centre, that makes it longer by 1 / cos(angle) at most.
void SkdSphereCell::SetBox()
{
  double cosine = 1.0;
  for (const skd::Vector3& corner : this->Corners)
  {
    this->Box.Add(Unit(corner));
    cosine = std::min(cosine, skd::Dot(Unit(corner), this->Centre));
  }
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double longer = cosine > 0.25 ? 1.0 / cosine - 1.0 + rounding : 2.0;
  this->Box = this->Box.Inflated(longer);
}

/// 1 or -1 of a convex cell whose edges turn left or right, else 0.
int SkdSphereCell::FindOrientation() const
{
  const std::size_t n = this->Corners.size();
  bool turnsLeft = false, turnsRight = false;
  for (std::size_t i = 0; i < n; ++i)
  {
    const int side =
      SideOf(this->Corners[i], this->Corners[(i + 1) % n], this->Corners[(i + 2) % n]);
    turnsLeft = turnsLeft || side > 0;
    turnsRight = turnsRight || side < 0;
  }
  return turnsLeft == turnsRight ? 0 : turnsLeft ? 1 : -1;
}

void SkdSphereCell::AddLoop(bool isReversed)
{
  this->Loops = this->Corners;
  if (isReversed)
  {
    std::reverse(this->Loops.begin(), this->Loops.end());
  }
  this->Pieces.push_back({ 0, this->Loops.size() });
}

// A gnomonic projection makes great circles straight lines. Both triangles beside a diagonal decide
// by its own two corners, so nothing is lost between them.
void SkdSphereCell::AddTriangles()
{
  this->Flat.clear();
  for (const skd::Vector3& corner : this->Corners)
  {
    this->Flat.push_back((1.0 / skd::Dot(corner, this->Centre)) * corner);
  }
  skd::EarClipping<std::vector<skd::Vector3>> ears(this->Flat, static_cast<int>(this->Flat.size()));
  ears.ForEachTriangle(
    [this](int i, int j, int k)
    {
      const skd::Vector3& a = this->Corners[static_cast<std::size_t>(i)];
      const skd::Vector3& b = this->Corners[static_cast<std::size_t>(j)];
      const skd::Vector3& c = this->Corners[static_cast<std::size_t>(k)];
      const int side = SideOf(a, b, c);
      if (side != 0)
      {
        const std::size_t first = this->Loops.size();
        this->Loops.insert(this->Loops.end(), { a, side > 0 ? b : c, side > 0 ? c : b });
        this->Pieces.push_back({ first, first + 3 });
      }
    });
}

bool SkdSphereCell::PieceContains(const Piece& piece, const skd::Vector3& x) const
{
  std::size_t last = piece.Last - 1;
  for (std::size_t i = piece.First; i < piece.Last; last = i++)
  {
    if (SideOf(this->Loops[last], this->Loops[i], x) < 0)
    {
      return false;
    }
  }
  return true;
}

bool SkdSphereCell::Contains(const skd::Vector3& x) const
{
  if (!(skd::Dot(x, this->Centre) > 0.0)) // also of NaN; and points opposite to corners have side 0
  {
    return false;
  }
  return std::any_of(this->Pieces.begin(), this->Pieces.end(),
    [&](const Piece& piece) { return this->PieceContains(piece, x); });
}
}
