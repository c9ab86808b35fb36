// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSurfaceSides.h
 * @brief Which sides of two surfaces that nearly coincide are on each other.
 */

#ifndef SkdSurfaceSides_h
#define SkdSurfaceSides_h

class vtkDataSet;

namespace skdtree
{
/// Areas of target cells whose normal is like that of the nearest donor cell, or opposite to it.
struct SkdSideVotes
{
  double Alike = 0.0;
  double Opposite = 0.0;

  /// What facets must be to have to do with each other (SkdFacetRules::Side): what nearly all are,
  /// so that the two sides of a thin plate are told apart. 0 if the normals of the meshes do not
  /// tell, for they are ordered in no one way.
  int GetSide() const;
};

/// Of some thousand cells that are evenly among all.
SkdSideVotes SkdCountSides(vtkDataSet* donor, vtkDataSet* target);
}

#endif
