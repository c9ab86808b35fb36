// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPart.h
 * @brief A body given by its boundary, with the point in/out test (section 6.3).
 */

#ifndef SkdPart_h
#define SkdPart_h

#include "Bodies/SkdBody.h"
#include "Bodies/SkdWinding.h"
#include "Core/Geometry/Vector.h"
#include "Search/InOut/SkdFeatureNormals.h"

#include <memory>
#include <vector>

namespace skdtree
{
/// The method of the inside test.
enum class SkdInsideMethod
{
  AxisRays,
  RandomRays,
  WindingNumber,
  NearestFeature,
  Automatic // SkdSolid where the boundary is closed, else SkdOpenSolid
};

struct SkdInsideRules
{
  SkdInsideMethod Method = SkdInsideMethod::Automatic;
  int NumberOfRays = 10; // random ones
  std::uint64_t Seed = 0;
  double WindingTolerance = 0.25; // see SkdWinding::Ask
};

/// How parts are made.
struct SkdPartSettings
{
  double Epsilon = 1e-9; // see vtkSkdTreeCellLocator::SetEpsilon
  SkdInsideMethod Method = SkdInsideMethod::Automatic;
  bool RepairsOrientation = false; // reverse triangles whose normals point inward
  double ChordalLength = 0.0;      // see SkdChordalLength

  bool operator==(const SkdPartSettings& other) const
  {
    return this->Epsilon == other.Epsilon && this->ChordalLength == other.ChordalLength &&
      this->Method == other.Method && this->RepairsOrientation == other.RepairsOrientation;
  }
};

/// A line through all of some bounds that begins at or before a point and goes along a unit
/// direction for a distance from there: both ends are outside, or beyond all that is wanted.
struct SkdLineThrough
{
  double Start; // from the point, negative
  double Length;
  skd::Vector3 From;
  skd::Vector3 To;

  SkdLineThrough(const double bounds[6], double diagonal, const double from[3],
    const double along[3], double distance);
};

class SkdPart
{
public:
  /// The body enclosed by the blocks, with its id: triangles, their trees, and the data of the
  /// method.
  SkdPart(int id, const std::vector<SkdBlock>& blocks, const SkdPartSettings& settings);

  int GetId() const { return this->Id; }
  vtkIdType GetNumberOfFaces() const { return this->GetBoundary().Faces->GetNumberOfCells(); }
  vtkIdType GetNumberOfOpenEdges() const { return this->GetBoundary().OpenEdges; }
  vtkIdType GetNumberOfCoarseFaces() const { return this->GetBoundary().CoarseFaces; }
  double GetDiagonal() const { return this->Diagonal; }
  double GetAbsoluteEpsilon() const { return this->Body.GetFaces()->GetAbsoluteEpsilon(); }

  bool BoundsHold(const double x[3]) const;

  /// Whether the part contains x. Points outside its bounds are outside; for an open boundary the
  /// confidence there is that of the method's result, or 1/2 if the method contradicts. The test is
  /// exact for a closed boundary: see SkdSolid, or by parity alone for methods with rays; for an
  /// open one see SkdOpenSolid, or rays vote until the vote is decided. Orientation matters for the
  /// winding number (at least one half in absolute value) and for the nearest feature (whose normal
  /// must point outward). `point` is the seed of random directions. Thread-safe.
  SkdSide AskSide(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const;

  /// The crossings of a line through the boundary, as ascending distances from a point along a unit
  /// direction: all of them up to a given distance, and possibly some beyond. For a closed boundary
  /// with rays or the automatic method. Thread-safe.
  void FindPasses(const double from[3], const double along[3], double distance,
    SkdInsideMethod method, std::vector<SkdPassAlong>& passes) const;

  /// Whether the boundary is within a distance of x. Thread-safe.
  bool IsNear(const double x[3], double distance) const
  {
    return this->Body.FindNearest(x, distance).has_value();
  }

private:
  const SkdBoundary& GetBoundary() const { return this->Body.GetBoundary(); }
  std::vector<bool> FindReversed(vtkPolyData* surface) const;
  SkdSide AskWithin(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const;
  SkdSide AskSolid(const double x[3]) const
  {
    return this->Body.GetSolid()->Ask(x, SkdRayEndsAlongAxes(this->Bounds, x)[0]);
  }
  void FindTransitions(
    const double p1[3], const double p2[3], double length, std::vector<SkdPassAlong>& passes) const;
  bool IsOdd(const double x[3], const SkdRayEnd& ray) const;
  SkdSide VoteAlongAxes(const double x[3]) const;
  SkdSide VoteAtRandom(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const;
  SkdSide AskWinding(const double x[3], double tolerance) const;
  SkdSide AskNearest(const double x[3]) const;

  int Id;
  SkdBody Body;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Diagonal = 0.0;
  std::unique_ptr<SkdWinding> Winding;        // of the boundary's surface, or nullptr
  std::unique_ptr<SkdFeatureNormals> Normals; // of its faces, or nullptr
};
}

#endif
