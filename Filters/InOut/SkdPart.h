// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPart.h
 * @brief A body that is given by its boundary, and whether it holds a point (section 6.3).
 */

#ifndef SkdPart_h
#define SkdPart_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdBoundary.h"
#include "Pipeline/SkdFeatureNormals.h"
#include "Pipeline/SkdSolid.h"
#include "Pipeline/SkdWinding.h"
#include "vtkSkdTreeCellLocator.h"

#include <memory>
#include <vector>

/// How it is decided whether a point is inside.
enum class SkdInsideMethod
{
  AxisRays,
  RandomRays,
  WindingNumber,
  NearestFeature,
  Automatic // SkdSolid where the boundary is closed, else the winding number, orientation repaired
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
  bool RepairsOrientation = false; // turn triangles whose normals point inward
  double ChordalLength = 0.0;      // see SkdChordalLength

  bool operator==(const SkdPartSettings& other) const
  {
    return this->Epsilon == other.Epsilon && this->ChordalLength == other.ChordalLength &&
      this->Method == other.Method && this->RepairsOrientation == other.RepairsOrientation;
  }
};

class SkdPart
{
public:
  /// The body that the blocks enclose together; `id` is what it is called. Triangles, their trees,
  /// and what the method needs besides.
  SkdPart(int id, const std::vector<SkdBlock>& blocks, const SkdPartSettings& settings);

  int GetId() const { return this->Id; }
  vtkIdType GetNumberOfFaces() const { return this->Boundary.Faces->GetNumberOfCells(); }
  vtkIdType GetNumberOfOpenEdges() const { return this->Boundary.OpenEdges; }
  double GetDiagonal() const { return this->Diagonal; }
  double GetAbsoluteEpsilon() const { return this->Faces->GetAbsoluteEpsilon(); }

  bool BoundsHold(const double x[3]) const;

  /// Whether the part holds x. Outside of its bounds nothing is inside; of an open boundary the
  /// confidence there is that of the answer that it would have, 1/2 if that is another. A closed
  /// boundary is decided exactly: see SkdSolid, or with a method by rays by parity alone; of an
  /// open one rays vote, and stop when the vote is decided. Orientation matters to the winding
  /// number (of either sign: at least one half) and to the nearest feature (whose normal must point
  /// outward). `point` tells points apart for random directions. Thread-safe.
  SkdSide AskSide(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const;

  /// Where a line passes through the boundary, to the other side, as distances from a point of it
  /// along a direction of length 1, ascending: all of them up to a given one, and maybe some
  /// beyond. Of a closed boundary; by the method, rays or automatic. Thread-safe.
  void FindPasses(const double from[3], const double along[3], double distance,
    SkdInsideMethod method, std::vector<SkdPassAlong>& passes) const;

  /// Whether the boundary comes within a distance of x. Thread-safe.
  bool IsNear(const double x[3], double distance) const;

private:
  /// What it is to this part.
  SkdInsideMethod Resolved(SkdInsideMethod method) const
  {
    return method == SkdInsideMethod::Automatic && !this->Solid ? SkdInsideMethod::WindingNumber
                                                                : method;
  }
  std::vector<bool> FindTurned(vtkPolyData* surface) const;
  SkdSide AskWithin(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const;
  SkdSide AskSolid(const double x[3]) const
  {
    return this->Solid->Ask(x, SkdWaysOutAlongAxes(this->Bounds, x)[0]);
  }
  void FindTurns(
    const double p1[3], const double p2[3], double length, std::vector<SkdPassAlong>& passes) const;
  bool IsOdd(const double x[3], const SkdWayOut& way) const;
  SkdSide VoteAlongAxes(const double x[3]) const;
  SkdSide VoteAtRandom(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const;
  SkdSide AskWinding(const double x[3], double tolerance) const;
  SkdSide AskNearest(const double x[3]) const;

  int Id;
  SkdBoundary Boundary;
  vtkSmartPointer<vtkSkdTreeCellLocator> Faces;
  vtkSmartPointer<vtkSkdTreeCellLocator> Surface; // often the same as Faces
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Diagonal = 0.0;
  std::unique_ptr<SkdSolid> Solid;            // of Surface, or nullptr of an open boundary
  std::unique_ptr<SkdWinding> Winding;        // of Surface, or nullptr
  std::unique_ptr<SkdFeatureNormals> Normals; // of Faces, or nullptr
};

#endif
