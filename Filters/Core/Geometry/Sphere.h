// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Sphere_h
#define skd_Geometry_Sphere_h

#include "Vector.h"

namespace skd
{

/// All points at a distance of at most Radius from Centre.
template <int D>
struct Sphere
{
  Vector<D> Centre;
  double Radius;
};

}

#endif
