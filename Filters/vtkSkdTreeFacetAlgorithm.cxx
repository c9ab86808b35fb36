// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeFacetAlgorithm.h"

#include "Pipeline/SkdPrint.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
void vtkSkdTreeFacetAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "ChordalDeviation", this->ChordalDeviation);
}
VTK_ABI_NAMESPACE_END
