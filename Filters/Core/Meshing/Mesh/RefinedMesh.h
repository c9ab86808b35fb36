// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh of cells of several types under refinement: a forest whose roots are the original cells.
/// How cells are cut is up to others (Bisection.h, RegularCuts.h); this keeps what they need to
/// agree on: nodes, edges and the nodes in their middles, faces, and the cells along them.
///
/// A node is where a point is: points of equal coordinates are one node, so that what is cut along
/// a seam is cut on both sides. Numbers have 32 bits. All cells are kept, those that were cut, too;
/// about 300 bytes a triangle, 600 a tetrahedron. Not thread-safe but for what is const.
#ifndef skd_Mesh_RefinedMesh_h
#define skd_Mesh_RefinedMesh_h

#include "MeshBorder.h"
#include "MeshSides.h"

#include <algorithm>
#include <functional>
#include <initializer_list>

namespace skd
{

class RefinedMesh
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;

  struct Cell
  {
    std::uint64_t First; ///< its nodes in the list of all
    std::uint32_t Size;
    std::uint32_t Input; ///< the cell of the mesh as it was
    std::uint32_t FirstChild = None;
    std::uint32_t Children = 0;
    CellKind Kind;
    bool IsFixed;       ///< it cannot be cut
    std::uint8_t Steps; ///< how often it was cut: a dimension's number of steps halves its size

    bool IsLeaf() const { return this->FirstChild == None; }
    int Level() const { return this->Steps / DimensionOf(this->Kind); }
  };

  /// Nodes of a cell or of a node's making.
  struct Nodes
  {
    const std::uint32_t* First;
    std::uint32_t Size;
    const std::uint32_t* begin() const { return this->First; }
    const std::uint32_t* end() const { return this->First + this->Size; }
    std::uint32_t operator[](std::uint32_t i) const { return this->First[i]; }
  };

  /// Where a new node is placed, given the mean of the points where those are that it is made of.
  using Placement = std::function<Vector3(const Vector3& mean, const RefinedMesh&, Nodes makers)>;

  ///@{
  /// To be set once the mesh has its nodes; without one, nodes stay where they are made. With a
  /// border (FindBorder.h), which is then kept while cells are cut, nodes within volumes are left
  /// out: these are in the mean of the others.
  void SetPlacement(Placement placement)
  {
    this->Transform = std::move(placement);
    this->Transformed = this->Flat;
  }
  void SetPlacement(Placement placement, MeshBorder border)
  {
    this->SetPlacement(std::move(placement));
    this->HasBorder = true;
    this->Border = std::move(border);
  }
  ///@}

  ///@{
  /// The mesh as it is. Nodes before cells, cells before any cut.
  std::uint32_t AddNode(const Vector3& x)
  {
    this->Flat.push_back(x);
    this->MakerEnds.push_back(this->Makers.size());
    if (this->Transform)
    {
      this->Transformed.push_back(x);
    }
    return this->NumberOfNodes() - 1;
  }
  std::uint32_t AddCell(
    CellKind kind, const std::uint32_t* nodes, std::uint32_t size, std::uint32_t input, int steps)
  {
    Cell cell{ this->AllNodes.size(), size, input, None, 0, kind, kind == CellKind::Fixed,
      static_cast<std::uint8_t>(std::min(steps, 255)) };
    this->AllNodes.insert(this->AllNodes.end(), nodes, nodes + size);
    this->Cells.push_back(cell);
    const std::uint32_t number = this->NumberOfCells() - 1;
    this->Register(number);
    return number;
  }
  ///@}

  std::uint32_t NumberOfNodes() const { return static_cast<std::uint32_t>(this->Flat.size()); }
  std::uint32_t NumberOfCells() const { return static_cast<std::uint32_t>(this->Cells.size()); }
  std::uint32_t NumberOfLeaves() const { return this->LeafCount; }
  const Cell& operator[](std::uint32_t cell) const { return this->Cells[cell]; }
  Nodes NodesOf(std::uint32_t cell) const
  {
    return { this->AllNodes.data() + this->Cells[cell].First, this->Cells[cell].Size };
  }

  ///@{
  /// Where a node is: before it was placed, which is what decides on cuts, and after.
  const Vector3& FlatPoint(std::uint32_t node) const { return this->Flat[node]; }
  const Vector3& Point(std::uint32_t node) const
  {
    return this->Transform ? this->Transformed[node] : this->Flat[node];
  }
  ///@}

  /// The nodes that a new node is in the middle of; none of one that was there.
  Nodes MakersOf(std::uint32_t node) const
  {
    const std::uint64_t first = node == 0 ? 0 : this->MakerEnds[node - 1];
    return { this->Makers.data() + first,
      static_cast<std::uint32_t>(this->MakerEnds[node] - first) };
  }

  ///@{
  /// The node in the middle of an edge or face, None if there is none yet.
  std::uint32_t MiddleOf(std::uint32_t a, std::uint32_t b) const
  {
    return this->Edges.MiddleOf({ a, b });
  }
  std::uint32_t MiddleOf(const FaceNodes& face) const { return this->Faces.MiddleOf(face); }
  ///@}

