// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdLeafFilters.h"

#include "Cells/Search/SkdLeafPlanes.h"
#include "Core/Search/LeafFilters/PlaneLeafFilter.h"
#include "Core/Search/LeafFilters/TriangleLeafFilters.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace skdtree
{
namespace
{
using Node = skd::Node<3>;

skd::QuantizationGrid QuantizationGridOf(const Node& leaf)
{
  skd::FloatBox<3> box = leaf.Boxes.Get(0);
  for (int lane = 1; lane < leaf.Count; ++lane)
  {
    skd::Enclose(box, leaf.Boxes.Get(lane));
  }
  return skd::QuantizationGrid(box);
}

skd::QuantizedCorners<2> QuantizedBoxesOf(const Node& leaf, const skd::QuantizationGrid& grid)
{
  skd::QuantizedCorners<2> boxes;
  boxes.Grid = grid;
  for (int lane = 0; lane < Node::Width; ++lane)
  {
    const skd::FloatBox<3> box = leaf.Boxes.Get(lane < leaf.Count ? lane : 0);
    boxes.Set(0, lane, { { box.Min[0], box.Min[1], box.Min[2] } });
    boxes.Set(1, lane, { { box.Max[0], box.Max[1], box.Max[2] } });
  }
  return boxes;
}

constexpr std::size_t NumberOfPieces = 64;

/// Calls body(piece, first, last) in parallel for pieces of 0 .. count - 1, always the same.
template <class Body>
void ForEachPiece(std::uint64_t count, const Body& body)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(NumberOfPieces), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto piece = static_cast<std::uint64_t>(begin); piece < static_cast<std::uint64_t>(end);
           ++piece)
      {
        body(piece, static_cast<std::uint32_t>(count * piece / NumberOfPieces),
          static_cast<std::uint32_t>(count * (piece + 1) / NumberOfPieces));
      }
    });
}

/// The points of a leaf's triangles, each once; in meshes whose cells do not share them, those that
/// have the same coordinates. (To compare these in all meshes makes builds 8 % slower.)
struct SharedPoints
{
  const SkdCellStore& Store;
  bool AreCompared = this->Store.GetNumberOfPoints() > vtkIdType(this->Store.NumberOfCells());
  std::uint32_t Ids[3 * skd::TrianglePacket::Width];
  std::uint32_t Count = 0;

  std::uint8_t SlotOf(std::uint32_t id)
  {
    std::uint32_t* const end = this->Ids + this->Count;
    const std::uint32_t* found =
      this->AreCompared ? this->FindLike(id) : std::find(this->Ids, end, id);
    if (found == end)
    {
      this->Ids[this->Count++] = id;
    }
    return static_cast<std::uint8_t>(found - this->Ids);
  }

private:
  /// To the last bit.
  SKD_NOINLINE const std::uint32_t* FindLike(std::uint32_t id) const
  {
    const auto isLike = [this, x = this->Store.Point(id)](std::uint32_t other)
    {
      const skd::Vector3 y = this->Store.Point(other);
      return std::equal(x.X, x.X + 3, y.X,
        [](double a, double b) { return a == b && std::signbit(a) == std::signbit(b); });
    };
    return std::find_if(this->Ids, this->Ids + this->Count, isLike);
  }
};
}

//------------------------------------------------------------------------------
class SkdLeafFilters::Arrays
{
public:
  Arrays(const SkdCellStore& store, skd::Tree<3>& tree, double rounding);

  skd::TrianglePackets ViewTriangles() const
  {
    return { this->Triangles.data(),
      { { this->FloatPoints.empty() ? nullptr : this->FloatPoints.data(),
        this->Points.empty() ? nullptr : this->Points.data() } } };
  }
  skd::PlanePackets ViewPlanes() const
  {
    return { this->PlanePackets.data(), this->PlanePackets.empty() ? this->Boxes.data() : nullptr,
      this->Rows.data(), this->CommonRows, this->Slabs.empty() ? nullptr : this->Slabs.data() };
  }
  skd::LeafCorners ViewCorners() const;
  std::size_t MemorySize() const;

private:
  // A tag is twice the number of a packet of triangles, or of a packet of planes and 1 more. If all
  // leaves have packets, or all packets of planes, these have the numbers of the nodes, and inner
  // nodes have a note about those of their children.

