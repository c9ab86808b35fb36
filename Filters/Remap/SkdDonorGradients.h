// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdDonorGradients.h
 * @brief A gradient in each cell of a donor, for remapping of second order.
 */

#ifndef SkdDonorGradients_h
#define SkdDonorGradients_h

#include "Core/Geometry/Rows.h"
#include "Remap/SkdDonorFields.h"
#include "Remap/SkdOverlapWeights.h"

#include <array>

namespace skdtree
{
/// What the averages of a cell and of those around it are between.
struct SkdCellRange
{
  double Least;
  double Greatest;
};
using SkdCellRanges = std::vector<SkdCellRange>; // of each cell

/// Gradients of cell averages: those of the linear fields that fit the averages of a cell and of
/// all cells that share a corner with it best, by least squares weighted with the inverse squares
/// of the distances. Exact for fields that are linear in x, y and z, at a border, too. On a sphere
/// that holds as well: the part of the gradient across it stands for how the field bends along it,
/// alike in all directions, for centroids lie the deeper the farther they are. Where a field jumps
/// that part is out of proportion: tangential gradients are without it. Of curved surfaces all are
/// tangential, and a neighbour counts in its direction as seen along the cell's normal, at its
/// distance: around a sharp edge, too. Points of equal coordinates count as one. Constant once
/// made.
class SkdDonorGradients
{
public:
  /// `cells` are the donor's, as SkdOverlapWeights measured them, which must live; `normal` is that
  /// of a plane, or zero. O(cells).
  SkdDonorGradients(
    vtkDataSet* donor, const SkdOverlapCells& cells, const skd::Vector3& normal, bool isOnSphere);

  bool AreOnSphere() const { return this->IsOnSphere; }

  /// One a cell, of one component; zero of cells that do not count or have no measure. In parallel.
  std::vector<skd::Vector3> Find(const SkdDonorField& field, int component) const;

  /// The same along the sphere, of cells that are wanted; zero of others.
  std::vector<skd::Vector3> FindTangential(
    const SkdDonorField& field, int component, const std::vector<char>& wanted) const;

  /// In parallel.
  SkdCellRanges FindRanges(const SkdDonorField& field, int component) const;

  /// Shortens gradients by T. J. Barth, D. C. Jespersen, AIAA paper 89-0366 (1989): at no corner
  /// does a cell's linear field leave its range. In parallel.
  void Limit(const SkdDonorField& field, int component, const SkdCellRanges& ranges,
    std::vector<skd::Vector3>& gradients) const;

private:
  using Matrix = std::array<double, 6>; // symmetric: xx, xy, xz, yy, yz, zz

  void ReadCorners(vtkDataSet* donor);
  void FindNeighbours(vtkIdType numberOfPoints);
  void InvertAll();
  skd::Vector3 StepTo(vtkIdType cell, const skd::Vector3& x) const;
  template <class Wanted>
  Matrix Invert(vtkIdType cell, const Wanted& isWanted) const;
  skd::Vector3 Fit(vtkIdType cell, const SkdDonorField& field, int component) const;
  std::array<skd::Vector3, 2> AxesOf(std::size_t cell) const;
  std::array<double, 2> FlatStep(
    std::size_t cell, std::size_t other, const std::array<skd::Vector3, 2>& axes) const;
  skd::Vector3 FitTangential(vtkIdType cell, const SkdDonorField& field, int component) const;
  template <class Fitting>
  std::vector<skd::Vector3> FitAll(const SkdDonorField& field, const Fitting& fit) const;
  double ShareWithin(
    vtkIdType cell, double here, const SkdCellRange& range, const skd::Vector3& gradient) const;
  bool Has(vtkIdType cell) const { return this->Measures[static_cast<std::size_t>(cell)] > 0.0; }

  const std::vector<double>& Measures;
  const std::vector<skd::Vector3>& Centroids;
  const std::vector<skd::Vector3>& Normals; // of a curved surface, else none
  skd::Vector3 Normal;
  bool IsOnSphere;
  skd::Rows<vtkIdType> Corners; // of each cell, of welded points
  std::vector<skd::Vector3> Points;
  skd::Rows<vtkIdType> Neighbours; // of each cell, ascending, without itself
  std::vector<Matrix> Inverses;    // of the least squares of all neighbours
};
}

#endif
