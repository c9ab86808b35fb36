// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSetText_h
#define SkdSetText_h

#include "vtkObject.h"

#include <string>

namespace skdtree
{
/// Sets a property that is a text, to an empty one for nullptr.
inline void SkdSetText(vtkObject* self, const char* wanted, std::string& property)
{
  const std::string text = wanted ? wanted : "";
  if (property != text)
  {
    property = text;
    self->Modified();
  }
}
}

#endif
