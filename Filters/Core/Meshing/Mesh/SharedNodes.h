// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_SharedNodes_h
#define skd_Mesh_SharedNodes_h

#include "../../Geometry/Box.h"
#include "../../Parallel/Processes.h"
#include "RefinedMesh.h"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace skd
{

/// The nodes that pieces of a mesh, each with a process of its own, have in common: those of equal
/// coordinates and the same descent, which is how many times nodes were made of nodes before it
/// was, and of how many it is made. (So a node that was there is not the one that is made in the
/// same position.) Nothing is sent of what lies within the bounds of no other process. O(log) a
/// node.
class SharedNodes
{
public:
  static constexpr std::uint32_t None = RefinedMesh::None;
  static constexpr std::size_t Size = 4; ///< the numbers by which others know a node

  /// Before any cut. All processes must make one.
  SharedNodes(const RefinedMesh& mesh, const Processes& processes)
    : Mesh(mesh)
    , Peers(processes)
  {
    Box3 box;
    double largest = 0.0;
    for (std::uint32_t node = 0; node < mesh.NumberOfNodes(); ++node)
    {
      const Vector3& x = mesh.FlatPoint(node);
      box.Add(x);
      largest = std::max({ largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
    }
    // The mean of four may be rounded to the outside.
    box = box.Inflated(8.0 * std::numeric_limits<double>::epsilon() * largest);
    const std::vector<double> own = { box.Min[0], box.Min[1], box.Min[2], box.Max[0], box.Max[1],
      box.Max[2] };
    for (const std::vector<double>& told : processes.GatherFromOthers(own))
    {
      this->Others.push_back(
        Box3({ { told[0], told[1], told[2] } }, { { told[3], told[4], told[5] } }));
    }
    this->Update();
  }

  /// Once the mesh has other nodes than before.
  void Update();

  bool MayBeShared(std::uint32_t node) const
  {
    return std::any_of(this->Others.begin(), this->Others.end(),
      [&](const Box3& box) { return box.Contains(this->Mesh.FlatPoint(node)); });
  }

  void Append(std::vector<double>& told, std::uint32_t node) const
  {
    const Vector3& x = this->Mesh.FlatPoint(node);
    told.insert(told.end(), { x[0], x[1], x[2], static_cast<double>(this->Descents[node]) });
  }

  /// The node that another process sent, None if it is not here.
  std::uint32_t Find(const double* told) const
  {
    const auto found =
      this->Nodes.find({ { { told[0], told[1], told[2] } }, static_cast<std::uint32_t>(told[3]) });
    return found == this->Nodes.end() ? None : found->second;
  }

  /// Makes the number of each node the largest that a process has of it. Those above `least` are
  /// told.
  template <class Number>
  void Raise(std::vector<Number>& numbers, Number least);

private:
  using Key = std::pair<Vector3, std::uint32_t>;

  std::uint32_t DescentOf(std::uint32_t node) const
  {
    constexpr std::uint32_t perGeneration = 16;
    std::uint32_t generation = 0;
    const RefinedMesh::Nodes makers = this->Mesh.MakersOf(node);
    for (const std::uint32_t maker : makers)
    {
      generation = std::max(generation, this->Descents[maker] / perGeneration + 1);
    }
    return generation * perGeneration + std::min(makers.Size, perGeneration - 1);
  }

  const RefinedMesh& Mesh;
  const Processes& Peers;
  std::vector<Box3> Others; // the bounds of the other processes' nodes
  std::map<Key, std::uint32_t> Nodes;
  std::vector<std::uint32_t> Descents; // of the nodes that are known
};

inline void SharedNodes::Update()
{
  const std::uint32_t count = this->Mesh.NumberOfNodes();
  if (this->Descents.size() > count) // the mesh went back
  {
    this->Descents.resize(count);
    for (auto next = this->Nodes.begin(); next != this->Nodes.end();)
    {
      next = next->second >= count ? this->Nodes.erase(next) : std::next(next);
    }
  }
  for (auto node = static_cast<std::uint32_t>(this->Descents.size()); node < count; ++node)
  {
    this->Descents.push_back(this->DescentOf(node));
    if (this->MayBeShared(node))
    {
      this->Nodes.emplace(Key(this->Mesh.FlatPoint(node), this->Descents[node]), node);
    }
  }
}

template <class Number>
void SharedNodes::Raise(std::vector<Number>& numbers, Number least)
{
  this->Update();
  std::vector<double> own;
  for (const auto& [key, node] : this->Nodes)
  {
    if (numbers[node] > least)
    {
      this->Append(own, node);
      own.push_back(numbers[node]);
    }
  }
  for (const std::vector<double>& told : this->Peers.GatherFromOthers(own))
  {
    for (std::size_t i = 0; i < told.size(); i += Size + 1)
    {
      const std::uint32_t node = this->Find(&told[i]);
      if (node != None)
      {
        numbers[node] = std::max(numbers[node], static_cast<Number>(told[i + Size]));
      }
    }
  }
}

}

#endif
