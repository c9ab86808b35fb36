// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cuts of a mesh distributed over several processes.
#ifndef skd_Mesh_SharedCuts_h
#define skd_Mesh_SharedCuts_h

#include "Bisection.h"
#include "FindBorder.h"
#include "SharedNodes.h"

#include <vector>

namespace skd
{

/// What processes must send each other about edges, faces and nodes where their pieces of a mesh
/// meet, so that the pieces together are what one process would make of the whole. All of them must
/// call the same functions, in the same order, and all wait for the last one.
class SharedCuts
{
public:
  /// Before any cut. Both must live.
  SharedCuts(RefinedMesh& mesh, const Processes& processes)
    : Mesh(mesh)
    , Peers(processes)
    , Nodes(mesh, processes)
    , MidpointsSent(mesh.NumberOfNodes())
  {
    this->AgreeOnFacesOfVolumes();
  }

  const Processes& GetProcesses() const { return this->Peers; }

  /// The border of all pieces together, as far as this one has it. Before any cut.
  MeshBorder FindBorder();

  /// For bisection: cuts here what others have cut, and sends them what is cut for it, until
  /// nothing changes. `fits` returns whether the cuts so far have made no more leaves than allowed;
  /// returns whether that is so on all processes to the end. If not, the mesh must be taken back to
  /// what it was.
  bool Exchange(Bisection& bisection, bool fits);

  /// For cuts that leave nodes hanging: makes the middles of edges and faces here that others have
  /// made, and marks the faces as cut. Returns whether it fits on all processes, as above.
  bool ShareMiddles(bool fits);

  ///@{
  /// Makes the level known of each node (see WithLayers, MeshBalance), or its mark, the largest.
  void ShareLevels(std::vector<int>& levels) { this->Nodes.Raise(levels, -1); }
  void ShareMarks(std::vector<char>& marks) { this->Nodes.Raise<char>(marks, 0); }
  ///@}

private:
  static constexpr std::uint32_t None = RefinedMesh::None;

  static int SizeOf(const FaceNodes& side) { return side[2] == None ? 2 : side[3] == None ? 3 : 4; }
  void Append(std::vector<double>& told, const FaceNodes& side) const;
  FaceNodes Receive(const std::vector<double>& told, std::size_t& at, bool& isWhole) const;
  template <class Visit>
  void ForEachReceived(const std::vector<double>& told, const Visit& visit);
  template <class Visit>
  void ForEachOfOthers(const std::vector<double>& own, const Visit& visit);
  FaceNodes BesideOf(const OuterFaces& faces, const FaceNodes& face) const;
  void LeaveOutWhereOthersContinue(OuterFaces& faces);
  std::vector<double> TellMiddles() const;
  void CutSide(const FaceNodes& side);
  void AgreeOnFacesOfVolumes();