  /// Of leaves, and of those that have a packet of either kind.
  struct Counts
  {
    std::uint32_t Leaves = 0;
    std::uint32_t Packets = 0;
    std::uint32_t PlanePackets = 0;
    std::uint32_t LeastRows = std::numeric_limits<std::uint32_t>::max(); // of the latter
    std::uint32_t MostRows = 0;
  };

  /// Tags leaves for a packet, or with the number of rows that they need.
  static Counts Census(const SkdCellStore& store, skd::Tree<3>& tree);
  static void CountIn(
    const SkdCellStore& store, skd::Tree<3>& tree, std::uint32_t index, Counts& counts);
  /// Gives packets their numbers, but packets of all leaves, which take theirs when
  /// they are filled. Whether the numbers are those of the leaves.
  bool Number(const SkdCellStore& store, skd::Tree<3>& tree, const Counts& counts);
  void NumberRows();
  void FillTriangles(const SkdCellStore& store, const skd::Tree<3>& tree, const skd::Node<3>& leaf);
  void FillPoints(const SkdCellStore& store, const skd::Tree<3>& tree);
  /// `firsts`: where the points of each piece of the packets begin.
  template <class Real>
  void CopyPoints(const SkdCellStore& store, const skd::Tree<3>& tree,
    const std::vector<std::uint64_t>& firsts, skd::RawVector<Real>& points);
  void FillPlanes(
    const SkdCellStore& store, const skd::Tree<3>& tree, const skd::Node<3>& leaf, double rounding);

  skd::RawVector<skd::TrianglePacket> Triangles;
  skd::RawVector<float> FloatPoints; // of the packets, in turn, if all leaves have one: in
  skd::RawVector<double> Points;     // single precision or, where that is not enough, in double
  skd::RawVector<skd::PlanePacket> PlanePackets;  // unless rows are common
  skd::RawVector<skd::QuantizedCorners<2>> Boxes; // of their cells, if all leaves have one
  bool AreDropped = false;                        // the nodes of leaves
  skd::RawVector<skd::PlaneRow> Rows;             // those of a packet in turn, or
  skd::RawVector<skd::SlabPacket> Slabs;          // instead of all leaves
  std::uint32_t CommonRows = 0;                   // of each packet, if all leaves have one, or 0
};

SkdLeafFilters::SkdLeafFilters() = default;
SkdLeafFilters::SkdLeafFilters(SkdLeafFilters&&) noexcept = default;
SkdLeafFilters& SkdLeafFilters::operator=(SkdLeafFilters&&) noexcept = default;
SkdLeafFilters::~SkdLeafFilters() = default;

SkdLeafFilters::SkdLeafFilters(const SkdCellStore& store, skd::Tree<3>& tree, double rounding)
  : Stored(std::make_unique<const Arrays>(store, tree, rounding))
  , Triangles(this->Stored->ViewTriangles())
  , Planes(this->Stored->ViewPlanes())
  , Corners(this->Stored->ViewCorners())
{
}

std::size_t SkdLeafFilters::MemorySize() const
{
  return this->Stored ? sizeof(Arrays) + this->Stored->MemorySize() : 0;
}

