// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSpreadSolids.h"

#include "Bodies/SkdEdgeTable.h"
#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/Predicates/ExactScale.h"
#include "Core/Search/Tree/PackedRTree.h"
#include "Exchange/SkdAskOthers.h"
#include "Exchange/SkdPieceNumbers.h"
#include "Pipeline/SkdLoop.h"
#include "Solids/Boolean/SkdAlignFaces.h"
#include "Solids/Boolean/SkdArrangement.h"
#include "Solids/Boolean/SkdBooleanNames.h"
#include "Solids/Boolean/SkdEdgeSums.h"
#include "Solids/Boolean/SkdFlushFaces.h"
#include "vtkCellData.h"

#include <algorithm>
#include <limits>
#include <map>

namespace skdtree
{
namespace
{
using Sources = std::array<const SkdSpreadSource*, 2>;
using Destinations = std::array<SkdRowsByProcess<vtkIdType>, 2>; // of each input, by process

/// By how much boxes of cells are larger that may meet, relative to the largest coordinate: units
/// in the last place of doubles, or of floats.
constexpr double MarginOfDoubles = 64.0 * std::numeric_limits<double>::epsilon();
constexpr double MarginOfFloats = 16.0 * std::numeric_limits<float>::epsilon();

constexpr std::uint32_t None = 0xffffffffu;

/// What a process has.
struct Facts
{
  int IsUnfit = 0;
  skd::Box3 Bounds;
  double Largest = 0.0;
  double Least = std::numeric_limits<double>::infinity();
  int Bits[2] = { SkdFlushFaces::BitsOfDouble, SkdFlushFaces::BitsOfDouble }; // of coordinates
  SkdEdgeSums Edges[2];

  void Add(const Facts& other)
  {
    this->IsUnfit = std::max(this->IsUnfit, other.IsUnfit);
    this->Bounds.Add(other.Bounds);
    this->Largest = std::max(this->Largest, other.Largest);
    this->Least = std::min(this->Least, other.Least);
    this->Bits[0] = std::min(this->Bits[0], other.Bits[0]);
    this->Bits[1] = std::min(this->Bits[1], other.Bits[1]);
    this->Edges[0].Add(other.Edges[0]);
    this->Edges[1].Add(other.Edges[1]);
  }

  /// Of all processes.
  bool AreFit() const
  {
    return this->IsUnfit == 0 && skd::ExactScale(this->Largest) == 1.0 &&
      !(this->Least < skd::LeastExactCoordinate * this->Largest) && this->Edges[0].AreZero() &&
      this->Edges[1].AreZero();
  }
};

/// A triangle of another process, or for one.
struct FarTriangle
{
  std::array<skd::Vector3, 3> Corners;
  int Input;
};

/// A box that has some of the cells of a process which meet others, and how many.
struct Cluster
{
  skd::Box3 Box;
  std::uint64_t Number;
};

class Dealer
{
public:
  Dealer(const Sources& sources, double chordalDeviation, vtkAlgorithm* filter)
    : Given(sources)
    , Transport(sources[0]->GetTransport())
    , Filter(filter)
    , Blocks(SkdMakeBooleanBlocks(sources[0]->GetOwn(), sources[1]->GetOwn()))
    , Ids(SkdJoinedIdsOf(this->Blocks.All))
  {
    this->Set.Update(this->Blocks.All, chordalDeviation);
    this->Set.LeaveOutCopies(1);
    this->FindOwn();
  }

  /// Where this process's cells go: those that stay, and those that meet others.
  SkdDealt Find(Destinations& staying, Destinations& inContact)
  {
    const SkdPlacement placement = SkdMakePlacement(this->Set, nullptr, std::nullopt);
    if (!this->AreFit(placement))
    {
      return SkdDealt::Unfit;
    }
    this->FindBoxes();
    this->FindContacts();
    if (SkdMostOf(this->Transport, SkdIsAborted(this->Filter) ? 1 : 0) > 0)
    {
      return SkdDealt::Aborted;
    }
    this->ListDestinations(staying, inContact);
    return SkdDealt::Done;
  }

  /// Of all processes: the middle of the bounds of cells, and the least bits of each input.
  const skd::Vector3& GetCenter() const { return this->Center; }
  const std::vector<int>& GetBits() const { return this->Bits; }

private:
  int InputOf(const SkdTriangleSet::Cell& cell) const
  {
    return cell.Block < this->Blocks.FirstOfSource ? 0 : 1;
  }

