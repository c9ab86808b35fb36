// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFaceSets_h
#define SkdFaceSets_h

#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/MarkedNumbers.h"
#include "Solids/Surfaces/SkdPlacement.h"

#include <string>

class vtkAbstractArray;

namespace skdtree
{
/// The flat faces that the triangles of a set are of. A face lies in the plane of its largest
/// triangle, to within rounding. To be used as long as the placement.
class SkdFaceSets
{
public:
  SkdFaceSets()
    : Sets(0)
    , United(0)
  {
  }

  /// Of one face are the triangles of one cell in one plane, and those of cells of one block in one
  /// plane that have the same number in a cell array of integers (`name`). `others` are names of
  /// arrays whose values Unite() does not compare. O(n), and O(n log n) of what has such numbers.
  SkdFaceSets(const SkdPlacement& placement, const std::vector<SkdBlock>& blocks, const char* name,
    const std::vector<std::string>& others);

  /// Begins anew, as with the constructor. O(1) for each triangle that was of a face of several, if
  /// these are of the same set as before, and each is a face when this begins.
  void Update(const SkdPlacement& placement, const std::vector<SkdBlock>& blocks, const char* name,
    const std::vector<std::string>& others);

  std::size_t GetNumberOfTriangles() const { return this->Largest.size(); }

  /// The face of a triangle, by its lowest triangle.
  std::uint32_t Find(std::uint32_t triangle) { return this->Sets.Find(triangle); }

  /// Whether it is a face with no other one.
  bool IsAlone(std::uint32_t triangle) const { return !this->United.IsMarked(triangle); }

  /// Triangles that are not alone, and maybe others.
  const skd::MarkedNumbers& GetUnited() const { return this->United; }

  /// Makes each triangle a face by itself.
  void Separate();

  /// Makes the faces of two triangles with a common edge one, if these are of one block, have the
  /// same cell data but for global ids, and lie in one plane, as their faces do. Returns whether
  /// they are one face.
  bool Unite(std::uint32_t a, std::uint32_t b);

  /// Whether the faces of two triangles lie in one plane, whichever way they face.
  bool AreInOnePlane(std::uint32_t a, std::uint32_t b) const;

private:
  struct Key;

  void TakeData(const std::vector<SkdBlock>& blocks, const std::vector<std::string>& others);
  std::vector<Key> ListKeys(const std::vector<SkdBlock>& blocks, const char* name) const;
  void UniteAll(const Key* first, const Key* last);
  void Unite(std::uint32_t a, std::uint32_t b, std::uint32_t largest);
  bool HaveSameData(std::uint32_t a, std::uint32_t b) const;
  bool IsInPlane(std::uint32_t triangle, std::uint32_t plane) const;
  bool FacesAs(std::uint32_t triangle, std::uint32_t plane) const;
  skd::Vector3 At(std::uint32_t triangle, std::size_t corner) const;
  skd::Vector3 NormalOf(std::uint32_t triangle) const;

  const SkdMovedTriangles* Moved = nullptr;
  const SkdTriangleSet* Set = nullptr;
  skd::DisjointSets<> Sets;
  std::vector<std::uint32_t> Largest; // triangle of each face, by its lowest
  skd::MarkedNumbers United;          // triangles that are of faces of several, and maybe others
  std::vector<std::vector<vtkSmartPointer<vtkAbstractArray>>> Data; // of each block
};
}

#endif
