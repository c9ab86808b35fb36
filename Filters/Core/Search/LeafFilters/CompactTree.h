// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_CompactTree_h
#define skd_LeafFilters_CompactTree_h

#include "LeafPackets.h"
#include "TrianglePacket.h"

namespace skd
{

inline void CompactTree::Fetch(std::uint32_t node) const
{
  if (node < this->FirstDropped)
  {
    TreeView<3>::Fetch(node);
  }
  else if (this->Corners.Triangles)
  {
    FetchLines<sizeof(TrianglePacket)>(this->Corners.Triangles + (node - this->FirstDropped));
  }
  else
  {
    FetchLines<sizeof(QuantizedCorners<2>)>(this->Corners.Boxes + (node - this->FirstDropped));
  }
}

SKD_NOINLINE inline const Node<3>& CompactTree::Make(
  std::uint32_t number, Node<3>& room, bool wantsBoxes) const
{
  const std::uint32_t tag = 2 * number + (this->Corners.Triangles ? 0 : 1); // as of stored leaves
  if (room.Tag == tag)
  {
    return room; // walks over pairs often open the same again
  }
  const ElementRange elements = this->LeafAt(number);
  room.Tag = wantsBoxes ? tag : Node<3>::NoTag;
  room.First = elements.First;
  room.SetCount(elements.Count);
  room.IsLeaf = true;
  if (wantsBoxes && this->Corners.Triangles)
  {
    this->Corners.Triangles[number].GetBoxes(this->Margin, room.Boxes);
  }
  else if (wantsBoxes)
  {
    this->Corners.Boxes[number].GetBoxes(this->Margin, room.Boxes);
  }
  return room;
}

}

#endif
