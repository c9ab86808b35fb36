// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef coretest_Dice_h
#define coretest_Dice_h

#include "Core/Geometry/Vector.h"

#include <random>

namespace coretest
{

/// Random numbers from a fixed seed.
struct Dice
{
  std::mt19937_64 Engine;

  explicit Dice(unsigned seed)
    : Engine(seed)
  {
  }

  double Between(double min, double max)
  {
    return min + (max - min) * (static_cast<double>(this->Engine() >> 11) * 0x1p-53);
  }
  int Below(int count) { return static_cast<int>(this->Engine() % count); }
  skd::Vector3 Point(double maxDistance)
  {
    return { { this->Between(-maxDistance, maxDistance), this->Between(-maxDistance, maxDistance),
      this->Between(-maxDistance, maxDistance) } };
  }
};

}

#endif
