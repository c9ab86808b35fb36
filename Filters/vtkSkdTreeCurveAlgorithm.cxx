// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeCurveAlgorithm.h"

#include "Curves/SkdCurveSet.h"
#include "Pipeline/SkdPrint.h"

using namespace skdtree;

namespace
{
constexpr double DefaultChordTolerance = 1e-3; // of the diagonal
}

VTK_ABI_NAMESPACE_BEGIN
SkdPolylineForm vtkSkdTreeCurveAlgorithm::FindPolylineForm() const
{
  return SkdPolylineForm::Of(this->PolylineForm, this->Tension, this->Bias, this->Continuity);
}

double vtkSkdTreeCurveAlgorithm::FindChordTolerance()
{
  if (this->ChordTolerance > 0.0)
  {
    return this->ChordTolerance;
  }
  vtkWarningMacro("ChordTolerance is "
    << this->ChordTolerance << " and is ignored; curves are approximated within "
    << DefaultChordTolerance << " of the diagonal of their bounds.");
  return DefaultChordTolerance;
}

void vtkSkdTreeCurveAlgorithm::WarnAboutInput(
  const char* port, const std::vector<std::string>& faults, bool isEmpty, const char* whatItLacks)
{
  for (const std::string& fault : faults)
  {
    vtkWarningMacro(<< port << ": " << fault << "; they are ignored.");
  }
  if (isEmpty)
  {
    vtkWarningMacro(<< port << " has no " << whatItLacks << "; there are no intersections.");
  }
}

void vtkSkdTreeCurveAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "PolylineForm", this->PolylineForm, "Tension", this->Tension, "Bias",
    this->Bias, "Continuity", this->Continuity, "InterpolateData", this->InterpolateData,
    "ChordTolerance", this->ChordTolerance);
}
VTK_ABI_NAMESPACE_END
