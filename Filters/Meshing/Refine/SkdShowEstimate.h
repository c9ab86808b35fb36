// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdShowEstimate_h
#define SkdShowEstimate_h

#include "vtkAlgorithm.h"

#include <iomanip>
#include <sstream>

namespace skdtree
{
/// Shows an estimate in the progress text. Negative seconds: not known.
inline void SkdShowEstimate(
  vtkAlgorithm* algorithm, double cells, double bytes, double seconds = -1.0)
{
  std::ostringstream text;
  text << std::setprecision(2) << "about " << cells << " cells, " << bytes / 1e6 << " MB";
  if (seconds >= 0.0)
  {
    text << ", " << seconds << " s";
  }
  algorithm->SetProgressText(text.str().c_str());
}
}

#endif
