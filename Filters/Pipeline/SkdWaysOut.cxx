// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdWaysOut.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
/// A number in [0, 1) from bits that look random (D. Lea's and G. Steele's SplitMix64).
double Scatter(std::uint64_t& state)
{
  state += 0x9e3779b97f4a7c15u;
  std::uint64_t bits = state;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31;
  return std::ldexp(static_cast<double>(bits >> 11), -53);
}
}

std::array<SkdWayOut, 7> SkdWaysOutAlongAxes(const double bounds[6], const double x[3])
{
  const double diagonal = vtkBoundingBox(bounds).GetDiagonalLength();
  std::array<SkdWayOut, 7> ways;
  for (int i = 0; i < 6; ++i)
  {
    const int axis = i / 2;
    const double toBound = bounds[i] - x[axis];
    const double length = std::abs(toBound) + 0.01 * diagonal;
    ways[i] = { 0.0437 * length, 0.0269 * length, 0.0163 * length };
    ways[i][axis] = i % 2 ? length : -length;
  }
  const auto length2 = [](const SkdWayOut& way) { return vtkMath::Dot(way.data(), way.data()); };
  std::stable_sort(ways.begin(), ways.begin() + 6,
    [&](const SkdWayOut& a, const SkdWayOut& b) { return length2(a) < length2(b); });
  ways[6] = { 1.31 * diagonal, 1.13 * diagonal, 1.23 * diagonal };
  return ways;
}

SkdRandomWaysOut::SkdRandomWaysOut(const double bounds[6], std::uint64_t seed, std::uint64_t point)
  : Length(1.01 * vtkBoundingBox(bounds).GetDiagonalLength())
{
  std::uint64_t state = seed;
  Scatter(state);
  state ^= point * 0xd1b54a32d192ed03u;
  this->U = Scatter(state);
  this->V = Scatter(state);
}

// R2 of M. Roberts: multiples of the inverses of the plastic number and of its square.
SkdWayOut SkdRandomWaysOut::Next()
{
  this->U = std::fmod(this->U + 0.75487766624669276005, 1.0);
  this->V = std::fmod(this->V + 0.56984029099805326591, 1.0);
  const double z = 1.0 - 2.0 * this->U;
  const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double angle = 2.0 * vtkMath::Pi() * this->V;
  return { this->Length * radius * std::cos(angle), this->Length * radius * std::sin(angle),
    this->Length * z };
}
