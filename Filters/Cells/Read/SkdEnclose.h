// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdEnclose_h
#define SkdEnclose_h

#include "Core/Geometry/Box.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

namespace skdtree
{
/// For SkdEnclose().
template <class BoxOf>
class SkdEnclosing
{
public:
  explicit SkdEnclosing(const BoxOf& boxOf)
    : BoxAt(boxOf)
  {
  }
  void Initialize() { this->Partial.Local() = {}; }
  void operator()(vtkIdType begin, vtkIdType end)
  {
    skd::Box3 box = this->Partial.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      box.Add(this->BoxAt(static_cast<std::size_t>(i)));
    }
    this->Partial.Local() = box;
  }
  void Reduce()
  {
    for (const skd::Box3& box : this->Partial)
    {
      this->Total.Add(box);
    }
  }

  skd::Box3 Total;

private:
  const BoxOf& BoxAt;
  vtkSMPThreadLocal<skd::Box3> Partial;
};

/// What encloses all boxes of a list, in parallel: boxOf(0) .. boxOf(count - 1).
template <class BoxOf>
skd::Box3 SkdEnclose(std::size_t count, const BoxOf& boxOf)
{
  SkdEnclosing<BoxOf> enclosing(boxOf);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), enclosing);
  return enclosing.Total;
}
}

#endif
