// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocatorOnMesh.h
 * @brief the fixtures of tests of the locator on each of the named meshes
 */
#ifndef skdtest_LocatorOnMesh_h
#define skdtest_LocatorOnMesh_h

#include "Support/BruteForce.h"
#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include <gtest/gtest.h>

namespace skdtest
{

/// A named mesh with its locator.
class BuiltLocator : public testing::TestWithParam<NamedMesh>
{
protected:
  BuiltLocator()
    : Data(GetParam().Make())
    , Locator(MakeLocator(this->Data))
  {
    this->Data->GetBounds(this->Box.data());
  }

  DataSetPointer Data;
  LocatorPointer Locator;
  Bounds Box;
};

class LocatorOnMesh : public BuiltLocator
{
protected:
  LocatorOnMesh()
    : Reference(this->Data)
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

  BruteForce Reference;
};

}

#endif
