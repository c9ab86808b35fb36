// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tolerances of trees, leaf filters and queries, each with its reference value. All of them
/// are in the tree's frame (Frame.h), where it lies in [-1, 1], unless they say otherwise.
#ifndef skd_Tree_Tolerances_h
#define skd_Tree_Tolerances_h

namespace skd::tolerances
{

/// Of squared distances: what the roundings of a dozen sums lose near 0.
constexpr double Denormal2 = 1e-44;
/// More than rounding outward and a sum add to coordinates of at most 1.
constexpr double BoxExcess = 1e-6;
/// Above three roundings of coordinates of at most 2, the last of a sum.
constexpr float QuantizedBox = 3e-7f;
/// As BoxExcess, of boxes that are moved from one frame into another of this size.
constexpr double BoxPairExcess = 2e-6;
/// Above the rounding of a sum of a few products of numbers of at most 2 in single precision.
constexpr double PlaneSum = 1e-5;
/// Of the offset of a plane in double precision, relative to the products in it.
constexpr double PlaneOffset = 1e-15;
/// Of a parameter in [0, 1]: a handful of operations of 2^-24 each.
constexpr float SegmentParameter = 4e-6f;
/// The shortest a segment counts as along an axis: no division by 0, no infinity.
constexpr double LeastAlong = 1e-30;
/// Of sums of products in single precision, relative to their largest factors; on the grid.
constexpr float CrossingSum = 1e-6f;
/// Of sums in single precision, relative to the point's coordinates; on the grid.
constexpr double DistanceSum = 4e-6;
/// A squared length that can be divided by, on the grid.
constexpr float LeastLength2 = 1e-30f;

}

#endif
