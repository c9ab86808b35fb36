// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurveSpans_h
#define SkdCurveSpans_h

#include <functional>

namespace skd
{
struct BezierCurve;
struct Interval;
}

namespace skdtree
{
/// A part of a curve, and its range of the curve's parameter.
using SkdSpanVisitor = std::function<void(const skd::BezierCurve&, const skd::Interval&)>;

/// VisitSpans of the core, compiled once.
void SkdVisitSpans(const skd::BezierCurve& curve, double delta, const SkdSpanVisitor& visit);
}

#endif
