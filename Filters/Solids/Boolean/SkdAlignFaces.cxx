// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdAlignFaces.h"

#include "Core/Geometry/Rows.h"
#include "Solids/Boolean/SkdBooleanNames.h"
#include "Solids/Boolean/SkdFlushFaces.h"
#include "Solids/Surfaces/SkdSplitPoints.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace skdtree
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/// Moves a point into planes, one after the other, without leaving those before.
class PointInPlanes
{
public:
  explicit PointInPlanes(const skd::Vector3& x)
    : Start(x)
    , X(x)
  {
  }

  bool IsFull() const { return this->Count == 3; }
  const skd::Vector3& GetPosition() const { return this->X; }

  /// False, and nothing is moved, if the plane is nearly that of others, or farther away along them
  /// than `most` from where the point was at first.
  bool Add(const SkdFacePlane& plane, double most)
  {
    constexpr double least = 1e-3; // sine of an angle
    skd::Vector3 across = plane.Normal;
    for (int pass = 0; pass < 2; ++pass) // the second for what the first one has rounded
    {
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        across = across - Dot(across, this->Across[i]) * this->Across[i];
      }
    }
    const double sine = Norm(across);
    if (this->IsFull() || sine < least)
    {
      return false;
    }
    this->Planes[this->Count] = &plane;
    this->Across[this->Count] = (1.0 / sine) * across;
    ++this->Count;
    const skd::Vector3 before = this->X;
    this->Project();
    this->Project();
    if (Norm(this->X - this->Start) <= most)
    {
      return true;
    }
    --this->Count;
    this->X = before;
    return false;
  }

private:
  void Project()
  {
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const SkdFacePlane& plane = *this->Planes[i];
      const double along = Dot(plane.Normal, this->Across[i]);
      this->X = this->X - (plane.HeightOf(this->X) / along) * this->Across[i];
    }
  }

  skd::Vector3 Start, X;
  std::array<const SkdFacePlane*, 3> Planes{};
  std::array<skd::Vector3, 3> Across{}; // orthonormal: each is along the planes before it
  std::size_t Count = 0;
};

class PointMover
{
public:
  explicit PointMover(const SkdFlushFaces& faces)
    : Faces(faces)
    , Points(faces.GetPoints())
    , HasMoved(faces.GetPoints().size(), false)
  {
  }

  void Run()
  {
    const skd::IndexRows planesOf = this->ListPlanes();
    for (std::uint32_t point = 0; point < this->Points.size(); ++point)
    {
      std::vector<std::uint32_t> planes(planesOf[point].begin(), planesOf[point].end());
      std::sort(planes.begin(), planes.end(),
        [this](std::uint32_t a, std::uint32_t b) { return this->ComesBefore(a, b); });
      planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
      if (const auto moved = this->FindPosition(this->Points[point], planes))
      {
        this->HasMoved[point] = true;
        this->Points[point] = *moved;
      }
    }
  }

  /// Puts the points of the set that have moved where they are then. Returns how many.
  vtkIdType Put(SkdTriangleSet& set) const
  {
    SkdTriangleSet::PointList points = set.GetPoints();
    vtkIdType count = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const std::uint32_t point = this->Faces.GetPointOf(i);
      if (this->HasMoved[point])
      {
        points[i] = this->Points[point];
        ++count;
      }
    }
    if (count > 0)
    {
      set.PutPoints(std::move(points));
    }
    return count;
  }

