// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBezierCell.h
 * @brief VTK's curved cells in Bernstein form, exact to rounding.
 */

#ifndef SkdBezierCell_h
#define SkdBezierCell_h

#include "Core/Curves/NodePatch.h"

class vtkCell;

namespace skdtree
{
/// The reason why a cell has no usable Bernstein form.
enum class SkdBezierFault
{
  None,
  Type,       ///< neither a curve nor a surface of a kind that is known
  Degree,     ///< above skd::MaximumDegree
  Coordinate, ///< not finite
  Weight      ///< zero, negative or not finite: the cell has no certain bounds
};

/// A curve or a patch whose control points are seen from an origin.
template <class Shape>
struct SkdBezierCell
{
  Shape Form;
  skd::Vector3 Origin;
  SkdBezierFault Fault;
};

///@{
/// Reads quadratic and cubic lines, Lagrange and Bezier curves, and triangles and quadrilaterals of
/// all these kinds. Parameters are VTK's, but for cubic lines, whose -1 to 1 become 0 to 1. The
/// origin is the first point.
SkdBezierCell<skd::BezierCurve> SkdReadBezierCurve(vtkCell* cell);
SkdBezierCell<skd::BezierPatch> SkdReadBezierPatch(vtkCell* cell);
///@}

/// The points of such a triangle or quadrilateral, where they are on its lattice of parameters.
SkdBezierFault SkdReadNodePatch(vtkCell* cell, skd::NodePatch& nodes);
}

#endif
