// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMessage_h
#define SkdMessage_h

#include "Exchange/SkdTransport.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkMultiProcessController;

namespace skdtree
{
/// Sends each process's data object, a data set or composite of them, to all others. Returns those
/// of all processes in their order; the own one is not copied. All processes must call it together.
/// Memory beside the results: twice the largest of the objects.
std::vector<vtkSmartPointer<vtkDataObject>> SkdExchangeAll(
  vtkDataObject* own, vtkMultiProcessController* controller);

/// Such an object as bytes, and again.
SkdBytes SkdPackObject(vtkDataObject* object);
vtkSmartPointer<vtkDataObject> SkdUnpackObject(SkdBytes bytes);

/// Sends a mesh, or nullptr, to each process; the one to this process is not copied. See
/// SkdTransport::Exchange.
void SkdExchangeMeshes(SkdTransport& transport,
  const std::function<vtkSmartPointer<vtkDataSet>(int to)>& make,
  const std::function<void(int from, vtkDataSet* mesh)>& take);
}

#endif
