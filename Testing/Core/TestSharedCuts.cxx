// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshScenes.h"

#include "Core/Meshing/Mesh/HangingNodes.h"
#include "Core/Meshing/Mesh/MeshLayers.h"
#include "Core/Meshing/Mesh/RegularCuts.h"

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
class Rendezvous
{
public:
  explicit Rendezvous(int count)
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
  Threads(Rendezvous& rendezvous, int id)
    : With(rendezvous)
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
  Rendezvous& With;
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
  int Layers = 0;
  bool IsRegular = false;
  skd::Contact Balance = skd::Contact::None;
  bool IsRounded = false; ///< nodes of the border are put on a sphere
  std::uint64_t Limit = 1u << 30;
};

Vector3 Rounded(const Vector3& x)
{
  return (3.0 / skd::Norm(x)) * x;
}

bool CutOnce(RefinedMesh& mesh, const std::vector<std::uint32_t>& wanted, const Task& task,
  skd::SharedCuts* shared)
{
  const std::vector<std::uint32_t> cells = skd::WithLayers(mesh, wanted, task.Layers,
    [&](std::vector<int>& levels) { shared ? shared->ShareLevels(levels) : void(); });
  if (task.IsRegular)
  {
    return skd::RegularCuts(mesh, task.Limit, task.Balance, shared).Refine(cells);
  }
  const auto before = mesh.GetState();
  skd::Bisection bisection(mesh, task.Limit);
  const bool fits = bisection.Refine(cells);
  if (shared && !shared->Exchange(bisection, fits))
  {
    mesh.GoBackTo(before);
    return false;
  }
  return fits;
}

struct Result
{
  Shapes Cells;
  std::map<Vector3, std::pair<Vector3, bool>> Corners; // where it is, and whether it hangs
  bool Fits = true;
};

/// What is left of a mesh in the end. Of equal places all are alike.
void AddTo(Result& result, const RefinedMesh& mesh, const skd::HangingNodes& hanging)
{
  for (const std::vector<std::uint32_t>& leaf : LeavesOf(mesh))
  {
    std::set<Vector3> shape;
    for (const std::uint32_t node : leaf)
    {
      const std::pair<Vector3, bool> corner(mesh.Point(node), hanging[node]);
      shape.insert(mesh.FlatPoint(node));
      EXPECT_EQ(result.Corners.emplace(mesh.FlatPoint(node), corner).first->second, corner);
    }
    result.Cells.insert(shape);
  }
}

/// Returns what hangs. `fits` becomes whether it fits.
skd::HangingNodes Refine(
  RefinedMesh& mesh, const Task& task, const skd::Processes* processes, bool& fits)
{
  std::optional<skd::SharedCuts> own;
  skd::SharedCuts* shared = processes ? &own.emplace(mesh, *processes) : nullptr;
  if (task.IsRounded)
  {
    mesh.SetPlacement([](const Vector3& mean, const RefinedMesh&, RefinedMesh::Nodes)
      { return Rounded(mean); },
      shared ? shared->FindBorder() : skd::MakeBorder(mesh, skd::OuterFaces(mesh)));
  }
  for (fits = true; fits;)
  {
    const std::vector<std::uint32_t> wanted = Wanted(mesh, task.At, task.By, task.Level);
    if (processes ? !processes->IsAny(!wanted.empty()) : wanted.empty())
    {
      break;
    }
    fits = CutOnce(mesh, wanted, task, shared);
  }
  skd::HangingNodes hanging(mesh);
  hanging.Add([&](std::vector<char>& marks) { shared ? shared->ShareMarks(marks) : void(); });
  return hanging;
}

Result ResultOf(RefinedMesh mesh, const Task& task)
{
  Result result;
  const skd::HangingNodes hanging = Refine(mesh, task, nullptr, result.Fits);
  AddTo(result, mesh, hanging);
  return result;
}

/// What all have together that are refined side by side.
Result ResultOf(std::vector<RefinedMesh> pieces, const Task& task)
{
  Rendezvous rendezvous(static_cast<int>(pieces.size()));
  std::vector<char> fits(pieces.size());
  std::vector<std::optional<skd::HangingNodes>> hanging(pieces.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        const Threads processes(rendezvous, static_cast<int>(i));
        bool fit = false;
        hanging[i].emplace(Refine(pieces[i], task, &processes, fit));
        fits[i] = fit;
      });
  }
  Result result;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    threads[i].join();
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    AddTo(result, pieces[i], *hanging[i]);
    EXPECT_EQ(fits[i], fits[0]);
  }
  result.Fits = fits[0] != 0;
  return result;
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

void ExpectSameOfPieces(
  const RefinedMesh& mesh, const Task& task, const std::vector<std::uint32_t>& counts = { 2, 3, 5 })
{
  const Result expected = ResultOf(mesh, task);
  EXPECT_TRUE(expected.Fits);
  EXPECT_GT(expected.Cells.size(), 2u * mesh.NumberOfCells());
  for (const std::uint32_t count : counts)
  {
    for (const bool isInRows : { true, false })
    {
      const Result together = ResultOf(PiecesOf(mesh, count, isInRows), task);
      EXPECT_TRUE(together.Fits);
      EXPECT_EQ(together.Cells, expected.Cells) << count << isInRows;
      EXPECT_EQ(together.Corners, expected.Corners) << count << isInRows;
    }
  }
}

