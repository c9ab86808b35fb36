// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSpreadCurves_h
#define SkdSpreadCurves_h

#include "Core/Geometry/Box.h"
#include "Exchange/SkdSpreadChains.h"
#include "Solids/Surfaces/SkdContactKey.h"
#include "Solids/Surfaces/SkdCurves.h"

#include <functional>

namespace skdtree
{
/// The points of contact that a process has found of its own piece of the first surface.
struct SkdSpreadPoints
{
  const std::vector<skd::Vector3>& Positions;

  std::vector<SkdContactKey> Keys;

  /// A box that has the corner or edge of the first surface which a point lies on: other processes
  /// that have the point have that corner or edge, too. Empty of points inside of triangles there.
  std::vector<skd::Box3> Around;
};

/// Curves of surfaces the first of which lies in pieces, as one process would find them that has it
/// as a whole. What several processes may have found is told to processes that are chosen by its
/// key, which compare it; a curve that goes on from process to process is joined on one of them.
/// No process gets more than what it is asked about and the curves that it outputs.
class SkdSpreadCurves
{
public:
  /// `triangles`: boxes of this process's triangles of the first surface that are in pairs. All
  /// processes must call it, and Find(), together.
  SkdSpreadCurves(
    SkdTransport& transport, const SkdSpreadPoints& points, std::vector<skd::Box3> triangles);

  /// Of each pair its label; there are `pairs` of them.
  using FindLabel = std::function<SkdContactLabel(std::size_t pair)>;

  /// Segments and lone points that several processes have are output by one alone, that with the
  /// lowest cells; and if they `are joined`, a curve of several processes by one of these.
  SkdCurves Find(SkdCurveParts parts, std::size_t pairs, const FindLabel& labelOf, bool areJoined);

private:
  struct Chains;
  struct Ends;
  struct Question;
  struct Step;
  class Receiver;

  bool MayBeShared(const SkdEndPair& segment) const
  {
    return this->AreShared[segment.A] != 0 && this->AreShared[segment.B] != 0;
  }
  void LeaveOutRepeated(SkdCurveParts& parts, const FindLabel& labelOf);
  void LeaveOutSegments(SkdCurveParts& parts, const FindLabel& labelOf);
  void LeaveOutPoints(SkdCurveParts& parts, const FindLabel& labelOf);
  std::vector<unsigned char> AskWhether(const std::vector<Question>& questions);
  Ends CountAtEnds(const std::vector<SkdEndPair>& segments);
  std::vector<SkdChainEnd> FindLinks(const std::vector<SkdPolyline>& lines,
    const std::vector<std::size_t>& chains, const Ends& ends);
  void Choose(Chains& chains, SkdCurves& curves, const Ends& ends);
  SkdRowsByProcess<Step> TakeAway(
    SkdCurves& curves, const Chains& chains, const Ends& ends, const FindLabel& labelOf);
  void Bring(SkdCurves& curves, const Chains& chains, const Ends& ends, std::size_t pairs,
    const FindLabel& labelOf);
  std::vector<SkdPolyline> Join(const SkdCurves& curves, const std::vector<SkdContactKey>& keys,
    std::vector<bool> areEnds) const;

  SkdTransport& Transport;
  const SkdSpreadPoints& Points;
  std::vector<unsigned char> AreShared; // by point, whether other processes may have it
};
}

#endif
