// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCurveSpans.h"

#include "Core/Curves/CurveSpans.h"

namespace skdtree
{
void SkdVisitSpans(const skd::BezierCurve& curve, double delta, const SkdSpanVisitor& visit)
{
  skd::VisitSpans(curve, delta, visit);
}
}
