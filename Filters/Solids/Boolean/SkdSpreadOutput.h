// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSpreadOutput.h
 * @brief The surface of combined solids of which each process has made a part. All processes must
 * call each function together.
 */

#ifndef SkdSpreadOutput_h
#define SkdSpreadOutput_h

#include "Exchange/SkdTransport.h"
#include "vtkType.h"

#include <array>

class vtkPolyData;

namespace skdtree
{
/// Whether all parts together pass each edge as often in both directions.
bool SkdIsClosedOverAll(SkdTransport& transport, vtkPolyData* part);

/// Replaces the numbers of faces (SkdFaceId), which each process has counted from 0 on, by those
/// that one process would have given: faces in the order of the inputs' cells. `cells` are the
/// numbers of cells of both inputs. O(n), also of what is sent.
void SkdNumberFacesOverAll(
  SkdTransport& transport, const std::array<vtkIdType, 2>& cells, vtkPolyData* part);

/// Replaces what the report says of volumes, areas and triangles by the sums.
void SkdSumReports(SkdTransport& transport, vtkPolyData* part);
}

#endif
