// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdLoop.h
 * @brief A parallel loop with progress reports and abort.
 *
 * Observers of progress (including ParaView's) must be called from the thread that runs the
 * pipeline. That thread therefore divides the work into pieces, each a parallel loop of its own,
 * and reports progress and checks for abort between them.
 */

#ifndef SkdLoop_h
#define SkdLoop_h

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeVersion.h"

#include <algorithm>

namespace skdtree
{
/// Whether an algorithm was aborted.
inline bool SkdIsAborted(vtkAlgorithm* algorithm)
{
#if VTK_SKD_HAS_CHECK_ABORT
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

class SkdLoop
{
public:
  /// Reports the progress of `total` steps, made in one or several loops, as going from `first` to
  /// `last` (both in [0, 1]) of the algorithm's progress. There is a report after each 64th of the
  /// steps, but at least `fewest` steps apart: smaller for expensive steps.
  SkdLoop(
    vtkAlgorithm* algorithm, vtkIdType total, double first, double last, vtkIdType fewest = 4096)
    : Algorithm(algorithm)
    , Total(total)
    , First(first)
    , Last(last)
    , Fewest(fewest)
  {
  }

  /// For work whose number of steps becomes known only later, or that starts again.
  void SetTotal(vtkIdType total)
  {
    this->Total = total;
    this->Done = 0;
  }

  /// Calls body(begin, end) in parallel for ranges that cover [0, n). After an abort, remaining
  /// ranges are skipped. Returns whether all were processed.
  template <typename Body>
  bool For(vtkIdType n, const Body& body)
  {
    return this->InPieces(n,
      [&body](vtkIdType begin, vtkIdType end)
      {
        if (end - begin > 1)
        {
          vtkSMPTools::For(begin, end, body);
        }
        else
        {
          body(begin, end);
        }
      });
  }

  /// The same from the calling thread, for bodies that are parallel themselves.
  template <typename Body>
  bool InPieces(vtkIdType n, const Body& body)
  {
    const vtkIdType piece = std::max<vtkIdType>(this->Total / 64, this->Fewest);
    for (vtkIdType begin = 0; begin < n && !this->IsStopped(); begin += piece)
    {
      const vtkIdType end = std::min(n, begin + piece);
      body(begin, end);
      this->Done += end - begin;
      const double part = static_cast<double>(this->Done) / std::max<vtkIdType>(this->Total, 1);
      this->Algorithm->UpdateProgress(this->First + part * (this->Last - this->First));
    }
    return !this->Stopped;
  }

private:
  bool IsStopped()
  {
    this->Stopped = this->Stopped || SkdIsAborted(this->Algorithm);
    return this->Stopped;
  }

  vtkAlgorithm* Algorithm;
  vtkIdType Total;
  double First;
  double Last;
  vtkIdType Fewest;
  vtkIdType Done = 0;
  bool Stopped = false;
};
}

#endif
