// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRigidPair.h
 * @brief Two closed surfaces, of which the second is moved, step by step: what no motion changes.
 */

#ifndef SkdRigidPair_h
#define SkdRigidPair_h

#include "Core/Geometry/Rows.h"
#include "Solids/Boolean/SkdArrangement.h"
#include "Solids/Boolean/SkdBooleanRule.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace skdtree
{
/// What is known of the two surfaces where the second one is at one place.
struct SkdPairState
{
  const SkdTriangleSet& AsRead; ///< the second surface where it was read
  int FirstOfSource;            ///< the first block of the second surface
  const SkdPlacement& Placement;
  const SkdArrangement& Arrangement;
  const std::vector<SkdRegionWindings>& Windings;
  bool IsMirrored; ///< by its motion
};

/// What is summed up of triangles to find the volume within a surface, and its area.
struct SkdAreaSum
{
  skd::Vector3 Normal{}; ///< of twice the area
  double Height = 0.0;   ///< six times the volume between triangles and an origin
  double Size = 0.0;     ///< twice the area

  SkdAreaSum() = default;

  /// Of a triangle; reversed, as a reflection does, if the sign is -1.
  SkdAreaSum(const std::array<skd::Vector3, 3>& x, const skd::Vector3& origin, int sign)
    : Normal(static_cast<double>(sign) * Cross(x[1] - x[0], x[2] - x[0]))
    , Height(Dot(x[0] - origin, this->Normal))
    , Size(Norm(this->Normal))
  {
  }

  /// Reversed, or not at all, if the sign is so.
  void Add(const SkdAreaSum& other, int sign)
  {
    this->Normal = this->Normal + static_cast<double>(sign) * other.Normal;
    this->Height += sign * other.Height;
    this->Size += sign != 0 ? other.Size : 0.0;
  }
};

/// Two surfaces of triangles, the first ones of the set and the others. Both are closed, with two
/// facets of opposite directions at each edge, and do not intersect themselves, whatever the motion
/// of the second; all triangles have an area and are cells of their own. So a motion changes
/// nothing within a surface: which triangles are neighbours, which of them are connected, and how
/// often the surface winds around what is in front of a triangle.
class SkdRigidPair
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;

  /// Triangles that are connected by edges.
  struct Component
  {
    bool IsOfSource = false; ///< of the second surface
    int InFront = 0;         ///< how often its surface winds around what is in front of it
    double Volume = 0.0;     ///< within it, negative if it is inside out
    double Area = 0.0;
    std::uint32_t Largest = None; ///< triangle
  };

  /// Takes the set that the state's placement is of, which `set` is. nullptr if the surfaces are of
  /// another kind; then `set` is as it was. `cache` has the pairs of triangles of each. O(n log n).
  static std::unique_ptr<SkdRigidPair> Make(
    const SkdPairState& state, SkdTriangleSet& set, SkdPairCache& cache, vtkAlgorithm* filter);

  ~SkdRigidPair();

  /// Moves the second surface from where it was read. False if what is known does not hold there:
  /// points are not finite, or one motion is a reflection and the other is not. It may not hold
  /// either if the motion rounds coordinates by more than GetMostRounding(). O(n).
  bool Move(const skd::RigidMotion& motion);
  double GetMostRounding() const { return this->MostRounding; }

  const SkdTriangleSet& GetSet() const { return this->Set; }
  SkdTriangleSet& GetSet() { return this->Set; }

  std::uint32_t GetMiddle() const { return this->Middle; } ///< the second surface's first triangle
  bool IsOfSource(std::uint32_t triangle) const { return triangle >= this->Middle; }

  /// The triangle at the other side of each edge, from a corner to the next.
  const std::array<std::uint32_t, 3>& GetNeighbours(std::uint32_t triangle) const
  {
    return this->Neighbours[triangle];
  }

  ///@{
  /// Of consecutive triangles of one surface as they were read; and what that is where the surface
  /// is, with the set's first point as the origin.
  SkdAreaSum SumAreas(std::uint32_t first, std::uint32_t end) const
  {
    SkdAreaSum sum = this->AreasBefore[end];
    const SkdAreaSum& before = this->AreasBefore[first];
    sum.Normal = sum.Normal - before.Normal;
    sum.Height -= before.Height;
    sum.Size -= before.Size;
    return sum;
  }
  SkdAreaSum Place(const SkdAreaSum& sum, bool isOfSource) const;
  ///@}

  ///@{
  /// Some tens of triangles that are connected: those in each, and the others beside it.
  std::size_t GetNumberOfClusters() const { return this->TrianglesOfCluster.size(); }
  std::uint32_t GetClusterOf(std::uint32_t triangle) const { return this->ClusterOf[triangle]; }
  skd::IndexRows::Row GetTrianglesOfCluster(std::uint32_t cluster) const
  {
    return this->TrianglesOfCluster[cluster];
  }
  skd::IndexRows::Row GetClustersBeside(std::uint32_t cluster) const
  {
    return this->ClustersBeside[cluster];
  }
  /// The ends of consecutive triangles of one cluster, ascending.
  const std::vector<std::uint32_t>& GetEndsOfRuns() const { return this->EndsOfRuns; }
  ///@}

  std::uint32_t GetComponentOf(std::uint32_t triangle) const { return this->ComponentOf[triangle]; }
  const std::vector<Component>& GetComponents() const { return this->Components; }
  skd::IndexRows::Row GetTrianglesOf(std::uint32_t component) const
  {
    return this->TrianglesOf[component];
  }

  /// Where a surface is.
  const skd::Box3& GetBounds(bool isOfSource) const
  {
    return isOfSource ? this->BoundsOfSource : this->OfFirst.Bounds;
  }

  /// Pairs of triangles, one of each surface, whose boxes overlap where they are, and triangles,
  /// ascending, whose boxes are that near to one of the other surface that rounding may bring
  /// points of both together.
  struct Near
  {
    SkdIndexPairs Pairs;
    std::vector<std::uint32_t> Triangles;
  };
  Near FindNear() const;

private:
  struct Trees;

  SkdRigidPair(SkdTriangleSet&& set, SkdTriangleSet::Extents ofFirst);
  static bool MayBe(const SkdPairState& state, SkdTriangleSet& set);
  bool FindNeighbours();
  bool FindComponents(const SkdPairState& state);
  bool TakePoints(const SkdPairState& state);
  void MeasureTriangles();
  void FindClusters();
  void BuildTrees();

  SkdTriangleSet Set;
  std::uint32_t Middle = 0;         // triangle
  std::uint32_t FirstPoint = 0;     // of the second surface
  SkdTriangleSet::PointList AsRead; // those of the second surface
  SkdTriangleSet::Extents OfFirst;
  skd::Box3 BoundsOfSource;
  double MostRounding = 0.0;
  bool IsMirrored = false;
  skd::RigidMotion Motion;
  std::vector<std::array<std::uint32_t, 3>> Neighbours;
  std::vector<SkdAreaSum> AreasBefore; // each triangle, and the end, as they were read
  std::array<skd::Vector3, 2> Origins{};
  std::vector<std::uint32_t> ComponentOf;
  std::vector<Component> Components;
  skd::IndexRows TrianglesOf; // components
  std::vector<std::uint32_t> ClusterOf;
  skd::IndexRows TrianglesOfCluster;
  skd::IndexRows ClustersBeside;
  std::vector<std::uint32_t> EndsOfRuns; // of clusters
  std::unique_ptr<Trees> Both;
};
}

#endif
