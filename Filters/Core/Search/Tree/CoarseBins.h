// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_CoarseBins_h
#define skd_Tree_CoarseBins_h

#include "ElementReader.h"
#include "QuantileGrid.h"
#include "RawVector.h"

#include <mutex>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace skd
{

/// The elements of the top of a tree, sorted into the bins of a grid only: each is read once and
/// takes 4 bytes. A split assigns most bins as a whole to one side and reads only the elements of
/// one slab of the grid again. So a tree of N elements that is built on query has its first nodes
/// after O(N) cheap steps, and stores boxes only of elements near queries. The result is identical
/// to that of SplitAtRank.
///
///    : . |: . : | .        a range of the tree is a list of pieces: bins, or what is left of them;
///    . : |. : . | : .      a split along x finds the slab with the median, and cuts its pieces
///        +--^---+
///
/// Ranges are known by the position of their first element. Different ranges may be split at once.
template <int D>
class CoarseBins
{
public:
  /// All elements, one range. `loop` as in Tree; the result does not depend on it.
  template <class Loop>
  CoarseBins(std::uint32_t count, std::size_t few, ElementReader<D> read, Loop& loop)
    : Enough(few)
    , Read(std::move(read))
    , Grid(ReadSample<D>(this->Read, count, SampleSize))
    , Indices(count)
  {
    this->Sort(loop);
  }

  /// Whether the range of `size` elements that begins at `first` should not be split here: it has
  /// few elements, or few bins.
  bool IsDone(std::uint32_t first, std::size_t size) const
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    return size <= this->Enough || this->Ranges.at(first).size() < FewPieces;
  }

  struct Boxes
  {
    FloatBox<D> Left;
    FloatBox<D> Right;
  };

  /// Divides the range that begins at `first`, neither side empty, into those that begin at `first`
  /// and at `middle`.
  Boxes Split(std::uint32_t first, std::uint32_t middle, int axis)
  {
    const Pieces pieces = this->TakePieces(first);
    const Cut cut = FindCut(pieces, middle - first, axis);
    Sides sides;
    Pieces inSlab;
    for (const Piece& piece : pieces)
    {
      const int slab = QuantileGrid<D>::SlabOf(piece.InBin, axis);
      (slab < cut.Slab ? sides.Left : slab > cut.Slab ? sides.Right : inSlab).push_back(piece);
    }
    this->CutPieces(inSlab, cut.Rank, axis, sides);
    const Boxes boxes{ UnionOf(sides.Left), UnionOf(sides.Right) };
    this->PutPieces(first, std::move(sides.Left));
    this->PutPieces(middle, std::move(sides.Right));
    return boxes;
  }

  /// The elements of the range that begins at `first`, which is then discarded.
  void Take(std::uint32_t first, Element<D>* to) { this->ReadPieces(this->TakePieces(first), to); }

  FloatBox<D> Box() const { return UnionOf(this->Ranges.at(0)); }

  std::size_t Size() const { return this->Indices.size(); }

private:
  static constexpr std::size_t FewPieces = 64;
  static constexpr std::uint32_t SampleSize = 1 << 14;
  static constexpr std::uint32_t StrandSize = 1 << 17; // at least
  using Bin = typename QuantileGrid<D>::Bin;
  using Key = typename SplitAtRank<D>::Key;

  /// Elements of one bin: Indices[First .. Last).
  struct Piece
  {
    std::uint32_t First;
    std::uint32_t Last;
    Bin InBin;
    FloatBox<D> Box;

    std::uint32_t Size() const { return this->Last - this->First; }
  };
  using Pieces = std::vector<Piece>;

  struct Sides
  {
    Pieces Left;
    Pieces Right;
  };

  /// The slab in which a range is divided, and how many of the elements there are left of it.
  struct Cut
  {
    int Slab;
    std::uint32_t Rank;
  };

  /// Consecutive elements, sorted by one thread: first the number in each bin, then the index of
  /// the next one.
  struct Strand
  {
    std::uint32_t First;
    std::uint32_t Last;
    std::vector<std::uint32_t> Counts = std::vector<std::uint32_t>(QuantileGrid<D>::NumberOfBins);
    RawVector<FloatBox<D>> Boxes = // of the bins with elements
      RawVector<FloatBox<D>>(QuantileGrid<D>::NumberOfBins);
  };

  template <class Loop>
  void Sort(Loop& loop)
  {
    const auto count = static_cast<std::uint32_t>(this->Indices.size());
    const std::size_t number = std::clamp<std::size_t>(count / StrandSize, 1, 8);
    std::vector<Strand> strands(number);
    RawVector<Bin> bins(count);
    loop(number,
      [&](std::size_t i)
      {
        strands[i].First = static_cast<std::uint32_t>(std::uint64_t(count) * i / number);
        strands[i].Last = static_cast<std::uint32_t>(std::uint64_t(count) * (i + 1) / number);
        this->CountBins(strands[i], bins.data());
      });
    this->AddUp(strands);
    loop(number,
      [&](std::size_t i)
      {
        for (std::uint32_t index = strands[i].First; index < strands[i].Last; ++index)
        {
          this->Indices[strands[i].Counts[bins[index]]++] = index;
        }
      });
  }

  void CountBins(Strand& strand, Bin* bins) const
  {
    ReadInRow<D>(this->Read, strand.First, strand.Last,
      [&](const Element<D>& element)
      {
        const Bin bin = this->Grid.BinOf(element);
        bins[element.Index] = bin;
        if (strand.Counts[bin]++ == 0)
        {
          strand.Boxes[bin] = element.Box;
        }
        EncloseInMemory(strand.Boxes[bin], element);
      });
  }

  /// The pieces of the range of all elements, and where each strand puts its own.
  void AddUp(std::vector<Strand>& strands)
  {
    Pieces pieces;
    std::uint32_t next = 0;
    for (std::size_t bin = 0; bin < QuantileGrid<D>::NumberOfBins; ++bin)
    {
      Piece piece{ next, next, static_cast<Bin>(bin), NoBox<D>() };
      for (Strand& strand : strands)
      {
        const std::uint32_t count = std::exchange(strand.Counts[bin], next);
        if (count > 0)
        {
          Enclose(piece.Box, strand.Boxes[bin]);
          next += count;
        }
      }
      piece.Last = next;
      if (piece.Size() > 0)
      {
        pieces.push_back(piece);
      }
    }
    this->Ranges[0] = std::move(pieces);
  }

  Pieces TakePieces(std::uint32_t first)
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    const auto found = this->Ranges.find(first);
    Pieces pieces = std::move(found->second);
    this->Ranges.erase(found);
    return pieces;
  }

  void PutPieces(std::uint32_t first, Pieces&& pieces)
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    this->Ranges[first] = std::move(pieces);
  }

  void ReadPieces(const Pieces& pieces, Element<D>* to) const
  {
    for (const Piece& piece : pieces)
    {
      this->Read(this->Indices.data() + piece.First, piece.Size(), to);
      to += piece.Size();
    }
  }

  static std::size_t SizeOf(const Pieces& pieces)
  {
    return std::accumulate(pieces.begin(), pieces.end(), std::size_t(0),
      [](std::size_t sum, const Piece& piece) { return sum + piece.Size(); });
  }

  static FloatBox<D> UnionOf(const Pieces& pieces)
  {
    FloatBox<D> box = NoBox<D>();
    for (const Piece& piece : pieces)
    {
      Enclose(box, piece.Box);
    }
    return box;
  }

  /// Before the element of that rank, which is not the last.
  static Cut FindCut(const Pieces& pieces, std::uint32_t rank, int axis)
  {
    std::array<std::uint32_t, QuantileGrid<D>::NumberOfSlabs> counts{};
    for (const Piece& piece : pieces)
    {
      counts[static_cast<std::size_t>(QuantileGrid<D>::SlabOf(piece.InBin, axis))] += piece.Size();
    }
    int slab = 0;
    for (; rank >= counts[static_cast<std::size_t>(slab)]; ++slab)
    {
      rank -= counts[static_cast<std::size_t>(slab)];
    }
    return { slab, rank };
  }

  /// The `rank` least elements of some pieces to the left, the others to the right.
  void CutPieces(const Pieces& pieces, std::uint32_t rank, int axis, Sides& sides)
  {
    RawVector<Element<D>> elements(SizeOf(pieces));
    this->ReadPieces(pieces, elements.data());
    std::vector<Key> keys(elements.size());
    std::transform(elements.begin(), elements.end(), keys.begin(),
      [axis](const Element<D>& element) { return SplitAtRank<D>::KeyOf(element, axis); });
    const auto least = keys.begin() + rank;
    std::nth_element(keys.begin(), least, keys.end());
    const Element<D>* next = elements.data();
    for (const Piece& piece : pieces)
    {
      this->CutPiece(piece, next, *least, axis, sides);
      next += piece.Size();
    }
  }

  /// `elements`: of the piece, in their order, which stays on either side.
  void CutPiece(const Piece& piece, const Element<D>* elements, Key least, int axis, Sides& sides)
  {
    Piece left{ piece.First, piece.First, piece.InBin, NoBox<D>() };
    Piece right{ piece.First, piece.Last, piece.InBin, NoBox<D>() };
    std::vector<std::uint32_t> others;
    for (const Element<D>* at = elements; at != elements + piece.Size(); ++at)
    {
      if (SplitAtRank<D>::KeyOf(*at, axis) < least)
      {
        this->Indices[left.Last++] = at->Index;
        Enclose(left.Box, at->Box);
      }
      else
      {
        others.push_back(at->Index);
        Enclose(right.Box, at->Box);
      }
    }
    right.First = left.Last;
    std::copy(others.begin(), others.end(), this->Indices.begin() + right.First);
    if (left.Size() > 0)
    {
      sides.Left.push_back(left);
    }
    if (right.Size() > 0)
    {
      sides.Right.push_back(right);
    }
  }

  std::size_t Enough;
  ElementReader<D> Read;
  QuantileGrid<D> Grid;
  RawVector<std::uint32_t> Indices;
  mutable std::mutex Lock; // of Ranges: only while it is looked at
  std::unordered_map<std::uint32_t, Pieces> Ranges;
};

}

#endif
