// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSpreadWindings_h
#define SkdSpreadWindings_h

#include "Exchange/SkdTransport.h"
#include "Solids/Boolean/SkdLineCrossings.h"
#include "Solids/Boolean/SkdWindingNumbers.h"

#include <optional>
#include <vector>

namespace skdtree
{
class SkdCut;

/// Counts winding numbers along lines of other processes: each counts the passes through its own
/// triangles, by exact signs. All processes must make it and call it together.
class SkdSpreadWindings
{
public:
  /// `surfaceOf` is the surface of each triangle of the set, one of two.
  SkdSpreadWindings(SkdTransport& transport, const SkdMovedTriangles& set,
    const std::vector<std::uint32_t>& surfaceOf);
  ~SkdSpreadWindings();

  /// See SkdAskWindings.
  std::optional<std::vector<std::optional<SkdRegionWindings>>> Ask(
    const std::vector<SkdPositionOnLine>& positions, bool isOpen);

private:
  struct Counts;

  Counts CountBefore(const SkdPositionOnLine& position) const;

  SkdTransport& Transport;
  const SkdMovedTriangles& Set;
  const std::vector<std::uint32_t>& SurfaceOf;
  std::vector<std::uint32_t> Triangles; // all
  std::optional<SkdLineCrossings> Lines;
  std::unique_ptr<SkdCut> Cut;
  skd::Box3 Bounds; // of all processes' triangles
};
}

#endif