  RefinedMesh& Mesh;
  const Processes& Peers;
  SharedNodes Nodes;
  std::uint32_t MidpointsSent;
  std::size_t FacesSent = 0;
};

//------------------------------------------------------------------------------
/// The number of nodes of a side, 2 to 4, and the nodes, if others may have all of them.
inline void SharedCuts::Append(std::vector<double>& told, const FaceNodes& side) const
{
  const int size = SizeOf(side);
  if (std::all_of(side.begin(), side.begin() + size, // the rest is None
        [this](std::uint32_t node) { return this->Nodes.MayBeShared(node); }))
  {
    told.push_back(size);
    std::for_each(side.begin(), side.begin() + size,
      [&](std::uint32_t node) { this->Nodes.Append(told, node); });
  }
}

/// A side that was appended, None in place of nodes that are not here; and whether all are.
inline FaceNodes SharedCuts::Receive(
  const std::vector<double>& told, std::size_t& at, bool& isWhole) const
{
  const int size = static_cast<int>(told[at++]);
  FaceNodes side{ None, None, None, None };
  isWhole = true;
  for (int k = 0; k < size; ++k, at += SharedNodes::Size)
  {
    side[k] = this->Nodes.Find(&told[at]);
    isWhole = isWhole && side[k] != None;
  }
  return side;
}

/// Calls visit(side), false to end it, for the sides whose nodes are all here. In turn: what is
/// made of a side may be nodes of the next one.
template <class Visit>
void SharedCuts::ForEachReceived(const std::vector<double>& told, const Visit& visit)
{
  bool goesOn = true;
  for (std::size_t i = 0; i < told.size() && goesOn;)
  {
    bool isHere = true;
    const FaceNodes side = this->Receive(told, i, isHere);
    goesOn = !isHere || visit(side);
    this->Nodes.Update();
  }
}

/// Sends `own` to the others, and calls visit(side) for all that they send.
template <class Visit>
void SharedCuts::ForEachOfOthers(const std::vector<double>& own, const Visit& visit)
{
  for (const std::vector<double>& told : this->Peers.GatherFromOthers(own))
  {
    this->ForEachReceived(told,
      [&](const FaceNodes& side)
      {
        visit(side);
        return true;
      });
  }
}

inline bool SharedCuts::Exchange(Bisection& bisection, bool fits)
{
  for (;;)
  {
    if (this->Peers.IsAny(!fits))
    {
      return false;
    }
    this->Nodes.Update();
    std::vector<double> own;
    for (const FaceNodes& cut : bisection.TakeCuts())
    {
      this->Append(own, cut);
    }
    if (!this->Peers.IsAny(!own.empty()))
    {
      return true;
    }
    for (const std::vector<double>& told : this->Peers.GatherFromOthers(own))
    {
      this->ForEachReceived(told,
        [&](const FaceNodes& side)
        {
          fits = fits &&
            (SizeOf(side) == 4 ? bisection.RefineAt(side) : bisection.RefineAt(side[0], side[1]));
          return fits;
        });
    }
  }
}

//------------------------------------------------------------------------------
/// Middles in the order in which they were made: the nodes of a side are there before its middle.
/// Faces of three nodes have none.
inline std::vector<double> SharedCuts::TellMiddles() const
{
  std::vector<double> told;
  for (std::uint32_t node = this->MidpointsSent; node < this->Mesh.NumberOfNodes(); ++node)
  {
    const RefinedMesh::Nodes of = this->Mesh.MakersOf(node);
    if (of.Size == 2)
    {
      this->Append(told, { of[0], of[1], None, None });
    }
    else if (of.Size == 4 && this->Mesh.MiddleOf({ of[0], of[1], of[2], of[3] }) == node)
    {
      this->Append(told, { of[0], of[1], of[2], of[3] });
    }
  }
  for (const FaceNodes& face : this->Mesh.GetCutFaces(this->FacesSent))
  {
    if (face[3] == None)
    {
      this->Append(told, face);
    }
  }
  return told;
}

/// Makes the middle that it has, an edge or a face of four nodes, and marks faces as cut.
inline void SharedCuts::CutSide(const FaceNodes& side)
{
  const int size = SizeOf(side);
  if (size == 2)
  {
    this->Mesh.MakeMiddle(side[0], side[1]);
    return;
  }
  this->Mesh.SetCut(side);
  if (size == 4)
  {
    this->Mesh.MakeMiddle(side);
  }
}

inline bool SharedCuts::ShareMiddles(bool fits)
{
  if (this->Peers.IsAny(!fits))
  {
    return false;
  }
  this->Nodes.Update();
  for (const std::vector<double>& told : this->Peers.GatherFromOthers(this->TellMiddles()))
  {
    this->ForEachReceived(told,
      [this](const FaceNodes& side)
      {
        this->CutSide(side);
        return true;
      });
  }
  this->MidpointsSent = this->Mesh.NumberOfNodes();
  this->FacesSent += this->Mesh.GetCutFaces(this->FacesSent).size();
  return true;
}

//------------------------------------------------------------------------------
/// A quadrilateral on the face of another process's volume cell is cut as that is.
inline void SharedCuts::AgreeOnFacesOfVolumes()
{
  std::vector<double> requested;
  for (std::uint32_t cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
  {
    const RefinedMesh::Nodes of = this->Mesh.NodesOf(cell);
    if (this->Mesh[cell].Kind == CellKind::Polygon && of.Size == 4)
    {
      this->Append(requested, { of[0], of[1], of[2], of[3] });
    }
  }
  std::vector<double> answers;
  this->ForEachOfOthers(requested,
    [&](const FaceNodes& side)
    {
      if (this->Mesh.IsFaceOfVolume(side))
      {
        this->Append(answers, side);
      }
    });
  this->ForEachOfOthers(
    answers, [this](const FaceNodes& side) { this->Mesh.SetFaceOfVolume(side); });
}

/// The nodes of the face's cell that are not of the face, ascending: they tell the cells on both
/// sides of a face apart. A single one is there twice, because sides have two nodes at least.
inline FaceNodes SharedCuts::BesideOf(const OuterFaces& faces, const FaceNodes& face) const
{
  FaceNodes beside{ None, None, None, None };
  std::size_t count = 0;
  for (const std::uint32_t node : this->Mesh.NodesOf(faces.CellOf(face)))
  {
    if (std::find(face.begin(), face.end(), node) == face.end() && count < beside.size())
    {
      beside[count++] = node;
    }
  }
  beside[1] = count == 1 ? beside[0] : beside[1];
  std::sort(beside.begin(), beside.end());
  return beside;
}

/// A face is no border where another process has a cell on its other side; the same cell may be on
/// several processes. Each face is sent with what its cell has beside it.
inline void SharedCuts::LeaveOutWhereOthersContinue(OuterFaces& faces)
{
  std::vector<double> own;
  faces.ForEach(
    [&](const FaceNodes& face)
    {
      const std::size_t before = own.size();
      this->Append(own, face);
      const std::size_t after = own.size();
      if (after == before)
      {
        return;
      }
      this->Append(own, this->BesideOf(faces, face));
      if (own.size() == after)
      {
        own.push_back(0.0); // others have not all of the cell
      }
    });
  for (const std::vector<double>& told : this->Peers.GatherFromOthers(own))
  {
    for (std::size_t i = 0; i < told.size();)
    {
      bool isWhole = true;
      const FaceNodes face = this->Receive(told, i, isWhole);
      const bool isHere = isWhole && faces.CellOf(face) != None;
      FaceNodes beside = this->Receive(told, i, isWhole);
      std::sort(beside.begin(), beside.end());
      if (isHere && beside != this->BesideOf(faces, face))
      {
        faces.LeaveOut(face);
      }
    }
  }
  // Others may have the cells on both sides of a face that seems to be outer here.
  own.clear();
  faces.ForEach([&](const FaceNodes& face) { this->Append(own, face); });
  std::vector<double> inner;
  this->ForEachOfOthers(own,
    [&](const FaceNodes& face)
    {
      if (faces.IsInner(face))
      {
        this->Append(inner, face);
      }
    });
  this->ForEachOfOthers(inner, [&](const FaceNodes& face) { faces.LeaveOut(face); });
}

/// Edges and faces of others that are of the border may be those of cells here that have no more of
/// it.
inline MeshBorder SharedCuts::FindBorder()
{
  OuterFaces faces(this->Mesh);
  this->LeaveOutWhereOthersContinue(faces);
  std::vector<double> own;
  MeshBorder border = MakeBorder(this->Mesh, faces);
  border.ForEachSide([&](const FaceNodes& side) { this->Append(own, side); });
  this->ForEachOfOthers(own, [&](const FaceNodes& side) { border.AddSide(side); });
  return border;
}

}

#endif
