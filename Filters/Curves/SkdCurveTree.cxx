// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCurveTree.h"

#include "Cells/Read/SkdForEach.h"
#include "Cells/Search/SkdBuildTree.h"
#include "Core/Curves/CurveSpans.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
//------------------------------------------------------------------------------
bool SkdCurveTree::Update(const std::vector<SkdBlock>& blocks, const SkdCurveSettings& settings)
{
  if (this->Settings == settings && this->Meshes.AreSameAs(blocks))
  {
    return false;
  }
  *this = SkdCurveTree();
  this->Settings = settings;
  this->Curves.Read(this->Meshes.Keep(blocks), settings.Form);
  this->Cut(settings.ChordTolerance * this->Curves.GetBounds().Diagonal());
  this->Build(settings.Epsilon);
  return true;
}

//------------------------------------------------------------------------------
void SkdCurveTree::Cut(double delta)
{
  for (std::size_t piece = 0; piece < this->Curves.GetNumberOfPieces(); ++piece)
  {
    const skd::BezierCurve whole = this->Curves.GetPiece(piece, skd::Vector3{});
    const skd::Vector3 origin = whole.IsLine() ? skd::Vector3{} : whole.Start(); // as they are
    skd::VisitStraightSpans(this->Curves.GetPiece(piece, origin), delta,
      [&](const skd::BezierCurve& part, const skd::Interval& range)
      {
        const skd::Box3 bounds = part.Bounds();
        this->Boxes.push_back({ bounds.Min + origin, bounds.Max + origin });
        this->Spans.push_back({ piece, range, { part.Start() + origin, part.End() + origin },
          skd::ChordDeviation(part), part.IsLine() });
      });
  }
}

//------------------------------------------------------------------------------
void SkdCurveTree::Build(double epsilon)
{
  const skd::Box3& bounds = this->Curves.GetBounds();
  const double rounding =
    8.0 * std::numeric_limits<double>::epsilon() * skd::LargestCoordinate(bounds);
  this->AbsoluteEpsilon = std::max(rounding, epsilon * bounds.Diagonal()); // also of NaN
  this->Tree = SkdBuildTree(skd::MakeTreeInput<3>(this->Boxes, this->AbsoluteEpsilon));
}

//------------------------------------------------------------------------------
skd::BezierCurve SkdCurveTree::GetForm(const SkdCurveSpan& span, const skd::Vector3& origin) const
{
  return this->Curves.GetPiece(span.Piece, origin).Restricted(span.Range.Min, span.Range.Max);
}
}