using skd::Contact;

struct Rule
{
  bool IsRegular;
  Contact Balance;
  int Layers;
};

/// Each once, for what takes long.
std::vector<Rule> SomeRules()
{
  return { { false, Contact::None, 1 }, { true, Contact::None, 1 }, { true, Contact::Face, 0 },
    { true, Contact::Edge, 0 }, { true, Contact::Corner, 0 } };
}

std::vector<Rule> AllRules()
{
  std::vector<Rule> rules = { { false, Contact::None, 0 }, { false, Contact::None, 2 } };
  for (const Contact balance : { Contact::None, Contact::Face, Contact::Edge, Contact::Corner })
  {
    rules.push_back({ true, balance, 0 });
    rules.push_back({ true, balance, 1 });
  }
  return rules;
}

/// Bricks, cut into tetrahedra, wedges or, from their middle (8), pyramids.
RefinedMesh MakeSolids(std::uint32_t n, skd::CellKind kind)
{
  const RefinedMesh bricks = MakeBricks(n);
  RefinedMesh mesh;
  for (std::uint32_t node = 0; node < bricks.NumberOfNodes(); ++node)
  {
    mesh.AddNode(bricks.FlatPoint(node));
  }
  for (std::uint32_t brick = 0; brick < bricks.NumberOfCells(); ++brick)
  {
    const RefinedMesh::Nodes nodes = bricks.NodesOf(brick);
    mesh.AddNode(0.5 * (bricks.FlatPoint(nodes[0]) + bricks.FlatPoint(nodes[6])));
  }
  const auto add = [&](std::uint32_t brick, const std::vector<int>& corners)
  {
    std::vector<std::uint32_t> nodes;
    for (const int corner : corners)
    {
      nodes.push_back(corner == 8 ? bricks.NumberOfNodes() + brick : bricks.NodesOf(brick)[corner]);
    }
    mesh.AddCell(kind, nodes.data(), static_cast<std::uint32_t>(nodes.size()), brick, 0);
  };
  for (std::uint32_t brick = 0; brick < bricks.NumberOfCells(); ++brick)
  {
    if (kind == skd::CellKind::Wedge)
    {
      add(brick, { 0, 1, 2, 4, 5, 6 });
      add(brick, { 0, 2, 3, 4, 6, 7 });
    }
    else if (kind == skd::CellKind::Pyramid)
    {
      for (const auto& base : { std::vector{ 0, 1, 2, 3, 8 }, { 7, 6, 5, 4, 8 }, { 0, 4, 5, 1, 8 },
             { 3, 2, 6, 7, 8 }, { 0, 3, 7, 4, 8 }, { 1, 5, 6, 2, 8 } })
      {
        add(brick, base);
      }
    }
    else
    {
      for (const auto& [a, b] :
        { std::pair{ 1, 2 }, { 2, 3 }, { 3, 7 }, { 7, 4 }, { 4, 5 }, { 5, 1 } })
      {
        add(brick, { 0, a, b, 6 });
      }
    }
  }
  return mesh;
}

/// A square's squares, and lines along one side.
RefinedMesh MakePolygons(std::uint32_t n)
{
  RefinedMesh mesh;
  const RefinedMesh triangles = MakeSquare(n);
  for (std::uint32_t node = 0; node < triangles.NumberOfNodes(); ++node)
  {
    mesh.AddNode(triangles.FlatPoint(node));
  }
  for (std::uint32_t i = 0; i < n * n; ++i)
  {
    const std::uint32_t a = i / n * (n + 1) + i % n;
    const std::uint32_t cell[4] = { a, a + 1, a + n + 2, a + n + 1 };
    mesh.AddCell(skd::CellKind::Polygon, cell, 4, i, 0);
    if (i < n)
    {
      mesh.AddCell(skd::CellKind::Line, cell, 2, i, 0);
    }
  }
  return mesh;
}

TEST(SharedCuts, OfSurfacesAreThoseOfTheWhole)
{
  for (const Rule& rule : AllRules())
  {
    const Task task{ { { 2.9, 3.1, 0.0 } }, 0.8, 4, rule.Layers, rule.IsRegular, rule.Balance };
    ExpectSameOfPieces(MakeSquare(6), task);
    ExpectSameOfPieces(MakePolygons(6), task);
  }
}

TEST(SharedCuts, OfVolumesAreThoseOfTheWhole)
{
  for (const Rule& rule : AllRules())
  {
    const Task task{ { { 1.7, 1.6, 1.4 } }, 0.95, 2, rule.Layers, rule.IsRegular, rule.Balance };
    ExpectSameOfPieces(MakeBricks(3), task);
  }
}