  /// Whether an edge is known, which it is once a cell has it or it is cut.
  bool HasEdge(std::uint32_t a, std::uint32_t b) const { return this->Edges.Has({ a, b }); }
  bool IsCut(const FaceNodes& face) const { return this->Faces.IsCut(face); }
  bool IsFaceOfVolume(const FaceNodes& face) const { return this->Faces.IsOfVolume(face); }

  /// Puts down that a face of four nodes is a volume cell's, whoever has that.
  void SetFaceOfVolume(const FaceNodes& face) { this->Faces.SetOfVolume(face); }

  ///@{
  /// Those, made if there are none.
  std::uint32_t MakeMiddle(std::uint32_t a, std::uint32_t b)
  {
    std::uint32_t middle = this->Edges.MiddleOf({ a, b });
    if (middle == None)
    {
      const bool isOfBorder = this->Border.HasEdge(a, b);
      middle = this->MakeNode({ a, b }, isOfBorder);
      this->Edges.SetMiddle({ a, b }, middle);
      if (isOfBorder)
      {
        this->Border.AddHalves(a, middle, b);
      }
    }
    return middle;
  }
  std::uint32_t MakeMiddle(const FaceNodes& nodes)
  {
    std::uint32_t middle = this->Faces.MiddleOf(nodes);
    if (middle == None)
    {
      const std::uint32_t size = nodes[3] == None ? 3 : 4;
      middle = this->MakeNode({ nodes.begin(), nodes.begin() + size }, this->Border.HasFace(nodes));
      this->Faces.SetMiddle(nodes, middle);
    }
    return middle;
  }
  std::uint32_t MakeMiddleOfCell(std::uint32_t cell)
  {
    return this->MakeNode({ this->NodesOf(cell).begin(), this->NodesOf(cell).end() },
      DimensionOf(this->Cells[cell].Kind) < 3);
  }
  ///@}

  /// Puts down that a face is cut. Returns whether it was not before.
  bool SetCut(const FaceNodes& face) { return this->Faces.SetCut(face); }

  /// The faces that are cut, in the order in which that was put down, but for the first few.
  std::vector<FaceNodes> GetCutFaces(std::size_t first) const { return this->Faces.GetCut(first); }

  ///@{
  /// A cell becomes several: begin, add the children one by one, none else in between.
  void BeginCut(std::uint32_t cell) { this->Cells[cell].FirstChild = this->NumberOfCells(); }
  std::uint32_t AddChild(
    std::uint32_t parent, CellKind kind, std::initializer_list<std::uint32_t> nodes, int moreSteps)
  {
    const Cell& from = this->Cells[parent];
    const std::uint32_t child = this->AddCell(kind, nodes.begin(),
      static_cast<std::uint32_t>(nodes.size()), from.Input, from.Steps + moreSteps);
    ++this->Cells[parent].Children;
    return child;
  }
  void EndCut(std::uint32_t cell)
  {
    --this->LeafCount;
    if (this->HasBorder)
    {
      this->PassBorderOn(cell);
    }
  }
  ///@}

  /// It was found that it cannot be cut.
  void Fix(std::uint32_t cell) { this->Cells[cell].IsFixed = true; }

  ///@{
  /// Calls visit(cell) for the leaves that have the edge or the face.
  template <class Visit>
  void ForEachLeafAt(std::uint32_t a, std::uint32_t b, const Visit& visit) const
  {
    this->Edges.ForEachCellAt({ a, b }, this->IfLeaf(visit));
  }
  template <class Visit>
  void ForEachLeafAt(const FaceNodes& face, const Visit& visit) const
  {
    this->Faces.ForEachCellAt(face, this->IfLeaf(visit));
  }
  ///@}

  ///@{
  /// Where the mesh is now, and back to it.
  struct State
  {
    std::size_t Nodes, Makers, Cells, AllNodes;
    std::uint32_t LeafCount;
    MeshSides<2>::State Edges;
    MeshSides<4>::State Faces;
  };
  State GetState() const
  {
    return { this->Flat.size(), this->Makers.size(), this->Cells.size(), this->AllNodes.size(),
      this->LeafCount, this->Edges.GetState(), this->Faces.GetState() };
  }
  void GoBackTo(const State& state);
  ///@}

  /// Bytes in use.
  std::size_t MemorySize() const
  {
    const auto bytes = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    return bytes(this->Flat) + bytes(this->Transformed) + bytes(this->Makers) +
      bytes(this->MakerEnds) + bytes(this->Cells) + bytes(this->AllNodes) +
      this->Edges.MemorySize() + this->Faces.MemorySize();
  }

private:
  template <class Visit>
  auto IfLeaf(const Visit& visit) const
  {
    return [this, &visit](std::uint32_t cell)
    {
      if (this->Cells[cell].IsLeaf())
      {
        visit(cell);
      }
    };
  }

