// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBuildTree_h
#define SkdBuildTree_h

#include "Core/Search/Tree/Tree.h"
#include "Core/Search/Tree/TreeInput.h"

namespace skd
{
template <int D>
class LazyTree;
}

namespace skdtree
{
///@{
/// BuildTree and BuildLazyTree of the core, compiled once. In parallel by vtkSMPTools, but for
/// those with "Serial", which are for trees that are built inside a parallel loop. The result is
/// the same.
skd::Tree<3> SkdBuildTree(skd::TreeInput<3>&& input);
skd::Tree<3> SkdBuildTree(const skd::ReadInput<3>& input);
skd::Tree<3> SkdBuildTreeSerial(skd::TreeInput<3>&& input);
skd::LazyTree<3> SkdBuildLazyTree(skd::TreeInput<3>&& input); ///< parallel where it is queried so
skd::LazyTree<3> SkdBuildLazyTree(const skd::ReadInput<3>& input);
///@}
}

#endif
