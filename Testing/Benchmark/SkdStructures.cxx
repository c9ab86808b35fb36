// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorStructure.h"

#include "vtkSkdTreeCellLocator.h"

namespace skdbench
{
namespace
{

class SkdStructure : public LocatorStructure<vtkSkdTreeCellLocator>
{
public:
  std::optional<double> BytesBySelf() const override
  {
    return static_cast<double>(this->Tree->GetMemorySize());
  }

protected:
  bool AllHits(const Query& query) override
  {
    this->Tree->IntersectWithLine(
      query.From.data(), query.To.data(), this->Tolerance, this->Points, this->Ids);
    return true;
  }

  vtkIdType FindCellWithHint(const Query& query, vtkIdType hint) override
  {
    int subId = 0;
    double pcoords[3];
    return this->Tree->FindCellWithHint(Point(query.From).data(), 0.0, hint, this->Cell, subId,
      pcoords, this->Cell ? this->Weights.data() : nullptr);
  }
};

}

std::vector<Kind> SkdKinds()
{
  return { { "skD-tree", Family::Ours, [] { return std::make_unique<SkdStructure>(); } } };
}

}
