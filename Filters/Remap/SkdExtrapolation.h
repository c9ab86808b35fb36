// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdExtrapolation.h
 * @brief Values where a donor is not.
 */

#ifndef SkdExtrapolation_h
#define SkdExtrapolation_h

#include "Remap/SkdDonorFields.h"
#include "Remap/SkdSampleTree.h"

#include <vector>

namespace skdtree
{
enum class SkdExtrapolationMethod
{
  None,
  Nearest,        ///< the value of the nearest sample, ties to the lowest
  Constant,       ///< one value for all
  InverseDistance ///< the mean of the nearest samples, by the inverse squares of their distances
};

struct SkdExtrapolationRules
{
  SkdExtrapolationMethod Method = SkdExtrapolationMethod::None;
  double Constant = 0.0;
  int Neighbours = 8; ///< of the mean
};

/// Sets the tuples of `values` that are wanted, by the field's values at the samples that count and
/// are no NaN. On a sphere distances are those of directions. In parallel.
void SkdExtrapolate(const SkdExtrapolationRules& rules, const SkdSampleTree& samples,
  const SkdDonorField& field, const std::vector<skd::Vector3>& positions,
  const std::vector<unsigned char>& isWanted, std::vector<double>& values);
}

#endif
