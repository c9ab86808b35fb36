// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdBuildTree.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Search/Tree/BuildLazyTree.h"
#include "Core/Search/Tree/BuildTree.h"

namespace skdtree
{
skd::Tree<3> SkdBuildTree(skd::TreeInput<3>&& input)
{
  return skd::BuildTree<3>(std::move(input), SkdTreeLoop);
}

skd::Tree<3> SkdBuildTree(const skd::ReadInput<3>& input)
{
  return skd::BuildTree<3>(input, SkdTreeLoop);
}

skd::Tree<3> SkdBuildTreeSerial(skd::TreeInput<3>&& input)
{
  return skd::BuildTree<3>(std::move(input));
}

skd::LazyTree<3> SkdBuildLazyTree(skd::TreeInput<3>&& input)
{
  return skd::BuildLazyTree<3>(std::move(input));
}

skd::LazyTree<3> SkdBuildLazyTree(const skd::ReadInput<3>& input)
{
  return skd::BuildLazyTree<3>(input, SkdTreeLoop);
}
}
