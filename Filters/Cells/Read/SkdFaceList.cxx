// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdFaceList.h"

namespace skdtree
{
//------------------------------------------------------------------------------
std::uint64_t SkdFaceList::HashOfName() const
{
  std::uint64_t hash = 0;
  for (const vtkIdType point : this->Name)
  {
    hash = (hash ^ static_cast<std::uint64_t>(point)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}

//------------------------------------------------------------------------------
int SkdFaceList::CompareNames(const Entry& a, const Entry& b) const
{
  if (a.Hash != b.Hash)
  {
    return a.Hash < b.Hash ? -1 : 1;
  }
  const auto one = this->Names[a.Name];
  const auto other = this->Names[b.Name];
  if (one.size() != other.size())
  {
    return one.size() < other.size() ? -1 : 1;
  }
  const auto [at, there] = std::mismatch(one.begin(), one.end(), other.begin());
  return at == one.end() ? 0 : (*at < *there ? -1 : 1);
}

//------------------------------------------------------------------------------
std::vector<SkdCellFace> SkdFaceList::TakeOuter()
{
  std::sort(this->Entries.begin(), this->Entries.end(),
    [this](const Entry& a, const Entry& b)
    {
      const int difference = this->CompareNames(a, b);
      return difference != 0 ? difference < 0 : a.Face < b.Face;
    });
  std::vector<SkdCellFace> outer;
  for (std::size_t i = 0, next = 0; i < this->Entries.size(); i = next)
  {
    for (next = i + 1; next < this->Entries.size() &&
         this->CompareNames(this->Entries[i], this->Entries[next]) == 0;)
    {
      ++next;
    }
    const Entry& last = this->Entries[next - 1];
    if ((next - i) % 2 == 1 && !last.IsGhost)
    {
      outer.push_back(last.Face);
    }
  }
  std::sort(outer.begin(), outer.end());
  *this = SkdFaceList();
  return outer;
}
}
