// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdWideWalks.h"

#include <cstdlib>

namespace skdtree
{
namespace
{
bool CanRun()
{
#if defined(SKD_HAS_WIDE_WALKS)
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
#else
  return false;
#endif
}

bool IsOn = CanRun() && !std::getenv("SKDTREE_BASELINE");
}

//------------------------------------------------------------------------------
bool SkdWideWalks::AreOn()
{
  return IsOn;
}

//------------------------------------------------------------------------------
void SkdWideWalks::TurnOn(bool on)
{
  IsOn = on && CanRun();
}
}
