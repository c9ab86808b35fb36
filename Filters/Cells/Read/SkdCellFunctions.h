// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellFunctions_h
#define SkdCellFunctions_h

class vtkCell;
class vtkDataSet;
class vtkGenericCell;

namespace skdtree
{
/// A cell's interpolation functions and their derivatives, thread-safe. VTK's own are not: all
/// Lagrange wedges, and all Bezier wedges, resize and use one static triangle at each call, in any
/// thread, which overruns memory (VTK 9.1 and later). So does any other evaluation of such a wedge:
/// EvaluatePosition, EvaluateLocation and Derivatives must not be called where threads may run.
namespace SkdCellFunctions
{
/// Identical to VTK's to the last bit, but those of Lagrange and Bezier triangles, tetrahedra and
/// wedges to within rounding (SkdHigherOrderFunctions).
void Interpolate(vtkCell* cell, const double pcoords[3], double* weights);

/// As many for each axis as the cell has points, axis by axis. By differences where VTK's are
/// wrong.
void Derive(vtkCell* cell, const double pcoords[3], double* derivatives);

/// For SkdLoadCell, after GetCell, which reads the rational weights of Bezier cells through one
/// tuple that all threads share, and so may take those of another thread's point. Reads them again,
/// safely.
void ReadRationalWeights(vtkDataSet* data, vtkGenericCell* cell);

/// The weights of a rational Bezier cell's points; nullptr of any other cell.
double* RationalWeights(vtkCell* cell);

/// Whether VTK evaluates cells of this type in memory that all of them share.
bool ShareMemory(int cellType);
}
}

#endif