  vtkIdType IdOf(const SkdTriangleSet::Cell& cell) const
  {
    return this->Ids[static_cast<std::size_t>(cell.Block)].Of(cell.Id);
  }

  bool IsOwn(std::uint32_t triangle) const
  {
    return this->Slots[this->Set.GetCellOf(triangle)] != None;
  }

  /// Each process also has cells of others, that reach the bounds of the whole.
  void FindOwn()
  {
    std::array<std::vector<vtkIdType>, 2> ids;
    for (int i = 0; i < 2; ++i)
    {
      this->Given[i]->VisitBlocks(
        [&](const SkdSpreadBlock& block) { ids[i] = block.ListOwnIds(); });
    }
    for (std::uint32_t i = 0; i < this->Set.GetCells().size(); ++i)
    {
      const SkdTriangleSet::Cell& cell = this->Set.GetCells()[i];
      const std::vector<vtkIdType>& own = ids[this->InputOf(cell)];
      const bool isOwn = std::binary_search(own.begin(), own.end(), this->IdOf(cell));
      this->Slots.push_back(isOwn ? static_cast<std::uint32_t>(this->Own.size()) : None);
      if (isOwn)
      {
        this->Own.push_back(i);
      }
    }
    this->HasContact.assign(this->Own.size(), false);
  }

  bool HasFaceNumbers() const
  {
    return std::any_of(this->Blocks.All.begin(), this->Blocks.All.end(),
      [](const SkdBlock& block)
      { return block.Mesh->GetCellData()->HasArray(SkdBooleanNames::Face) != 0; });
  }

  bool AreFit(const SkdPlacement& placement)
  {
    Facts facts;
    facts.IsUnfit = this->Blocks.All.size() != 2 || this->Given[0]->GetBlocks().size() != 1 ||
      this->Given[1]->GetBlocks().size() != 1 || this->Set.GetChordalLength() > 0.0 ||
      this->Set.GetNumberOfFacesLeftOut() > 0 || placement.CountWithoutArea() > 0 ||
      placement.HasTinyPoints || !this->Set.GetCopiesLeftOut().empty() || this->HasFaceNumbers();
    facts.Bounds = this->Set.GetBounds();
    facts.Largest = this->Set.GetLargestCoordinate();
    facts.Least = this->Set.GetLeastCoordinate();
    const std::vector<int> bits = SkdCoordinateBits(this->Blocks.All);
    std::copy_n(bits.begin(), std::min<std::size_t>(bits.size(), 2), facts.Bits);
    for (std::uint32_t triangle = 0; triangle < this->Set.GetTriangles().size(); ++triangle)
    {
      const SkdTriangleSet::Cell& cell = this->Set.GetCells()[this->Set.GetCellOf(triangle)];
      const auto x = placement.First.GetCornerPoints(triangle);
      for (std::size_t i = 0; i < 3 && this->IsOwn(triangle); ++i)
      {
        facts.Edges[this->InputOf(cell)].Add(x[i], x[(i + 1) % 3]);
      }
    }
    Facts all;
    for (const std::vector<Facts>& told :
      SkdGatherRows(this->Transport, std::vector<Facts>{ facts }))
    {
      all.Add(told.front());
    }
    this->Center = 0.5 * (all.Bounds.Min + all.Bounds.Max);
    this->Bits.assign(std::begin(all.Bits), std::end(all.Bits));
    const bool areFloats =
      std::count(this->Bits.begin(), this->Bits.end(), SkdFlushFaces::BitsOfFloat) > 0;
    this->Margin = (areFloats ? MarginOfFloats : MarginOfDoubles) * all.Largest;
    return all.AreFit();
  }

  void FindBoxes()
  {
    this->Boxes.resize(this->Own.size());
    for (std::uint32_t triangle = 0; triangle < this->Set.GetTriangles().size(); ++triangle)
    {
      for (std::size_t i = 0; i < 3 && this->IsOwn(triangle); ++i)
      {
        this->Boxes[this->Slots[this->Set.GetCellOf(triangle)]].Add(
          this->Set.GetPoints()[this->Set.GetTriangles()[triangle][i]]);
      }
    }
    for (skd::Box3& box : this->Boxes)
    {
      box = box.Inflated(this->Margin);
    }
  }

