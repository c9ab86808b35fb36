// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Timing.h
 * @brief medians of interleaved repetitions, by Google Benchmark
 */
#ifndef skdbench_Timing_h
#define skdbench_Timing_h

#include "Options.h"

#include <functional>
#include <optional>
#include <vector>

namespace skdbench
{

/// Must be called before anything is timed.
void StartTiming();

/// A thing to time: it is called over and over.
struct Task
{
  std::function<void()> Run;
  std::function<void()> CleanUp; // after each run, untimed; may be empty
  int Repetitions;
};

/// Median nanoseconds a run of each task; the repetitions of the tasks take turns.
std::vector<double> MedianNanoseconds(const std::vector<Task>& tasks, const Options& options);

/// Bytes on this process's heap, where the system reports them.
std::optional<double> BytesOnHeap();

}

#endif