//------------------------------------------------------------------------------
SkdLeafFilters::Arrays::Arrays(const SkdCellStore& store, skd::Tree<3>& tree, double rounding)
{
  const Counts counts = Census(store, tree);
  const bool isInOrder = this->Number(store, tree, counts);
  vtkSMPTools::For(0, static_cast<vtkIdType>(tree.NumberOfNodes()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
      {
        const Node& node = tree.Open(i);
        if (node.IsLeaf && skd::TrianglePackets::Knows(node))
        {
          if (isInOrder)
          {
            tree.SetTag(i, skd::TrianglePackets::TagOf(tree.NumberOf(node)));
          }
          this->FillTriangles(store, tree, node);
        }
        else if (node.IsLeaf && skd::PlaneLeafFilter::Knows(node))
        {
          if (isInOrder)
          {
            tree.SetTag(i, skd::PlaneLeafFilter::TagOf(tree.NumberOf(node)));
          }
          this->FillPlanes(store, tree, node, rounding);
        }
        else if (!node.IsLeaf && isInOrder)
        {
          tree.SetTag(i,
            counts.PlanePackets == 0 ? skd::TrianglePackets::TagOf(0)
                                     : skd::PlaneLeafFilter::TagOf(0));
          tree.SetNote(i, tree.LeavesBelow(node));
        }
      }
    });
  if (isInOrder)
  {
    tree.DropLeaves();
    this->AreDropped = true;
    this->FillPoints(store, tree);
    if (!this->Triangles.empty())
    {
      const skd::TrianglePackets view = this->ViewTriangles();
      tree.NoteData([&](std::uint32_t leaf)
        { return view.GetPoints().LineOf(this->Triangles[leaf].FirstPoint); });
    }
  }
}

//------------------------------------------------------------------------------
skd::LeafCorners SkdLeafFilters::Arrays::ViewCorners() const
{
  if (!this->AreDropped)
  {
    return {};
  }
  const auto larger = [](float unit, const auto& packet)
  { return std::max(unit, packet.Grid.Unit); };
  const float unit = std::accumulate(this->Triangles.begin(), this->Triangles.end(),
    std::accumulate(this->Boxes.begin(), this->Boxes.end(), 0.0f, larger), larger);
  const double widening = skd::TrianglePacket::WideningOf(unit);
  return this->Boxes.empty() ? skd::LeafCorners{ this->Triangles.data(), nullptr, widening }
                             : skd::LeafCorners{ nullptr, this->Boxes.data(), widening };
}

//------------------------------------------------------------------------------
SkdLeafFilters::Arrays::Counts SkdLeafFilters::Arrays::Census(
  const SkdCellStore& store, skd::Tree<3>& tree)
{
  std::array<Counts, NumberOfPieces> pieces;
  ForEachPiece(tree.NumberOfNodes(),
    [&](std::size_t piece, std::uint32_t first, std::uint32_t last)
    {
      Counts counts;
      for (std::uint32_t i = first; i < last; ++i)
      {
        CountIn(store, tree, i, counts);
      }
      pieces[piece] = counts;
    });
  Counts all;
  for (const Counts& counts : pieces)
  {
    all.Leaves += counts.Leaves;
    all.Packets += counts.Packets;
    all.PlanePackets += counts.PlanePackets;
    all.LeastRows = std::min(all.LeastRows, counts.LeastRows);
    all.MostRows = std::max(all.MostRows, counts.MostRows);
  }
  return all;
}

//------------------------------------------------------------------------------
void SkdLeafFilters::Arrays::CountIn(
  const SkdCellStore& store, skd::Tree<3>& tree, std::uint32_t index, Counts& counts)
{
  const Node& node = tree.Open(index);
  if (!node.IsLeaf)
  {
    return;
  }
  int least = std::numeric_limits<int>::max();
  int most = 0;
  std::uint32_t triangles = 0;
  for (std::uint32_t lane = 0; lane < node.Count; ++lane)
  {
    const std::uint32_t cell = tree.Element(node.First + lane);
    const bool isTriangle = store.ShapeOf(cell) == SkdShape::Triangle;
    const int planes = isTriangle ? 0 : SkdNumberOfPlanes(store, cell);
    least = std::min(least, planes);
    most = std::max(most, planes);
    triangles += isTriangle ? 1 : 0;
  }
  ++counts.Leaves;
  const bool haveRowsNumbers = tree.NumberOfNodes() < Node::NoTag / 2 / SkdMostPlanes;
  if (triangles == node.Count)
  {
    tree.SetTag(index, skd::TrianglePackets::TagOf(0));
    ++counts.Packets;
  }
  else if (most > 0 && least > 0 && haveRowsNumbers)
  {
    tree.SetTag(index, skd::PlaneLeafFilter::TagOf(static_cast<std::uint32_t>(most)));
    ++counts.PlanePackets;
    counts.LeastRows = std::min(counts.LeastRows, static_cast<std::uint32_t>(most));
    counts.MostRows = std::max(counts.MostRows, static_cast<std::uint32_t>(most));
  }
}

