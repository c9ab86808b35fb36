// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Batches.h
 * @brief what threads gain: construction and batches of queries, beside one thread and a loop
 */
#ifndef skdbench_Batches_h
#define skdbench_Batches_h

#include "Measure.h"

namespace skdbench
{

/// Milliseconds by the wall's clock, of Options::Threads (at least two), of one, and of a loop over
/// single queries. The machine must do nothing else.
Results MeasureBatches(const Options& options);

}

#endif
