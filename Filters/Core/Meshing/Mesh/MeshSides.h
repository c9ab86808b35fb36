// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_MeshSides_h
#define skd_Mesh_MeshSides_h

#include "CellKind.h"
#include "TupleNumbers.h"

#include <cstddef>
#include <vector>

namespace skd
{

/// Sides of one kind, edges (N = 2) or faces (N = 4, the fourth node of a triangle None): the node
/// in the middle of each, whether it is cut, and the cells that were put down as having it. All of
/// it can be taken back to an earlier state. O(1) each.
template <int N>
class MeshSides
{
public:
  using Nodes = std::array<std::uint32_t, N>;
  static constexpr std::uint32_t None = 0xffffffffu;

  bool Has(const Nodes& nodes) const { return this->Numbers.Find(nodes) != None; }

  std::uint32_t MiddleOf(const Nodes& nodes) const
  {
    const std::uint32_t side = this->Numbers.Find(nodes);
    return side == None ? None : this->Sides[side].Middle;
  }
  void SetMiddle(const Nodes& nodes, std::uint32_t middle)
  {
    this->Sides[this->NumberOf(nodes)].Middle = middle;
  }

  bool IsCut(const Nodes& nodes) const
  {
    const std::uint32_t side = this->Numbers.Find(nodes);
    return side != None && this->Sides[side].IsCut;
  }
  /// Returns whether it was not before.
  bool SetCut(const Nodes& nodes)
  {
    const std::uint32_t side = this->NumberOf(nodes);
    if (this->Sides[side].IsCut)
    {
      return false;
    }
    this->Sides[side].IsCut = true;
    this->CutSides.push_back(side);
    return true;
  }

  /// The sides that are cut, in turn, from `first` on.
  std::vector<Nodes> GetCut(std::size_t first) const
  {
    std::vector<Nodes> cut;
    for (std::size_t i = first; i < this->CutSides.size(); ++i)
    {
      cut.push_back(this->Numbers[this->CutSides[i]]);
    }
    return cut;
  }

  /// Whether a volume cell was put down.
  bool IsOfVolume(const Nodes& nodes) const
  {
    const std::uint32_t side = this->Numbers.Find(nodes);
    return side != None && this->Sides[side].IsOfVolume;
  }

  void SetOfVolume(const Nodes& nodes) { this->Sides[this->NumberOf(nodes)].IsOfVolume = true; }

  void Enter(const Nodes& nodes, std::uint32_t cell, bool isVolume)
  {
    Side& side = this->Sides[this->NumberOf(nodes)];
    side.IsOfVolume = side.IsOfVolume || isVolume;
    this->Entries.push_back({ cell, side.Head });
    side.Head = static_cast<std::uint32_t>(this->Entries.size() - 1);
  }

  /// Calls visit(cell) for all that were put down, the last one first.
  template <class Visit>
  void ForEachCellAt(const Nodes& nodes, const Visit& visit) const
  {
    const std::uint32_t side = this->Numbers.Find(nodes);
    std::uint32_t entry = side == None ? None : this->Sides[side].Head;
    for (; entry != None; entry = this->Entries[entry].Next)
    {
      visit(this->Entries[entry].Cell);
    }
  }

  struct State
  {
    std::size_t Entries, CutSides;
  };
  State GetState() const { return { this->Entries.size(), this->CutSides.size() }; }

  /// Sides that are new since then stay, without a cell; middles are those of less than `nodes`.
  void GoBackTo(const State& state, std::size_t nodes)
  {
    for (Side& side : this->Sides)
    {
      side.Middle = side.Middle < nodes ? side.Middle : None;
      while (side.Head != None && side.Head >= state.Entries)
      {
        side.Head = this->Entries[side.Head].Next;
      }
    }
    for (std::size_t i = state.CutSides; i < this->CutSides.size(); ++i)
    {
      this->Sides[this->CutSides[i]].IsCut = false;
    }
    this->CutSides.resize(state.CutSides);
    this->Entries.resize(state.Entries);
  }

  std::size_t MemorySize() const
  {
    return this->Numbers.MemorySize() + this->Sides.capacity() * sizeof(Side) +
      this->Entries.capacity() * sizeof(Entry);
  }

private:
  struct Side
  {
    std::uint32_t Middle = None;
    std::uint32_t Head = None; // of a list of entries
    bool IsCut = false;
    bool IsOfVolume = false;
  };
  struct Entry
  {
    std::uint32_t Cell;
    std::uint32_t Next;
  };

  std::uint32_t NumberOf(const Nodes& nodes)
  {
    const std::uint32_t side = this->Numbers.FindOrAdd(nodes);
    if (side == this->Sides.size())
    {
      this->Sides.emplace_back();
    }
    return side;
  }

  TupleNumbers<N> Numbers;
  std::vector<Side> Sides;
  std::vector<Entry> Entries;
  std::vector<std::uint32_t> CutSides;
};

}

#endif