TEST(SharedCuts, OfSolidsOfAllKindsAreThoseOfTheWhole)
{
  for (const skd::CellKind kind :
    { skd::CellKind::Tetrahedron, skd::CellKind::Pyramid, skd::CellKind::Wedge })
  {
    for (const Rule& rule : SomeRules())
    {
      const Task task{ { { 1.1, 1.05, 1.0 } }, 0.3, 3, rule.Layers, rule.IsRegular, rule.Balance };
      ExpectSameOfPieces(MakeSolids(2, kind), task, { 3 });
    }
  }
}

/// Cells that have no more of the border than an edge, or the corner of a piece, place nodes as
/// those do that have it.
TEST(SharedCuts, NodesOfTheBorderAreThoseOfTheWhole)
{
  for (const bool isRegular : { false, true })
  {
    const Task task{ { { 0.1, 1.2, 1.1 } }, 1.0, 2, 0, isRegular, Contact::None, true };
    ExpectSameOfPieces(MakeBricks(3), task);
    ExpectSameOfPieces(MakeSolids(2, skd::CellKind::Tetrahedron), task);
  }
}

/// Cells that several pieces have are one cell: their faces are no border for that reason, nor are
/// they inside for it.
TEST(SharedCuts, NodesOfTheBorderAreThoseOfTheWholeWhereSeveralHaveACell)
{
  for (const bool isRegular : { false, true })
  {
    const Task task{ { { 0.1, 1.2, 1.1 } }, 1.0, 2, 0, isRegular, Contact::None, true };
    for (const RefinedMesh& mesh : { MakeBricks(3), MakeSolids(2, skd::CellKind::Tetrahedron),
           MakeSolids(2, skd::CellKind::Wedge), MakeSolids(2, skd::CellKind::Pyramid) })
    {
      const auto expected = ResultOf(mesh, task).Corners;
      const std::uint32_t n = mesh.NumberOfCells();
      const auto some = [&](std::uint32_t first, std::uint32_t last, std::uint32_t step)
      {
        return PieceOf(mesh,
          [=](std::uint32_t cell)
          { return first <= cell && cell < last && (cell - first) % step == 0; });
      };
      EXPECT_EQ(ResultOf({ mesh, mesh }, task).Corners, expected);
      EXPECT_EQ(ResultOf({ mesh, some(0, n, 2) }, task).Corners, expected);
      EXPECT_EQ(ResultOf({ some(0, 2 * n / 3, 1), some(n / 3, n, 1) }, task).Corners, expected);
      EXPECT_EQ(ResultOf({ some(0, n / 2, 1), some(n / 2, n, 1), some(n / 4, n, 3) }, task).Corners,
        expected);
    }
  }
}

/// A node that is in the middle of an edge from the beginning is not the one that is made there.
TEST(SharedCuts, NodesThatHangFromTheBeginningStayApart)
{
  RefinedMesh mesh;
  const double x[7][2] = { { 0, 0 }, { 4, 0 }, { 2, 4 }, { 2, 0 }, { 0, -3 }, { 4, -3 },
    { 2, -3 } };
  for (const auto& at : x)
  {
    mesh.AddNode({ { at[0], at[1], 0.0 } });
  }
  const std::uint32_t cells[5][3] = { { 0, 1, 2 }, { 0, 4, 3 }, { 4, 6, 3 }, { 6, 5, 3 },
    { 5, 1, 3 } };
  for (std::uint32_t cell = 0; cell < 5; ++cell)
  {
    mesh.AddCell(skd::CellKind::Triangle, cells[cell], 3, cell, 0);
  }
  for (const bool isRegular : { false, true })
  {
    ExpectSameOfPieces(mesh, { { { 2.0, 4.0, 0.0 } }, 2.5, 4, 0, isRegular, Contact::Corner });
  }
}

/// A quadrilateral between two volume cells is cut as their faces are, also where it is alone.
TEST(SharedCuts, QuadrilateralsOnFacesOfOthersAreCutAsThose)
{
  RefinedMesh mesh = MakeBricks(2);
  const std::uint32_t inner[4] = { 1, 4, 13, 10 }; // at x = 1.1
  mesh.AddCell(skd::CellKind::Polygon, inner, 4, 8, 0);
  for (const bool isRegular : { false, true })
  {
    const Task task{ { { 1.1, 0.5, 0.5 } }, 0.8, 3, 0, isRegular, Contact::None, true };
    const Result expected = ResultOf(mesh, task);
    const Result together =
      ResultOf({ PieceOf(mesh, [](std::uint32_t cell) { return cell < 8; }),
                 PieceOf(mesh, [](std::uint32_t cell) { return cell == 8; }) },
        task);
    EXPECT_EQ(together.Cells, expected.Cells);
    EXPECT_EQ(together.Corners, expected.Corners);
  }
}

TEST(SharedCuts, TheLimitOfOneStopsAllAtTheSameRound)
{
  Task task{ { { 2.9, 3.1, 0.0 } }, 0.8, 6 };
  task.Limit = 100;
  const Result together = ResultOf(PiecesOf(MakeSquare(6), 3, true), task);
  EXPECT_FALSE(together.Fits);
  // What there is fits together: every inner edge has two triangles.
  std::map<std::set<Vector3>, int> edges;
  for (const std::set<Vector3>& shape : together.Cells)
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
  EXPECT_GT(together.Cells.size(), 72u);
}

}
