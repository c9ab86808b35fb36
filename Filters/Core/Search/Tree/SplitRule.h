// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_SplitRule_h
#define skd_Tree_SplitRule_h

namespace skd
{

/// The split of a node's range.
enum class SplitRule
{
  Automatic,  ///< SurfaceArea where elements overlap and differ much in size (see ElementSizes)
  Median,     ///< half the elements on either side, across the longest axis (Algorithm 3.1)
  SurfaceArea ///< where the boxes of both sides, times what is in them, are least
};

}

#endif
