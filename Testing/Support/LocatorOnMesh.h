// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocatorOnMesh.h
 * @brief the fixture of tests of the locator on each of the named meshes, against brute force
 */
#ifndef skdtest_LocatorOnMesh_h
#define skdtest_LocatorOnMesh_h

#include "Support/BruteForce.h"
#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include <gtest/gtest.h>

namespace skdtest
{

class LocatorOnMesh : public testing::TestWithParam<NamedMesh>
{
protected:
  LocatorOnMesh()
    : Data(GetParam().Make())
    , Locator(MakeLocator(this->Data))
    , Reference(this->Data)
  {
  }

  /// A random segment through the bounds, both ends outside of them.
  std::array<Point, 2> Line(Random& random) const
  {
    const Bounds& box = this->Reference.GetBounds();
    const Point through = random.InBox(box);
    const Point along = 2.0 * Diagonal(box) * random.Direction();
    return { through - along, through + along };
  }

  DataSetPointer Data;
  LocatorPointer Locator;
  BruteForce Reference;
};

}

#endif
