// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFieldIntegral.h
 * @brief Means over cells of a field that is known everywhere.
 */

#ifndef SkdFieldIntegral_h
#define SkdFieldIntegral_h

#include "Core/Meshing/Adaptation/SurfaceShape.h"
#include "Meshing/Adaptation/SkdFieldSamples.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkSmartPointer.h"

class vtkPoints;

namespace skdtree
{
/// A field between the points where it is given: that of points is interpolated in the cells of
/// its mesh, that of cells is the same all over each. What is off the mesh takes what is nearest.
/// Means over a cell are by the midpoint rule on each of the triangles around the middle of its
/// corners, or on four parts of each where the field jumps (from cell to cell) or has many samples:
/// exact, to rounding, for fields that are linear there. The order of the cells does not matter.
class SkdFieldIntegral
{
public:
  /// Whether a source has what it takes: it is one mesh, of triangles, quads, pixels and polygons.
  static bool CanRead(vtkDataObject* source);

  /// `values` are those of its samples. With `isInDegrees` the source has longitudes and latitudes
  /// on the shape, a sphere. All must live on.
  SkdFieldIntegral(vtkDataObject* source, const SkdFieldSamples& values,
    const skd::SurfaceShape& shape, bool isInDegrees);

  /// One a cell, NaN of those that are all where the field has no value. O(log n) a point of the
  /// rule, in parallel; the same whatever the number of threads.
  std::vector<double> GetMeans(const skd::SurfaceMesh& mesh);

private:
  /// Where the rule looks, and what each point counts.
  struct Rule
  {
    vtkSmartPointer<vtkPoints> Positions;
    std::vector<double> Weights;
    std::vector<std::uint32_t> Cells;
  };

  void Add(const std::array<skd::Vector3, 3>& corners, std::uint32_t cell, Rule& rule) const;
  skd::Vector3 InSource(const skd::Vector3& x) const;
  std::vector<double> FindValues(vtkPoints* positions) const;

  const SkdFieldSamples& Samples;
  const skd::SurfaceShape& Shape;
  bool IsInDegrees;
  bool IsInParts = false; // each triangle
  double Bounds[6];
  std::vector<vtkIdType> OldCells; // by their ids in the locator, if those are others
  vtkSmartPointer<vtkSkdTreeCellLocator> Locator;
};
}

#endif
