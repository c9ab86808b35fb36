// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_WalkPairs_h
#define skd_Tree_WalkPairs_h

#include "Node.h"

#include <vector>

namespace skd
{

/// The one walk over a pair of trees (Algorithm 5.4).
///
/// A Query gives
///   FloatBox<D> ToFirst(const FloatBox<D>&)     a box of the second tree, seen in the first's
///   frame bool IsWanted(const FloatBox<D>& a, b)      both in the first's frame: may they hold a
///   pair? bool Visit(element of first, of second)     a pair was reached; false ends the walk
/// Of two nodes the one with the larger box is opened.
///
/// A tree may be walked against itself: then each pair of two elements is reached once, (a, b) or
/// (b, a), and no element with itself. The query's boxes must then not be moved.
///
/// Split() and RunFrom() give the walk in parts that may run at the same time, each with a query
/// and a walk of its own.
template <class FirstTree, class SecondTree, class Query>
class PairWalk
{
public:
  PairWalk(const FirstTree& first, const SecondTree& second, Query& query)
    : First(first)
    , Second(second)
    , TheQuery(query)
  {
  }

  /// One tree against itself.
  PairWalk(const FirstTree& tree, Query& query)
    : First(tree)
    , Second(tree)
    , IsWithinOne(true)
    , TheQuery(query)
  {
  }

  static constexpr int D = Query::Dimension;

  struct Side
  {
    Reference What;
    FloatBox<D> Box;
  };
  struct Pair
  {
    Side A;
    Side B;
  };

  void Run()
  {
    for (const Pair& pair : this->Start())
    {
      this->RunFrom(pair);
    }
  }

  /// At least `enough` pairs from which the walk may go on, or all there are. Nothing is visited.
  std::vector<Pair> Split(std::size_t enough)
  {
    std::vector<Pair> pairs = this->Start();
    bool grows = true;
    while (grows && pairs.size() < enough)
    {
      grows = false;
      std::vector<Pair> next;
      for (const Pair& pair : pairs)
      {
        const bool isReached = pair.A.What.IsElement() && pair.B.What.IsElement();
        grows = grows || !isReached;
        this->Stack.assign(isReached ? 1 : 0, pair);
        if (!isReached)
        {
          this->Advance(pair);
        }
        next.insert(next.end(), this->Stack.begin(), this->Stack.end());
      }
      pairs.swap(next);
    }
    this->Stack.clear();
    return pairs;
  }

  /// Walks on from a pair. Returns whether the query wants more.
  bool RunFrom(const Pair& start)
  {
    this->Stack.assign(1, start);
    while (!this->Stack.empty())
    {
      const Pair pair = this->Stack.back();
      this->Stack.pop_back();
      if (!this->Advance(pair))
      {
        return false;
      }
    }
    return true;
  }

private:
  std::vector<Pair> Start() const
  {
    if (this->First.IsEmpty() || this->Second.IsEmpty())
    {
      return {};
    }
    return { { this->Root(this->First), this->SeenInFirst(this->Root(this->Second)) } };
  }

  template <class Tree>
  static Side Root(const Tree& tree)
  {
    return { Reference::ToNode(0), tree.GetFrame().Outward(tree.GetBounds()) };
  }

  Side SeenInFirst(const Side& side) const
  {
    return { side.What, this->TheQuery.ToFirst(side.Box) };
  }

  static float Size(const FloatBox<D>& box)
  {
    float size = 0.0f;
    for (int axis = 0; axis < D; ++axis)
    {
      size = std::max(size, box.Max[axis] - box.Min[axis]);
    }
    return size;
  }

  bool Advance(const Pair& pair)
  {
    if (this->IsWithinOne && pair.A.What == pair.B.What)
    {
      this->OpenBoth(pair.A.What);
      return true;
    }
    if (pair.A.What.IsElement() && pair.B.What.IsElement())
    {
      return this->TheQuery.Visit(
        this->First.Element(pair.A.What.Index()), this->Second.Element(pair.B.What.Index()));
    }
    const bool opensA =
      pair.B.What.IsElement() || (!pair.A.What.IsElement() && Size(pair.A.Box) >= Size(pair.B.Box));
    if (opensA)
    {
      const Node<D>& node = this->First.Open(pair.A.What.Index());
      for (int lane = 0; lane < node.Count; ++lane)
      {
        this->Push({ { Child(node, lane), node.Boxes.Get(lane) }, pair.B });
      }
      return true;
    }
    const Node<D>& node = this->Second.Open(pair.B.What.Index());
    for (int lane = 0; lane < node.Count; ++lane)
    {
      this->Push({ pair.A, this->SeenInFirst({ Child(node, lane), node.Boxes.Get(lane) }) });
    }
    return true;
  }

  void OpenBoth(const Reference& what)
  {
    if (what.IsElement())
    {
      return;
    }
    const Node<D>& node = this->First.Open(what.Index());
    for (int lane = 0; lane < node.Count; ++lane)
    {
      const Side side{ Child(node, lane), node.Boxes.Get(lane) };
      for (int other = lane; other < node.Count; ++other)
      {
        this->Push({ side, this->SeenInFirst({ Child(node, other), node.Boxes.Get(other) }) });
      }
    }
  }

  void Push(const Pair& pair)
  {
    if (this->TheQuery.IsWanted(pair.A.Box, pair.B.Box))
    {
      this->Stack.push_back(pair);
    }
  }

  const FirstTree& First;
  const SecondTree& Second;
  const bool IsWithinOne = false;
  Query& TheQuery;
  std::vector<Pair> Stack;
};

template <class FirstTree, class SecondTree, class Query>
void WalkPairs(const FirstTree& first, const SecondTree& second, Query& query)
{
  PairWalk<FirstTree, SecondTree, Query>(first, second, query).Run();
}

}

#endif
