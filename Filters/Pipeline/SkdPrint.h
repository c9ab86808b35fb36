// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPrint_h
#define SkdPrint_h

#include "vtkIndent.h"
#include "vtkSystemIncludes.h"

#include <cstddef>
#include <type_traits>

namespace skdtree
{
/// What a property's line says of its value: of a switch On or Off, of several numbers (1, 2, 3).
template <class Value>
void SkdPrintValue(ostream& os, const Value& value)
{
  if constexpr (std::is_same_v<Value, bool>)
  {
    os << (value ? "On" : "Off");
  }
  else
  {
    os << value;
  }
}

template <std::size_t Size>
void SkdPrintValue(ostream& os, const char (&text)[Size])
{
  os << text;
}

template <class Number, std::size_t Size>
void SkdPrintValue(ostream& os, const Number (&numbers)[Size])
{
  const char* before = "(";
  for (const Number number : numbers)
  {
    os << before << number;
    before = ", ";
  }
  os << ")";
}

/// Lines of PrintSelf, one a property, whose names and values are given in turn.
template <class Value, class... Others>
void SkdPrint(
  ostream& os, vtkIndent indent, const char* name, const Value& value, const Others&... others)
{
  os << indent << name << ": ";
  SkdPrintValue(os, value);
  os << "\n";
  if constexpr (sizeof...(others) > 0)
  {
    SkdPrint(os, indent, others...);
  }
}
}

#endif
