// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPatch_h
#define SkdPatch_h

#include "Core/Geometry/Cells/ParameterDomain.h"

#include <iterator>

namespace skdtree
{
/// A part of a cell's domain that a line may hit: all of a curve or surface, a side of a volume.
struct SkdPatch
{
  const skd::ParameterDomain* Domain;
  skd::Vector3 Origin;
  skd::Vector3 Axes[2];

  skd::Vector3 At(double r, double s) const
  {
    return this->Origin + r * this->Axes[0] + s * this->Axes[1];
  }
};

struct SkdPatchRange
{
  const SkdPatch* First;
  const SkdPatch* Last;
  const SkdPatch* begin() const { return this->First; }
  const SkdPatch* end() const { return this->Last; }
};

namespace SkdPatches
{
inline constexpr int Most = 6;

inline constexpr skd::Vector3 O = { { 0.0, 0.0, 0.0 } };
inline constexpr skd::Vector3 X = { { 1.0, 0.0, 0.0 } };
inline constexpr skd::Vector3 Y = { { 0.0, 1.0, 0.0 } };
inline constexpr skd::Vector3 Z = { { 0.0, 0.0, 1.0 } };
inline constexpr skd::Vector3 FromXToY = { { -1.0, 1.0, 0.0 } };
inline constexpr skd::Vector3 FromXToZ = { { -1.0, 0.0, 1.0 } };

inline constexpr SkdPatch OfSegment[] = { { &skd::UnitSegment, O, { X, O } } };
inline constexpr SkdPatch OfSquare[] = { { &skd::UnitSquare, O, { X, Y } } };
inline constexpr SkdPatch OfTriangle[] = { { &skd::UnitTriangle, O, { X, Y } } };
inline constexpr SkdPatch OfCube[] = { { &skd::UnitSquare, O, { X, Y } },
  { &skd::UnitSquare, Z, { X, Y } }, { &skd::UnitSquare, O, { X, Z } },
  { &skd::UnitSquare, Y, { X, Z } }, { &skd::UnitSquare, O, { Y, Z } },
  { &skd::UnitSquare, X, { Y, Z } } };
inline constexpr SkdPatch OfTetrahedron[] = { { &skd::UnitTriangle, O, { X, Y } },
  { &skd::UnitTriangle, O, { X, Z } }, { &skd::UnitTriangle, O, { Y, Z } },
  { &skd::UnitTriangle, X, { FromXToY, FromXToZ } } };
inline constexpr SkdPatch OfPrism[] = { { &skd::UnitTriangle, O, { X, Y } },
  { &skd::UnitTriangle, Z, { X, Y } }, { &skd::UnitSquare, O, { X, Z } },
  { &skd::UnitSquare, O, { Y, Z } }, { &skd::UnitSquare, X, { FromXToY, Z } } };

inline SkdPatchRange Of(const skd::ParameterDomain& domain)
{
  const auto range = [](const auto& patches) {
    return SkdPatchRange{ std::begin(patches), std::end(patches) };
  };
  return &domain == &skd::UnitSegment ? range(OfSegment)
    : &domain == &skd::UnitSquare     ? range(OfSquare)
    : &domain == &skd::UnitTriangle   ? range(OfTriangle)
    : &domain == &skd::UnitCube       ? range(OfCube)
    : &domain == &skd::UnitPrism      ? range(OfPrism)
                                      : range(OfTetrahedron);
}
}
}

#endif
