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

  void Run()
  {
    if (this->First.IsEmpty() || this->Second.IsEmpty())
    {
      return;
    }
    this->Stack.push_back({ this->Root(this->First), this->SeenInFirst(this->Root(this->Second)) });
    while (!this->Stack.empty())
    {
      const Pair pair = this->Stack.back();
      this->Stack.pop_back();
      if (!this->Advance(pair))
      {
        return;
      }
    }
  }

private:
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

  void Push(const Pair& pair)
  {
    if (this->TheQuery.IsWanted(pair.A.Box, pair.B.Box))
    {
      this->Stack.push_back(pair);
    }
  }

  const FirstTree& First;
  const SecondTree& Second;
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
