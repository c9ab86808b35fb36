// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdComparedSet.h
 * @brief One of two surfaces, or sets of points, that are compared: its triangles and their tree.
 */

#ifndef SkdComparedSet_h
#define SkdComparedSet_h

#include "Bodies/SkdSignedSource.h"
#include "Bodies/SkdTriangulation.h"
#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdSourceTrees.h"
#include "Search/Compare/SkdReduction.h"

#include <optional>
#include <vector>

namespace skdtree
{
class SkdSpreadSides;

class SkdComparedSet
{
public:
  /// Where an element comes from: an index in the list of blocks, and a cell of the whole (see
  /// SkdJoinedIds) or, in a set of points, a point.
  using Origin = SkdBoundary::Origin;

  /// Reads all surface cells and outer faces of volume cells, as triangles; without any, the
  /// points, each an element whose three corners are the same. Builds the tree unless it is still
  /// valid, and with `wantsSide` what decides which points are inside. Points that are not finite
  /// (see Cells/Read/SkdMagnitudes.h) are left out, and faces that have one. Each of several
  /// processes has some elements of its own, which it is to look at: those of its own cells
  /// (SkdOwnCellsOf) or, where all have the whole, as many as the others. Each element is so on one
  /// process, and elements are in the same order on all.
  void Update(const std::vector<SkdBlock>& blocks, bool wantsSide, double epsilon,
    double chordalDeviation, const SkdReduction& all);

  /// Whether the elements are triangles.
  bool IsSurface() const { return this->Surface; }

  bool IsEmpty() const { return this->Elements.empty() || this->GetCounts().Cells == 0; }
  const std::vector<skd::Vector3>& GetPoints() const { return this->Points; }
  const std::vector<SkdTriangleIds>& GetElements() const { return this->Elements; }
  const Origin& GetOrigin(vtkIdType element) const { return this->Origins[element]; }
  const skd::Vector3& GetCorner(vtkIdType element, int corner) const
  {
    return this->Points[this->Elements[element][corner]];
  }

  ///@{
  /// The own elements, ascending.
  vtkIdType GetNumberOfOwn() const { return this->NumberOfOwn; }
  vtkIdType GetOwn(vtkIdType i) const
  {
    return this->OwnElements.empty() ? this->FirstOwn + i : this->OwnElements[i];
  }
  ///@}

  /// For each point, 1 if an own element has it.
  std::vector<unsigned char> FindOwnPoints() const;

  /// The nearest point and its element (CellId), ties to the lowest. Thread-safe.
  std::optional<SkdNearest> FindNearest(const skd::Vector3& x, double maximumDistance) const
  {
    return this->Trees.FindNearest(x.X, maximumDistance);
  }

  /// The squared distance to one element.
  double GetDistance2(vtkIdType element, const skd::Vector3& x) const;

  ///@{
  /// Of what was wanted at the last Update(); without sides, nothing is inside. Thread-safe.
  bool HasSides() const { return this->Sided || this->SpreadSides; }
  bool KnowsSides() const { return this->Sided; } // this process
  bool IsInside(const skd::Vector3& x) const { return this->Sided && this->Side.IsInside(x.X); }
  vtkIdType GetNumberOfOpenEdges() const
  {
    return this->Sided ? this->Side.GetNumberOfOpenEdges() : 0;
  }
  ///@}

  ///@{
  /// What processes tell together of a set whose pieces they have, until the next Update();
  /// nullptr: nothing.
  void SetSpreadSides(SkdSpreadSides* sides) { this->SpreadSides = sides; }
  SkdSpreadSides* GetSpreadSides() const { return this->SpreadSides; }
  ///@}

  ///@{
  /// Of the last Update().
  int GetTreesBuilt() const { return this->TreesBuilt; }
  double GetChordalLength() const { return this->ChordalLength; }
  vtkIdType GetNumberOfCoarseFaces() const { return this->CoarseFaces; }
  SkdTreeCounts GetCounts() const { return this->Trees.GetCounts(); }
  ///@}

  /// The bounds of all points; empty ones are (max, lowest).
  void GetBounds(skd::Vector3& low, skd::Vector3& high) const;

  /// Releases all but the trees.
  void Release();

private:
  /// Reused from face to face, so that none allocates.
  struct FaceBuffers
  {
    SkdTriangulation Triangulation;
    std::vector<vtkIdType> Ids;
  };

  void AddFaces(int block, vtkDataSet* mesh, const SkdBlockSurface& surface);
  template <class Corner>
  void AddFace(FaceBuffers& buffers, const Origin& origin, vtkIdType first, vtkIdType size,
    const Corner* corners);
  void AddPoints(int block, vtkDataSet* mesh);
  void FindOwn(const std::vector<SkdBlock>& blocks, const SkdReduction& all);
  vtkSmartPointer<vtkPolyData> MakeMesh() const;

  std::vector<skd::Vector3> Points;
  std::vector<SkdTriangleIds> Elements;
  std::vector<Origin> Origins;
  std::vector<vtkIdType> OwnElements; // unless they follow each other
  vtkIdType FirstOwn = 0;
  vtkIdType NumberOfOwn = 0;
  bool Surface = false;
  SkdSourceTrees Trees;
  SkdSignedSource Side;
  bool Sided = false;
  SkdSpreadSides* SpreadSides = nullptr;
  int TreesBuilt = 0;
  double ChordalLength = 0.0;
  vtkIdType CoarseFaces = 0;
};
}

#endif
