// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTargetCells.h
 * @brief The cells of a target mesh: which points each holds.
 */

#ifndef SkdTargetCells_h
#define SkdTargetCells_h

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Overlap/LonLatCell.h"
#include "Remap/SkdSphereCell.h"

#include <memory>
#include <optional>

namespace skdtree
{
/// A mesh and the query which points its cells contain. Constant once made; the mesh must live.
///
/// In space a cell holds what is at a distance of at most 8 units in the last place of the largest
/// coordinate, as everywhere, or of at most the given tolerance: so surfaces and curves hold what
/// is near them. On a sphere about the origin triangles, quads, pixels and polygons are bounded by
/// great-circle arcs, and hold points by their directions, exactly; or, by choice, those whose
/// corners allow it by meridians and parallels, to rounding. Other cells hold nothing. Rims are in:
/// a point on an edge that two cells have in common is in both. Ghost cells (duplicate or
/// hidden), broken ones and empty ones hold nothing.
class SkdTargetCells
{
public:
  SkdTargetCells(vtkDataSet* mesh, bool isOnSphere, double tolerance = 0.0, bool isLonLat = false);

  vtkIdType GetNumberOfCells() const { return this->Mesh->GetNumberOfCells(); }
  bool IsOnSphere() const { return this->OnSphere; }

  /// Cells that hold nothing because of their type: on a sphere those with curved edges, strips and
  /// what is no surface. O(n).
  vtkIdType CountUnfit() const;

  /// One cell after the other. One object a thread.
  class Cell
  {
  public:
    explicit Cell(const SkdTargetCells& cells);

    /// False of a cell that holds nothing.
    bool Load(vtkIdType id);

    /// Holds all that the cell does; on a sphere on the unit sphere.
    const skd::Box3& GetBox() const { return this->Box; }
    bool Contains(const skd::Vector3& x) const;

    /// The mean of its points; on a sphere of their directions.
    skd::Vector3 GetCentre() const { return this->Centre; }

  private:
    bool LoadOnSphere(vtkIdType id);
    bool LoadInSpace(vtkIdType id);
    void FindLonLat();
    void ReadCorners(vtkIdType id);

    const SkdTargetCells& Cells;
    vtkIdType Id = -1;
    SkdSphereCell Sphere;
    std::optional<skd::LonLatCell> LonLat;
    std::vector<skd::Vector3> Corners;
    skd::Vector3 Centre{ { 0.0, 0.0, 0.0 } };
    skd::Box3 Box;
    vtkSmartPointer<vtkGenericCell> Scratch;
    vtkSmartPointer<vtkIdList> List;
  };

private:
  /// Whether a cell is no ghost.
  bool IsOurs(vtkIdType id) const;

  vtkDataSet* Mesh;
  bool OnSphere;
  bool LonLat;
  double Tolerance;
  SkdCellReader Reader;
  vtkUnsignedCharArray* Ghosts;
  std::unique_ptr<SkdCellTree> InSpace;
};
}

#endif
