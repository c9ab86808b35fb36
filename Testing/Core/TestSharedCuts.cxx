// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshScenes.h"

#include "Core/Mesh/MeshLayers.h"
#include "Core/Mesh/SharedCuts.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <thread>

namespace
{

using skd::RefinedMesh;
using skd::Vector3;
using Shapes = std::multiset<std::set<Vector3>>;

/// Where threads wait for each other, and leave numbers.
class Meeting
{
public:
  explicit Meeting(int count)
    : Left(count)
    , Count(count)
  {
  }

  std::vector<std::vector<double>> Exchange(int id, const std::vector<double>& own)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Left[id] = own;
    this->Wait(lock);
    const std::vector<std::vector<double>> all = this->Left;
    this->Wait(lock);
    return all;
  }

private:
  void Wait(std::unique_lock<std::mutex>& lock)
  {
    const int turn = this->Turn;
    if (++this->Arrived == this->Count)
    {
      this->Arrived = 0;
      ++this->Turn;
      this->All.notify_all();
      return;
    }
    this->All.wait(lock, [&] { return this->Turn != turn; });
  }

  std::vector<std::vector<double>> Left;
  int Count;
  int Arrived = 0;
  int Turn = 0;
  std::mutex Mutex;
  std::condition_variable All;
};

class Threads : public skd::Processes
{
public:
  Threads(Meeting& meeting, int id)
    : With(meeting)
    , Id(id)
  {
  }

  bool IsAny(bool here) const override
  {
    bool is = false;
    for (const std::vector<double>& told : this->With.Exchange(this->Id, { here ? 1.0 : 0.0 }))
    {
      is = is || told[0] > 0.0;
    }
    return is;
  }
  std::vector<std::vector<double>> GatherFromOthers(const std::vector<double>& own) const override
  {
    std::vector<std::vector<double>> all = this->With.Exchange(this->Id, own);
    all.erase(all.begin() + this->Id);
    return all;
  }

private:
  Meeting& With;
  int Id;
};

/// The cells that `isOwn` takes, with nodes of their own.
RefinedMesh PieceOf(const RefinedMesh& mesh, const std::function<bool(std::uint32_t)>& isOwn)
{
  RefinedMesh piece;
  std::vector<std::uint32_t> nodeOf(mesh.NumberOfNodes(), RefinedMesh::None);
  for (const bool isAdding : { false, true }) // nodes before cells
  {
    for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      std::vector<std::uint32_t> nodes;
      for (const std::uint32_t node : mesh.NodesOf(cell))
      {
        if (isOwn(cell) && nodeOf[node] == RefinedMesh::None)
        {
          nodeOf[node] = piece.AddNode(mesh.FlatPoint(node));
        }
        nodes.push_back(nodeOf[node]);
      }
      if (isOwn(cell) && isAdding)
      {
        piece.AddCell(mesh[cell].Kind, nodes.data(), mesh.NodesOf(cell).Size, cell, 0);
      }
    }
  }
  return piece;
}

/// Leaves near a place that are not yet of the level.
std::vector<std::uint32_t> Wanted(const RefinedMesh& mesh, const Vector3& at, double by, int level)
{
  std::vector<std::uint32_t> wanted;
  for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    bool isNear = false;
    for (const std::uint32_t node : mesh.NodesOf(cell))
    {
      isNear = isNear || skd::Norm(mesh.FlatPoint(node) - at) < by;
    }
    if (isNear && mesh[cell].IsLeaf() && mesh[cell].Level() < level)
    {
      wanted.push_back(cell);
    }
  }
  return wanted;
}

struct Task
{
  Vector3 At;
  double By;
  int Level;
  int Layers;
  std::uint64_t Limit = 1u << 30;
};

/// Returns whether it fits.
bool Refine(RefinedMesh& mesh, const Task& task, const skd::Processes* processes)
{
  std::optional<skd::SharedCuts> shared;
  if (processes)
  {
    shared.emplace(mesh, *processes);
  }
  for (;;)
  {
    const std::vector<std::uint32_t> wanted = Wanted(mesh, task.At, task.By, task.Level);
    if (processes ? !processes->IsAny(!wanted.empty()) : wanted.empty())
    {
      return true;
    }
    const auto before = mesh.GetState();
    skd::Bisection bisection(mesh, task.Limit);
    bool fits = bisection.Refine(skd::WithLayers(mesh, wanted, task.Layers,
      [&](std::vector<int>& levels) { shared ? shared->ShareLevels(levels) : void(); }));
    if (shared)
    {
      fits = shared->Exchange(bisection, fits);
    }
    if (!fits)
    {
      mesh.GoBackTo(before);
      return false;
    }
  }
}

