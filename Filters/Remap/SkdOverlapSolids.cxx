// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapReader.h"

#include "Core/Geometry/Cells/LinearShapes.h"
#include "Core/Geometry/Overlap/SolidOverlap.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
using skd::Vector3;
using Faces = std::vector<std::vector<int>>;

double SixfoldVolume(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return Dot(b - a, Cross(c - a, d - a));
}

template <class Corners>
double SixfoldVolume(const Corners& corners, const Faces& faces)
{
  double sum = 0.0;
  for (const std::vector<int>& face : faces)
  {
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      sum +=
        SixfoldVolume(corners[0].X, corners[face[0]].X, corners[face[i - 1]].X, corners[face[i]].X);
    }
  }
  return sum;
}

template <class Corners>
double ExtentOf(const Corners& corners)
{
  double extent = 0.0;
  for (const auto& corner : corners)
  {
    extent = std::max(extent, Norm(corner.X - corners[0].X));
  }
  return extent;
}

constexpr double Flatness = 16.0; // of what a cut takes for contact

/// Whether the corners of a face are in its plane. Four whose diagonals are parallel are.
template <class Corners>
bool IsFlat(const Corners& corners, const std::vector<int>& face)
{
  std::vector<Vector3> relative;
  for (const int corner : face)
  {
    relative.push_back(corners[corner].X - corners[0].X);
  }
  const skd::HalfSpace inside = skd::InsideOf([&](int i) -> const Vector3& { return relative[i]; },
    static_cast<int>(relative.size()), ExtentOf(corners));
  const auto isInPlane = [&](const Vector3& x)
  { return std::abs(Dot(inside.Normal, x) + inside.Offset) <= Flatness * inside.Tolerance; };
  return (inside.Tolerance > 0.0 || relative.size() == 4) &&
    std::all_of(relative.begin(), relative.end(), isInPlane);
}

