// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_SolidOverlap_h
#define skd_Geometry_Overlap_SolidOverlap_h

#include "ConvexSolid.h"

namespace skd
{

/// A convex polyhedron with flat faces. What is cut needs a simple topology, what it is cut by only
/// faces.
struct SolidView
{
  const Vector3* Corners;
  const SolidTopology* Topology;
};

namespace detail
{

/// The insides of all faces of `around` at the corners of `within`. False if one has all of them
/// without: then there is no overlap. Those that have all within are left out.
template <class Take>
bool ForEachCuttingFace(const SolidTopology& topology, const Vector3* around, const Vector3* within,
  int size, double extent, const Take& take)
{
  for (const std::vector<int>& face : topology.Faces)
  {
    const HalfSpace inside =
      InsideOf([&](int i) -> const Vector3& { return around[face[static_cast<std::size_t>(i)]]; },
        static_cast<int>(face.size()), extent);
    bool isAnyIn = false;
    bool isAnyOut = false;
    for (int i = 0; i < size; ++i)
    {
      const double side = inside(within[i]);
      isAnyIn |= side > 0.0;
      isAnyOut |= side < 0.0;
    }
    if (!isAnyIn)
    {
      return false;
    }
    if (isAnyOut)
    {
      take(inside);
    }
  }
  return true;
}

}

/// What two convex polyhedra have in common, by cutting `within` by the faces of `around`: best the
/// smaller one is cut. `use(solid, result)` gets it, seen from `origin`, a point of `within`;
/// nothing is called where there is none. About a microsecond of tetrahedra and hexahedra, no
/// allocation.
template <class Use>
void FindOverlap(
  const Vector3& origin, const SolidView& within, const SolidView& around, const Use& use)
{
  std::array<Vector3, SolidTopology::MostCorners> own;
  std::array<Vector3, SolidTopology::MostCorners> other;
  double extent = 0.0;
  const auto see = [&](const SolidView& solid, Vector3* relative)
  {
    for (int i = 0; i < solid.Topology->Size; ++i)
    {
      relative[i] = solid.Corners[i] - origin;
      extent = std::max(
        { extent, std::abs(relative[i][0]), std::abs(relative[i][1]), std::abs(relative[i][2]) });
    }
  };
  see(within, own.data());
  see(around, other.data());
  std::array<HalfSpace, SolidTopology::MostFaces> cuts;
  int number = 0;
  const bool mayMeet =
    detail::ForEachCuttingFace(*around.Topology, other.data(), own.data(), within.Topology->Size,
      extent, [&](const HalfSpace& inside) { cuts[number++] = inside; }) &&
    (number == 0 ||
      detail::ForEachCuttingFace(*within.Topology, own.data(), other.data(), around.Topology->Size,
        extent, [](const HalfSpace&) {}));
  if (!mayMeet)
  {
    return;
  }
  ConvexSolid solid(*within.Topology, own.data());
  for (int i = 0; i < number; ++i)
  {
    if (solid.Clip(cuts[i]) == ClipResult::Nothing)
    {
      return;
    }
  }
  use(solid, number == 0 ? ClipResult::All : ClipResult::Some);
}

}

#endif
