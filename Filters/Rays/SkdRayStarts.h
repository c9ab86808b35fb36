// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRayStarts_h
#define SkdRayStarts_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdQueryPoints.h"

#include <string>
#include <vector>

/// Where rays go.
struct SkdRayAim
{
  enum class Along
  {
    Normals,
    Array,
    Direction,
    ToPoint
  };

  Along Mode = Along::Normals;
  std::string Array;     // of Array; empty: the active vectors
  skd::Vector3 Vector{}; // the direction, or the point
  bool IsReversed = false;
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

  /// The number of starts that are not finite or have no direction.
  vtkIdType CountWithoutRay() const;

private:
  void ReadPoints(vtkDataSet* mesh, SkdQueryPoints::At at);
  void UseNormals(vtkDataSet* mesh, SkdQueryPoints::At at);
  void UseArray(vtkDataSet* mesh, SkdQueryPoints::At at, const std::string& name);
  void Read(vtkDataArray* vectors);
};

#endif
