// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSurfaceReader_h
#define SkdSurfaceReader_h

#include "Bodies/SkdTriangulation.h"
#include "Cells/Read/SkdFaceList.h"
#include "Core/Curves/BezierPatch.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkType.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkCell;
class vtkDataSet;

namespace skdtree
{
/// A triangle or a patch, and its cell.
struct SkdSurfaceElement
{
  std::size_t FirstPoint; ///< of three corners, or of an origin and the control points after it
  vtkIdType CellId;
  int Block; ///< index in the list of blocks
  std::uint8_t DegreeR;
  std::uint8_t DegreeS;
  bool IsPatch;
  bool IsTriangle;
  bool IsWhole; ///< its parameters are those of the cell
  int Part = 0; ///< what it is of the boundary of
};

/// Divides surfaces: planar quads, polygons and strips into triangles; warped quads and curved
/// cells are patches. Ghosts are ignored.
/// It does not use SkdBlockSurface, the class for readers of flat faces, because curved faces and
/// warped quads are facets there.
class SkdSurfaceReader
{
public:
  /// With volumes: also the outer faces of volume cells.
  explicit SkdSurfaceReader(bool withVolumes)
    : WithVolumes(withVolumes)
  {
  }

  /// Finds the outer faces of data sets that are pieces of one mesh, without those between pieces.
  /// To be called before these are read.
  void FindOuterFaces(const std::vector<SkdBlock>& blocks);

  void Read(vtkDataSet* mesh, int block);

  /// Messages about cells that could not be read.
  std::vector<std::string> GetFaults() const;

  std::vector<SkdSurfaceElement> Elements;
  std::vector<skd::Vector3> Corners;
  std::vector<skd::Homogeneous> Controls;

private:
  void ReadFaces(vtkDataSet* mesh);
  void AddCell(vtkCell* cell);
  template <class CornerOf>
  void AddPolygon(vtkIdType size, const CornerOf& cornerOf);
  void AddQuad(const skd::Vector3 (&corners)[4]);
  void AddStrip(vtkCell* cell);
  void AddNative(vtkCell* cell);
  void AddTriangle(const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c);
  void AddPatch(const skd::BezierPatch& patch, const skd::Vector3& origin);

  std::map<int, std::vector<SkdCellFace>> OuterFaces; // of blocks that are pieces
  SkdTriangulation Triangulation;
  bool WithVolumes;
  int Block = 0;
  vtkIdType CellId = 0;
  bool IsWhole = false;
  vtkIdType NotSurfaces = 0;
  vtkIdType NotFinite = 0;
  vtkIdType BadWeights = 0;
  vtkIdType TooHigh = 0;
};
}

#endif
