// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPointJoin_h
#define SkdPointJoin_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace skdtree
{
/// Which points of several pieces are one, of points with a key each: the n-th point of a piece
/// with a key is one with the n-th of other pieces.
class SkdPointJoin
{
public:
  explicit SkdPointJoin(std::size_t numberOfKeys = 0)
    : Joined(numberOfKeys)
  {
  }

  /// The joined points so far.
  vtkIdType GetNumber() const { return static_cast<vtkIdType>(this->Shared.size()); }

  /// The joined point that the next point of a piece becomes: a new one if it is GetNumber().
  vtkIdType Add(int piece, vtkIdType key)
  {
    JoinedPoints& joined = this->Joined[static_cast<std::size_t>(key)];
    const bool isFirst = joined.Piece != piece;
    vtkIdType id = isFirst ? joined.First : this->Next[static_cast<std::size_t>(joined.Last)];
    if (id >= 0)
    {
      this->Shared[static_cast<std::size_t>(id)] = 1;
    }
    else
    {
      id = this->GetNumber();
      (isFirst ? joined.First : this->Next[static_cast<std::size_t>(joined.Last)]) = id;
      this->Shared.push_back(0);
      this->Next.push_back(-1);
      this->Firsts.push_back(joined.First);
    }
    joined.Last = id;
    joined.Piece = piece;
    return id;
  }

  /// The first joined point with the same key.
  vtkIdType FirstLike(vtkIdType id) const { return this->Firsts[static_cast<std::size_t>(id)]; }

  /// Whether several pieces have a joined point.
  bool IsShared(vtkIdType id) const { return this->Shared[static_cast<std::size_t>(id)] != 0; }

private:
  /// The joined points with one key: the first, and the last that this piece has.
  struct JoinedPoints
  {
    vtkIdType First = -1;
    vtkIdType Last = -1;
    int Piece = -1;
  };

  std::vector<JoinedPoints> Joined;  // by key
  std::vector<vtkIdType> Next;       // the next joined point with the same key, or -1
  std::vector<unsigned char> Shared; // by joined point
  std::vector<vtkIdType> Firsts;     // the same: the first one with the same key
};
}

#endif