//------------------------------------------------------------------------------
bool SkdLeafFilters::Arrays::Number(
  const SkdCellStore& store, skd::Tree<3>& tree, const Counts& counts)
{
  const bool isInOrder = counts.Packets == counts.Leaves || counts.PlanePackets == counts.Leaves;
  this->Triangles.resize(counts.Packets);
  this->Boxes.resize(isInOrder ? counts.PlanePackets : 0);
  if (isInOrder && counts.LeastRows >= counts.MostRows)
  {
    const bool areSlabs = SkdFillSlabs(store);
    this->CommonRows = areSlabs ? 0 : counts.MostRows;
    this->Slabs.resize(areSlabs ? counts.PlanePackets : 0);
    this->Rows.resize(std::size_t(this->CommonRows) * counts.PlanePackets);
    return true; // packets are numbered as they are filled
  }
  this->PlanePackets.resize(counts.PlanePackets);
  std::uint32_t packets = 0;
  std::uint32_t planePackets = 0;
  for (std::uint32_t i = 0; i < tree.NumberOfNodes(); ++i)
  {
    const Node& node = tree.Open(i);
    if (!node.IsLeaf)
    {
      continue;
    }
    if (skd::TrianglePackets::Knows(node))
    {
      tree.SetTag(i, skd::TrianglePackets::TagOf(packets++));
    }
    else if (skd::PlaneLeafFilter::Knows(node))
    {
      const std::uint32_t number = isInOrder ? tree.NumberOf(node) : planePackets++;
      this->PlanePackets[number].Count = node.Tag >> 1;
      tree.SetTag(i, skd::PlaneLeafFilter::TagOf(number));
    }
  }
  this->NumberRows();
  return isInOrder;
}

//------------------------------------------------------------------------------
void SkdLeafFilters::Arrays::NumberRows()
{
  std::uint32_t rows = 0;
  for (skd::PlanePacket& packet : this->PlanePackets)
  {
    packet.FirstRow = rows;
    rows += packet.Count;
  }
  this->Rows.resize(rows);
}

//------------------------------------------------------------------------------
void SkdLeafFilters::Arrays::FillTriangles(
  const SkdCellStore& store, const skd::Tree<3>& tree, const Node& leaf)
{
  skd::TrianglePacket& packet = this->Triangles[leaf.Tag >> 1];
  packet = {};
  packet.Grid = QuantizationGridOf(leaf);
  SharedPoints shared{ store };
  for (int lane = 0; lane < Node::Width; ++lane)
  {
    // Lanes that are not in use have the box of the first triangle, and points of no triangle.
    const bool isUsed = lane < leaf.Count;
    const auto used = static_cast<std::uint32_t>(isUsed ? lane : 0);
    const std::uint32_t* ids = store.PointIdsOf(tree.Element(leaf.First + used));
    for (int corner = 0; corner < 3; ++corner)
    {
      const skd::Vector3 world = store.Point(ids[corner]);
      packet.Set(corner, lane, tree.GetFrame().Local(world));
      packet.PointOf[lane][corner] = shared.SlotOf(ids[isUsed ? corner : 0]);
    }
  }
  packet.FirstPoint = shared.Count;
}

//------------------------------------------------------------------------------
// So far, packets have said how many points they have.
void SkdLeafFilters::Arrays::FillPoints(const SkdCellStore& store, const skd::Tree<3>& tree)
{
  std::vector<std::uint64_t> firsts(NumberOfPieces);
  ForEachPiece(this->Triangles.size(),
    [&](std::size_t piece, std::uint32_t first, std::uint32_t last)
    {
      for (std::uint32_t number = first; number < last; ++number)
      {
        firsts[piece] += this->Triangles[number].FirstPoint;
      }
    });
  std::uint64_t points = 0;
  for (std::uint64_t& first : firsts)
  {
    points += std::exchange(first, points);
  }
  const std::uint64_t lanes = std::uint64_t(skd::TrianglePacket::Width) * this->Triangles.size();
  if (std::max(points, lanes) > std::numeric_limits<std::uint32_t>::max())
  {
    return; // lines then read the store
  }
  if (store.HasFloatPoints())
  {
    this->FloatPoints.resize(3 * points);
    this->CopyPoints(store, tree, firsts, this->FloatPoints);
  }
  else
  {
    this->Points.resize(3 * points);
    this->CopyPoints(store, tree, firsts, this->Points);
  }
}

