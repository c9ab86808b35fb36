// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/InOut/SkdPartClassifier.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

SkdPartClassifier::SkdPartClassifier(const std::vector<SkdPart>& parts, const SkdInsideRules& rules,
  double band, const SkdQueryPoints& queryPoints)
  : Parts(parts)
  , Rules(rules)
  , Band(band)
  , QueryPoints(queryPoints)
  , UsesRows(queryPoints.GetRowLength() > 0 && rules.Method != SkdInsideMethod::WindingNumber &&
      rules.Method != SkdInsideMethod::NearestFeature)
{
  this->TheRow.Passes.resize(this->UsesRows ? parts.size() : 0);
}

bool SkdPartClassifier::HasRowOf(const SkdPart& part) const
{
  return this->UsesRows && part.GetNumberOfOpenEdges() == 0;
}

void SkdPartClassifier::GoToRow(vtkIdType number)
{
  Row& row = this->TheRow;
  const vtkIdType length = this->QueryPoints.GetRowLength();
  double last[3];
  row.Number = number;
  this->QueryPoints.GetPoint(number * length, row.From);
  this->QueryPoints.GetPoint(number * length + length - 1, last);
  vtkMath::Subtract(last, row.From, row.Along);
  const double distance = vtkMath::Normalize(row.Along);
  for (std::size_t part = 0; part < this->Parts.size(); ++part)
  {
    row.Passes[part].clear();
    if (this->HasRowOf(this->Parts[part]))
    {
      this->Parts[part].FindPasses(
        row.From, row.Along, distance, this->Rules.Method, row.Passes[part]);
    }
  }
}

SkdSide SkdPartClassifier::AskRow(
  std::size_t part, const double x[3], std::uint64_t queryPoint) const
{
  if (!this->Parts[part].BoundsHold(x))
  {
    return SkdSide();
  }
  double away[3];
  vtkMath::Subtract(x, this->TheRow.From, away);
  const std::vector<SkdPassAlong>& passes = this->TheRow.Passes[part];
  const auto next =
    std::lower_bound(passes.begin(), passes.end(), vtkMath::Dot(away, this->TheRow.Along),
      [](const SkdPassAlong& pass, double at) { return pass.At < at; });
  const int around = next == passes.begin() ? 0 : std::prev(next)->After;
  return std::abs(around) > 1 ? this->Parts[part].AskSide(x, this->Rules, queryPoint)
                              : SkdSide{ around != 0, 1.0 };
}

SkdInOut SkdPartClassifier::Ask(vtkIdType queryPoint)
{
  SkdInOut answer;
  double x[3];
  this->QueryPoints.GetPoint(queryPoint, x);
  if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
  {
    answer.WindingNumber = vtkMath::Nan();
    answer.WindingBound = vtkMath::Nan();
    return answer;
  }
  if (this->UsesRows && queryPoint / this->QueryPoints.GetRowLength() != this->TheRow.Number)
  {
    this->GoToRow(queryPoint / this->QueryPoints.GetRowLength());
  }
  answer.Confidence = 1.0;
  double smallest = VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    const SkdPart& part = this->Parts[i];
    const auto number = static_cast<std::uint64_t>(queryPoint);
    const SkdSide side =
      this->HasRowOf(part) ? this->AskRow(i, x, number) : part.AskSide(x, this->Rules, number);
    answer.Confidence = std::min(answer.Confidence, side.Confidence);
    answer.IsOnBoundary = answer.IsOnBoundary || (this->Band > 0.0 && part.IsNear(x, this->Band));
    answer.WindingNumber += side.WindingNumber;
    answer.WindingBound += side.WindingBound;
    answer.IsInside = answer.IsInside || side.IsInside;
    answer.Depth += side.IsInside ? 1 : 0;
    if (side.IsInside && part.GetDiagonal() < smallest)
    {
      smallest = part.GetDiagonal();
      answer.PartId = part.GetId();
    }
  }
  return answer;
}
