// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Node_h
#define skd_Tree_Node_h

#include "Frame.h"
#include "Lanes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <type_traits>

namespace skd
{

/// Up to W boxes in SIMD layout, one box a lane, which are tested together.
template <int D, int W>
struct BoxPacket
{
  static constexpr int Width = W;

  float Min[D][W];
  float Max[D][W];

  Lanes<W> Mins(int axis) const { return Lanes<W>::Load(this->Min[axis]); }
  Lanes<W> Maxs(int axis) const { return Lanes<W>::Load(this->Max[axis]); }

  /// Where, in bytes, the sides of the boxes are that a line comes to first and last.
  struct Sides
  {
    std::int32_t Near[D];
    std::int32_t Far[D];
  };
  /// Of a line that runs backward along the axes of these bits.
  static const Sides& SidesOf(unsigned backward)
  {
    static constexpr std::array<Sides, std::size_t(1) << D> sides = []
    {
      constexpr int toMax = sizeof(float[D][W]);
      std::array<Sides, std::size_t(1) << D> all{};
      for (unsigned bits = 0; bits < all.size(); ++bits)
      {
        for (int axis = 0; axis < D; ++axis)
        {
          const int min = axis * int(sizeof(float[W]));
          const bool isBackward = (bits >> axis & 1u) != 0;
          all[bits].Near[axis] = min + (isBackward ? toMax : 0);
          all[bits].Far[axis] = min + (isBackward ? 0 : toMax);
        }
      }
      return all;
    }();
    return sides[backward];
  }
  Lanes<W> Side(std::ptrdiff_t at) const
  {
    return Lanes<W>::Load(reinterpret_cast<const float*>(reinterpret_cast<const char*>(this) + at));
  }

  /// All lanes empty: (+max, lowest), which no finite query overlaps.
  void Clear()
  {
    for (int axis = 0; axis < D; ++axis)
    {
      for (int lane = 0; lane < W; ++lane)
      {
        this->Min[axis][lane] = std::numeric_limits<float>::max();
        this->Max[axis][lane] = std::numeric_limits<float>::lowest();
      }
    }
  }

  void Set(int lane, const FloatBox<D>& box)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      this->Min[axis][lane] = box.Min[axis];
      this->Max[axis][lane] = box.Max[axis];
    }
  }

  FloatBox<D> Get(int lane) const
  {
    FloatBox<D> box;
    for (int axis = 0; axis < D; ++axis)
    {
      box.Min[axis] = this->Min[axis][lane];
      box.Max[axis] = this->Max[axis][lane];
    }
    return box;
  }
};

/// A node: the boxes of its children, three levels of the paper's binary tree in one. The children
/// of an inner node are the nodes First .. First + Count - 1, those of a leaf the elements
/// at these positions.
template <int D>
struct alignas(64) Node
{
  static constexpr int Width = 8;

  BoxPacket<D, Width> Boxes;
  std::uint32_t First = 0;
  std::uint8_t Count = 0;
  std::uint8_t InUse = 0; ///< a bit for each in use
  bool IsLeaf = false;
  std::uint32_t Tag = NoTag; ///< what the tree's owner keeps of the elements below
  /// The owner's, too, in what would be padding; not set until it sets it.
  alignas(std::uint32_t) unsigned char Note[52];

  static constexpr std::uint32_t NoTag = 0xffffffffu;
  void SetCount(std::uint32_t count)
  {
    this->Count = static_cast<std::uint8_t>(count);
    this->InUse = static_cast<std::uint8_t>(LowBits(count));
  }
  unsigned Occupied() const { return this->InUse; }

  template <class T>
  void Write(const T& note)
  {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(this->Note) &&
      alignof(T) <= alignof(std::uint32_t));
    new (this->Note) T(note);
  }
  /// What was written: not copied, for queries read a part of it at every node.
  template <class T>
  const T& Read() const
  {
    return *std::launder(reinterpret_cast<const T*>(this->Note));
  }
};

/// What a traversal opens of an inner node's children: nodes, or leaves whose elements are given by
/// the leaf's number, in the order of the elements (Tree::LeafAt), so that it need not open them.
/// Nodes with this mark also have a tag.
struct KnownLeaves
{
  static constexpr std::uint32_t Mark = 0x80000000u;

  std::uint32_t Entries[8]; ///< by lane: the index of a node, or the number of a leaf and the mark
  ///@{
  /// Where what belongs to each leaf begins in an array of the owner's, so that it can be fetched
  /// before the leaf is looked at. What is too far from the first is only not fetched.
  std::uint32_t FirstData = 0;
  std::uint16_t DataOffsets[8] = {};
  ///@}

  bool IsKnown(int lane) const { return (this->Entries[lane] & Mark) != 0; }
  std::uint32_t NumberOf(int lane) const { return this->Entries[lane] & ~Mark; }
  std::uint32_t DataOf(int lane) const { return this->FirstData + this->DataOffsets[lane]; }

  template <class DataOf>
  void NoteData(const DataOf& dataOf)
  {
    constexpr std::uint32_t most = std::numeric_limits<std::uint16_t>::max();
    bool isFirst = true;
    for (int lane = 0; lane < 8; ++lane)
    {
      if (this->IsKnown(lane))
      {
        const std::uint32_t data = dataOf(this->NumberOf(lane));
        this->FirstData = isFirst ? data : this->FirstData;
        this->DataOffsets[lane] =
          static_cast<std::uint16_t>(std::min(data - this->FirstData, most));
        isFirst = false;
      }
    }
  }
};

///@{
/// A node of a tree. One that the tree does not store it makes in `room`, which has been
/// initialized once: with its boxes, if these are wanted.
template <class Tree, class Node>
auto OpenIn(const Tree& tree, std::uint32_t node, Node& room, bool wantsBoxes, int)
  -> decltype(tree.Open(node, room, wantsBoxes))
{
  return tree.Open(node, room, wantsBoxes);
}
template <class Tree, class Node>
const Node& OpenIn(const Tree& tree, std::uint32_t node, Node&, bool, long)
{
  return tree.Open(node);
}
///@}

/// A reference to a node, or to an element by its position.
class Reference
{
public:
  static Reference ToNode(std::uint32_t node) { return Reference(node); }
  static Reference ToElement(std::uint32_t position) { return Reference(position | ElementBit); }

  bool IsElement() const { return (this->Bits & ElementBit) != 0; }
  std::uint32_t Index() const { return this->Bits & ~ElementBit; }
  bool operator==(const Reference& other) const { return this->Bits == other.Bits; }

  Reference() = default;

private:
  static constexpr std::uint32_t ElementBit = 0x80000000u;

  explicit Reference(std::uint32_t bits)
    : Bits(bits)
  {
  }

  std::uint32_t Bits;
};

/// The number of elements a tree can hold.
constexpr std::uint64_t MaximumNumberOfElements = 0x7fffffffu;

template <int D>
Reference Child(const Node<D>& node, int lane)
{
  const std::uint32_t index = node.First + static_cast<std::uint32_t>(lane);
  return node.IsLeaf ? Reference::ToElement(index) : Reference::ToNode(index);
}

}

#endif
