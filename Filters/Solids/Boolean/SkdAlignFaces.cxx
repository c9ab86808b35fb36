// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdAlignFaces.h"

#include "Core/Geometry/Rows.h"
#include "Solids/Boolean/SkdBooleanNames.h"
#include "Solids/Boolean/SkdFlushFaces.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace skdtree
{
namespace
{
/// Moves a point into planes, one after the other, without leaving those before.
class PointInPlanes
{
public:
  /// `most` is how far it may move.
  PointInPlanes(const skd::Vector3& x, double most)
    : Start(x)
    , Most(most)
    , X(x)
  {
  }

  const skd::Vector3& GetPosition() const { return this->X; }

  /// Does nothing if the plane is nearly that of others, or too far away along them.
  void Add(const SkdFacePlane& plane)
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
    if (this->Count == 3 || sine < least)
    {
      return;
    }
    this->Planes[this->Count] = &plane;
    this->Across[this->Count] = (1.0 / sine) * across;
    ++this->Count;
    // Where three planes meet is one position for all points.
    const skd::Vector3 moved = this->Projected(this->Count == 3 ? plane.Corners[0] : this->X);
    if (Norm(moved - this->Start) <= this->Most)
    {
      this->X = moved;
    }
    else
    {
      --this->Count;
    }
  }

private:
  skd::Vector3 Projected(skd::Vector3 x) const
  {
    for (int pass = 0; pass < 3; ++pass) // others for what the first one has rounded
    {
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        const SkdFacePlane& plane = *this->Planes[i];
        x = x - (plane.HeightOf(x) / Dot(plane.Normal, this->Across[i])) * this->Across[i];
      }
    }
    return x;
  }

  const skd::Vector3 Start;
  const double Most;
  skd::Vector3 X;
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
    std::vector<double> tolerances(this->Points.size(), 0.0);
    const skd::IndexRows planesOf = this->ListPlanes(tolerances);
    for (std::uint32_t point = 0; point < this->Points.size(); ++point)
    {
      std::vector<std::uint32_t> planes(planesOf[point].begin(), planesOf[point].end());
      std::sort(planes.begin(), planes.end(),
        [this](std::uint32_t a, std::uint32_t b) { return this->ComesBefore(a, b); });
      planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
      if (const auto moved = this->FindPosition(this->Points[point], tolerances[point], planes))
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

  /// Of each point that may move the planes that it is to be in, and its tolerance.
  skd::IndexRows ListPlanes(std::vector<double>& tolerances) const
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
          const bool hasPlane = face.IsFlat && (!face.IsSingle || this->Faces.IsFlush(triangle));
          for (std::size_t i = 0; i < 3 && hasPlane; ++i)
          {
            const std::uint32_t corner = triangles[triangle][i];
            if (isFlush[corner] && !stays[corner])
            {
              tolerances[corner] = std::max(tolerances[corner], face.Tolerance);
              add(corner, this->Faces.GetPlaneOf(triangle));
            }
          }
        }
      });
  }

  /// Nothing if it is there. The tolerance is that of the faces that the point is of, not of those
  /// whose planes they get.
  std::optional<skd::Vector3> FindPosition(
    const skd::Vector3& x, double tolerance, const std::vector<std::uint32_t>& planes) const
  {
    constexpr double tolerances = 8.0;
    const auto isThere = [&](std::uint32_t plane)
    {
      constexpr double ofDoubles = 4.0 * std::numeric_limits<double>::epsilon();
      const SkdFacePlane& its = this->Faces.GetPlane(plane);
      return std::abs(its.HeightOf(x)) <= ofDoubles * SkdFlushFaces::Along(its.Normal, its.Largest);
    };
    if (std::all_of(planes.begin(), planes.end(), isThere))
    {
      return std::nullopt;
    }
    PointInPlanes point(x, tolerances * tolerance);
    for (const std::uint32_t plane : planes)
    {
      point.Add(this->Faces.GetPlane(plane));
    }
    return point.GetPosition();
  }

  const SkdFlushFaces& Faces;
  std::vector<skd::Vector3> Points;
  std::vector<bool> HasMoved;
};

int BitsOf(vtkDataSet* mesh)
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

/// None if there is nothing to align.
std::optional<SkdFlushFaces> FindFlushFaces(
  const std::vector<int>& bits, const SkdTriangleSet& set, const std::vector<std::uint32_t>* among)
{
  if (std::count(bits.begin(), bits.end(), SkdFlushFaces::BitsOfFloat) == 0 ||
    set.GetTriangles().empty())
  {
    return std::nullopt;
  }
  std::optional<SkdFlushFaces> faces(std::in_place, bits, set, among);
  return faces->AreSomeOff() ? std::move(faces) : std::nullopt;
}
}

//------------------------------------------------------------------------------
std::vector<int> SkdCoordinateBits(const std::vector<SkdBlock>& blocks)
{
  std::vector<int> bits;
  for (const SkdBlock& block : blocks)
  {
    bits.push_back(BitsOf(block.Mesh));
  }
  return bits;
}

//------------------------------------------------------------------------------
bool SkdHasFacesToAlign(
  const std::vector<int>& bits, const SkdTriangleSet& set, const std::vector<std::uint32_t>& among)
{
  return FindFlushFaces(bits, set, &among).has_value();
}

vtkIdType SkdAlignFaces(const std::vector<int>& bits, SkdTriangleSet& set)
{
  std::optional<SkdFlushFaces> faces = FindFlushFaces(bits, set, nullptr);
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