  /// Triangles of other processes that may be in contact with own ones.
  std::vector<FarTriangle> BringBorder() const
  {
    const SkdCut cut(this->Transport, this->Boxes);
    SkdRowsByProcess<FarTriangle> rows(static_cast<std::size_t>(this->Transport.GetNumber()));
    std::vector<int> processes;
    for (std::uint32_t triangle = 0; triangle < this->Set.GetTriangles().size(); ++triangle)
    {
      if (this->IsOwn(triangle))
      {
        cut.FindOverlapping(this->Boxes[this->Slots[this->Set.GetCellOf(triangle)]], processes);
        for (const int process : processes)
        {
          rows[static_cast<std::size_t>(process)].push_back(this->Get(triangle));
        }
      }
    }
    rows[static_cast<std::size_t>(this->Transport.GetRank())].clear();
    std::vector<FarTriangle> border;
    for (const std::vector<FarTriangle>& some : SkdExchangeRows(this->Transport, rows))
    {
      border.insert(border.end(), some.begin(), some.end());
    }
    return border;
  }

  FarTriangle Get(std::uint32_t triangle) const
  {
    const SkdTriangleSet::Corners& corners = this->Set.GetTriangles()[triangle];
    const SkdTriangleSet::PointList& points = this->Set.GetPoints();
    return { { points[corners[0]], points[corners[1]], points[corners[2]] },
      this->InputOf(this->Set.GetCells()[this->Set.GetCellOf(triangle)]) };
  }

  /// The own triangles and, behind them, others; gets the slot of the cell that each is of.
  SkdTriangleSet MakeBordered(
    const std::vector<FarTriangle>& border, std::vector<std::uint32_t>& slots) const
  {
    SkdReadTriangles made;
    const auto add = [&](const FarTriangle& x, std::uint32_t slot, const SkdTriangleCell& cell)
    {
      const auto first = static_cast<std::uint32_t>(made.Points.size());
      for (const skd::Vector3& corner : x.Corners)
      {
        made.Points.push_back(corner);
        made.Origins.push_back({ cell.Block, -1 });
      }
      made.Triangles.push_back({ first, first + 1, first + 2 });
      made.Cells.push_back(cell);
      made.CellOf.push_back(static_cast<std::uint32_t>(slots.size()));
      slots.push_back(slot);
    };
    for (std::uint32_t triangle = 0; triangle < this->Set.GetTriangles().size(); ++triangle)
    {
      if (this->IsOwn(triangle))
      {
        add(this->Get(triangle), this->Slots[this->Set.GetCellOf(triangle)],
          { 0, static_cast<vtkIdType>(triangle) });
      }
    }
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      add(border[i], None, { 1, static_cast<vtkIdType>(i) });
    }
    SkdTriangleSet set(std::move(made));
    set.LeaveOutCopies(1);
    return set;
  }

  /// Own cells whose boxes overlap those of the other input: faces that are flush but for rounding
  /// may be in no contact.
  void MarkNear(const std::vector<FarTriangle>& border)
  {
    std::vector<skd::Box3> boxes;
    for (const FarTriangle& triangle : border)
    {
      boxes.emplace_back();
      for (const skd::Vector3& corner : triangle.Corners)
      {
        boxes.back().Add(corner);
      }
    }
    const skd::PackedRTree tree(boxes);
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      const int own = this->InputOf(this->Set.GetCells()[this->Own[i]]);
      tree.ForEachOverlapping(this->Boxes[i],
        [&](std::uint32_t k)
        {
          this->HasContact[i] =
            this->HasContact[i] || (border[k].Input != own && boxes[k].Overlaps(this->Boxes[i]));
        });
    }
  }

