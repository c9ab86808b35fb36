// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdSpreadSides.h"

namespace skdtree
{
void SkdSpreadSides::Update(
  vtkDataObject* piece, double epsilon, vtkMultiProcessController* controller)
{
  this->Spread.Update(SkdMakeTransport(controller), piece);
  this->TreesBuilt = this->Body.Update(this->Spread, epsilon);
  this->Sure = this->Body.GetNumberOfFaces() > 0 && this->Body.IsFit();
}
}
