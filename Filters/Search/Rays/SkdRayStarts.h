// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRayStarts_h
#define SkdRayStarts_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdQueryPoints.h"
#include "Pipeline/SkdSourceTrees.h"

#include <string>
#include <vector>

namespace skdtree
{
/// Where rays go.
struct SkdRayAim
{
  enum class Along
  {
    Normals,
    Array,
    Direction,
    ToPoint,
    ToPositions,
    ToNearest
  };

  Along Mode = Along::Normals;
  std::string Array;                      // of Array, empty: the active vectors; of ToPositions
  skd::Vector3 Vector{};                  // the direction, or the point
  const SkdSourceTrees* Source = nullptr; // of ToNearest
  bool IsReversed = false;
  std::vector<skd::Vector3> OfPiece{}; // normals at points of a piece of a mesh; empty of others
};

/// The rays of one data set: where they start, and their directions.
class SkdRayStarts
{
public:
  SkdRayStarts(vtkDataSet* mesh, SkdQueryPoints::At at, const SkdRayAim& aim);

  std::vector<skd::Vector3> Points;
  std::vector<skd::Vector3> Directions; // of length 1, or 0: no ray

  /// Why there are no rays at all; empty if there may be some.
  std::string Fault;

  vtkIdType GetNumber() const { return static_cast<vtkIdType>(this->Points.size()); }

  /// The points within a mesh of volume cells, which have no normal.
  vtkIdType Inner = 0;

  /// The number of starts that are hidden, which have no ray either.
  vtkIdType CountHidden() const;

  /// The number of others that are not finite or have no direction, without inner points.
  vtkIdType CountWithoutRay() const;

private:
  void ReadPoints(vtkDataSet* mesh, SkdQueryPoints::At at);
  void UseNormals(vtkDataSet* mesh, SkdQueryPoints::At at, const SkdRayAim& aim);
  void UseArray(vtkDataSet* mesh, SkdQueryPoints::At at, const SkdRayAim& aim);
  void FaceNearest(const SkdSourceTrees& source);
  bool Read(vtkDataArray* vectors, const std::string& what);
  void Face(const std::vector<skd::Vector3>& targets);

  std::vector<unsigned char> Shown; // each start
};

/// The rays of all blocks: normals at points are those of the meshes that they are pieces of.
std::vector<SkdRayStarts> SkdMakeRayStarts(
  const std::vector<SkdBlock>& blocks, SkdQueryPoints::At at, SkdRayAim aim);
}

#endif
