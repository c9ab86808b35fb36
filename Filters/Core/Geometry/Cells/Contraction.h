// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_Contraction_h
#define skd_Geometry_Cells_Contraction_h

#include "../Tolerances.h"

#include <algorithm>
#include <cmath>

namespace skd
{

/// How far a function of N parameters in [0, 1] is from x + constant on a whole box, from the hulls
/// of its derivatives: Spread[i] is the sum over j of max |dF_i/dx_j - delta_ij|.
///
/// Where all are below 1 the function takes no value twice. A root then lies within Spread / 2 of
/// the one that a simplified step of Newton's gives from the middle: R. Krawczyk's test.
template <int N>
struct Contraction
{
  double Step[N];   ///< from the middle of the box
  double Spread[N]; ///< infinite where there is no inverse
  double Slack[N];  ///< what the distance that is 0 to within rounding makes of a step

  double Worst() const { return *std::max_element(this->Spread, this->Spread + N); }

  /// Certainly no root in the box.
  bool Excludes() const
  {
    for (int i = 0; i < N; ++i)
    {
      if (this->Worst() < 1.0 &&
        std::abs(this->Step[i]) >
          0.5 * (1.0 + this->Spread[i]) + tolerances::BesidePatch + this->Slack[i])
      {
        return true;
      }
    }
    return false;
  }
};

}

#endif
