// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdGridExtras.h"

#include "Refine/SkdGridDistances.h"
#include "Refine/SkdGridFractions.h"
#include "Refine/SkdGridInside.h"

SkdGridExtras SkdFindExtras(const SkdGrid& grid, const SkdGridQuestions& questions,
  const SkdParts& parts, const SkdEnclosure& enclosure, vtkAlgorithm* algorithm, double first,
  double last)
{
  const double third = (last - first) / 3.0;
  SkdGridExtras extras;
  if (questions.NeedBoundary())
  {
    extras.Inside = SkdFindInside(grid, enclosure, algorithm, first, first + third);
  }
  if (questions.Fractions)
  {
    extras.Fractions = SkdFindFractions(grid, enclosure, extras.Inside, questions.Epsilon,
      algorithm, first + third, first + 2.0 * third);
  }
  if (!questions.Inside)
  {
    extras.Inside.clear(); // was for the fractions only
  }
  if (questions.Distances)
  {
    extras.Distances = SkdFindDistances(grid, parts, algorithm, first + 2.0 * third, last);
    if (questions.Inside)
    {
      SkdSignDistances(extras.Distances, extras.Inside);
    }
  }
  return extras;
}
