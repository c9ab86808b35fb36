// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFlushFaces.h
 * @brief Faces of several bodies that lie in one plane but for the rounding of points to floats.
 */

#ifndef SkdFlushFaces_h
#define SkdFlushFaces_h

#include "Core/Geometry/EdgeTable.h"
#include "Core/Geometry/Rows.h"
#include "Solids/Surfaces/SkdTriangleSet.h"

#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace skdtree
{
/// The plane of a face: of triangles in one plane, to within rounding, that edges connect. It is
/// that of three of its points which are far apart, so it does not depend on the order of anything.
struct SkdFacePlane
{
  std::array<skd::Vector3, 3> Corners{};
  skd::Vector3 Normal{};  // of length 1
  double Area = 0.0;      // of the three, twice
  double Tolerance = 0.0; // of points of floats
  skd::Vector3 Largest{}; // coordinates
  bool IsSingle = true;   // triangle
  bool IsExact = true;    // of points that are no floats
  bool IsFlat = false;    // else points are farther away from it than that, or it is not to move

  /// How far a point is in front of it.
  double HeightOf(const skd::Vector3& x) const { return Dot(this->Normal, x - this->Corners[0]); }

  /// Whether others are put in its plane, rather than it in theirs.
  bool ComesBefore(const SkdFacePlane& other) const
  {
    return this->IsExact != other.IsExact ? this->IsExact
      : this->Area != other.Area          ? this->Area > other.Area
                                          : this->Corners < other.Corners;
  }
};

class SkdGroups;

/// The triangles of a set with points of equal coordinates as one; their bodies, which are blocks
/// or parts of these that edges connect; and their faces. About 200 bytes a triangle. To be used
/// as long as the set.
class SkdFlushFaces
{
public:
  using Corners = SkdTriangleSet::Corners;
  using Triangle = std::array<skd::Vector3, 3>;

  static constexpr int BitsOfFloat = std::numeric_limits<float>::digits;
  static constexpr int BitsOfDouble = std::numeric_limits<double>::digits;
  /// How far rounding to a float takes a coordinate, relative to it.
  static constexpr double Rounding = 0.5 * std::numeric_limits<float>::epsilon();

  /// How far errors of coordinates take a point along a normal.
  static double Along(const skd::Vector3& normal, const skd::Vector3& errors);

  /// `bits` are those of the coordinates of each block. Finds triangles of two bodies that lie in
  /// one plane, on each other or side by side, to within 16 roundings of each coordinate along its
  /// axis; but none of plates that are as thin as that. O(n) where bodies are apart,
  /// else O(n log n). Of a piece of surfaces only `among` are looked at, ascending, as edges do not
  /// tell bodies there: triangles of two blocks, or of one if they overlap and have no common
  /// point.
  SkdFlushFaces(const std::vector<int>& bits, const SkdTriangleSet& set,
    const std::vector<std::uint32_t>* among = nullptr);

  /// Whether some of these are not in one plane to the rounding of doubles, and may cross.
  bool AreSomeOff() const;

  /// Finds the faces, and gives those that are flush, and others that touch them in their plane,
  /// the plane of one of them.
  void FindPlanes();

  const std::vector<skd::Vector3>& GetPoints() const { return this->Points; }
  const std::vector<Corners>& GetTriangles() const { return this->Triangles; }
  /// The point that one of the set is.
  std::uint32_t GetPointOf(std::size_t given) const { return this->PointOf[given]; }
  bool IsExact(std::uint32_t triangle) const
  {
    return this->Bits[static_cast<std::size_t>(this->BlockOf(triangle))] != BitsOfFloat;
  }

  ///@{
  /// Once planes are found: of each triangle the face, whether that is flush with another one, and
  /// the face whose plane it is to be in.
  const SkdFacePlane& GetFaceOf(std::uint32_t triangle) const
  {
    return this->Faces[this->FaceOf[triangle]];
  }
  bool IsFlush(std::uint32_t triangle) const { return this->AreFlush[this->FaceOf[triangle]]; }
  std::uint32_t GetPlaneOf(std::uint32_t triangle) const
  {
    return this->PlaneOf[this->FaceOf[triangle]];
  }
  const SkdFacePlane& GetPlane(std::uint32_t face) const { return this->Planes[face]; }
  ///@}

private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  /// Twice the area, along the normal.
  static skd::Vector3 AreaOf(const Triangle& x) { return Cross(x[1] - x[0], x[2] - x[0]); }
  /// Of each coordinate the largest magnitude.
  static skd::Vector3 LargestOf(const Triangle& positions);
  int BlockOf(std::uint32_t triangle) const
  {
    return this->Set.GetCells()[this->Set.GetCellOf(triangle)].Block;
  }
  Triangle PositionsOf(std::uint32_t triangle) const
  {
    const Corners& corners = this->Triangles[triangle];
    return { this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]] };
  }
  bool IsInPlaneOf(std::uint32_t triangle, std::uint32_t wider, double width) const;
  bool AreInOnePlane(std::uint32_t a, std::uint32_t b) const;
  bool AreAllIn(const std::vector<std::uint32_t>& triangles, const SkdFacePlane& plane) const;
  std::size_t CountCommonPoints(std::uint32_t a, std::uint32_t b) const;
  skd::Box3 BoxOf(std::uint32_t triangle) const;
  template <class Visit>
  void ForEachNeighbours(const Visit& visit) const;
  void Weld();
  void FindErrors();
  void FindBodies();
  std::vector<std::uint32_t> ListNear() const;
  bool MayCross(std::uint32_t a, std::uint32_t b) const;
  bool AreOverlapping(std::uint32_t a, std::uint32_t b, double tolerances) const;
  bool AreOfTwoBodies(std::uint32_t a, std::uint32_t b) const;
  bool AreSidesOfAPlate(std::uint32_t a, std::uint32_t b) const;
  void FindPairs();
  void FindFaces();
  void GrowFace(std::uint32_t seed, const std::vector<std::array<std::uint32_t, 3>>& neighbours);
  void Fit(std::uint32_t face);
  SkdFacePlane FitPlane(const std::vector<std::uint32_t>& triangles) const;
  skd::IndexRows ListFacesAtPoints() const;
  void AddTouching(std::set<Pair>& pairs);
  void Join(std::uint32_t first, std::uint32_t second, SkdGroups& groups);
  void UniteFaces();
  std::vector<std::uint32_t> ListTriangles(const std::vector<std::uint32_t>& faces) const;

  const std::vector<int> Bits;
  const SkdTriangleSet& Set;
  const std::vector<std::uint32_t>* const Among;
  std::vector<std::uint32_t> PointOf;
  std::vector<skd::Vector3> Points;
  std::vector<Corners> Triangles;
  skd::EdgeTable<> Edges;
  std::vector<skd::Vector3> Errors;  // of each triangle's coordinates
  std::vector<bool> IsOfPlate;       // the same: to be left as it is
  std::vector<std::uint32_t> BodyOf; // each triangle
  std::uint32_t NumberOfBodies = 0;
  std::vector<Pair> Pairs;           // of triangles in one plane
  std::vector<std::uint32_t> FaceOf; // each triangle
  skd::IndexRows TrianglesOf;        // each face
  std::vector<SkdFacePlane> Faces;
  std::vector<SkdFacePlane> Planes;   // the same, or those of several that are put in one
  std::vector<bool> AreFitted;        // faces
  std::vector<bool> AreFlush;         // of each face
  std::vector<std::uint32_t> PlaneOf; // the same
};
}

#endif