//------------------------------------------------------------------------------
template <class Real>
void SkdLeafFilters::Arrays::CopyPoints(const SkdCellStore& store, const skd::Tree<3>& tree,
  const std::vector<std::uint64_t>& firsts, skd::RawVector<Real>& points)
{
  const auto copy = [&](const skd::TrianglePacket& packet, const skd::ElementRange& elements)
  {
    for (std::uint32_t lane = 0; lane < elements.Count; ++lane)
    {
      const std::uint32_t* ids = store.PointIdsOf(tree.Element(elements.First + lane));
      for (int corner = 0; corner < 3; ++corner)
      {
        const skd::Vector3 x = store.Point(ids[corner]);
        const std::size_t point = std::size_t(packet.FirstPoint) + packet.PointOf[lane][corner];
        Real* const at = points.data() + 3 * point;
        at[0] = static_cast<Real>(x[0]);
        at[1] = static_cast<Real>(x[1]);
        at[2] = static_cast<Real>(x[2]);
      }
    }
  };
  ForEachPiece(this->Triangles.size(),
    [&](std::size_t piece, std::uint32_t first, std::uint32_t last)
    {
      auto next = static_cast<std::uint32_t>(firsts[piece]);
      for (std::uint32_t number = first; number < last; ++number)
      {
        next += std::exchange(this->Triangles[number].FirstPoint, next);
        copy(this->Triangles[number], tree.LeafAt(number));
      }
    });
}

//------------------------------------------------------------------------------
void SkdLeafFilters::Arrays::FillPlanes(
  const SkdCellStore& store, const skd::Tree<3>& tree, const Node& leaf, double rounding)
{
  const std::uint32_t number = leaf.Tag >> 1;
  const skd::QuantizationGrid grid = QuantizationGridOf(leaf);
  std::size_t firstRow = std::size_t(number) * this->CommonRows;
  std::uint32_t count = this->CommonRows;
  if (!this->PlanePackets.empty())
  {
    skd::PlanePacket& packet = this->PlanePackets[number];
    packet.Grid = grid;
    firstRow = packet.FirstRow;
    count = packet.Count;
  }
  if (!this->Boxes.empty())
  {
    this->Boxes[number] = QuantizedBoxesOf(leaf, grid);
  }
  const skd::Frame<3>& frame = tree.GetFrame();
  const double margin = rounding * frame.Scale / grid.Unit + skd::PlaneRow::Rounding;
  std::uint32_t cells[Node::Width];
  for (int lane = 0; lane < leaf.Count; ++lane)
  {
    cells[lane] = tree.Element(leaf.First + static_cast<std::uint32_t>(lane));
  }
  const SkdLeafPlanes planes(store, frame, grid, margin);
  if (!this->Slabs.empty())
  {
    this->Slabs[number] = {};
    planes.Set(cells, leaf.Occupied(), this->Slabs[number]);
    return;
  }
  skd::PlaneRow* rows = this->Rows.data() + firstRow;
  std::fill_n(rows, count, skd::PlaneRow());
  planes.Set(cells, leaf.Occupied(), rows);
}

//------------------------------------------------------------------------------
std::size_t SkdLeafFilters::Arrays::MemorySize() const
{
  return this->Triangles.capacity() * sizeof(skd::TrianglePacket) +
    this->FloatPoints.capacity() * sizeof(float) + this->Points.capacity() * sizeof(double) +
    this->PlanePackets.capacity() * sizeof(skd::PlanePacket) +
    this->Boxes.capacity() * sizeof(skd::QuantizedCorners<2>) +
    this->Rows.capacity() * sizeof(skd::PlaneRow) +
    this->Slabs.capacity() * sizeof(skd::SlabPacket);
}
}