  /// Own cells that are in contact with others which are not their neighbours, or at an edge that
  /// more than two triangles have: their order around it matters.
  void FindContacts()
  {
    const std::vector<FarTriangle> border = this->BringBorder();
    this->MarkNear(border);
    std::vector<std::uint32_t> slots;
    SkdTriangleSet set = this->MakeBordered(border, slots);
    const auto mark = [&](std::uint32_t triangle)
    {
      if (slots[triangle] != None)
      {
        this->HasContact[slots[triangle]] = true;
      }
    };
    SkdLoop loop(this->Filter, 0, 0.0, 0.2, 8);
    const SkdPlacement placement = SkdMakePlacement(set, nullptr, std::nullopt);
    const auto pairs = SkdFindSelfPairs(set, placement, loop, this->Filter);
    if (!pairs)
    {
      return; // aborted
    }
    for (const SkdTrianglePair& pair : pairs->Pairs)
    {
      mark(pair.First);
      mark(pair.Second);
    }
    for (const SkdDuplicate& duplicate : pairs->Duplicates)
    {
      mark(duplicate.Original);
      mark(duplicate.Triangle);
    }
    const std::vector<SkdTriangleSet::Corners> triangles(
      set.GetTriangles().begin(), set.GetTriangles().end());
    SkdMakeEdgeTable(triangles, set.GetPoints().size())
      .ForEach(
        [&](std::uint32_t, const SkdEdgeUse* first, const SkdEdgeUse* last)
        {
          for (const SkdEdgeUse* use = first; use != last && last - first > 2; ++use)
          {
            mark(use->Triangle);
          }
        });
  }

  /// Of the boxes of cells that meet others, a few that have them all.
  std::vector<Cluster> MakeClusters() const
  {
    std::vector<skd::Box3> boxes;
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      if (this->HasContact[i])
      {
        boxes.push_back(this->Boxes[i]);
      }
    }
    std::vector<Cluster> clusters;
    for (const skd::Box3& box : SkdCoverOf(boxes))
    {
      clusters.push_back({ box, 0 });
    }
    for (const skd::Box3& box : boxes)
    {
      ++clusters[IndexOf(clusters, box)].Number;
    }
    return clusters;
  }

  static std::size_t IndexOf(const std::vector<Cluster>& clusters, const skd::Box3& box)
  {
    return static_cast<std::size_t>(
      std::find_if(clusters.begin(), clusters.end(),
        [&box](const Cluster& cluster) { return cluster.Box.Contains(box); }) -
      clusters.begin());
  }

  /// The process that gets each of the own clusters: of those that hang together by boxes, which
  /// has most of their cells.
  std::vector<int> FindProcesses(const std::vector<Cluster>& own) const
  {
    const SkdRowsByProcess<Cluster> all = SkdGatherRows(this->Transport, own);
    std::vector<std::pair<Cluster, int>> clusters;
    std::size_t firstOwn = 0;
    for (std::size_t process = 0; process < all.size(); ++process)
    {
      firstOwn =
        static_cast<int>(process) == this->Transport.GetRank() ? clusters.size() : firstOwn;
      for (const Cluster& cluster : all[process])
      {
        clusters.emplace_back(cluster, static_cast<int>(process));
      }
    }
    skd::DisjointSets<> sets = UniteOverlapping(clusters);
    std::map<std::uint32_t, std::map<int, std::uint64_t>> numbers; // by set and process
    for (std::uint32_t i = 0; i < clusters.size(); ++i)
    {
      numbers[sets.Find(i)][clusters[i].second] += clusters[i].first.Number;
    }
    std::vector<int> processes;
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      const auto& ofSet = numbers[sets.Find(static_cast<std::uint32_t>(firstOwn + i))];
      processes.push_back(std::max_element(ofSet.begin(), ofSet.end(),
        [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first);
    }
    return processes;
  }

  static skd::DisjointSets<> UniteOverlapping(const std::vector<std::pair<Cluster, int>>& clusters)
  {
    std::vector<skd::Box3> boxes;
    for (const auto& [cluster, process] : clusters)
    {
      boxes.push_back(cluster.Box);
    }
    skd::DisjointSets<> sets(boxes.size());
    const skd::PackedRTree tree(boxes);
    for (std::uint32_t a = 0; a < boxes.size(); ++a)
    {
      tree.ForEachOverlapping(boxes[a],
        [&](std::uint32_t b)
        {
          if (boxes[a].Overlaps(boxes[b]))
          {
            sets.Unite(a, b);
          }
        });
    }
    return sets;
  }

  void ListDestinations(Destinations& staying, Destinations& inContact) const
  {
    const std::vector<Cluster> clusters = this->MakeClusters();
    const std::vector<int> processes = this->FindProcesses(clusters);
    for (int i = 0; i < 2; ++i)
    {
      staying[i].resize(static_cast<std::size_t>(this->Transport.GetNumber()));
      inContact[i].resize(staying[i].size());
    }
    for (std::size_t i = 0; i < this->Own.size(); ++i)
    {
      const SkdTriangleSet::Cell& cell = this->Set.GetCells()[this->Own[i]];
      const auto input = static_cast<std::size_t>(this->InputOf(cell));
      const auto process =
        static_cast<std::size_t>(this->HasContact[i] ? processes[IndexOf(clusters, this->Boxes[i])]
                                                     : this->Transport.GetRank());
      (this->HasContact[i] ? inContact : staying)[input][process].push_back(this->IdOf(cell));
    }
  }

  const Sources& Given;
  SkdTransport& Transport;
  vtkAlgorithm* const Filter;
  const SkdBooleanBlocks Blocks;       // what this process has
  const std::vector<SkdJoinedIds> Ids; // of its cells
  SkdTriangleSet Set;
  std::vector<int> Bits;
  double Margin = 0.0; // of boxes
  skd::Vector3 Center{};
  std::vector<std::uint32_t> Own;   // the cells of the set that this process counts
  std::vector<std::uint32_t> Slots; // of each cell of the set its place among these, or None
  std::vector<bool> HasContact;     // by own cell
  std::vector<skd::Box3> Boxes;     // the same
};

