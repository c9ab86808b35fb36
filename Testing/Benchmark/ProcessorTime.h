// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProcessorTime.h
 * @brief what whole filters cost, run by run
 */
#ifndef skdbench_ProcessorTime_h
#define skdbench_ProcessorTime_h

#include <algorithm>
#include <ctime>
#include <vector>

namespace skdbench
{

/// Of this process, which runs one thread: what others do on the machine does not count.
inline double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Of values, at least one; of an even number the upper of the two.
inline double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}

#endif
