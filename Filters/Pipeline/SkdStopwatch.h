// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdStopwatch_h
#define SkdStopwatch_h

#include "vtkTimerLog.h"

#include <utility>

/// Seconds between laps.
class SkdStopwatch
{
public:
  double Lap()
  {
    const double now = vtkTimerLog::GetUniversalTime();
    return now - std::exchange(this->Last, now);
  }

private:
  double Last = vtkTimerLog::GetUniversalTime();
};

#endif
