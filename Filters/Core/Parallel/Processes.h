// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_Processes_h
#define skd_Mesh_Processes_h

#include <algorithm>
#include <vector>

namespace skd
{

/// Communication between parallel processes. All of them must make the same calls, in the same
/// order.
class Processes
{
public:
  virtual ~Processes() = default;

  /// Whether it is so on any of them.
  virtual bool IsAny(bool here) const = 0;

  /// The numbers of each of the others.
  virtual std::vector<std::vector<double>> GatherFromOthers(
    const std::vector<double>& own) const = 0;

  /// The sum of one number of each.
  double SumOf(double here) const
  {
    double sum = here;
    for (const std::vector<double>& told : this->GatherFromOthers({ here }))
    {
      sum += told[0];
    }
    return sum;
  }

  /// The least of one number of each.
  double LeastOf(double here) const
  {
    double least = here;
    for (const std::vector<double>& told : this->GatherFromOthers({ here }))
    {
      least = std::min(least, told[0]);
    }
    return least;
  }
};

}

#endif
