// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Element_h
#define skd_Tree_Element_h

#include "Frame.h"

#include <cstdint>

namespace skd
{

/// An element of a tree: its safety box in the tree's frame, and its index.
template <int D>
struct alignas(16) Element
{
  FloatBox<D> Box;
  std::uint32_t Index;
};

}

#endif