/// Whether all corners are on the inner side of the planes of all faces, and those of a face on it.
template <class Corners>
bool IsConvexAndFlat(const Corners& corners, const Faces& faces)
{
  const double extent = ExtentOf(corners);
  std::vector<Vector3> relative;
  for (const auto& corner : corners)
  {
    relative.push_back(corner.X - corners[0].X);
  }
  for (const std::vector<int>& face : faces)
  {
    const skd::HalfSpace inside =
      skd::InsideOf([&](int i) -> const Vector3& { return relative[face[i]]; },
        static_cast<int>(face.size()), extent);
    const double tolerance = Flatness * inside.Tolerance;
    for (std::size_t i = 0; i < relative.size(); ++i)
    {
      const double side = Dot(inside.Normal, relative[i]) + inside.Offset;
      const bool isOfFace = std::find(face.begin(), face.end(), static_cast<int>(i)) != face.end();
      if (!(side >= -tolerance) || (isOfFace && !(side <= tolerance)) || !(inside.Tolerance > 0.0))
      {
        return false;
      }
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
// All in the order that SolidTopology has them, with a positive volume.
void SkdOverlapReader::AddFixed(SkdShape shape)
{
  Corners& corners = this->CellPoints;
  if (shape == SkdShape::Tetrahedron)
  {
    const double volume = SixfoldVolume(corners[0].X, corners[1].X, corners[2].X, corners[3].X);
    if (volume < 0.0)
    {
      std::swap(corners[2], corners[3]);
    }
    this->AddTetrahedron({ corners[0], corners[1], corners[2], corners[3] }, 1);
    return;
  }
  if (shape == SkdShape::Pyramid)
  {
    this->AddHull({ { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } });
    return;
  }
  if (shape == SkdShape::Voxel)
  {
    std::swap(corners[2], corners[3]);
    std::swap(corners[6], corners[7]);
  }
  const skd::SolidTopology& topology =
    shape == SkdShape::Wedge ? skd::SolidTopology::Wedge() : skd::SolidTopology::Hexahedron();
  if (SixfoldVolume(corners, topology.Faces) < 0.0)
  {
    std::swap_ranges(
      corners.begin(), corners.begin() + topology.Size / 2, corners.begin() + topology.Size / 2);
  }
  this->AddSolid(topology, false);
}

//------------------------------------------------------------------------------
void SkdOverlapReader::AddSolid(const skd::SolidTopology& topology, bool isOwn)
{
  const bool fits = topology.Size <= skd::SolidTopology::MostCorners &&
    topology.Faces.size() <= skd::SolidTopology::MostFaces && topology.IsSimple();
  if (this->Reading.IntoSimplices || !fits || !IsConvexAndFlat(this->CellPoints, topology.Faces))
  {
    this->AddTetrahedra(topology.Faces);
    return;
  }
  const skd::SolidTopology* stored = &topology;
  if (isOwn)
  {
    this->Block.Topologies.push_back(topology);
    stored = &this->Block.Topologies.back();
  }
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (const Corner& corner : this->CellPoints)
  {
    sum = sum + (corner.X - this->CellPoints[0].X);
  }
  const Vector3 reference = this->CellPoints[0].X + (1.0 / topology.Size) * sum;
  std::array<Vector3, skd::SolidTopology::MostCorners> relative;
  double radius2 = 0.0;
  for (int i = 0; i < topology.Size; ++i)
  {
    relative[i] = this->CellPoints[i].X - reference;
    radius2 = std::max(radius2, Norm2(relative[i]));
  }
  const skd::Moments own = skd::ConvexSolid(topology, relative.data()).Moments();
  if (own.Measure > 0.0)
  {
    SkdOverlapPiece& piece = this->Add(this->CellPoints.data(), this->CellPoints.size());
    piece.Topology = stored;
    piece.Reference = reference;
    piece.Radius = std::sqrt(radius2);
    piece.Own = own;
  }
}

//------------------------------------------------------------------------------
void SkdOverlapReader::AddPolyhedron(const SkdPolyCell& cell)
{
  Faces faces;
  cell.AsPolyhedron().ForEachFace([&faces](const skd::PolyhedronFace& face)
    { faces.emplace_back(face.Ids, face.Ids + face.Size); });
  this->AddHull(std::move(faces));
}

//------------------------------------------------------------------------------
// Faces are oriented alike, outward or inward.
void SkdOverlapReader::AddHull(Faces faces)
{
  if (faces.empty())
  {
    return;
  }
  if (SixfoldVolume(this->CellPoints, faces) < 0.0)
  {
    for (std::vector<int>& face : faces)
    {
      std::reverse(face.begin(), face.end());
    }
  }
  this->AddSolid(
    skd::SolidTopology(static_cast<int>(this->CellPoints.size()), std::move(faces)), true);
}

//------------------------------------------------------------------------------
// About the mean of the corners, and of each face of more than three about its own: both cells of a
// face cut it alike. In simplices of the mesh's points about the corner with the least coordinates,
// and faces that are flat as well: whatever order the points have in this mesh or in a piece of it.
void SkdOverlapReader::AddTetrahedra(const Faces& faces)
{
  const bool isOfPoints = this->Reading.IntoSimplices;
  const auto meanOf = [&](const auto& numbers)
  {
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    const Vector3& first = this->CellPoints[numbers[0]].X;
    Corners corners;
    for (const int number : numbers)
    {
      sum = sum + (this->CellPoints[number].X - first);
      corners.push_back(this->CellPoints[number]);
    }
    return Corner{ first + (1.0 / static_cast<double>(numbers.size())) * sum,
      isOfPoints ? this->AddMeanOf(corners) : -1 };
  };
  std::vector<int> all;
  for (int i = 0; i < static_cast<int>(this->CellPoints.size()); ++i)
  {
    all.push_back(i);
  }
  const auto findLeast = [this](const std::vector<int>& numbers)
  {
    return std::min_element(numbers.begin(), numbers.end(),
      [this](int a, int b) { return this->CellPoints[a].X < this->CellPoints[b].X; });
  };
  const Corner apex = isOfPoints ? this->CellPoints[*findLeast(all)] : meanOf(all);
  for (const std::vector<int>& face : faces)
  {
    const bool isFan = face.size() == 3 || (isOfPoints && IsFlat(this->CellPoints, face));
    const auto first = static_cast<std::size_t>(isFan ? findLeast(face) - face.begin() : 0);
    const auto cornerAt = [&](std::size_t i) -> const Corner&
    { return this->CellPoints[face[(first + i) % face.size()]]; };
    const Corner middle = isFan ? cornerAt(0) : meanOf(face);
    for (std::size_t i = isFan ? 1 : 0; i + (isFan ? 1 : 0) < face.size(); ++i)
    {
      this->AddSigned(apex, middle, cornerAt(i), cornerAt(i + 1));
    }
  }
}

//------------------------------------------------------------------------------
bool SkdOverlapReader::AreFlat(const Faces& faces) const
{
  return std::all_of(faces.begin(), faces.end(),
    [this](const std::vector<int>& face) { return IsFlat(this->CellPoints, face); });
}

//------------------------------------------------------------------------------
// What is inverted counts negative.
void SkdOverlapReader::AddSigned(
  const Corner& apex, const Corner& a, const Corner& b, const Corner& c)
{
  const double volume = SixfoldVolume(apex.X, a.X, b.X, c.X);
  if (volume > 0.0)
  {
    this->AddTetrahedron({ apex, a, b, c }, 1);
  }
  else if (volume < 0.0)
  {
    this->AddTetrahedron({ apex, a, c, b }, -1);
  }
}

//------------------------------------------------------------------------------
void SkdOverlapReader::AddTetrahedron(const Corner (&corners)[4], std::int8_t sign)
{
  const Vector3& a = corners[0].X;
  const Vector3 offset = 0.25 * ((corners[1].X - a) + (corners[2].X - a) + (corners[3].X - a));
  std::array<Vector3, 4> relative;
  double radius2 = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    relative[i] = corners[i].X - (a + offset);
    radius2 = std::max(radius2, Norm2(relative[i]));
  }
  const skd::Moments own =
    skd::ConvexSolid(skd::SolidTopology::Tetrahedron(), relative.data()).Moments();
  if (own.Measure > 0.0)
  {
    SkdOverlapPiece& piece = this->Add(corners, 4);
    piece.Topology = &skd::SolidTopology::Tetrahedron();
    piece.Sign = sign;
    piece.Reference = a + offset;
    piece.Radius = std::sqrt(radius2);
    piece.Own = own;
  }
}
}
