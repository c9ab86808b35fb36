// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdStamp_h
#define SkdStamp_h

#include "Exchange/SkdCompositePieces.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

namespace skdtree
{
/// What a data object was, to notice changes. It keeps the object, so that its address is not used
/// again.
class SkdStamp
{
public:
  SkdStamp() = default;
  explicit SkdStamp(vtkDataObject* object)
    : Object(object)
    , Parts{ { object, object->GetMTime() } }
  {
    for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(object))
    {
      this->Parts.emplace_back(leaf.Mesh.Get(), leaf.Mesh->GetMTime());
    }
  }

  vtkDataObject* Get() const { return this->Object; }

  bool operator==(const SkdStamp& other) const { return this->Parts == other.Parts; }
  bool operator!=(const SkdStamp& other) const { return !(*this == other); }

private:
  vtkSmartPointer<vtkDataObject> Object;
  std::vector<std::pair<void*, vtkMTimeType>> Parts;
};
}

#endif
