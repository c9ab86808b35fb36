// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdPointOrder.h"

#include "vtkPointSet.h"
#include "vtkPoints.h"

SkdPointOrder::SkdPointOrder(vtkDataSet* mesh)
  : Mesh(mesh)
{
  auto* points = vtkPointSet::SafeDownCast(mesh);
  if (points && points->GetPoints())
  {
    this->Scattered.emplace(points->GetPoints()->GetData(), SkdBatchOf::Points);
  }
}
