// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cuts of a mesh whose pieces are with several processes.
#ifndef skd_Mesh_SharedCuts_h
#define skd_Mesh_SharedCuts_h

#include "../Geometry/Box.h"
#include "Bisection.h"

#include <map>
#include <vector>

namespace skd
{

/// What processes that run side by side tell each other. All of them must ask the same, in the same
/// order.
class Processes
{
public:
  virtual ~Processes() = default;

  /// Whether it is so on any of them.
  virtual bool IsAny(bool here) const = 0;

  /// The numbers of each of the others.
  virtual std::vector<std::vector<double>> GatherFromOthers(
    const std::vector<double>& own) const = 0;
};

/// An edge or face that one process cuts is cut on all that have it, and what must be cut for it,
/// until nothing changes: the pieces together are what one process would make of the whole. Nodes
/// of two processes are one where their coordinates are equal. Of what lies within the bounds of no
/// other process nothing is told.
class SharedCuts
{
public:
  /// Before any cut.
  SharedCuts(RefinedMesh& mesh, const Processes& processes);

  /// Cuts here what others have cut, and tells them what is cut for it, until all is done. `fits`
  /// tells whether what was cut so far has made no more leaves than may be; returns whether that is
  /// so on all processes to the end. If not, the mesh must be taken back to what it was.
  bool Exchange(Bisection& bisection, bool fits);

  /// Makes what is known of nodes (see WithLayers) the largest of all processes.
  void ShareLevels(std::vector<int>& levels);

private:
  static constexpr std::uint32_t None = RefinedMesh::None;

  static void Append(std::vector<double>& numbers, const Vector3& x)
  {
    numbers.insert(numbers.end(), x.X, x.X + 3);
  }
  bool MayBeShared(const Vector3& x) const;
  void EnterNewNodes();
  std::uint32_t Find(const double* x) const;
  std::vector<double> Tell(const std::vector<FaceNodes>& cuts) const;
  bool CutAsTold(const std::vector<double>& told, Bisection& bisection);

  RefinedMesh& Mesh;
  const Processes& Peers;
  std::vector<Box3> Others; // the bounds of the other processes' nodes
  std::map<Vector3, std::uint32_t> Nodes;
  std::uint32_t NodesSeen = 0;
};

inline SharedCuts::SharedCuts(RefinedMesh& mesh, const Processes& processes)
  : Mesh(mesh)
  , Peers(processes)
{
  Box3 box;
  for (std::uint32_t node = 0; node < mesh.NumberOfNodes(); ++node)
  {
    box.Add(mesh.FlatPoint(node));
  }
  std::vector<double> own;
  Append(own, box.Min);
  Append(own, box.Max);
  for (const std::vector<double>& told : processes.GatherFromOthers(own))
  {
    this->Others.push_back(
      Box3({ { told[0], told[1], told[2] } }, { { told[3], told[4], told[5] } }));
  }
}

inline bool SharedCuts::MayBeShared(const Vector3& x) const
{
  return std::any_of(
    this->Others.begin(), this->Others.end(), [&](const Box3& box) { return box.Contains(x); });
}

inline void SharedCuts::EnterNewNodes()
{
  for (; this->NodesSeen < this->Mesh.NumberOfNodes(); ++this->NodesSeen)
  {
    const Vector3& x = this->Mesh.FlatPoint(this->NodesSeen);
    if (this->MayBeShared(x))
    {
      this->Nodes.emplace(x, this->NodesSeen);
    }
  }
}

inline std::uint32_t SharedCuts::Find(const double* x) const
{
  const auto found = this->Nodes.find({ { x[0], x[1], x[2] } });
  return found == this->Nodes.end() ? None : found->second;
}

//------------------------------------------------------------------------------
/// The number of nodes of each cut, 2 or 4, and where they are.
inline std::vector<double> SharedCuts::Tell(const std::vector<FaceNodes>& cuts) const
{
  std::vector<double> told;
  for (const FaceNodes& cut : cuts)
  {
    const int size = cut[3] == None ? 2 : 4;
    const bool isShared = std::all_of(cut.begin(), cut.begin() + size,
      [this](std::uint32_t node) { return this->MayBeShared(this->Mesh.FlatPoint(node)); });
    if (isShared)
    {
      told.push_back(size);
      std::for_each(cut.begin(), cut.begin() + size,
        [&](std::uint32_t node) { Append(told, this->Mesh.FlatPoint(node)); });
    }
  }
  return told;
}

/// In turn: the halves of an edge are there once the edge is cut.
inline bool SharedCuts::CutAsTold(const std::vector<double>& told, Bisection& bisection)
{
  bool fits = true;
  for (std::size_t i = 0; i < told.size() && fits;)
  {
    const int size = static_cast<int>(told[i++]);
    FaceNodes nodes{ None, None, None, None };
    for (int k = 0; k < size; ++k, i += 3)
    {
      nodes[k] = this->Find(&told[i]);
    }
    const bool isHere =
      std::find(nodes.begin(), nodes.begin() + size, None) == nodes.begin() + size;
    if (isHere && size == 4 && this->Mesh.IsFaceOfVolume(nodes))
    {
      fits = bisection.RefineAt(nodes);
    }
    else if (isHere && size == 2 && this->Mesh.HasEdge(nodes[0], nodes[1]))
    {
      fits = bisection.RefineAt(nodes[0], nodes[1]);
    }
    this->EnterNewNodes();
  }
  return fits;
}

inline bool SharedCuts::Exchange(Bisection& bisection, bool fits)
{
  for (;;)
  {
    if (this->Peers.IsAny(!fits))
    {
      return false;
    }
    this->EnterNewNodes();
    const std::vector<double> own = this->Tell(bisection.TakeCuts());
    if (!this->Peers.IsAny(!own.empty()))
    {
      return true;
    }
    for (const std::vector<double>& told : this->Peers.GatherFromOthers(own))
    {
      fits = fits && this->CutAsTold(told, bisection);
    }
  }
}

//------------------------------------------------------------------------------
inline void SharedCuts::ShareLevels(std::vector<int>& levels)
{
  this->EnterNewNodes();
  std::vector<double> own;
  for (const auto& [x, node] : this->Nodes)
  {
    if (levels[node] >= 0)
    {
      Append(own, x);
      own.push_back(levels[node]);
    }
  }
  for (const std::vector<double>& told : this->Peers.GatherFromOthers(own))
  {
    for (std::size_t i = 0; i < told.size(); i += 4)
    {
      const std::uint32_t node = this->Find(&told[i]);
      if (node != None)
      {
        levels[node] = std::max(levels[node], static_cast<int>(told[i + 3]));
      }
    }
  }
}

}

#endif
