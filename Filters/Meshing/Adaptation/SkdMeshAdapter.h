// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMeshAdapter.h
 * @brief Data sets moved until their cells follow a monitor, and what was done.
 */

#ifndef SkdMeshAdapter_h
#define SkdMeshAdapter_h

#include "Core/Meshing/Adaptation/Adapt.h"
#include "Meshing/Adaptation/SkdMovedMesh.h"
#include "vtkSkdTreeCellLocator.h"

#include <functional>
#include <string>

class vtkTable;

namespace skdtree
{
/// What points stay on.
enum class SkdSurfaceChoice
{
  Automatic, ///< a plane or sphere if all points are on one, else the mesh as it was
  Plane,
  Sphere,
  AsItWas
};

/// A mesh and where it comes to.
class SkdMeshAdapter
{
public:
  /// Reads the surface cells. False, and why, if there are none, or they are not on what was
  /// chosen.
  bool Begin(const std::vector<SkdBlock>& inputs, SkdSurfaceChoice choice, std::string& problem);

  const SkdMovedMesh& GetMesh() const { return this->Moved; }
  const skd::SurfaceShape& GetShape() const { return this->Shape; }
  bool IsOnSphere() const { return this->Shape.What == skd::SurfaceShape::Kind::Sphere; }

  /// Tells the field's means in the cells of a mesh whose points are less the sphere's centre, if
  /// they are on one. False to stop.
  using FindField = std::function<bool(vtkPolyData* mesh, std::vector<double>& field)>;

  /// Called in each iteration with its number; false to stop.
  using Look = std::function<bool(int iteration)>;

  /// Tells the field's means in the cells by integration.
  using Integrate = std::function<std::vector<double>(const skd::SurfaceMesh& mesh)>;

  /// Moves the mesh. With `keepsAll` each iteration can be had afterwards. What the measure of the
  /// best one is for a monitor that is the field itself is found if there is `integrate`.
  void Run(const skd::AdaptRules& rules, bool keepsAll, const FindField& find, const Look& look,
    const Integrate& integrate);

  /// See Run; negative if it was not found.
  double GetMeasureOfField() const { return this->MeasureOfField; }

  const skd::AdaptOutcome& GetOutcome() const { return this->Outcome; }

  ///@{
  /// The state to show: the best one, or an iteration of those kept, at most the last.
  void ShowBest() { this->Show(this->Best); }
  void ShowIteration(std::size_t iteration)
  {
    this->Show(this->Previous[std::min(iteration, this->Previous.size() - 1)]);
  }
  bool HasIterations() const { return !this->Previous.empty(); }
  ///@}

  /// Points, displacements and cell arrays of the state shown for the blocks' copies. Copies that
  /// are no vtkPointSet stay.
  void FillBlocks(const std::vector<SkdBlock>& outputs) const;

  /// A row an iteration.
  void FillTable(vtkTable* table) const;

private:
  struct State
  {
    std::vector<skd::Vector3> Points;
    std::vector<double> Field;
    std::vector<double> Monitor;
    std::vector<double> Areas;
  };

  void Show(const State& state);
  void LayReference();
  std::vector<double> RatiosOf(const std::vector<double>& areas) const;

  SkdMovedMesh Moved{ {} };
  skd::SurfaceShape Shape;
  vtkSmartPointer<vtkSkdTreeCellLocator> Reference;
  std::vector<double> FirstAreas;
  skd::AdaptOutcome Outcome;
  double MeasureOfField = -1.0;
  State Best;
  State Shown;
  std::vector<State> Previous;
};
}

#endif
