// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/InOut/SkdInOut.h"

#include "Pipeline/SkdMakeArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMath.h"

namespace skdtree
{
SkdInOuts::SkdInOuts(vtkIdType n, bool hasWinding)
  : Inside(SkdMakeArray<vtkUnsignedCharArray>(InsideName, 1, n, 0))
  , PartIds(SkdMakeArray<vtkIntArray>("SkdPartId", 1, n, -1))
  , Depths(SkdMakeArray<vtkIntArray>("SkdDepth", 1, n, 0))
  , Confidences(SkdMakeArray<vtkFloatArray>("SkdConfidence", 1, n, 0))
  , OnBoundary(SkdMakeArray<vtkUnsignedCharArray>("SkdOnBoundary", 1, n, 0))
{
  if (hasWinding)
  {
    this->Windings = SkdMakeArray<vtkDoubleArray>("SkdWindingNumber", 1, n, vtkMath::Nan());
    this->WindingBounds = SkdMakeArray<vtkDoubleArray>("SkdWindingBound", 1, n, vtkMath::Nan());
  }
}

void SkdInOuts::Set(vtkIdType i, const SkdInOut& answer)
{
  this->Inside->SetValue(i, answer.IsInside ? 1 : 0);
  this->PartIds->SetValue(i, answer.PartId);
  this->Depths->SetValue(i, answer.Depth);
  this->Confidences->SetValue(i, static_cast<float>(answer.Confidence));
  this->OnBoundary->SetValue(i, answer.IsOnBoundary ? 1 : 0);
  if (this->Windings)
  {
    this->Windings->SetValue(i, answer.WindingNumber);
    this->WindingBounds->SetValue(i, answer.WindingBound);
  }
}

void SkdInOuts::AddTo(vtkDataSetAttributes* data) const
{
  data->AddArray(this->Inside);
  data->AddArray(this->PartIds);
  data->AddArray(this->Depths);
  data->AddArray(this->Confidences);
  data->AddArray(this->OnBoundary);
  if (this->Windings)
  {
    data->AddArray(this->Windings);
    data->AddArray(this->WindingBounds);
  }
  data->SetActiveScalars(InsideName);
}
}
