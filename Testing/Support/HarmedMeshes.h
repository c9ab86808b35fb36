// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HarmedMeshes.h
 * @brief a few cells of every type, and the faults that they may have
 */
#ifndef skdtest_HarmedMeshes_h
#define skdtest_HarmedMeshes_h

#include "Support/CellZoo.h"

namespace skdtest
{

enum class Harm
{
  None,
  TooFewPoints,  ///< of one cell, as of those down to Faces
  TooManyPoints, ///< not where any number is right
  IdTooLarge,
  IdNegative,
  OffsetTooLarge, ///< of two cells, as the next
  OffsetDecreases,
  FacesOfOthers, ///< faces of polyhedra name points that are not theirs, or are of two points
  FacesMissing,  ///< the stream of faces ends too early
  NaN,           ///< a point of one cell
  Infinite,
  Far, ///< the whole mesh, as what follows
  Tiny,
  Huge,
  Flat,
  OnePoint
};

constexpr int NumberOfHarms = static_cast<int>(Harm::OnePoint) + 1;

std::string NameOf(Harm harm);

/// Whether the harm is that cells are broken, which are to be named and left out.
bool IsBroken(Harm harm);

/// Eight cells of a type, 1.5 apart; of cells of higher order, of this order. nullptr if the harm
/// cannot be done to cells of this type.
GridPointer MakeHarmed(int type, Harm harm, int order = 2);

/// The same cells, but those that are broken are empty.
GridPointer MakeWithoutHarmed(int type, Harm harm, int order = 2);

///@{
/// The same as polydata, of polyvertices, polylines, polygons or strips: what is broken has no
/// points. Only those that have none to begin with cannot have too few.
PolyDataPointer MakeHarmedPolyData(int type, Harm harm, bool ids32);
PolyDataPointer MakePolyDataWithoutHarmed(int type, Harm harm);
///@}

}

#endif
