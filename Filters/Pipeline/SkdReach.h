// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdReach_h
#define SkdReach_h

/// How far a cell may be from what a process has, and still be near it: a distance, and a fraction
/// of the diagonal of the cell's box, together.
struct SkdReach
{
  double Distance = 0.0;
  double OfDiagonal = 0.0;

  /// The neighbours of cells that are near are wanted, too.
  bool WithNeighbours = false;

  /// Cells are wanted for their faces: those of volume cells depend on all of these.
  bool IsOfFaces = false;

  /// Both meshes are to have volume cells alone, and the searched one no blocks.
  bool IsOfVolumes = false;

  /// The cells of a process's own piece are wanted, too, wherever they are, for sums over all
  /// cells.
  bool WithOwn = false;
};

#endif