void AddShapes(const RefinedMesh& mesh, Shapes& shapes)
{
  for (const std::vector<std::uint32_t>& leaf : LeavesOf(mesh))
  {
    std::set<Vector3> shape;
    for (const std::uint32_t node : leaf)
    {
      shape.insert(mesh.FlatPoint(node));
    }
    shapes.insert(shape);
  }
}

/// Refines pieces side by side; whether it fits, and what all have together.
bool RefinePieces(std::vector<RefinedMesh>& pieces, const Task& task, Shapes& shapes)
{
  Meeting meeting(static_cast<int>(pieces.size()));
  std::vector<char> fits(pieces.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        const Threads processes(meeting, static_cast<int>(i));
        fits[i] = Refine(pieces[i], task, &processes);
      });
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    threads[i].join();
    AddShapes(pieces[i], shapes);
    EXPECT_EQ(fits[i], fits[0]);
  }
  return fits[0] != 0;
}

std::vector<RefinedMesh> PiecesOf(const RefinedMesh& mesh, std::uint32_t count, bool isInRows)
{
  std::vector<RefinedMesh> pieces;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    pieces.push_back(PieceOf(mesh,
      [&](std::uint32_t cell)
      {
        const std::uint32_t row =
          isInRows ? cell * count / mesh.NumberOfCells() : cell * 2654435761u >> 7;
        return row % count == i;
      }));
  }
  return pieces;
}

void ExpectSameOfPieces(const RefinedMesh& mesh, const Task& task)
{
  RefinedMesh whole = mesh;
  ASSERT_TRUE(Refine(whole, task, nullptr));
  Shapes expected;
  AddShapes(whole, expected);
  EXPECT_GT(expected.size(), 2u * mesh.NumberOfCells());
  for (const std::uint32_t count : { 2u, 3u, 5u })
  {
    for (const bool isInRows : { true, false })
    {
      std::vector<RefinedMesh> pieces = PiecesOf(mesh, count, isInRows);
      Shapes together;
      EXPECT_TRUE(RefinePieces(pieces, task, together));
      EXPECT_EQ(together, expected) << count << isInRows;
    }
  }
}

TEST(SharedCuts, OfTrianglesAreThoseOfTheWhole)
{
  for (int layers = 0; layers <= 2; ++layers)
  {
    ExpectSameOfPieces(MakeSquare(6), { { { 2.9, 3.1, 0.0 } }, 0.8, 4, layers });
  }
}

TEST(SharedCuts, OfHexahedraThatBecomeTetrahedraAreThoseOfTheWhole)
{
  for (int layers = 0; layers <= 1; ++layers)
  {
    ExpectSameOfPieces(MakeBricks(3), { { { 1.7, 1.6, 1.4 } }, 1.0, 2, layers });
  }
}

TEST(SharedCuts, TheLimitOfOneStopsAllAtTheSameRound)
{
  std::vector<RefinedMesh> pieces = PiecesOf(MakeSquare(6), 3, true);
  Shapes together;
  EXPECT_FALSE(RefinePieces(pieces, { { { 2.9, 3.1, 0.0 } }, 0.8, 6, 0, 100 }, together));
  // What there is fits together: every inner edge has two triangles.
  std::map<std::set<Vector3>, int> edges;
  for (const std::set<Vector3>& shape : together)
  {
    for (const Vector3& corner : shape)
    {
      std::set<Vector3> edge = shape;
      edge.erase(corner);
      ++edges[edge];
    }
  }
  for (const auto& [edge, count] : edges)
  {
    const Vector3 middle = 0.5 * (*edge.begin() + *edge.rbegin());
    const bool isOnBorder =
      middle[0] == 0.0 || middle[0] == 6.0 || middle[1] == 0.0 || middle[1] == 6.0;
    EXPECT_EQ(count, isOnBorder ? 1 : 2);
  }
  EXPECT_GT(together.size(), 72u);
}

}
