// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CountInstructions.h
 * @brief what valgrind's callgrind is to count, each part by itself
 */
#ifndef skdtest_CountInstructions_h
#define skdtest_CountInstructions_h

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#define CALLGRIND_DUMP_STATS_AT(name) static_cast<void>(name)
#define SKDTREE_CANNOT_COUNT
#endif

namespace skdtest
{

/// Runs the body; under callgrind with --instr-atstart=no its instructions alone are counted, and
/// written under the name.
template <class Body>
void CountInstructions(const char* name, const Body& body)
{
  CALLGRIND_START_INSTRUMENTATION;
  body();
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT(name);
}

}

#endif
