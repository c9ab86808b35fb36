// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What leaf filters (Tree/Walk.h) look at, for those who only pass it on: what a packet is and
/// what is asked of it is in TriangleLeafFilters.h and PlaneLeafFilter.h.
#ifndef skd_LeafFilters_LeafPackets_h
#define skd_LeafFilters_LeafPackets_h

#include "../../Geometry/PointArray.h"
#include "../Tree/TreeView.h"

#include <cstddef>
#include <cstdint>

namespace skd
{

struct TrianglePacket;
template <int Number>
struct QuantizedCorners;
struct PlanePacket;
struct PlaneRow;
struct SlabPacket;

/// The corners that packets name, each once a packet, as the data set has them: in single precision
/// where it has no more.
struct PacketPoints : PointArray
{
  static constexpr std::size_t Line = 64; ///< bytes that are fetched together

  /// How many lines of the array lie before a point.
  std::uint32_t LineOf(std::size_t point) const
  {
    return static_cast<std::uint32_t>(
      point * (3 * (this->Floats ? sizeof(float) : sizeof(double))) / Line);
  }
  /// As many as packets have usually.
  void Fetch(std::uint32_t line) const
  {
    const void* const floats = this->Floats;
    FetchLines<4 * Line>(static_cast<const char*>(floats ? floats : this->Doubles) + Line * line);
  }
};

/// The packets of triangles of a tree's leaves.
class TrianglePackets
{
public:
  TrianglePackets() = default; ///< none
  TrianglePackets(const TrianglePacket* first, const PacketPoints& points)
    : First(first)
    , Points(points)
  {
  }

  static constexpr bool SkipsLeaves = true;
  static bool Knows(const Node<3>& node) { return (node.Tag & 1u) == 0; }
  static std::uint32_t TagOf(std::uint32_t packet) { return 2 * packet; }
  static std::uint32_t NumberOf(const Node<3>& leaf) { return leaf.Tag >> 1; }

  /// Whether there are points: the packets are then those of all leaves, by number.
  bool HavePoints() const { return this->Points.Floats || this->Points.Doubles; }
  const PacketPoints& GetPoints() const { return this->Points; }

  ///@{
  /// TriangleLeafFilters.h has these.
  const TrianglePacket& Of(std::uint32_t number) const;
  void Fetch(std::uint32_t number) const;
  void FetchData(std::uint32_t) const {}
  Vector3 Corner(std::uint32_t number, std::uint32_t lane, int corner) const;
  /// body(along): along(axis) returns what a triangle's three corners have along it.
  template <class Body>
  auto WithCorners(std::uint32_t number, std::uint32_t lane, const Body& body) const;
  ///@}

private:
  const TrianglePacket* First = nullptr;
  PacketPoints Points;
};

/// What tells the boxes of a leaf's cells by the leaf's number: one of the two, or neither.
struct LeafCorners
{
  const TrianglePacket* Triangles = nullptr;
  const QuantizedCorners<2>* Boxes = nullptr;
  double Widening = 0.0; ///< of the boxes, at most (QuantizedCorners), in the frame

  bool AreThere() const { return this->Triangles || this->Boxes; }
};

/// A view of a tree that does not store the nodes of leaves among leaves (Tree::DropLeaves): their
/// boxes are made of the corners when a query opens them. Without corners it stores all nodes.
/// CompactTree.h has what opens them.
class CompactTree : public TreeView<3>
{
public:
  CompactTree() = default; ///< of an empty tree
  /// `margin`: of triangles' safety boxes, in world units.
  CompactTree(const TreeView<3>& view, const LeafCorners& corners, double margin)
    : TreeView<3>(view)
    , Corners(corners)
    , Margin(corners.Triangles ? static_cast<float>(margin * view.GetFrame().Scale) : 0.0f)
    , FirstDropped(corners.AreThere() ? this->GetLeaves().FirstBehind : Node<3>::NoTag)
  {
  }

  using TreeView<3>::Open;
  /// See OpenIn().
  const Node<3>& Open(std::uint32_t node, Node<3>& room, bool wantsBoxes) const
  {
    return node < this->FirstDropped ? this->Open(node)
                                     : this->Make(node - this->FirstDropped, room, wantsBoxes);
  }
  void Fetch(std::uint32_t node) const;

  /// By how much boxes of leaves may be wider than safety boxes, on each side, in world units.
  double Widening() const { return this->Corners.Widening / this->GetFrame().Scale; }

private:
  const Node<3>& Make(std::uint32_t number, Node<3>& room, bool wantsBoxes) const;

  LeafCorners Corners;
  float Margin = 0.0f;
  std::uint32_t FirstDropped = Node<3>::NoTag;
};

/// The packets of planes of a tree's leaves. Those of all leaves, of slabs or of equally many rows,
/// are told by their numbers alone: their grids are those of the boxes.
struct PlanePackets
{
  const PlanePacket* First = nullptr;
  const QuantizedCorners<2>* Boxes = nullptr; ///< instead, or nullptr
  const PlaneRow* Rows = nullptr;             ///< those of a packet in turn
  std::uint32_t CommonRows = 0;               ///< of each packet, beside Boxes
  const SlabPacket* Slabs = nullptr;          ///< instead of rows, beside Boxes, or nullptr
};

}

#endif