  /// Puts a new leaf down at its edges, and at its faces of four nodes.
  void Register(std::uint32_t cell)
  {
    ++this->LeafCount;
    const Cell& at = this->Cells[cell];
    const Nodes nodes = this->NodesOf(cell);
    ForEachEdge(at.Kind, nodes.First, nodes.Size,
      [&](std::uint32_t a, std::uint32_t b) {
        this->Edges.Enter({ a, b }, cell, false);
      });
    ForEachFace(at.Kind, nodes.First,
      [&](const FaceNodes& face)
      {
        if (face[3] != None)
        {
          this->Faces.Enter(face, cell, true);
        }
      });
    if (at.Kind == CellKind::Polygon && nodes.Size == 4)
    {
      this->Faces.Enter({ nodes[0], nodes[1], nodes[2], nodes[3] }, cell, false);
    }
  }

  /// The mean of points in the order of where they are: the same whatever their numbers.
  static Vector3 MeanOf(const std::vector<Vector3>& points, const Nodes& makers)
  {
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    for (const std::uint32_t maker : makers)
    {
      sum = sum + (1.0 / makers.Size) * points[maker];
    }
    return sum;
  }

  std::uint32_t MakeNode(std::vector<std::uint32_t> makers, bool isOfBorder)
  {
    std::sort(makers.begin(), makers.end(),
      [this](std::uint32_t a, std::uint32_t b)
      { return this->Flat[a] == this->Flat[b] ? a < b : this->Flat[a] < this->Flat[b]; });
    const Nodes list{ makers.data(), static_cast<std::uint32_t>(makers.size()) };
    if (this->Transform)
    {
      const Vector3 mean = MeanOf(this->Transformed, list);
      this->Transformed.push_back(
        isOfBorder || !this->HasBorder ? this->Transform(mean, *this, list) : mean);
    }
    this->Flat.push_back(MeanOf(this->Flat, list));
    this->Makers.insert(this->Makers.end(), makers.begin(), makers.end());
    this->MakerEnds.push_back(this->Makers.size());
    return this->NumberOfNodes() - 1;
  }

  void PassBorderOn(std::uint32_t cell);

  Placement Transform;
  MeshBorder Border;
  bool HasBorder = false;
  std::vector<Vector3> Flat;
  std::vector<Vector3> Transformed; // empty without a placement
  std::vector<std::uint32_t> Makers;
  std::vector<std::uint64_t> MakerEnds;
  std::vector<Cell> Cells;
  std::vector<std::uint32_t> AllNodes;
  MeshSides<2> Edges;
  MeshSides<4> Faces;
  std::uint32_t LeafCount = 0;
};

//------------------------------------------------------------------------------
inline void RefinedMesh::GoBackTo(const State& state)
{
  this->Edges.GoBackTo(state.Edges, state.Nodes);
  this->Faces.GoBackTo(state.Faces, state.Nodes);
  this->Flat.resize(state.Nodes);
  this->Transformed.resize(this->Transform ? state.Nodes : 0);
  this->Makers.resize(state.Makers);
  this->MakerEnds.resize(state.Nodes);
  this->Cells.resize(state.Cells);
  this->AllNodes.resize(state.AllNodes);
  this->LeafCount = state.LeafCount;
  for (Cell& cell : this->Cells)
  {
    if (!cell.IsLeaf() && cell.FirstChild >= state.Cells)
    {
      cell.FirstChild = None;
      cell.Children = 0;
    }
  }
}

//------------------------------------------------------------------------------
/// Children's faces are border where all of their nodes lie on one face that is.
inline void RefinedMesh::PassBorderOn(std::uint32_t cell)
{
  const Cell& at = this->Cells[cell];
  std::vector<std::uint32_t> onFace;
  const auto passOn = [&](std::uint32_t child)
  {
    ForEachFace(this->Cells[child].Kind, this->NodesOf(child).First,
      [&](const FaceNodes& face)
      {
        const bool isOnFace = std::all_of(face.begin(), face.end(),
          [&](std::uint32_t node)
          { return node == None || std::count(onFace.begin(), onFace.end(), node) > 0; });
        if (isOnFace)
        {
          this->Border.AddFace(face);
        }
      });
  };
  ForEachFace(at.Kind, this->NodesOf(cell).First,
    [&](const FaceNodes& face)
    {
      if (!this->Border.HasFace(face))
      {
        return;
      }
      const int size = face[3] == None ? 3 : 4;
      onFace = { face[0], face[1], face[2], face[3], this->MiddleOf(face) };
      for (int i = 0; i < size; ++i)
      {
        onFace.push_back(this->MiddleOf(face[i], face[(i + 1) % size]));
      }
      for (std::uint32_t child = 0; child < at.Children; ++child)
      {
        passOn(at.FirstChild + child);
      }
    });
  for (std::uint32_t child = 0; DimensionOf(at.Kind) < 3 && child < at.Children; ++child)
  {
    const Nodes nodes = this->NodesOf(at.FirstChild + child);
    this->Border.AddCell(this->Cells[at.FirstChild + child].Kind, nodes.First, nodes.Size);
  }
}

}

#endif