private:
  bool ComesBefore(std::uint32_t a, std::uint32_t b) const
  {
    const SkdFacePlane& first = this->Faces.GetPlane(a);
    const SkdFacePlane& second = this->Faces.GetPlane(b);
    return first.ComesBefore(second) || (!second.ComesBefore(first) && a < b);
  }

  /// Of each point that may move the planes that it is to be in.
  skd::IndexRows ListPlanes() const
  {
    const std::vector<SkdFlushFaces::Corners>& triangles = this->Faces.GetTriangles();
    const auto n = static_cast<std::uint32_t>(triangles.size());
    std::vector<bool> isFlush(this->Points.size(), false);
    std::vector<bool> stays(this->Points.size(), false);
    for (std::uint32_t triangle = 0; triangle < n; ++triangle)
    {
      for (const std::uint32_t corner : triangles[triangle])
      {
        isFlush[corner] = isFlush[corner] || this->Faces.IsFlush(triangle);
        stays[corner] = stays[corner] || this->Faces.IsExact(triangle);
      }
    }
    return skd::IndexRows(this->Points.size(),
      [&](const auto& add)
      {
        for (std::uint32_t triangle = 0; triangle < n; ++triangle)
        {
          const SkdFacePlane& face = this->Faces.GetFaceOf(triangle);
          const bool hasPlane = face.IsFlat && (face.Size > 1 || this->Faces.IsFlush(triangle));
          for (std::size_t i = 0; i < 3 && hasPlane; ++i)
          {
            const std::uint32_t corner = triangles[triangle][i];
            if (isFlush[corner] && !stays[corner])
            {
              add(corner, this->Faces.GetPlaneOf(triangle));
            }
          }
        }
      });
  }

  /// Nothing if it is there. Points of the same three planes get the same position.
  std::optional<skd::Vector3> FindPosition(
    const skd::Vector3& x, const std::vector<std::uint32_t>& planes)
  {
    constexpr double roundings = 128.0;
    double largest = 0.0;
    for (const std::uint32_t plane : planes)
    {
      largest = std::max(largest, this->Faces.GetPlane(plane).Largest);
    }
    const double exact = 0.25 * SkdSplitPoints::ErrorOf(largest);
    const auto isThere = [&](std::uint32_t plane)
    { return std::abs(this->Faces.GetPlane(plane).HeightOf(x)) <= exact; };
    if (std::all_of(planes.begin(), planes.end(), isThere))
    {
      return std::nullopt;
    }
    PointInPlanes point(x);
    SkdFlushFaces::Corners taken{ None, None, None };
    std::size_t count = 0;
    for (const std::uint32_t plane : planes)
    {
      if (point.Add(this->Faces.GetPlane(plane), roundings * SkdFlushFaces::Rounding * largest))
      {
        taken[count++] = plane;
      }
    }
    return point.IsFull() ? this->OfThree.emplace(taken, point.GetPosition()).first->second
                          : point.GetPosition();
  }

  const SkdFlushFaces& Faces;
  std::vector<skd::Vector3> Points;
  std::vector<bool> HasMoved;
  std::map<SkdFlushFaces::Corners, skd::Vector3> OfThree; // points by their planes
};

std::vector<int> BitsOf(const std::vector<SkdBlock>& blocks)
{
  std::vector<int> bits;
  for (const SkdBlock& block : blocks)
  {
    bits.push_back(SkdCoordinateBits(block.Mesh));
  }
  return bits;
}

/// None if there is nothing to align.
std::optional<SkdFlushFaces> FindFlushFaces(
  const std::vector<SkdBlock>& blocks, const SkdTriangleSet& set)
{
  const std::vector<int> bits = BitsOf(blocks);
  if (std::count(bits.begin(), bits.end(), SkdFlushFaces::BitsOfFloat) == 0 ||
    set.GetTriangles().empty())
  {
    return std::nullopt;
  }
  std::optional<SkdFlushFaces> faces(std::in_place, bits, set);
  return faces->AreSomeOff() ? std::move(faces) : std::nullopt;
}
}

//------------------------------------------------------------------------------
int SkdCoordinateBits(vtkDataSet* mesh)
{
  auto* const points = vtkPointSet::SafeDownCast(mesh);
  if (!points || !points->GetPoints())
  {
    return SkdFlushFaces::BitsOfDouble;
  }
  const std::string name = std::string("SkdReport") + SkdBooleanNames::CoordinateBits;
  auto* const told = mesh->GetFieldData()->GetArray(name.c_str());
  const bool areFloats = points->GetPoints()->GetDataType() == VTK_FLOAT ||
    (told && told->GetNumberOfValues() == 1 && told->GetTuple1(0) == SkdFlushFaces::BitsOfFloat);
  return areFloats ? SkdFlushFaces::BitsOfFloat : SkdFlushFaces::BitsOfDouble;
}

int SkdLeastCoordinateBits(const std::vector<SkdBlock>& blocks)
{
  const std::vector<int> bits = BitsOf(blocks);
  return bits.empty() ? SkdFlushFaces::BitsOfDouble : *std::min_element(bits.begin(), bits.end());
}

//------------------------------------------------------------------------------
bool SkdHasFacesToAlign(const std::vector<SkdBlock>& blocks, const SkdTriangleSet& set)
{
  return FindFlushFaces(blocks, set).has_value();
}

vtkIdType SkdAlignFaces(const std::vector<SkdBlock>& blocks, SkdTriangleSet& set)
{
  std::optional<SkdFlushFaces> faces = FindFlushFaces(blocks, set);
  if (!faces)
  {
    return 0;
  }
  faces->FindPlanes();
  PointMover mover(*faces);
  mover.Run();
  return mover.Put(set);
}
}