/// The ids in all rows, ascending.
std::vector<vtkIdType> Joined(const SkdRowsByProcess<vtkIdType>& rows)
{
  std::vector<vtkIdType> all;
  for (const std::vector<vtkIdType>& some : rows)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}
}

SkdDealt SkdSpreadSolids::Update(const SkdSpreadSource& input, const SkdSpreadSource& source,
  double chordalDeviation, vtkAlgorithm* filter)
{
  const Sources sources{ { &input, &source } };
  const bool isKnown = this->Known[0] == input.GetOwn() && this->Known[1] == source.GetOwn() &&
    this->KnownDeviation == chordalDeviation; // the same on all processes
  if (isKnown && this->Result != SkdDealt::Aborted)
  {
    return this->Result;
  }
  *this = SkdSpreadSolids();
  this->Known = { { input.GetOwn(), source.GetOwn() } };
  this->KnownDeviation = chordalDeviation;
  Destinations staying;
  Destinations inContact;
  Dealer dealer(sources, chordalDeviation, filter);
  this->Result = dealer.Find(staying, inContact);
  this->Center = dealer.GetCenter();
  this->CoordinateBits = dealer.GetBits();
  SkdTransport& transport = input.GetTransport();
  for (std::size_t i = 0; i < 2 && this->Result == SkdDealt::Done; ++i)
  {
    const SkdRowsByProcess<vtkIdType> coming = SkdExchangeRows(transport, inContact[i]);
    SkdRowsByProcess<vtkIdType> wanted = coming;
    std::vector<vtkIdType>& own = wanted[static_cast<std::size_t>(transport.GetRank())];
    const std::vector<vtkIdType> stays = Joined(staying[i]);
    own.insert(own.end(), stays.begin(), stays.end());
    std::sort(own.begin(), own.end());
    this->InContact[i] = Joined(coming);
    this->NumberInContact += static_cast<vtkIdType>(this->InContact[i].size());
    sources[i]->VisitBlocks(
      [&](const SkdSpreadBlock& block)
      {
        this->NumbersOfCells[i] = block.GetNumberOfCells();
        this->Meshes[i] = block.BringOnly(transport, wanted);
      });
  }
  if (this->Result == SkdDealt::Done)
  {
    this->Blocks = SkdMakeBooleanBlocks(this->Meshes[0], this->Meshes[1]);
    this->NumberInContact = SkdSumOver(transport, { this->NumberInContact }).front().All;
  }
  return this->Result;
}

std::vector<std::uint32_t> SkdSpreadSolids::ListInContact(const SkdTriangleSet& set) const
{
  const std::vector<SkdJoinedIds> joined = SkdJoinedIdsOf(this->Blocks.All);
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t triangle = 0; triangle < set.GetTriangles().size(); ++triangle)
  {
    const SkdTriangleSet::Cell& cell = set.GetCells()[set.GetCellOf(triangle)];
    const auto& ids = this->InContact[cell.Block < this->Blocks.FirstOfSource ? 0 : 1];
    const vtkIdType id = joined[static_cast<std::size_t>(cell.Block)].Of(cell.Id);
    if (std::binary_search(ids.begin(), ids.end(), id))
    {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}
}
