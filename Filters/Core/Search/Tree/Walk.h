// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Walk_h
#define skd_Tree_Walk_h

#include "LaneQueue.h"
#include "Node.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace skd
{

/// The maximum depth of a tree. 2^31 elements need 12 levels with one element a leaf, and splits by
/// area one more.
constexpr int MostLevels = 16;

namespace detail
{

/// Whether a traversal may skip leaf nodes: the tree gives their elements by number, and the query
/// has its own test for these.
template <class Tree, class Query, class = void>
struct SkipsLeaves : std::false_type
{
};
template <class Tree, class Query>
struct SkipsLeaves<Tree, Query,
  std::void_t<decltype(&Tree::LeafAt), std::enable_if_t<Query::SkipsLeaves>>> : std::true_type
{
};

/// The wanted lanes of a node. A query may look at elements in a way of its own.
template <class Query, int D>
auto TestElements(Query& query, const Node<D>& leaf, float* keys, int)
  -> decltype(query.TestElements(leaf, keys))
{
  return query.TestElements(leaf, keys);
}
template <class Query, int D>
unsigned TestElements(Query& query, const Node<D>& leaf, float* keys, long)
{
  return query.TestBoxes(leaf.Boxes, keys);
}

/// Whether a query can decide that all elements of a subtree are answers.
template <class Query, class = void>
struct KnowsSure : std::false_type
{
};
template <class Query>
struct KnowsSure<Query, std::void_t<decltype(&Query::VisitSure)>> : std::true_type
{
};

/// Whether of most nodes many children are within the limit, which falls before most are opened:
/// then it is quicker to put none in order before it is opened.
template <class Query, class = void>
struct HasManyChildren : std::false_type
{
};
template <class Query>
struct HasManyChildren<Query, std::enable_if_t<Query::ManyChildren>> : std::true_type
{
};

/// What a traversal has still to open: a number in the order of the keys, which are 0 or more. The
/// key is in its upper half; below are the index of a node and a mark, or the number of a leaf that
/// need not be opened and a mark.
using QueueEntry = std::uint64_t;

constexpr std::uint32_t Mark = KnownLeaves::Mark;

inline bool IsMarked(QueueEntry entry)
{
  return (entry & Mark) != 0;
}
inline std::uint32_t IndexOf(QueueEntry entry)
{
  return static_cast<std::uint32_t>(entry) & ~Mark;
}
inline float KeyOf(QueueEntry entry)
{
  const auto bits = static_cast<std::uint32_t>(entry >> 32);
  float key;
  std::memcpy(&key, &bits, sizeof(key));
  return key;
}
inline QueueEntry EntryOf(float key, std::uint32_t index)
{
  std::uint32_t bits;
  std::memcpy(&bits, &key, sizeof(bits));
  return static_cast<QueueEntry>(bits) << 32 | index;
}

/// Of some lanes, at least one, that with the least key. Written so that compilers make it without
/// a branch in the loop: which element comes first is anyone's guess.
inline int LeastLane(unsigned lanes, const float* keys)
{
  int least = LowestBit(lanes);
  ForEachLane(
    lanes & (lanes - 1), [&](int lane) { least = keys[lane] < keys[least] ? lane : least; });
  return least;
}

/// A node's children that are still to be opened.
template <class Node>
struct Siblings
{
  LaneQueue Lanes;
  const Node* Parent;
};

/// A traversal: its stack, whose last is the next. The stack is no member: so compilers keep the
/// members in registers.
template <class Tree, class Query>
class Traversal
{
public:
  using Node = std::decay_t<decltype(std::declval<const Tree&>().Open(0))>;
  static constexpr bool BySiblings = HasManyChildren<Query>::value;
  using StackItem = std::conditional_t<BySiblings, Siblings<Node>, QueueEntry>;
  static constexpr int StackSize = MostLevels * (BySiblings ? 1 : Node::Width - 1);

  Traversal(const Tree& tree, Query& query, StackItem* stack, Node& room)
    : TheTree(tree)
    , TheQuery(query)
    , Stack(stack)
    , Top(stack)
    , Room(room)
  {
  }

  void Run()
  {
    QueueEntry next = 0;
    while (this->Open(next))
    {
    }
  }

private:
  static constexpr bool Skips = SkipsLeaves<Tree, Query>::value;
  static constexpr bool Sure = KnowsSure<Query>::value;

  /// Opens what is next, and says what comes then. False: nothing.
  bool Open(QueueEntry& next)
  {
    float keys[Node::Width];
    if (Skips && IsMarked(next))
    {
      return this->VisitKnown(IndexOf(next), keys) && this->Take(next);
    }
    const bool isSure = Sure && IsMarked(next);
    const std::uint32_t index = Sure ? IndexOf(next) : static_cast<std::uint32_t>(next);
    const Node& node = OpenIn(this->TheTree, index, this->Room, !isSure, 0);
    if (node.IsLeaf)
    {
      return this->VisitLeaf(node, isSure, keys) && this->Take(next);
    }
    const unsigned overlapping =
      isSure ? node.Occupied() : this->TheQuery.TestBoxes(node.Boxes, keys) & node.Occupied();
    if (overlapping == 0)
    {
      return this->Take(next);
    }
    if constexpr (BySiblings)
    {
      next = this->PutSiblings(node, overlapping, keys);
    }
    else
    {
      next = this->Put(node, overlapping, isSure, keys);
    }
    return true;
  }

  /// The last whose key is within the limit, which may have fallen.
  bool Take(QueueEntry& next)
  {
    while (this->Top != this->Stack)
    {
      if constexpr (BySiblings)
      {
        Siblings<Node>& siblings = this->Top[-1];
        const int lane = siblings.Lanes.Take(this->TheQuery.Limit());
        if (lane != LaneQueue::None)
        {
          const Node& parent = *siblings.Parent;
          next = this->ChildOf(parent, this->KnowsLeavesOf(parent), lane);
          return true;
        }
        --this->Top;
      }
      else
      {
        next = *--this->Top;
        if (!Query::Ordered || KeyOf(next) <= this->TheQuery.Limit())
        {
          return true;
        }
      }
    }
    return false;
  }

  bool KnowsLeavesOf(const Node& node) const
  {
    if constexpr (Skips)
    {
      return this->TheQuery.Knows(node);
    }
    return false;
  }

  /// What a child is opened by, as the lower half of an entry has it.
  std::uint32_t ChildOf(const Node& node, bool isKnown, int lane) const
  {
    if constexpr (Skips)
    {
      if (isKnown)
      {
        const auto& known = node.template Read<KnownLeaves>();
        if (known.IsKnown(lane)) // what is needed last is asked for first
        {
          this->TheQuery.FetchData(known.DataOf(lane));
        }
        return known.Entries[lane];
      }
    }
    return node.First + static_cast<std::uint32_t>(lane);
  }

  /// Puts children on the stack, takes the first of them, and returns it.
  QueueEntry PutSiblings(const Node& node, unsigned lanes, const float* keys)
  {
    const bool isKnown = this->KnowsLeavesOf(node);
    if ((lanes & (lanes - 1)) == 0)
    {
      return this->ChildOf(node, isKnown, LowestBit(lanes));
    }
    Siblings<Node>& siblings = *this->Top++;
    siblings.Parent = &node;
    siblings.Lanes.Put(lanes, keys);
    const int first = siblings.Lanes.Take(std::numeric_limits<float>::infinity());
    ForEachLane(
      lanes & ~(1u << first), [&](int lane) { this->Fetched(this->ChildOf(node, isKnown, lane)); });
    return this->ChildOf(node, isKnown, first);
  }

  /// Puts children on the stack but the first of them, which it returns.
  QueueEntry Put(const Node& node, unsigned lanes, bool isSure, const float* keys)
  {
    unsigned sure = 0;
    if constexpr (Sure)
    {
      sure = isSure ? lanes : this->TheQuery.SureOf(node);
    }
    const bool isKnown = this->KnowsLeavesOf(node);
    const auto entryOf = [&](int lane)
    {
      std::uint32_t index = this->ChildOf(node, isKnown, lane);
      if constexpr (Sure)
      {
        index |= (sure >> lane & 1u) != 0 ? Mark : 0u;
      }
      return EntryOf(Query::Ordered ? keys[lane] : 0.0f, index);
    };
    if constexpr (!Query::Ordered)
    {
      for (; (lanes & (lanes - 1)) != 0; lanes &= LowBits(HighestBit(lanes)))
      {
        *this->Top++ = this->Fetched(entryOf(HighestBit(lanes)));
      }
      return entryOf(LowestBit(lanes));
    }
    QueueEntry first = entryOf(LowestBit(lanes));
    if ((lanes &= lanes - 1) == 0)
    {
      return first;
    }
    const QueueEntry second = entryOf(LowestBit(lanes));
    QueueEntry* const bottom = this->Top;
    *this->Top++ = this->Fetched(std::max(first, second));
    first = std::min(first, second);
    while ((lanes &= lanes - 1) != 0) // two are the rule
    {
      const QueueEntry entry = entryOf(LowestBit(lanes));
      this->Insert(this->Fetched(std::max(first, entry)), bottom);
      first = std::min(first, entry);
    }
    return first;
  }

  /// Keeps what is on the stack from `bottom` on in order.
  void Insert(QueueEntry entry, const QueueEntry* bottom)
  {
    QueueEntry* at = this->Top++;
    for (; at != bottom && at[-1] < entry; --at)
    {
      *at = at[-1];
    }
    *at = entry;
  }

  /// Prefetches what will be opened later: in trees larger than the caches, traversals mostly wait
  /// for memory.
  QueueEntry Fetched(QueueEntry entry) const
  {
    if constexpr (Skips)
    {
      if (IsMarked(entry))
      {
        this->TheQuery.FetchKnown(IndexOf(entry));
        return entry;
      }
    }
    this->TheTree.Fetch(Sure ? IndexOf(entry) : static_cast<std::uint32_t>(entry));
    return entry;
  }

  /// False ends the walk, as in all that visits.
  bool VisitKnown(std::uint32_t number, float* keys)
  {
    if constexpr (Skips)
    {
      const auto elements = this->TheTree.LeafAt(number);
      this->TheTree.FetchElements(elements.First);
      const unsigned wanted = this->TheQuery.TestKnown(number, elements.Count, keys);
      return Query::GivesKeys ? this->VisitInOrder(elements.First, wanted, keys)
                              : this->VisitAll(elements.First, wanted, 0);
    }
    return true;
  }

  bool VisitLeaf(const Node& leaf, bool isSure, float* keys)
  {
    std::fill(keys, keys + Node::Width, 0.0f); // of elements that are tested all at once
    const unsigned wanted =
      isSure ? leaf.Occupied() : TestElements(this->TheQuery, leaf, keys, 0) & leaf.Occupied();
    if constexpr (Sure)
    {
      return this->VisitAll(leaf.First, wanted,
        isSure          ? wanted
          : wanted != 0 ? this->TheQuery.SureOf(leaf)
                        : 0u);
    }
    return this->VisitInOrder(leaf.First, wanted, keys);
  }

  bool VisitAll(std::uint32_t first, unsigned wanted, unsigned sure)
  {
    for (; wanted != 0; wanted &= wanted - 1)
    {
      const int lane = LowestBit(wanted);
      const std::uint32_t element = this->TheTree.Element(first + static_cast<std::uint32_t>(lane));
      bool goesOn;
      if constexpr (Sure)
      {
        goesOn = (sure >> lane & 1u) != 0 ? this->TheQuery.VisitSure(element)
                                          : this->TheQuery.Visit(element);
      }
      else
      {
        goesOn = this->TheQuery.Visit(element);
      }
      if (!goesOn)
      {
        return false;
      }
    }
    return true;
  }

  bool VisitInOrder(std::uint32_t first, unsigned wanted, const float* keys)
  {
    if constexpr (!Query::Ordered)
    {
      return this->VisitAll(first, wanted, 0);
    }
    for (; (wanted &= LessEqual(
              Lanes<Node::Width>::Load(keys), Lanes<Node::Width>(this->TheQuery.Limit()))) != 0;)
    {
      const int lane = LeastLane(wanted, keys);
      wanted &= ~(1u << lane);
      if (!this->TheQuery.Visit(this->TheTree.Element(first + static_cast<std::uint32_t>(lane))))
      {
        return false;
      }
    }
    return true;
  }

  const Tree& TheTree;
  Query& TheQuery;
  StackItem* const Stack;
  StackItem* Top; ///< one past the last
  Node& Room;     ///< of a leaf that the tree does not store
};

}

/// The traversal of a tree. It serves every query and need not be changed for new ones.
///
/// A Tree gives IsEmpty(), Open(node index) -> const Node<D>& (or what OpenIn() does instead),
/// Element(position) -> element index, Fetch(node index).
/// A Query is a small value that gives
///   static constexpr bool Ordered        visit the least key first?
///   unsigned TestBoxes(const BoxPacket&, float* keys)
///                                        bit i: lane i is wanted; if Ordered, its key, a lower
///                                        bound of what is sought below that box, is within Limit()
///   unsigned TestElements(const Node&, float* keys)
///                                        if there: the same for a leaf and its elements
///   static constexpr bool ManyChildren   if there and true, and Ordered: most nodes have more than
///                                        two wanted children
///   static constexpr bool SkipsLeaves   if there and true, it gives
///   bool Knows(const Node&)              whether the node's note, if it is an inner one, is
///                                        KnownLeaves: these need not be opened
///   unsigned TestKnown(number, count, float* keys), void FetchKnown(number), FetchData(data)
///                                        what TestElements() does, by a leaf's number, that this
///                                        test will follow, and what KnownLeaves say of its data
///   static constexpr bool GivesKeys      whether that sets the keys
///   unsigned SureOf(const Node&), bool VisitSure(element index)
///                                        if there, and not Ordered: the lanes below which all is
///                                        an answer, and what is visited without a test of any box
///   float Limit()                        a node whose key is above it is not wanted any more
///   bool Visit(element index)            an element was reached; false ends the walk
/// Keys are 0 or more: with a negative limit nothing is reached. Depth first, siblings by key. No
/// allocation. O(nodes whose key is within the limit).
template <class Tree, class Query>
void Walk(const Tree& tree, Query& query)
{
  if (tree.IsEmpty() || !(0.0f <= query.Limit()))
  {
    return;
  }
  using Traversal = detail::Traversal<Tree, Query>;
  typename Traversal::StackItem stack[Traversal::StackSize];
  typename Traversal::Node room;
  Traversal(tree, query, stack, room).Run();
}

/// A leaf filter, quantized or not, looks at the elements of a leaf more closely than their boxes
/// do, all at once, and says which are worth a visit: it may leave out what is proven to be no
/// answer. It gives
///   bool Knows(const Node&)             whether it can, of this node
///   std::uint32_t NumberOf(const Node&) by what it knows the leaf
///   unsigned Pass(number, count, float* keys, float& limit)
///                                       as TestBoxes() of a query, whose limit it may lower, of a
///                                       leaf's number and how many elements it has
///   static constexpr bool SkipsLeaves   whether numbers are those of KnownLeaves; if so it gives
///   void Fetch(number), FetchData(data), and static constexpr bool GivesKeys: whether Pass() sets
///                                       the keys then
/// AlongSegment first calls Aim(point, margin), in the frame: where the segment begins, clipped to
/// where the tree is. This one knows nothing.
struct NoLeafFilter
{
  static constexpr bool SkipsLeaves = false;
  static constexpr bool GivesKeys = true;

  template <class Point>
  void Aim(const Point&, double)
  {
  }
  template <class Node>
  static bool Knows(const Node&)
  {
    return false;
  }
  template <class Node>
  static std::uint32_t NumberOf(const Node&)
  {
    return 0;
  }
  unsigned Pass(std::uint32_t, std::uint32_t count, float*, float&) const { return LowBits(count); }
};

/// What queries that have a leaf filter do with it, and their limit. The boxes of the
/// elements decide where the filter does not know the leaf: `Query` has TestBoxes().
template <class Query, class LeafFilter>
class FilteredQuery
{
public:
  static constexpr bool SkipsLeaves = LeafFilter::SkipsLeaves;
  static constexpr bool GivesKeys = LeafFilter::GivesKeys;

  template <class Node>
  unsigned TestElements(const Node& leaf, float* keys)
  {
    return this->Knows(leaf) ? this->TestKnown(LeafFilter::NumberOf(leaf), leaf.Count, keys)
                             : static_cast<Query*>(this)->TestBoxes(leaf.Boxes, keys);
  }

  template <class Node>
  bool Knows(const Node& inner) const
  {
    return LeafFilter::Knows(inner);
  }
  unsigned TestKnown(std::uint32_t leaf, std::uint32_t count, float* keys)
  {
    return this->TheLeafFilter.Pass(leaf, count, keys, this->TheLimit);
  }
  void FetchKnown(std::uint32_t leaf) const { this->TheLeafFilter.Fetch(leaf); }
  void FetchData(std::uint32_t data) const { this->TheLeafFilter.FetchData(data); }

  float Limit() const { return this->TheLimit; }

protected:
  /// The leaf filter, or what it is made of.
  template <class... Parts>
  explicit FilteredQuery(float limit, const Parts&... parts)
    : TheLeafFilter(parts...)
    , TheLimit(limit)
  {
  }

  LeafFilter TheLeafFilter;
  float TheLimit;
};

}

#endif
